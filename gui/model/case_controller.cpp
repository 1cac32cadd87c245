// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/case_controller.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/parameters/field.h"
#include "gui/job/component_points.h"
#include "gui/model/change_parameters.h"
#include "gui/model/step_text.h"

namespace angiomesh {

namespace {

constexpr int kPollMilliseconds = 33;

/// The file's name without extensions. A folder's name often is a patient's, so it is not used.
QString nameOf(const QString& path) {
  const QFileInfo info(path);
  if (info.isDir()) {
    return QStringLiteral("DICOM series");
  }
  QString name = info.completeBaseName();
  if (name.endsWith(QLatin1String(".nii"), Qt::CaseInsensitive)) {
    name.chop(4);
  }
  return name;
}

/// Of two fields that bound each other, the other one follows.
void pushPartner(Parameters& params, const std::string& key) {
  VesselnessParams& v = params.vesselness;
  LevelSetParams& l = params.levelset;
  SizingParams& edge = params.surface.sizing;
  if (key == "vesselness.sigmaMinMm" && v.sigmaMinMm && v.sigmaMaxMm) {
    v.sigmaMaxMm = std::max(*v.sigmaMaxMm, *v.sigmaMinMm);
  } else if (key == "vesselness.sigmaMaxMm" && v.sigmaMinMm && v.sigmaMaxMm) {
    v.sigmaMinMm = std::min(*v.sigmaMinMm, *v.sigmaMaxMm);
  } else if (key == "surface.edgeMinMm" && edge.edgeMinMm && edge.edgeMaxMm) {
    edge.edgeMaxMm = std::max(*edge.edgeMaxMm, *edge.edgeMinMm);
  } else if (key == "surface.edgeMaxMm" && edge.edgeMinMm && edge.edgeMaxMm) {
    edge.edgeMinMm = std::min(*edge.edgeMinMm, *edge.edgeMaxMm);
  } else if (key == "levelset.bMin") {
    l.bMax = std::max(l.bMax, l.bMin);
  } else if (key == "levelset.bMax") {
    l.bMin = std::min(l.bMin, l.bMax);
  }
}

/// Places and labels, unlike the rest, mean something in one image only.
void copyPlaces(const Parameters& from, Parameters& to) {
  to.preprocess.roi = from.preprocess.roi;
  to.seeds.points = from.seeds.points;
  to.segmentation.drop = from.segmentation.drop;
  to.ports.cuts = from.ports.cuts;
  to.ports.names = from.ports.names;
  if (isSegmented(from)) {
    to.segmentation.method = from.segmentation.method;
    to.segmentation.label = from.segmentation.label;
  } else if (isSegmented(to)) {
    to.segmentation.method = SegmentationParams().method;
    to.segmentation.label = SegmentationParams().label;
  }
}

/// Parameters to begin with on another image.
void forgetPlaces(const std::optional<Label>& label, Parameters& params) {
  Parameters fresh;
  if (label) {
    fresh.segmentation.method = SegmentationMethod::Label;
    fresh.segmentation.label = static_cast<int>(label->value);
  }
  copyPlaces(fresh, params);
}

}  // namespace

CaseController::CaseController(const JobRunnerFactory& makeRunner, QObject* parent,
                               const std::filesystem::path& recovery)
    : QObject(parent),
      runRunner_(makeRunner()),
      loadRunner_(makeRunner()),
      exportRunner_(makeRunner()),
      speedRunner_(makeRunner()),
      estimateRunner_(makeRunner()),
      params_(preset("angiomesh")),
      store_(makeRunner, recovery) {
  connect(&undo_, &QUndoStack::indexChanged, this, &CaseController::noteEdit);
  timer_.setInterval(kPollMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &CaseController::poll);
}

CaseController::~CaseController() {
  undo_.disconnect(this);
  cancelEstimate();
  if (run_) {
    run_->cancel();
  }
  if (load_) {
    load_->progress().cancel();
  }
  for (JobRunner* runner : {runRunner_.get(), loadRunner_.get(), exportRunner_.get(),
                            speedRunner_.get(), estimateRunner_.get()}) {
    runner->wait();
  }
}

void CaseController::say(Severity severity, const QString& text) {
  Q_EMIT message(severity, text.simplified());
}

void CaseController::open(const QString& path) {
  startLoad(std::make_shared<LoadJob>(QFileInfo(path).absoluteFilePath().toStdString(),
                                      nameOf(path).toStdString()));
}

void CaseController::openSeries(const QString& path, const ImageSummary& entry, bool evenOut) {
  startLoad(std::make_shared<LoadJob>(QFileInfo(path).absoluteFilePath().toStdString(),
                                      nameOf(path).toStdString(), entry, evenOut));
}

void CaseController::openLabel(const QString& path, const std::optional<Label>& label) {
  startLoad(std::make_shared<LoadJob>(QFileInfo(path).absoluteFilePath().toStdString(),
                                      nameOf(path).toStdString(), label));
}

void CaseController::openSample() {
  startLoad(std::make_shared<LoadJob>(std::filesystem::path(), "sample"));
}

void CaseController::take(Source source) {
  startLoad(std::make_shared<LoadJob>(std::move(source)));
}

void CaseController::startLoad(std::shared_ptr<LoadJob> job) {
  if (load_) {
    load_->progress().cancel();
    nextLoad_ = std::move(job);
    return;
  }
  load_ = std::move(job);
  loadRunner_->start([load = load_] { load->execute(); });
  timer_.start();
  Q_EMIT statesChanged();
  poll();
}

void CaseController::finishLoad() {
  const bool usable = !load_->cancelled() && load_->error().empty();
  if (usable && run_ && load_->pipeline()) {
    // The new case begins once the old one's run has let go.
    runAgain_.reset();
    run_->cancel();
    return;
  }
  const std::shared_ptr<LoadJob> job = std::exchange(load_, nullptr);
  if (!usable) {
    if (!job->cancelled()) {
      say(Severity::Error, tr("Cannot open: %1").arg(QString::fromStdString(job->error())));
    }
  } else if (const auto opening = std::dynamic_pointer_cast<const OpenCaseJob>(job)) {
    finishCase(opening);
  } else if (!job->choices().empty()) {
    Q_EMIT seriesFound(QString::fromStdString(job->path().string()), job->choices());
  } else if (!job->labels().empty()) {
    Q_EMIT labelsFound(QString::fromStdString(job->path().string()), job->labels(),
                       job->entry()->geometry.voxelVolumeMm3());
  } else if (!job->uneven().empty()) {
    Q_EMIT unevenFound(QString::fromStdString(job->path().string()), *job->entry(),
                       QString::fromStdString(job->uneven()));
  } else {
    takeLoaded(*job);
    params_ = job->startParameters().value_or(params_);
    forgetPlaces(job->label(), params_);
    store_.begin({describeSource(), params_, {}, 0}, nullptr);
    sayOpened(job->info());
    if (job->label()) {
      sayLabel(*job->label());
    }
    Q_EMIT caseChanged();
    Q_EMIT parametersChanged();
    Q_EMIT resultsChanged();
    if (!job->path().empty()) {
      const QString path = QString::fromStdString(job->path().string());
      Q_EMIT opened(path);
      Q_EMIT sourceSeen(path);
    }
  }
  Q_EMIT statesChanged();
  if (nextLoad_) {
    startLoad(std::exchange(nextLoad_, nullptr));
  }
}

void CaseController::takeLoaded(const LoadJob& job) {
  leaveCase();
  pending_.reset();
  clearResults();
  pipeline_ = job.pipeline();
  info_ = job.info();
  name_ = QString::fromStdString(pipeline_->source().name);
  window_ = job.window();
  level_ = job.level();
  undo_.clear();
}

void CaseController::sayOpened(const InputInfo& info) {
  const QString modality =
      info.modality.empty() ? QString() : tr(", ") + QString::fromStdString(info.modality);
  say(Severity::Info, tr("Opened %1: %2%3.").arg(name_, gridText(image()->geometry), modality));
  for (const std::string& warning : screenWarnings(info)) {
    say(Severity::Warning, QString::fromStdString(warning));
  }
}

void CaseController::sayLabel(const Label& label) {
  const QString name =
      label.name.empty() ? QString() : tr(" (%1)").arg(QString::fromStdString(label.name));
  say(Severity::Info, tr("Taken as a segmentation: its label %1%2, %3 voxels, is the vessel. For a "
                         "scan choose another segmentation.method.")
                          .arg(label.value)
                          .arg(name)
                          .arg(label.voxels));
}

QString CaseController::caseName() const { return name_; }

std::shared_ptr<const Volume<float>> CaseController::image() const {
  return pipeline_ ? pipeline_->source().image : nullptr;
}

void CaseController::setField(const QString& key, const FieldValue& value, bool continued) {
  Parameters after = params_;
  try {
    angiomesh::setField(after, key.toStdString(), value);
    pushPartner(after, key.toStdString());
    if (stepOfField(findField(key.toStdString())) != Step::Seeds) {
      validate(after);
    }
  } catch (const Error& failure) {
    say(Severity::Error, QString::fromStdString(failure.what()));
    Q_EMIT parametersChanged();
    return;
  }
  change(after, tr("change %1").arg(key), key, continued);
}

FieldValue CaseController::suggestedValue(const Field& field) const {
  double value = field.logarithmic && field.minimum > 0.0 ? std::sqrt(field.minimum * field.maximum)
                                                          : 0.5 * (field.minimum + field.maximum);
  const double voxel = image() ? image()->geometry.voxelMm() : 1.0;
  const auto& v = params_.vesselness;
  if (field.key == "vesselness.sigmaMinMm") {
    value = std::min(voxel, v.sigmaMaxMm.value_or(voxel));
  } else if (field.key == "vesselness.sigmaMaxMm") {
    value = shown_.vesselness ? shown_.vesselness->scalesMm.back()
                              : std::max(6.0 * voxel, v.sigmaMinMm.value_or(voxel));
  } else if (field.key == "vesselness.k") {
    value = 2.0 * v.sigmaMinMm.value_or(voxel);
  } else if (field.key == "vesselness.scales") {
    value = shown_.vesselness ? static_cast<double>(shown_.vesselness->scalesMm.size()) : 6.0;
  } else if (field.key == "vesselness.c") {
    value = shown_.vesselness ? shown_.vesselness->c : window_ * v.cFraction;
  } else if (field.key == "levelset.b") {
    value = shown_.evolve && shown_.evolve->thresholds.b > 0.0
                ? shown_.evolve->thresholds.b
                : 0.5 * (params_.levelset.bMin + params_.levelset.bMax);
  } else if (field.key == "surface.edgesAround") {
    value = SizingParams().edgesAround;
  } else if (field.key == "surface.edgeMinVoxels") {
    value = SizingParams().edgeMinVoxels.value_or(1.0);
  } else if (field.key == "surface.edgeMinMm") {
    value = std::min(0.2 * voxel, params_.surface.sizing.edgeMaxMm.value_or(voxel));
  } else if (field.key == "surface.edgeMaxMm") {
    value = std::max(2.0 * voxel, params_.surface.sizing.edgeMinMm.value_or(voxel));
  } else if (field.key == "preprocess.sigmoid.window") {
    value = window_;
  } else if (field.key == "comparison.gac.alpha") {
    value = -window_ / 12.0;
  } else if (field.key == "comparison.gac.beta") {
    value = 0.25 * window_;
  } else if (field.key == "comparison.threshold.upper" || field.key == "preprocess.clamp.upper") {
    value = level_ + window_;
  } else if (field.key == "preprocess.sigmoid.level" || field.key == "comparison.threshold.lower") {
    value = level_;
  } else if (field.key == "preprocess.clamp.lower") {
    value = level_ - window_;
  }
  value = std::clamp(value, field.minimum, field.maximum);
  switch (field.kind) {
    case FieldKind::Integer:
      return static_cast<std::int64_t>(std::lround(value));
    case FieldKind::Real:
      return value;
    case FieldKind::Boolean:
      return true;
    case FieldKind::Choice:
      return field.choices.empty() ? std::string() : field.choices.front();
    case FieldKind::Texts:
      return std::vector<std::string>();
    case FieldKind::Numbers:
      break;
  }
  return std::vector<double>();
}

void CaseController::applyPreset(const QString& name) {
  Parameters after = preset(name.toStdString());
  copyPlaces(params_, after);
  change(after, tr("preset %1").arg(name));
}

QString CaseController::presetName() const {
  for (const std::string& name : presetNames()) {
    Parameters candidate = preset(name);
    copyPlaces(params_, candidate);
    if (parametersToJson(candidate) == parametersToJson(params_)) {
      return QString::fromStdString(name);
    }
  }
  return {};
}

std::vector<Eigen::Vector3d> CaseController::seeds() const {
  std::vector<Eigen::Vector3d> points;
  const std::vector<double>& numbers = params_.seeds.points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return points;
}

void CaseController::addSeed(const Eigen::Vector3d& lps) {
  std::vector<double> points = params_.seeds.points;
  points.insert(points.end(), {lps[0], lps[1], lps[2]});
  Parameters after = params_;
  after.seeds.points = points;
  change(after, tr("add a seed"));
}

void CaseController::removeSeed(int index) {
  Parameters after = params_;
  std::vector<double>& points = after.seeds.points;
  const auto at = static_cast<std::ptrdiff_t>(index) * 3;
  if (index < 0 || at + 3 > static_cast<std::ptrdiff_t>(points.size())) {
    return;
  }
  points.erase(points.begin() + at, points.begin() + at + 3);
  change(after, tr("remove a seed"));
}

void CaseController::setRoi(const std::optional<std::array<double, 6>>& roi) {
  if (roi && image()) {
    try {
      (void)cropToBox(*image(), *roi);
    } catch (const Error& failure) {
      say(Severity::Error, QString::fromStdString(failure.what()));
      return;
    }
  }
  Parameters after = params_;
  after.preprocess.roi = roi;
  change(after, roi ? tr("draw the region of interest") : tr("clear the region of interest"));
}

QString CaseController::setCuts(const std::vector<std::string>& cuts, const QString& what) {
  PortParams ports = params_.ports;
  ports.cuts = cuts;
  return setPorts(ports, what);
}

QString CaseController::setPorts(const PortParams& ports, const QString& what) {
  Parameters after = params_;
  after.ports = ports;
  try {
    checkPorts(after.ports);
  } catch (const Error& failure) {
    return QString::fromStdString(failure.what()).simplified();
  }
  change(after, what);
  return {};
}

void CaseController::change(const Parameters& after, const QString& text, const QString& mergeKey,
                            bool continued) {
  if (parametersToJson(after) == parametersToJson(params_)) {
    Q_EMIT parametersChanged();
    return;
  }
  undo_.push(new ChangeParameters(*this, params_, after, text, mergeKey, continued));
}

void CaseController::replaceParameters(const Parameters& params) {
  params_ = params;
  interruptRun();
  Q_EMIT parametersChanged();
  refreshFromCache();
  Q_EMIT statesChanged();
}

std::vector<std::size_t> CaseController::dropsIn(const SegmentComponent& component,
                                                 const Parameters& params) const {
  const std::vector<double>& drop = params.segmentation.drop;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i + 2 < drop.size(); i += 3) {
    if (Eigen::Vector3d(drop[i], drop[i + 1], drop[i + 2]).isApprox(component.innerPointLps)) {
      found.push_back(i / 3);
    }
  }
  // Points from an earlier evolution or another program may lie elsewhere in the component.
  if (found.empty() && !component.kept && !drop.empty() && meshRun_ && meshRun_->evolve) {
    return pointsInComponent(*meshRun_->evolve->phi, component.innerPointLps, drop);
  }
  return found;
}

std::vector<ComponentRow> CaseController::components() const {
  std::vector<ComponentRow> rows;
  if (!meshRun_ || !meshRun_->surface) {
    return rows;
  }
  for (const SegmentComponent& component : meshRun_->surface->components) {
    ComponentRow row;
    row.voxels = component.voxels;
    row.volumeMm3 = component.volumeMm3;
    row.measure = component.measure;
    row.byRule = !component.kept && dropsIn(component, meshRun_->params).empty();
    row.ticked = !row.byRule && dropsIn(component, params_).empty();
    rows.push_back(row);
  }
  return rows;
}

void CaseController::setComponentTicked(int index, bool ticked) {
  if (!meshRun_ || !meshRun_->surface || index < 0 ||
      index >= static_cast<int>(meshRun_->surface->components.size())) {
    return;
  }
  const SegmentComponent& component =
      meshRun_->surface->components[static_cast<std::size_t>(index)];
  Parameters after = params_;
  std::vector<double>& drop = after.segmentation.drop;
  const std::vector<std::size_t> known = dropsIn(component, params_);
  if (ticked) {
    for (auto i = known.rbegin(); i != known.rend(); ++i) {
      const auto at = drop.begin() + static_cast<std::ptrdiff_t>(3 * *i);
      drop.erase(at, at + 3);
    }
  } else if (known.empty()) {
    const Eigen::Vector3d& p = component.innerPointLps;
    drop.insert(drop.end(), {p[0], p[1], p[2]});
  }
  change(after, ticked ? tr("tick a part on") : tr("tick a part off"));
}

}  // namespace angiomesh
