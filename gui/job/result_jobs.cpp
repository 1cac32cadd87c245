// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/result_jobs.h"

#include <exception>
#include <vector>

#include "core/base/error.h"
#include "core/contour/marching_cubes.h"
#include "core/cuts/cuts.h"
#include "core/field/wall_field.h"
#include "core/pipeline/expected_surface.h"
#include "core/pipeline/vesselness_step.h"

namespace angiomesh {

void SpeedJob::execute() noexcept {
  try {
    speed = std::make_shared<const Volume<float>>(
        speedVolume(*vesselness->multiScale, thresholdsFor(*vesselness, params)));
  } catch (const std::exception& failure) {
    error = failure.what();
  }
}

void EstimateJob::execute() noexcept {
  try {
    const SplineField field = wallField(*phi, surface.spline);
    std::vector<std::string> remarks;
    const CutAway away = makeCuts(field, *phi, ports, remarks, progress);
    expected = expectSurface(*phi, field, surface, progress, away);
  } catch (const std::exception&) {
    expected.reset();
  }
}

void OutlineJob::execute() noexcept {
  try {
    surface =
        std::make_shared<const TriMesh>(marchingCubes(*evolve->phi, SurfaceBorder::Cap, progress));
  } catch (const std::exception&) {
    surface.reset();
  }
}

void FrontJob::execute() noexcept {
  try {
    phi = std::make_shared<const Volume<float>>(front->phi.unpacked());
    surface = std::make_shared<const TriMesh>(marchingCubes(*phi, SurfaceBorder::Cap, progress));
  } catch (const std::exception&) {
    phi.reset();
    surface.reset();
  }
}

void DoubtJob::execute() noexcept {
  try {
    places = doubtfulPlaces(*phi, vesselness.get(), thresholds, progress);
  } catch (const Cancelled&) {
    places.clear();
  } catch (const std::exception& failure) {
    error = failure.what();
  }
}

void ReasonJob::execute() noexcept {
  try {
    reason = reasonAt(pointLps, *image, *vessels, *evolve, keptPhi.get(), params);
  } catch (const std::exception& failure) {
    error = failure.what();
  }
}

}  // namespace angiomesh
