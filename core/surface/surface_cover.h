// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/surface/front_surface.h"
#include "core/surface/point_grid.h"

namespace angiomesh {

/// Tells which places of a surface the vertices of a mesh reach.
class SurfaceCover {
 public:
  /// `slope`: by how much the wanted length may change per mm.
  explicit SurfaceCover(double slope) : slope_(slope) {}

  static constexpr std::uint32_t none = 0xffffffffU;

  void add(const FrontPoint& vertex) {
    grid_.insert(static_cast<std::uint32_t>(vertices_.size()), vertex.point, vertex.length);
    vertices_.push_back(vertex);
  }
  [[nodiscard]] std::size_t size() const { return vertices_.size(); }

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

  double slope_;
  std::vector<FrontPoint> vertices_;
  PointGrid grid_;
};

}  // namespace angiomesh
