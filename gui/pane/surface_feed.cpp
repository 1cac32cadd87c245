// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pane/surface_feed.h"

#include <exception>
#include <utility>

namespace angiomesh {

void DrawJob::execute() noexcept {
  try {
    drawn = drawnMesh(mesh, kCoarseTriangles, hidden);
  } catch (const std::exception&) {
    drawn.reset();
  }
}

SurfaceFeed::SurfaceFeed(SurfaceView& view, JobTimer& timer, const JobRunnerFactory& makeRunner,
                         QObject* parent)
    : QObject(parent),
      view_(view),
      slot_(timer, makeRunner, [this](const std::shared_ptr<DrawJob>& job) { finish(*job); }) {}

void SurfaceFeed::show(std::shared_ptr<const TriMesh> mesh, bool passing) {
  if (mesh == wanted_) return;
  wanted_ = std::move(mesh);
  passing_ = passing;
  hidden_.clear();
  if (!wanted_) {
    view_.setSurface(nullptr);
    shown_ = nullptr;
    Q_EMIT arrived();
  } else if (!slot_) {
    start();
  }
}

void SurfaceFeed::start() {
  auto job = std::make_shared<DrawJob>();
  job->mesh = wanted_;
  job->passing = passing_;
  job->hidden = hidden_;
  slot_.startAndPoll(std::move(job));
}

void SurfaceFeed::finish(const DrawJob& job) {
  const bool last = job.mesh == wanted_ && job.hidden == hidden_;
  if (job.drawn && (last || (job.passing && passing_ && wanted_))) {
    view_.setDrawnSurface(job.drawn);
    shown_ = job.mesh;
    Q_EMIT arrived();
  }
  if (!last && wanted_) start();
}

void SurfaceFeed::hidePart(std::size_t triangle) {
  if (!wanted_) return;
  hidden_.push_back(triangle);
  if (!slot_) start();
  Q_EMIT arrived();
}

void SurfaceFeed::showAllParts() {
  if (hidden_.empty()) return;
  hidden_.clear();
  if (!slot_) start();
  Q_EMIT arrived();
}

}  // namespace angiomesh
