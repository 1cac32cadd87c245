// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <memory>

#include "gui/job/job_slot.h"
#include "gui/view/surface_view.h"

namespace angiomesh {

/// Makes a volume ready to be drawn in 3D.
struct DrawVolumeJob {
  std::shared_ptr<const Volume<float>> image;

  void execute() noexcept;

  std::shared_ptr<const DrawnVolume> drawn;  ///< after execute(); null: not enough memory
};

/// Hands volumes to a 3D pane, made ready off the window's thread. The pane ends with the last one
/// that was asked for.
class VolumeFeed : public QObject {
  Q_OBJECT

 public:
  VolumeFeed(SurfaceView& view, JobTimer& timer, const JobRunnerFactory& makeRunner,
             QObject* parent = nullptr);

  /// Null shows nothing, at once.
  void show(std::shared_ptr<const Volume<float>> image);

 private:
  void start();
  void finish(const DrawVolumeJob& job);

  SurfaceView& view_;
  std::shared_ptr<const Volume<float>> wanted_;
  JobSlot<DrawVolumeJob> slot_;
};

}  // namespace angiomesh
