// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pane/volume_feed.h"

#include <exception>
#include <utility>

namespace angiomesh {

void DrawVolumeJob::execute() noexcept {
  try {
    drawn = drawnVolume(image);
  } catch (const std::exception&) {
    drawn.reset();
  }
}

VolumeFeed::VolumeFeed(SurfaceView& view, JobTimer& timer, const JobRunnerFactory& makeRunner,
                       QObject* parent)
    : QObject(parent),
      view_(view),
      slot_(timer, makeRunner,
            [this](const std::shared_ptr<DrawVolumeJob>& job) { finish(*job); }) {}

void VolumeFeed::show(std::shared_ptr<const Volume<float>> image) {
  if (image == wanted_) return;
  wanted_ = std::move(image);
  if (!wanted_)
    view_.setDrawnImage(nullptr);
  else if (!slot_)
    start();
}

void VolumeFeed::start() {
  auto job = std::make_shared<DrawVolumeJob>();
  job->image = wanted_;
  slot_.startAndPoll(std::move(job));
}

void VolumeFeed::finish(const DrawVolumeJob& job) {
  // One of many that follow each other on one grid is shown though the next has come already.
  if (wanted_ && job.image->geometry == wanted_->geometry) view_.setDrawnImage(job.drawn);
  if (wanted_ && job.image != wanted_) start();
}

}  // namespace angiomesh
