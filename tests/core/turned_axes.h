// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/core/analytic.h"

namespace angiomesh::analytic {

/// The same grid with its axes in turn: what was the first one is the second. No voxel moves.
inline Geometry turned(const Geometry& g) {
  Geometry t = g;
  for (int a = 0; a < 3; ++a) {
    const int to = (a + 1) % 3;
    t.size[static_cast<std::size_t>(to)] = g.size[static_cast<std::size_t>(a)];
    t.spacing[to] = g.spacing[a];
    t.direction.col(to) = g.direction.col(a);
  }
  return t;
}

inline Index3 turned(const Index3& p) { return {p[2], p[0], p[1]}; }

/// The same image on the turned grid. What is computed of it, wherever axes play no part, is that
/// of the image: one axis taken for another shows, as all three differ in size and spacing on
/// oblique() grids.
template <class T>
Volume<T> turned(const Volume<T>& volume) {
  Volume<T> t(turned(volume.geometry));
  for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
    const Index3 p = turned(volume.geometry.indexOf(i));
    t.at(p[0], p[1], p[2]) = volume.voxels[i];
  }
  return t;
}

/// The largest difference between voxels; infinite on different grids.
template <class T>
double mostApart(const Volume<T>& a, const Volume<T>& b) {
  if (!(a.geometry == b.geometry)) return std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (std::size_t i = 0; i < a.voxels.size(); ++i)
    most = std::max(most, std::fabs(static_cast<double>(a.voxels[i]) - b.voxels[i]));
  return most;
}

/// Signed distance to a curved vessel with a side branch on a grid whose axes are all different,
/// the fewest voxels along the first one or along the last one.
inline Volume<float> unlikeVessels(bool fewAlongLast) {
  const Geometry g = fewAlongLast ? oblique(44, 34, 19) : oblique(40, 42, 30);
  const Eigen::Vector3d middle = centreOf(g);
  const auto at = [&](double i, double j, double k) {
    return g.toPhysical({i * (g.size[0] - 1), j * (g.size[1] - 1), k * (g.size[2] - 1)});
  };
  return clamped(g, [&](const Eigen::Vector3d& x) {
    return std::min({capsule(x, at(0.2, 0.2, 0.2), middle, 1.7),
                     capsule(x, middle, at(0.75, 0.65, 0.8), 1.5),
                     capsule(x, middle, at(0.3, 0.8, 0.4), 1.2)});
  });
}

}  // namespace angiomesh::analytic
