// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "render/port_mark.h"

namespace angiomesh {

/// A line of sight; `direction` is a unit vector away from the viewer.
struct ViewRay {
  Eigen::Vector3d from{0.0, 0.0, 0.0}, direction{0.0, 0.0, 1.0};
};

/// Where a disc goes while the mouse drags it. The disc follows its vessel, tilted as it is to the
/// centre line; without one it goes along its normal. By the arrow it is tilted about its centre.
class PortDrag {
 public:
  enum class Grip { Disc, Arrow };

  /// @param arrowMm how long the arrow is shown
  PortDrag(const PortMark& mark, Grip grip, double arrowMm, const ViewRay& ray);

  /// @param free a disc is moved in the plane of the screen instead
  [[nodiscard]] CutPlane moved(const ViewRay& ray, bool free);

 private:
  [[nodiscard]] CutPlane slid(const ViewRay& ray);
  [[nodiscard]] CutPlane alongNormal(const ViewRay& ray) const;
  [[nodiscard]] CutPlane acrossView(const ViewRay& ray) const;
  [[nodiscard]] CutPlane tilted(const ViewRay& ray) const;
  [[nodiscard]] double distance(std::size_t point, const ViewRay& ray) const;
  [[nodiscard]] Eigen::Vector3d tangent(std::size_t point) const;

  PortMark mark_;
  Grip grip_;
  double arrowMm_;
  ViewRay first_;
  Eigen::Vector3d grabbed_;
  std::size_t start_ = 0, grabbedAt_ = 0, at_ = 0;  ///< points of the path
};

}  // namespace angiomesh
