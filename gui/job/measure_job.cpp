// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/measure_job.h"

#include <exception>

#include "core/base/error.h"
#include "core/field/wall_field.h"
#include "core/measure/cross_section.h"
#include "core/measure/vessel_profile.h"
#include "gui/job/file_jobs.h"
#include "io/vessel/measurements_file.h"

namespace angiomesh {

void MeasureJob::execute() noexcept {
  try {
    measure();
  } catch (const Cancelled&) {
    // Nobody waits for it any more.
  } catch (const std::exception& failure) {
    error = failure.what();
  }
}

void MeasureJob::prepare(bool withSkeleton) {
  if (!ground.wall)
    ground.wall = std::make_shared<const SplineField>(
        wallField(*ground.phi, SplineKind::InterpolatingBspline));
  progress.check();
  if (withSkeleton && !ground.skeleton)
    ground.skeleton = std::make_shared<const Skeleton>(skeletonOf(*ground.phi, progress));
}

void MeasureJob::measure() {
  Measurement& m = measurement;
  m.sections.clear();
  m.profile.clear();
  m.key.clear();
  if (m.kind == MeasurementKind::Distance) return;
  m.key = ground.key;
  prepare(m.kind != MeasurementKind::Section);
  if (m.kind == MeasurementKind::Section) {
    m.sections = {crossSectionAt(*ground.wall, m.places[0])};
    return;
  }
  const bool branch = m.kind == MeasurementKind::Profile;
  VesselProfile profile =
      profileAlong(*ground.wall,
                   branch ? branchAt(*ground.skeleton, *ground.wall, m.places[0])
                          : wayBetween(*ground.skeleton, *ground.wall, m.places[0], m.places[1]),
                   progress);
  m.profile = std::move(profile.points);
  if (!branch) m.sections = {profile.narrowest, profile.first, profile.last};
}

void MeasurementsFileJob::execute() noexcept {
  try {
    writeMeasurements(path, measurements, key);
  } catch (const std::exception& failure) {
    error = withoutPath(failure.what(), path, path.filename().string());
  }
}

}  // namespace angiomesh
