// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "render/slice/slice_layer.h"

class vtkRenderer;

namespace angiomesh {

/// The crosshair of a slice pane: two lines, where the other two planes cut the slice. Each ends in
/// knobs by which it is turned. Lengths are the slice's mm.
class CrosshairArms {
 public:
  explicit CrosshairArms(vtkRenderer* renderer);  ///< which outlives the arms

  /// What the pane shows of the slice.
  struct Frame {
    Eigen::Vector2d low{0.0, 0.0}, high{0.0, 0.0};  ///< the lines end at this rectangle
    double mmPerPixel = 1.0, pixelRatio = 1.0;
  };
  /// @param along unit vectors of the two lines   @param depth towards the viewer
  void show(const Eigen::Vector2d& centre, const std::array<Eigen::Vector2d, 2>& along,
            const Frame& frame, double depth);
  void hide();
  /// Whether a knob lies at a place, within `reachMm`.
  [[nodiscard]] bool knobAt(const Eigen::Vector2d& place, double reachMm) const;
  [[nodiscard]] const std::vector<Eigen::Vector2d>& knobs() const { return knobs_; }

 private:
  SliceLayer layer_;
  std::vector<Eigen::Vector2d> knobs_;
};

}  // namespace angiomesh
