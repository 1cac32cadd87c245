// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QString>
#include <optional>

#include "gui/model/mouse_tool.h"
#include "render/slice/slice_measures.h"
#include "render/slice/slice_scene.h"

namespace angiomesh {

/// What the left button can take hold of in a slice pane: the ports, the knobs of the crosshair,
/// the points of measurements, seeds by hand, and the corner of a region of interest. Places are
/// display positions.
class SliceGrip {
 public:
  SliceGrip(SliceScene& scene, const SliceMeasures& measures)
      : scene_(scene), measures_(measures) {}

  void setTool(Tool tool) { tool_ = tool; }

  /// While the tool lets ports be grabbed.
  [[nodiscard]] std::optional<PortHit> portAt(const Eigen::Vector2d& at) const;
  [[nodiscard]] QString nameOf(const std::optional<PortHit>& hit) const;  ///< empty off the ports
  bool takePort(const Eigen::Vector2d& at);
  [[nodiscard]] const QString& port() const { return port_; }
  [[nodiscard]] CutPlane portMoved(const Eigen::Vector2d& at, bool free);
  [[nodiscard]] bool turnsPort() const { return drag_->grip() == PortDrag::Grip::Turn; }

  /// What the mouse looks like there.
  [[nodiscard]] Qt::CursorShape cursorAt(const Eigen::Vector2d& at) const;

  [[nodiscard]] bool knobAt(const Eigen::Vector2d& at) const;
  bool takeKnob(const Eigen::Vector2d& at);
  [[nodiscard]] PlaneTurn knobMoved(const Eigen::Vector2d& at) const;

  bool takeMark(const Eigen::Vector2d& at);
  /// The point taken, dragged there: its distance from the slice stays as it was.
  [[nodiscard]] MarkPoint markMoved(const Eigen::Vector2d& at) const;

  void takeRoi(const Eigen::Vector2d& at);
  /// From the corner taken to here; none where it would hold no voxel.
  [[nodiscard]] std::optional<RoiBox> roiMoved(const Eigen::Vector2d& at) const;
  [[nodiscard]] const std::optional<RoiBox>& roiBefore() const { return roiBefore_; }

 private:
  [[nodiscard]] std::optional<MarkPoint> markAt(const Eigen::Vector2d& at) const;

  SliceScene& scene_;
  const SliceMeasures& measures_;
  Tool tool_ = Tool::Navigate;
  std::optional<PortDrag> drag_;
  QString port_;
  PlaneTurn turnBefore_;
  double angleBefore_ = 0.0;
  std::optional<MarkPoint> mark_;
  Eigen::Vector3d markTakenAt_{0.0, 0.0, 0.0};
  Eigen::Vector3d roiCorner_{0.0, 0.0, 0.0};
  std::optional<RoiBox> roiBefore_;
};

}  // namespace angiomesh
