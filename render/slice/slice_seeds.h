// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "render/slice/slice_layer.h"
#include "render/slice/slice_raster.h"

class vtkRenderer;

namespace angiomesh {

/// The seeds near a slice as dots: those by hand, and fainter those that were found.
class SliceSeeds {
 public:
  explicit SliceSeeds(vtkRenderer* renderer);

  /// LPS mm.
  void set(std::vector<Eigen::Vector3d> byHand, std::vector<Eigen::Vector3d> found);
  [[nodiscard]] const std::vector<Eigen::Vector3d>& byHand() const { return byHand_; }

  /// @param plane null: nothing is shown   @param slab the first and the last slice shown
  /// @param depth towards the viewer
  void show(const SlicePlane* plane, int slice, const std::array<int, 2>& slab, double depth,
            double pixelRatio);
  /// The seed by hand nearest to a place in the slice, mm, of those that are seen within reach.
  [[nodiscard]] std::optional<std::size_t> at(const Eigen::Vector2d& place, double reachMm) const;

 private:
  std::vector<Eigen::Vector3d> byHand_, found_;
  std::vector<std::pair<std::size_t, Eigen::Vector2d>> seen_;  ///< of those by hand, in the slab
  SliceLayer dots_;
};

}  // namespace angiomesh
