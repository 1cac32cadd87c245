// SPDX-License-Identifier: BSD-3-Clause
#include "gui/findings/mesh_file.h"

#include <utility>

namespace angiomesh {

namespace {

std::shared_ptr<const SurfaceResult> surfaceOf(const ResultModel& results) {
  return results.meshRun() ? results.meshRun()->surface : nullptr;
}

}  // namespace

MeshFile::MeshFile(CaseModels& models, ViewState& state, const JobRunnerFactory& makeRunner,
                   QObject* parent)
    : QObject(parent),
      models_(models),
      state_(state),
      slot_(models.timer, makeRunner,
            [this](const std::shared_ptr<MeshFileJob>& job) { finish(*job); }) {
  connect(&models_.files, &CaseFiles::caseChanged, this, &MeshFile::leave);
  connect(&models_.results, &ResultModel::resultsChanged, this, &MeshFile::refresh);
}

MeshFile::~MeshFile() {
  if (slot_) slot_.job()->progress.cancel();
}

void MeshFile::open(const QString& path) {
  auto job = std::make_shared<MeshFileJob>();
  job->path = path.toStdString();
  start(std::move(job));
}

void MeshFile::leave() {
  next_.reset();
  if (slot_) slot_.job()->progress.cancel();
  if (!mesh_) return;
  mesh_.reset();
  against_.reset();
  name_.clear();
  limits_.clear();
  if (state_.meshKind() == MeshKind::File) state_.setMeshKind(MeshKind::Exported);
  if (state_.besideKind() == MeshKind::File) state_.setBesideKind(MeshKind::MarchingCubes);
  models_.results.setFileMesh(nullptr, nullptr);
  Q_EMIT changed();
}

void MeshFile::refresh() {
  if (!mesh_ || slot_ || against_ == surfaceOf(models_.results)) return;
  auto job = std::make_shared<MeshFileJob>();
  job->path = name_.toStdString();
  job->mesh = mesh_;
  start(std::move(job));
}

void MeshFile::start(std::shared_ptr<MeshFileJob> job) {
  if (slot_) {
    slot_.job()->progress.cancel();
    next_ = std::move(job);
    return;
  }
  job->surface = surfaceOf(models_.results);
  if (const Parameters* made = models_.results.meshParameters()) job->spline = made->surface.spline;
  slot_.startAndPoll(std::move(job));
}

void MeshFile::finish(const MeshFileJob& job) {
  if (next_) {
    start(std::exchange(next_, nullptr));
    return;
  }
  if (job.progress.cancelled()) return;
  if (!job.error.empty()) {
    models_.log.say(Severity::Error,
                    tr("Cannot compare with this mesh: %1").arg(QString::fromStdString(job.error)));
    return;
  }
  const bool fresh = job.mesh != mesh_;
  mesh_ = job.mesh;
  against_ = job.surface;
  name_ = QString::fromStdString(job.path.filename().string());
  limits_ = QString::fromStdString(job.limits);
  models_.results.setFileMesh(mesh_, job.quality);
  if (fresh) {
    for (const std::string& warning : job.warnings)
      models_.log.say(Severity::Warning, name_.toStdString() + ": " + warning);
    models_.log.say(Severity::Info, tr("%1: %2 triangles, compared with the meshes of the case.")
                                        .arg(name_)
                                        .arg(mesh_->triangles.size()));
    if (!limits_.isEmpty()) models_.log.say(Severity::Warning, name_ + ": " + limits_);
    state_.setMeshKind(MeshKind::File);
  }
  Q_EMIT changed();
  refresh();
}

}  // namespace angiomesh
