// SPDX-License-Identifier: BSD-3-Clause
#include "gui/findings/mesh_inspection.h"

#include <algorithm>

namespace angiomesh {

namespace {

/// In edges of the triangle, to be seen around it.
constexpr double kEdgesAround = 12.0;

using Meshes = std::array<std::shared_ptr<const TriMesh>, kMeshKindCount>;

Meshes meshesAtHand(const ResultModel& results) {
  Meshes meshes;
  for (std::size_t kind = 0; kind < meshes.size(); ++kind)
    meshes[kind] = results.mesh(static_cast<MeshKind>(kind));
  return meshes;
}

}  // namespace

MeshInspection::MeshInspection(CaseModels& models, ViewState& state,
                               const JobRunnerFactory& makeRunner, QObject* parent)
    : QObject(parent),
      models_(models),
      state_(state),
      slot_(models.timer, makeRunner,
            [this](const std::shared_ptr<InspectJob>& job) { finish(*job); }) {
  connect(&models_.results, &ResultModel::resultsChanged, this, &MeshInspection::refresh);
  connect(&state_, &ViewState::changed, this, &MeshInspection::refresh);
}

MeshInspection::~MeshInspection() {
  if (slot_) slot_.job()->progress.cancel();
}

const TriangleMeasure& MeshInspection::measure() const {
  return state_.meshColour() ? *state_.meshColour() : triangleMeasures().front();
}

const MeasuredMeshes::Of* MeshInspection::of(const TriMesh* mesh, MeshKind kind) const {
  if (!measured_ || mesh == nullptr || measured_->measure != &measure()) return nullptr;
  const MeasuredMeshes::Of& of = measured_->of(kind);
  return of.mesh.get() == mesh ? &of : nullptr;
}

void MeshInspection::refresh() {
  const Meshes meshes = meshesAtHand(models_.results);
  const TriangleMeasure* wanted = &measure();
  if (slot_) {
    if (slot_.job()->measure != wanted || slot_.job()->meshes != meshes)
      slot_.job()->progress.cancel();
    return;
  }
  const bool any = std::any_of(meshes.begin(), meshes.end(), [](const auto& m) { return !!m; });
  if (!any) {
    if (!measured_) return;
    measured_.reset();
    unlight();
    Q_EMIT changed();
    return;
  }
  if (measured_ && measured_->measure == wanted &&
      std::equal(meshes.begin(), meshes.end(), measured_->meshes.begin(),
                 [](const auto& mesh, const MeasuredMeshes::Of& of) { return mesh == of.mesh; }))
    return;
  auto job = std::make_shared<InspectJob>();
  job->measure = wanted;
  job->meshes = meshes;
  slot_.startAndPoll(std::move(job));
}

void MeshInspection::finish(const InspectJob& job) {
  if (job.measured && !job.progress.cancelled()) {
    measured_ = job.measured;
    unlight();
    Q_EMIT changed();
  }
  if (job.progress.cancelled()) refresh();
}

void MeshInspection::unlight() {
  bars_.reset();
  triangle_.reset();
  Q_EMIT litChanged();
}

void MeshInspection::lightBars(std::optional<std::pair<int, int>> bars) {
  if (bars == bars_ && !triangle_) return;
  bars_ = bars;
  triangle_.reset();
  Q_EMIT litChanged();
}

void MeshInspection::goToWorst(std::size_t index) {
  const MeshKind kind = models_.results.kindAtHand(state_.meshKind());
  if (!measured_ || index >= measured_->of(kind).worst.size()) return;
  const WorstPlace& place = measured_->of(kind).worst[index];
  bars_.reset();
  triangle_ = {kind, place.triangle};
  Q_EMIT litChanged();
  Q_EMIT goTo(place.centreLps, place.normal, kEdgesAround * place.edgeMm);
}

std::vector<std::uint32_t> MeshInspection::lit(MeshKind kind) const {
  std::vector<std::uint32_t> triangles;
  if (!measured_) return triangles;
  if (triangle_ && triangle_->first == kind) triangles.push_back(triangle_->second);
  if (!bars_) return triangles;
  const std::vector<float>& values = measured_->of(kind).values;
  for (std::uint32_t t = 0; t < values.size(); ++t) {
    const int bar = measured_->barOf(values[t]);
    if (bar >= bars_->first && bar <= bars_->second) triangles.push_back(t);
  }
  return triangles;
}

}  // namespace angiomesh
