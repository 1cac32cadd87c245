// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "render/slice/slice_raster.h"

class vtkRenderer;

namespace angiomesh {

/// The part of a slice that a pane shows. Display coordinates are pixels of the window from the
/// lower left corner, places are the slice's mm.
class SliceViewport {
 public:
  explicit SliceViewport(vtkRenderer* renderer) : renderer_(renderer) {}

  [[nodiscard]] Eigen::Vector2d size() const;  ///< of the pane, pixels
  [[nodiscard]] const Eigen::Vector2d& centre() const { return centre_; }
  [[nodiscard]] double mmPerPixel() const { return mmPerPixel_; }
  [[nodiscard]] bool fitted() const { return fitted_; }
  [[nodiscard]] Eigen::Vector2d toScene(double displayX, double displayY) const;

  void fit(const SlicePlane& plane);
  /// A fitted view follows the pane's size.
  void followSize(const SlicePlane& plane);
  /// About a display position.
  void zoom(double factor, double displayX, double displayY, const SlicePlane& plane);
  void pan(double displayDx, double displayDy);
  void moveBy(const Eigen::Vector2d& mm) { centre_ += mm; }
  /// Shows the same part on a screen of another ratio of pixels.
  void scaleBy(double factor) { mmPerPixel_ *= factor; }
  /// Lets the camera of the renderer show it.
  void apply() const;

 private:
  vtkRenderer* renderer_;
  Eigen::Vector2d centre_{0.0, 0.0};
  double mmPerPixel_ = 1.0;
  bool fitted_ = true;
  std::array<int, 2> lastSize_{0, 0};
};

}  // namespace angiomesh
