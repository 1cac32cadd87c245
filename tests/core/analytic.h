// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/field/spline_field.h"
#include "core/image/volume.h"
#include "core/image/voxels.h"

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
  for (std::size_t i = 0; i < volume.voxels.size(); ++i)
    volume.voxels[i] = static_cast<float>(f(voxelCentre(g, i)));
  return volume;
}

/// sampled(), clamped at five working voxels as the pipeline's phi is.
template <class F>
Volume<float> clamped(const Geometry& g, F f) {
  const double most = 5.0 * g.voxelMm();
  return sampled(g, [&](const Eigen::Vector3d& x) { return std::clamp(f(x), -most, most); });
}

inline SplineField fieldOf(const Volume<float>& phi) {
  return SplineField(phi, SplineKind::InterpolatingBspline);
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

/// What is within `radius` of a segment.
inline double capsule(const Eigen::Vector3d& x, const Eigen::Vector3d& from,
                      const Eigen::Vector3d& to, double radius) {
  const Eigen::Vector3d d = to - from;
  const double t = std::clamp((x - from).dot(d) / d.squaredNorm(), 0.0, 1.0);
  return (x - from - t * d).norm() - radius;
}

/// Torus around the z axis through `centre`.
inline double torus(const Eigen::Vector3d& x, const Eigen::Vector3d& centre, double ring,
                    double radius) {
  const Eigen::Vector3d d = x - centre;
  return std::hypot(std::hypot(d[0], d[1]) - ring, d[2]) - radius;
}

inline double degreesBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / M_PI;
}

}  // namespace angiomesh::analytic
