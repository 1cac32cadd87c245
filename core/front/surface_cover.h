// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/front/front_surface.h"
#include "core/mesh/point_grid.h"

namespace angiomesh {

/// Tells which places of a surface the vertices of a mesh reach.
class SurfaceCover {
 public:
  /// `slope`: by how much the wanted length may change per mm. `vertices`, which may only be
  /// appended to, must outlive the object.
  SurfaceCover(const std::vector<FrontPoint>& vertices, double slope)
      : vertices_(vertices), slope_(slope) {}

  static constexpr std::uint32_t none = 0xffffffffU;

  /// Takes in the vertices that are new.
  void update() {
    for (; size_ < vertices_.size(); ++size_)
      grid_.insert(size_, vertices_[size_].point, vertices_[size_].length);
  }

  /// The nearest vertex less than one wanted edge away on the same sheet (by its normal); none.
  [[nodiscard]] std::uint32_t reach(const FrontPoint& place) const {
    std::uint32_t nearest = none;
    double least = place.length * place.length;
    const double shortest = place.length * std::max(kMargin * (1.0 - slope_), 0.05);
    grid_.forEachNear(place.point, place.length, shortest, [&](std::uint32_t id) {
      const double d = (vertices_[id].point - place.point).squaredNorm();
      if (d < least && vertices_[id].normal.dot(place.normal) > 0.2) {
        least = d;
        nearest = id;
      }
    });
    return nearest;
  }

 private:
  static constexpr double kMargin = 0.7;  // the wanted length is known to so much

  const std::vector<FrontPoint>& vertices_;
  double slope_;
  std::uint32_t size_ = 0;  ///< so many vertices are in the grid
  PointGrid grid_;
};

}  // namespace angiomesh
