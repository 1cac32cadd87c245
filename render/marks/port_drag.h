// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "render/marks/port_mark.h"

namespace angiomesh {

/// A line of sight; `direction` is a unit vector away from the viewer.
struct ViewRay {
  Eigen::Vector3d from{0.0, 0.0, 0.0}, direction{0.0, 0.0, 1.0};
};

/// Where a disc goes while the mouse drags it. The disc follows its vessel, tilted as it is to the
/// centre line; without one it goes along its normal; where that way is seen end-on it goes across.
/// By the arrow it is tilted about its centre, or turned about the line of sight.
class PortDrag {
 public:
  enum class Grip { Disc, Arrow, Turn };

  /// @param arrowMm how long the arrow is shown
  PortDrag(const PortMark& mark, Grip grip, double arrowMm, const ViewRay& ray);

  [[nodiscard]] Grip grip() const { return grip_; }
  /// @param free a disc is moved in the plane of the screen instead
  [[nodiscard]] CutPlane moved(const ViewRay& ray, bool free);

 private:
  [[nodiscard]] bool endOn() const;
  [[nodiscard]] CutPlane slid(const ViewRay& ray);
  [[nodiscard]] CutPlane alongNormal(const ViewRay& ray) const;
  [[nodiscard]] CutPlane acrossView(const ViewRay& ray) const;
  [[nodiscard]] CutPlane tilted(const ViewRay& ray) const;
  [[nodiscard]] CutPlane turned(const ViewRay& ray) const;
  [[nodiscard]] double distance(std::size_t point, const ViewRay& ray) const;
  [[nodiscard]] Eigen::Vector3d tangent(std::size_t point) const;

  PortMark mark_;
  Grip grip_;
  double arrowMm_;
  ViewRay first_;
  Eigen::Vector3d grabbed_;
  std::size_t start_ = 0, grabbedAt_ = 0, at_ = 0;  ///< points of the path
};

/// What of a mark is under the mouse.
struct PortHit {
  std::size_t mark = 0;
  PortDrag::Grip grip = PortDrag::Grip::Disc;
};

}  // namespace angiomesh
