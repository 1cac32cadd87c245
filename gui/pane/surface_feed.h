// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "gui/job/job_slot.h"
#include "gui/view/surface_view.h"

namespace angiomesh {

/// Makes a mesh ready to be drawn.
struct DrawJob {
  std::shared_ptr<const TriMesh> mesh;
  bool passing = false;
  std::vector<std::size_t> hidden;  ///< see drawnMesh()

  void execute() noexcept;

  // After execute():
  std::shared_ptr<const DrawnMesh> drawn;  ///< null: not enough memory
};

/// Hands meshes to a 3D pane, made ready off the window's thread. The pane ends with the last one
/// that was asked for.
class SurfaceFeed : public QObject {
  Q_OBJECT

 public:
  SurfaceFeed(SurfaceView& view, JobTimer& timer, const JobRunnerFactory& makeRunner,
              QObject* parent = nullptr);

  /// Null shows nothing, at once. @param passing one of many of a moving surface, which may be
  /// shown though the next one has come already
  void show(std::shared_ptr<const TriMesh> mesh, bool passing);
  [[nodiscard]] const std::shared_ptr<const TriMesh>& shown() const { return shown_; }
  /// Leaves the connected part that a triangle belongs to out, until another mesh comes.
  void hidePart(std::size_t triangle);
  void showAllParts();
  [[nodiscard]] bool hidesParts() const { return !hidden_.empty(); }
  /// Whether the pane shows what was asked for last.
  [[nodiscard]] bool settled() const { return shown_ == wanted_; }

 Q_SIGNALS:
  void arrived();  ///< shown() has changed

 private:
  void start();
  void finish(const DrawJob& job);

  SurfaceView& view_;
  std::shared_ptr<const TriMesh> wanted_, shown_;
  bool passing_ = false;  ///< of wanted_
  std::vector<std::size_t> hidden_;
  JobSlot<DrawJob> slot_;
};

}  // namespace angiomesh
