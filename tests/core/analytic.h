// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "core/image/volume.h"

namespace angiomesh::analytic {

/// A grid of n^3 voxels of 1 mm, identity direction.
inline Geometry cube(int n) {
  Geometry g;
  g.size = {n, n, n};
  return g;
}

/// A small grid with three different spacings and an oblique direction.
inline Geometry oblique(int nx, int ny, int nz) {
  Geometry g;
  g.size = {nx, ny, nz};
  g.spacing = {0.4, 0.5, 0.9};
  g.origin = {-12.0, 30.0, 7.0};
  g.direction = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  return g;
}

/// f at every voxel centre, f a function of the position in LPS mm.
template <class F>
Volume<float> sampled(const Geometry& g, F f) {
  Volume<float> volume(g);
  for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
    const Index3 p = g.indexOf(i);
    volume.voxels[i] = static_cast<float>(f(g.toPhysical({1.0 * p[0], 1.0 * p[1], 1.0 * p[2]})));
  }
  return volume;
}

/// The centre of the grid in LPS mm.
inline Eigen::Vector3d centreOf(const Geometry& g) {
  return g.toPhysical({0.5 * (g.size[0] - 1), 0.5 * (g.size[1] - 1), 0.5 * (g.size[2] - 1)});
}

inline double ball(const Eigen::Vector3d& x, const Eigen::Vector3d& centre, double radius) {
  return (x - centre).norm() - radius;
}

/// Tube of infinite length around the line through `centre` along the unit vector `axis`.
inline double tube(const Eigen::Vector3d& x, const Eigen::Vector3d& centre,
                   const Eigen::Vector3d& axis, double radius) {
  const Eigen::Vector3d d = x - centre;
  return (d - d.dot(axis) * axis).norm() - radius;
}

/// Torus around the z axis through `centre`.
inline double torus(const Eigen::Vector3d& x, const Eigen::Vector3d& centre, double ring,
                    double radius) {
  const Eigen::Vector3d d = x - centre;
  return std::hypot(std::hypot(d[0], d[1]) - ring, d[2]) - radius;
}

}  // namespace angiomesh::analytic
