// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/result_model.h"

#include <QScopedValueRollback>
#include <algorithm>
#include <utility>

#include "core/pipeline/expected_surface.h"

namespace angiomesh {

ResultModel::ResultModel(CaseDocument& document, MessageLog& log, JobTimer& timer,
                         const JobRunnerFactory& makeRunner, QObject* parent)
    : QObject(parent),
      document_(document),
      log_(log),
      speedSlot_(timer, makeRunner,
                 [this](const std::shared_ptr<SpeedJob>& job) { finishSpeed(*job); }),
      estimateSlot_(timer, makeRunner,
                    [this](const std::shared_ptr<EstimateJob>& job) { finishEstimate(*job); }),
      outlineSlot_(timer, makeRunner,
                   [this](const std::shared_ptr<OutlineJob>& job) { finishOutline(*job); }),
      frontSlot_(timer, makeRunner,
                 [this](const std::shared_ptr<FrontJob>& job) { finishFront(*job); }) {}

ResultModel::~ResultModel() {
  cancelEstimate();
  if (outlineSlot_) outlineSlot_.job()->progress.cancel();
  if (frontSlot_) frontSlot_.job()->progress.cancel();
}

void ResultModel::clear() {
  shown_ = RunResult();
  keys_.fill({});
  reports_.fill({});
  meshRun_.reset();
  fileMesh_.reset();
  fileQuality_.reset();
  names_.clear();
  segmentation_ = ofEvolution_ = meshOf_ = 0;
  livePhi_.reset();
  liveSurface_.reset();
  speed_.reset();
  speedKey_.clear();
  outline_.reset();
  outlined_.reset();
  wanted_.reset();
  front_ = {};
}

void ResultModel::accept(const StepResult& result) {
  const RunResult& run = *result.run;
  const auto i = static_cast<std::size_t>(result.step);
  keys_[i] = result.key;
  for (const StageReport& stage : run.stages)
    if (stage.step == result.step) reports_[i] = stage;
  switch (result.step) {
    case Step::Preprocess:
      shown_.preprocessed = run.preprocessed;
      break;
    case Step::Vesselness:
      shown_.vesselness = run.vesselness;
      break;
    case Step::Seeds:
      shown_.seeds = run.seeds;
      break;
    case Step::Evolve:
      if (run.evolve != shown_.evolve) {
        const bool byHand = endedByHand(*run.evolve, run.params);
        segmentation_ = ofEvolution_ = names_.segmentation(byHand ? std::string() : result.key);
      }
      if (run.evolve != shown_.evolve) shown_.corrected.reset();
      shown_.evolve = run.evolve;
      evolveParams_ = run.params;
      if (run.params.segmentation.corrections.empty()) {
        // Nothing is left to be made for it.
        shown_.corrected = run.evolve;
        keys_[static_cast<std::size_t>(Step::Correct)] = result.key;
      }
      livePhi_.reset();
      liveSurface_.reset();
      wanted_.reset();
      front_ = {};
      break;
    case Step::Correct:
      if (!run.corrected->corrections.empty())
        segmentation_ = names_.corrected(
            ofEvolution_, endedByHand(*run.evolve, run.params) ? std::string() : result.key);
      else
        segmentation_ = ofEvolution_;
      shown_.corrected = run.corrected;
      evolveParams_ = run.params;
      break;
    case Step::Surface:
    case Step::Smooth:
    case Step::Quality:
      meshRun_ = result.run;
      meshOf_ = segmentation_;
      meshName_ = names_.mesh(segmentation_, document_.pipeline()->key(Step::Smooth, run.params));
      break;
    case Step::Load:
      break;
  }
}

bool ResultModel::setLive(std::shared_ptr<const Volume<float>> phi,
                          std::shared_ptr<const TriMesh> surface) {
  const bool before = livePhi_ || liveSurface_;
  livePhi_ = std::move(phi);
  liveSurface_ = std::move(surface);
  return before;
}

bool ResultModel::fresh(Step step) const {
  return document_.hasCase() && !key(step).empty() && key(step) == document_.key(step);
}

bool ResultModel::layerFresh(Layer layer) const {
  switch (layer) {
    case Layer::Source:
      break;
    case Layer::Preprocessed:
      return fresh(Step::Preprocess);
    case Layer::Vesselness:
      return fresh(Step::Vesselness);
    case Layer::Speed:
      return fresh(Step::Vesselness) &&
             speedKey_ == document_.pipeline()->speedKey(document_.parameters());
  }
  return true;
}

QString ResultModel::segmentationName() const {
  return segmentation_ > 0 ? names_.name(segmentation_) : QString();
}

double ResultModel::seconds(Step step) const { return fresh(step) ? report(step).seconds : -1.0; }

WindowLevel ResultModel::windowLevel(Layer layer) const {
  switch (layer) {
    case Layer::Vesselness:
      return {0.6, 0.3};
    case Layer::Speed:
      return {2.0, 0.0};
    case Layer::Source:
    case Layer::Preprocessed:
      break;
  }
  return document_.display().window();
}

std::shared_ptr<const Volume<float>> ResultModel::layer(Layer layer) {
  switch (layer) {
    case Layer::Source:
      return document_.image();
    case Layer::Preprocessed:
      return shown_.preprocessed;
    case Layer::Vesselness:
      return shown_.vesselness ? shown_.vesselness->multiScale : nullptr;
    case Layer::Speed:
      break;
  }
  if (!shown_.vesselness) return nullptr;
  const std::string wanted = document_.pipeline()->speedKey(document_.parameters());
  if (speedKey_ != wanted && !speedSlot_) {
    auto job = std::make_shared<SpeedJob>();
    job->vesselness = shown_.vesselness;
    job->params = document_.parameters().thresholds;
    job->key = wanted;
    const QScopedValueRollback<bool> quiet(quiet_, true);
    speedSlot_.startAndPoll(std::move(job));
  }
  return speed_;
}

void ResultModel::finishSpeed(const SpeedJob& job) {
  if (job.vesselness != shown_.vesselness) return;
  speed_ = job.speed;
  speedKey_ = job.key;
  if (!job.error.empty()) log_.say(Severity::Error, job.error);
  if (!quiet_) Q_EMIT resultsChanged();
}

void ResultModel::showFront(std::shared_ptr<const KeptFront> front) {
  if (front == wanted_) return;
  wanted_ = std::move(front);
  if (wanted_) {
    makeFront();
    return;
  }
  front_ = {};
  Q_EMIT resultsChanged();
}

void ResultModel::makeFront() {
  if (frontSlot_ || !wanted_) return;
  auto job = std::make_shared<FrontJob>();
  job->front = wanted_;
  frontSlot_.startAndPoll(std::move(job));
}

void ResultModel::finishFront(const FrontJob& job) {
  if (job.front != wanted_) {
    makeFront();
    return;
  }
  front_ = {job.front->iterations, job.phi, job.surface};
  Q_EMIT resultsChanged();
}

std::shared_ptr<const Volume<float>> ResultModel::phi() const {
  if (front_.phi) return front_.phi;
  if (livePhi_) return livePhi_;
  if (meshFits() && meshRun_->surface) return meshRun_->surface->phi;
  return segmentation() ? segmentation()->phi : nullptr;
}

std::shared_ptr<const Volume<float>> ResultModel::uncutPhi() const {
  if (meshFits() && meshRun_->surface) return meshRun_->surface->uncutPhi;
  return segmentation() ? segmentation()->phi : nullptr;
}

std::shared_ptr<ReasonJob> ResultModel::groundsOfSegmentation() const {
  if (!shown_.evolve || !shown_.vesselness || !shown_.vesselness->multiScale ||
      !shown_.preprocessed || !evolves(evolveParams_))
    return nullptr;
  const Pipeline& pipeline = *document_.pipeline();
  for (const Step step : {Step::Preprocess, Step::Vesselness})
    if (key(step) != pipeline.key(step, evolveParams_)) return nullptr;
  auto job = std::make_shared<ReasonJob>();
  job->image = shown_.preprocessed;
  job->vessels = shown_.vesselness;
  job->evolve = shown_.evolve;
  job->keptPhi = uncutPhi();
  job->params = evolveParams_;
  return job;
}

std::shared_ptr<const RunResult> ResultModel::segmentationRun() const {
  if (!shown_.evolve) return nullptr;
  if (meshFits() && meshRun_->surface) return meshRun_;
  auto run = std::make_shared<RunResult>();
  run->source = document_.pipeline()->source();
  run->evolve = shown_.evolve;
  run->corrected = shown_.corrected;
  run->params = evolveParams_;
  SegmentationParams& parts = run->params.segmentation;
  const SegmentationParams& present = document_.parameters().segmentation;
  parts.keep = present.keep;
  parts.minVolumeMm3 = present.minVolumeMm3;
  parts.minLengthMm = present.minLengthMm;
  parts.drop = present.drop;
  run->params.seeds.points = document_.parameters().seeds.points;
  return run;
}

std::vector<std::size_t> ResultModel::dropsIn(const SegmentComponent& component,
                                              const Parameters& params) {
  const std::vector<double>& drop = params.segmentation.drop;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i + 2 < drop.size(); i += 3) {
    const Eigen::Vector3d point(drop[i], drop[i + 1], drop[i + 2]);
    // Points from an earlier evolution or another program may lie elsewhere in the component.
    if (point.isApprox(component.innerPointLps) ||
        std::count(component.droppedBy.begin(), component.droppedBy.end(), point) > 0)
      found.push_back(i / 3);
  }
  return found;
}

std::vector<ComponentRow> ResultModel::components() const {
  std::vector<ComponentRow> rows;
  if (!meshRun_ || !meshRun_->surface) return rows;
  for (const SegmentComponent& component : meshRun_->surface->components) {
    ComponentRow row;
    row.voxels = component.voxels;
    row.volumeMm3 = component.volumeMm3;
    row.measure = component.measure;
    row.byRule = !component.kept && dropsIn(component, meshRun_->params).empty();
    row.ticked = !row.byRule && dropsIn(component, document_.parameters()).empty();
    rows.push_back(row);
  }
  return rows;
}

void ResultModel::setComponentTicked(int index, bool ticked) {
  if (!meshRun_ || !meshRun_->surface || index < 0 ||
      index >= static_cast<int>(meshRun_->surface->components.size()))
    return;
  const SegmentComponent& component =
      meshRun_->surface->components[static_cast<std::size_t>(index)];
  Parameters after = document_.parameters();
  std::vector<double>& drop = after.segmentation.drop;
  const std::vector<std::size_t> known = dropsIn(component, document_.parameters());
  if (ticked) {
    for (auto i = known.rbegin(); i != known.rend(); ++i) {
      const auto at = drop.begin() + static_cast<std::ptrdiff_t>(3 * *i);
      drop.erase(at, at + 3);
    }
  } else if (known.empty()) {
    const Eigen::Vector3d& p = component.innerPointLps;
    drop.insert(drop.end(), {p[0], p[1], p[2]});
  }
  document_.change(after, ticked ? tr("tick a part on") : tr("tick a part off"));
}

std::vector<Eigen::Vector3d> ResultModel::innerPoints() const {
  std::vector<Eigen::Vector3d> points;
  if (!meshRun_ || !meshRun_->surface) return points;
  for (const SegmentComponent& component : meshRun_->surface->components)
    points.push_back(component.innerPointLps);
  return points;
}

void ResultModel::keepOnlyComponent(int index) {
  const std::vector<ComponentRow> rows = components();
  const std::vector<Eigen::Vector3d> points = innerPoints();
  if (index < 0 || index >= static_cast<int>(rows.size())) return;
  Parameters after = document_.parameters();
  after.segmentation.drop.clear();
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<int>(i) != index && !rows[i].byRule)
      after.segmentation.drop.insert(after.segmentation.drop.end(), points[i].begin(),
                                     points[i].end());
  document_.change(after, tr("keep only one part"));
}

void ResultModel::setFileMesh(std::shared_ptr<const TriMesh> mesh,
                              std::shared_ptr<const MeshQuality> quality) {
  fileMesh_ = std::move(mesh);
  fileQuality_ = std::move(quality);
  Q_EMIT resultsChanged();
}

std::shared_ptr<const TriMesh> ResultModel::mesh(MeshKind kind) const {
  if (kind == MeshKind::File) return fileMesh_;
  if (!meshRun_) return nullptr;
  switch (kind) {
    case MeshKind::Exported:
      return meshRun_->smoothed;
    case MeshKind::Unsmoothed:
      return meshRun_->surface ? meshRun_->surface->mesh : nullptr;
    case MeshKind::MarchingCubes:
      return meshRun_->surface ? meshRun_->surface->marchingCubes : nullptr;
    case MeshKind::File:
      break;
  }
  return nullptr;
}

std::shared_ptr<const TriMesh> ResultModel::outline() {
  if (meshFits() || !segmentation()) return nullptr;
  if (outlined_ == segmentation()) return outline_;
  if (outlineSlot_) {
    if (outlineSlot_.job()->evolve != segmentation()) outlineSlot_.job()->progress.cancel();
    return nullptr;
  }
  auto job = std::make_shared<OutlineJob>();
  job->evolve = segmentation();
  const QScopedValueRollback<bool> quiet(quiet_, true);
  outlineSlot_.startAndPoll(std::move(job));
  return outlined_ == segmentation() ? outline_ : nullptr;
}

void ResultModel::finishOutline(const OutlineJob& job) {
  if (!job.progress.cancelled()) {
    outline_ = job.surface;
    outlined_ = job.evolve;
  }
  if (!quiet_) Q_EMIT resultsChanged();
}

MeshKind ResultModel::kindAtHand(MeshKind wanted) const {
  if (wanted == MeshKind::File && !fileMesh_) wanted = MeshKind::Exported;
  return wanted == MeshKind::Exported && !mesh(wanted) ? MeshKind::Unsmoothed : wanted;
}

std::vector<Port> ResultModel::ports(MeshKind kind) const {
  const std::shared_ptr<const TriMesh> shown = mesh(kind);
  if (!shown || shown->patch.empty() || !isOurs(kind)) return {};
  std::vector<Port> ports = meshRun_->surface->ports;
  if (kind == MeshKind::Exported) {
    ports = meshRun_->ports;
    for (std::size_t n = 0; n < ports.size(); ++n) ports[n].name = meshRun_->surface->ports[n].name;
  }
  // Names are given at once, without a run.
  (void)namePorts(document_.parameters().ports, ports);
  return ports;
}

const MeshQuality* ResultModel::quality(MeshKind kind) const {
  if (kind == MeshKind::File) return fileQuality_.get();
  if (!meshRun_ || !meshRun_->quality) return nullptr;
  const QualityResult& quality = *meshRun_->quality;
  switch (kind) {
    case MeshKind::Exported:
      return &quality.mesh;
    case MeshKind::Unsmoothed:
      return &quality.unsmoothed;
    case MeshKind::MarchingCubes:
      return &quality.marchingCubes;
    case MeshKind::File:
      break;
  }
  return nullptr;
}

const SurfaceOrigin* ResultModel::surfaceOrigin() const {
  return meshRun_ && meshRun_->surface ? &meshRun_->surface->origin : nullptr;
}

std::optional<double> ResultModel::estimatedTriangles() {
  if (fresh(Step::Surface) && meshRun_ && meshRun_->surface)
    return meshRun_->surface->origin.estimatedTriangles;
  const std::optional<ExpectedSurface> expected = expectedSurface();
  return expected ? std::optional(expected->triangles) : std::nullopt;
}

std::optional<ExpectedSurface> ResultModel::expectedSurface() {
  const Parameters& params = document_.parameters();
  const std::shared_ptr<const Volume<float>> phi = uncutPhi();
  if (params.surface.method == SurfaceMethod::MarchingCubes || !phi) return std::nullopt;
  const std::string wanted = document_.key(Step::Surface);
  if (estimateKey_ == wanted && estimatePhi_.lock() == phi) return estimate_;
  if (estimateSlot_) {
    if (estimateSlot_.job()->key != wanted) cancelEstimate();
  } else if (!running_) {
    auto job = std::make_shared<EstimateJob>();
    job->phi = phi;
    job->surface = params.surface;
    job->ports = params.ports;
    job->key = wanted;
    const QScopedValueRollback<bool> quiet(quiet_, true);
    estimateSlot_.startAndPoll(std::move(job));
  }
  return estimateKey_ == wanted ? estimate_ : std::nullopt;
}

void ResultModel::finishEstimate(const EstimateJob& job) {
  if (!job.progress.cancelled()) {
    estimate_ = job.expected;
    estimateKey_ = job.key;
    estimatePhi_ = job.phi;
  }
  if (!quiet_) Q_EMIT resultsChanged();
}

void ResultModel::cancelEstimate() {
  if (estimateSlot_) estimateSlot_.job()->progress.cancel();
}

QStringList ResultModel::expectationWarnings() {
  QStringList list;
  if (fresh(Step::Surface)) return list;
  if (const std::optional<ExpectedSurface> expected = expectedSurface()) {
    for (const std::string& warning : warningsOf(*expected))
      list << QString::fromStdString(warning);
    if (const auto why =
            refusal(*expected, document_.parameters().surface, SurfaceLimits::ofMachine()))
      list << tr("Such a surface is not begun: %1.").arg(QString::fromStdString(*why));
  }
  return list;
}

FieldContext ResultModel::fieldContext() const {
  FieldContext context = document_.facts();
  if (shown_.vesselness) {
    context.scalesMm = shown_.vesselness->scalesMm;
    context.c = shown_.vesselness->c;
  }
  if (shown_.evolve && shown_.evolve->thresholds.b > 0.0) context.b = shown_.evolve->thresholds.b;
  return context;
}

}  // namespace angiomesh
