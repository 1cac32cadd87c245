// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "core/base/error.h"
#include "core/cuts/cuts.h"
#include "core/field/wall_field.h"
#include "core/parameters/field.h"
#include "core/pipeline/expected_surface.h"
#include "gui/model/case_controller.h"

namespace angiomesh {

/// What the surface will be, made off the window's thread.
struct CaseController::EstimateJob {
  std::shared_ptr<const Volume<float>> phi;
  SurfaceParams params;
  PortParams ports;
  std::string key;
  Progress progress;
  std::optional<ExpectedSurface> expected;

  void execute() noexcept {
    try {
      const SplineField field = wallField(*phi, params.spline);
      std::vector<std::string> remarks;
      const CutAway away = makeCuts(field, *phi, ports, remarks, progress);
      expected = expectSurface(*phi, field, params, progress, away);
    } catch (const std::exception&) {
      // Without an estimate nothing is lost: meshing says what is wrong.
    }
  }
};

CaseController::Estimate CaseController::estimateWanted() const {
  Estimate wanted;
  if (params_.surface.method == SurfaceMethod::MarchingCubes || !shown_.evolve) {
    return wanted;
  }
  wanted.phi = uncutPhi();
  wanted.key = keys_[static_cast<std::size_t>(Step::Evolve)];
  for (const Field& field : parameterFields()) {
    if (field.key.starts_with("surface.") || field.key.starts_with("ports.")) {
      wanted.key += '/' + fieldText(field.get(params_), field);
    }
  }
  return wanted;
}

std::optional<double> CaseController::estimatedTriangles() {
  if (state(Step::Surface) == StepState::Fresh && meshRun_ && meshRun_->surface) {
    return meshRun_->surface->origin.estimatedTriangles;
  }
  const std::optional<ExpectedSurface> expected = expectedSurface();
  return expected ? std::optional(expected->triangles) : std::nullopt;
}

std::optional<ExpectedSurface> CaseController::expectedSurface() {
  const Estimate wanted = estimateWanted();
  if (!wanted.phi) {
    return std::nullopt;
  }
  if (estimateKey_ == wanted.key && estimatePhi_.lock() == wanted.phi) {
    return estimate_;
  }
  requestEstimate(wanted);
  return estimateKey_ == wanted.key ? estimate_ : std::nullopt;
}

QStringList CaseController::expectationWarnings() {
  QStringList list;
  if (state(Step::Surface) == StepState::Fresh) {
    return list;
  }
  if (const std::optional<ExpectedSurface> expected = expectedSurface()) {
    for (const std::string& warning : warningsOf(*expected)) {
      list << QString::fromStdString(warning);
    }
    if (const auto why = refusal(*expected, params_.surface, SurfaceLimits::ofMachine())) {
      list << tr("Such a surface is not begun: %1.").arg(QString::fromStdString(*why));
    }
  }
  return list;
}

void CaseController::requestEstimate(const Estimate& wanted) {
  if (run_) {
    return;  // its surface step will tell
  }
  if (estimateRun_) {
    if (estimateRun_->key != wanted.key) {
      estimateRun_->progress.cancel();
    }
    return;
  }
  estimateRun_ = std::make_shared<EstimateJob>();
  estimateRun_->phi = wanted.phi;
  estimateRun_->params = params_.surface;
  estimateRun_->ports = params_.ports;
  estimateRun_->key = wanted.key;
  estimateRunner_->start([job = estimateRun_] { job->execute(); });
  if (estimateRunner_->running()) {
    timer_.start();
  } else {
    finishEstimate();
  }
}

void CaseController::finishEstimate() {
  const std::shared_ptr<EstimateJob> job = std::exchange(estimateRun_, nullptr);
  if (job->progress.cancelled()) {
    return;
  }
  estimate_ = job->expected;
  estimateKey_ = job->key;
  estimatePhi_ = job->phi;
}

void CaseController::cancelEstimate() {
  if (estimateRun_) {
    estimateRun_->progress.cancel();
  }
}

}  // namespace angiomesh
