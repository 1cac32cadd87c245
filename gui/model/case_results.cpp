// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "core/parameters/field.h"
#include "gui/model/case_controller.h"

namespace angiomesh {

void CaseController::clearResults() {
  shown_ = RunResult();
  keys_.fill({});
  meshRun_.reset();
  facts_.reset();
  livePhi_.reset();
  liveSurface_.reset();
  speed_.reset();
  speedKey_.clear();
  failedKey_.clear();
  iterations_ = 0;
  change_ = -1.0;
  history_.clear();
}

StepState CaseController::state(Step step) const {
  const std::string& key = keys_[static_cast<std::size_t>(step)];
  if (!pipeline_) {
    return StepState::Empty;
  }
  if (isSegmented(params_) && (step == Step::Vesselness || step == Step::Seeds)) {
    return StepState::NotNeeded;
  }
  const std::string now = pipeline_->key(step, params_);
  // What follows from an evolution that was ended by hand has a key, but is computed again.
  const bool wanted = key != now || !pipeline_->has(step, params_);
  if (run_ && !quietRun_ && wanted && pipeline_->key(step, run_->params()) == now) {
    const Step atWork = run_->step();
    if (step == atWork) {
      return StepState::Running;
    }
    if (step < atWork) {
      return StepState::Fresh;  // computed, and on its way here
    }
  }
  if (!failedKey_.empty() && step == failedStep_ && failedKey_ == now) {
    return StepState::Failed;
  }
  if (key.empty()) {
    return StepState::Empty;
  }
  return key == now ? StepState::Fresh : StepState::Stale;
}

std::pair<double, double> CaseController::sliderRange(const Field& field) const {
  double low = field.minimum;
  double high = field.maximum;
  const double voxel = image() ? image()->geometry.voxelMm() : 1.0;
  if (field.key == "vesselness.sigmaMinMm" || field.key == "vesselness.sigmaMaxMm" ||
      field.key == "vesselness.k") {
    low = 0.4 * voxel;
    high = 30.0 * voxel;
  } else if (field.key == "surface.edgeMinMm" || field.key == "surface.edgeMaxMm") {
    low = 0.02 * voxel;
    high = 20.0 * voxel;
  } else if (field.key == "surface.edgeMinVoxels") {
    low = 0.1;
    high = 4.0;
  } else if (field.key == "surface.rho") {
    low = 0.02;
    high = 1.2;
  } else if (field.key == "surface.edgesAround") {
    high = 48.0;
  } else if (field.key == "preprocess.sigmoid.window") {
    low = 0.01 * window_;
    high = 3.0 * window_;
  } else if (field.key == "comparison.gac.alpha") {
    low = -window_;
  } else if (field.key == "comparison.gac.beta") {
    high = 2.0 * window_;
  } else if (field.key == "preprocess.sigmoid.level" || field.key == "comparison.threshold.lower" ||
             field.key == "comparison.threshold.upper" || field.key == "preprocess.clamp.lower" ||
             field.key == "preprocess.clamp.upper") {
    low = level_ - window_;
    high = level_ + 2.0 * window_;
  } else if (field.key == "segmentation.minVolumeMm3" || field.key == "surface.minComponentMm3") {
    high = image() ? 0.01 * static_cast<double>(image()->geometry.voxelCount()) *
                         image()->geometry.voxelVolumeMm3()
                   : 1e4;
  } else if (field.key == "segmentation.label") {
    high = image() ? static_cast<double>(valueRange(*image())[1]) : 1.0;
  } else if (field.key == "levelset.maxIterations") {
    high = 20000.0;
  } else if (field.key == "levelset.checkEvery" || field.key == "smooth.iterations") {
    high = 500.0;
  }
  return {std::max(low, field.minimum), std::min(high, field.maximum)};
}

std::optional<Step> CaseController::stepInWork() const {
  return run_ && !quietRun_ ? std::optional(run_->step()) : std::nullopt;
}

double CaseController::runFraction() const { return run_ ? run_->fraction() : 0.0; }

double CaseController::stepFraction() const { return run_ ? run_->stepFraction() : 0.0; }

QString CaseController::failure(Step step) const {
  return state(step) == StepState::Failed ? failedText_ : QString();
}

double CaseController::seconds(Step step) const {
  const auto i = static_cast<std::size_t>(step);
  const bool shown =
      !keys_[i].empty() && i < shown_.stages.size() && keys_[i] == pipeline_->key(step, params_);
  return shown ? shown_.stages[i].seconds : -1.0;
}

double CaseController::change() const { return change_; }

std::pair<double, double> CaseController::windowLevel(Layer layer) const {
  switch (layer) {
    case Layer::Vesselness:
      return {0.6, 0.3};
    case Layer::Speed:
      return {2.0, 0.0};
    case Layer::Source:
    case Layer::Preprocessed:
      break;
  }
  return {window_, level_};
}

std::shared_ptr<const Volume<float>> CaseController::layer(Layer layer) {
  switch (layer) {
    case Layer::Source:
      return image();
    case Layer::Preprocessed:
      return shown_.preprocessed;
    case Layer::Vesselness:
      return shown_.vesselness ? shown_.vesselness->multiScale : nullptr;
    case Layer::Speed:
      if (speedKey_ != speedKey()) {
        requestSpeed();
      }
      return speed_;
  }
  return nullptr;
}

std::shared_ptr<const VesselnessResult> CaseController::vesselnessResult() const {
  return shown_.vesselness;
}

std::shared_ptr<const Volume<float>> CaseController::phi() const {
  if (livePhi_) {
    return livePhi_;
  }
  if (meshRun_ && meshRun_->surface && meshRun_->evolve == shown_.evolve) {
    return meshRun_->surface->phi;
  }
  return shown_.evolve ? shown_.evolve->phi : nullptr;
}

std::shared_ptr<const Volume<float>> CaseController::uncutPhi() const {
  if (meshRun_ && meshRun_->surface && meshRun_->evolve == shown_.evolve) {
    return meshRun_->surface->uncutPhi;
  }
  return shown_.evolve ? shown_.evolve->phi : nullptr;
}

std::vector<Port> CaseController::ports(MeshKind kind) const {
  const std::shared_ptr<const TriMesh> shown = mesh(kind);
  if (!shown || shown->patch.empty()) {
    return {};
  }
  std::vector<Port> ports = meshRun_->surface->ports;
  if (kind == MeshKind::Exported) {
    ports = meshRun_->ports;
    for (std::size_t n = 0; n < ports.size(); ++n) {
      ports[n].name = meshRun_->surface->ports[n].name;
    }
  }
  (void)namePorts(params_.ports, ports);  // names are given at once, without a run
  return ports;
}

std::shared_ptr<const TriMesh> CaseController::mesh(MeshKind kind) const {
  if (!meshRun_) {
    return nullptr;
  }
  switch (kind) {
    case MeshKind::Exported:
      return meshRun_->smoothed;
    case MeshKind::Unsmoothed:
      return meshRun_->surface ? meshRun_->surface->mesh : nullptr;
    case MeshKind::MarchingCubes:
      return meshRun_->surface ? meshRun_->surface->marchingCubes : nullptr;
  }
  return nullptr;
}

const MeshQuality* CaseController::quality(MeshKind kind) const {
  if (!meshRun_ || !meshRun_->quality) {
    return nullptr;
  }
  const QualityResult& quality = *meshRun_->quality;
  switch (kind) {
    case MeshKind::Exported:
      return &quality.mesh;
    case MeshKind::Unsmoothed:
      return &quality.unsmoothed;
    case MeshKind::MarchingCubes:
      return &quality.marchingCubes;
  }
  return nullptr;
}

const SurfaceOrigin* CaseController::surfaceOrigin() const {
  return meshRun_ && meshRun_->surface ? &meshRun_->surface->origin : nullptr;
}

bool CaseController::meshFresh() const { return state(Step::Smooth) == StepState::Fresh; }

}  // namespace angiomesh
