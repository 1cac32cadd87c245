// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/pane_grid.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiomesh {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A rotation, or one with a reflection: the directions of files may be slightly skew.
Matrix3d nearestOrthonormal(const Matrix3d& directions) {
  const Eigen::JacobiSVD<Matrix3d> svd(directions, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

/// Cubes as fine as the finest spacing over the whole image, with `pivot` on a lattice point.
Geometry covering(const Geometry& image, const Matrix3d& direction, const Vector3d& pivot) {
  Geometry grid;
  grid.direction = direction;
  grid.spacing = Vector3d::Constant(image.voxelMm());
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::max());
  Vector3d high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    Vector3d index;
    for (int a = 0; a < 3; ++a)
      index[a] = ((corner >> a) & 1) != 0 ? image.size[static_cast<std::size_t>(a)] - 0.5 : -0.5;
    const Vector3d at = direction.transpose() * (image.toPhysical(index) - pivot) / image.voxelMm();
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  // A cube belongs to it whose centre does: one more would be empty.
  const Vector3d first = (low.array() - 1e-6).ceil();
  const Vector3d last = (high.array() + 1e-6).floor();
  for (int a = 0; a < 3; ++a)
    grid.size[static_cast<std::size_t>(a)] = std::max(1, static_cast<int>(last[a] - first[a]) + 1);
  grid.origin = pivot + direction * (image.voxelMm() * first);
  return grid;
}

/// The image's grid with the directions that the planes begin with.
Geometry begun(const Geometry& image, const PlaneTurn& turn) {
  Geometry grid = image;
  grid.direction =
      turn.patientAxes ? Matrix3d::Identity().eval() : nearestOrthonormal(image.direction);
  return grid;
}

Vector3d normalOf(const Geometry& begun, int plane, const PlaneTurn& turn) {
  return turn.turns[static_cast<std::size_t>(plane)] *
         begun.direction.col(paneAxes(begun, plane).across);
}

}  // namespace

bool PlaneTurn::turned(int plane) const {
  return turns[static_cast<std::size_t>(plane)] != Matrix3d::Identity();
}

bool PlaneTurn::turned() const { return turned(0) || turned(1) || turned(2); }

PlaneTurn PlaneTurn::turnedBy(int about, double radians, const Vector3d& axis,
                              const Vector3d& pivot) const {
  PlaneTurn next = *this;
  next.pivotLps = pivot;
  const Matrix3d turn = Eigen::AngleAxisd(radians, axis).toRotationMatrix();
  for (int plane = 0; plane < 3; ++plane)
    if (plane != about) {
      Matrix3d& of = next.turns[static_cast<std::size_t>(plane)];
      of = nearestOrthonormal(turn * of);
    }
  return next;
}

PaneGrid paneGrid(const Geometry& image, int plane, const PlaneTurn& turn) {
  PaneGrid pane;
  if (!turn.patientAxes && !turn.turned(plane)) {
    pane.grid = image;
    pane.axes = paneAxes(image, plane);
    return pane;
  }
  const Geometry start = begun(image, turn);
  const Matrix3d& rotation = turn.turns[static_cast<std::size_t>(plane)];
  pane.native = false;
  // By where the plane began: it keeps its name and its sides however far it is turned.
  pane.axes = paneAxes(start, plane);
  pane.axes.rightLps = rotation * pane.axes.rightLps;
  pane.axes.upLps = rotation * pane.axes.upLps;
  pane.grid = covering(image, rotation * start.direction, turn.pivotLps);
  const Vector3d from = start.direction.col(pane.axes.across);
  const double cosine = std::clamp(from.dot(rotation * from), -1.0, 1.0);
  pane.turnedDeg = std::acos(cosine) * 180.0 / std::numbers::pi;
  return pane;
}

std::array<Vector3d, 3> planeNormals(const Geometry& image, const PlaneTurn& turn) {
  const Geometry start = begun(image, turn);
  return {normalOf(start, 0, turn), normalOf(start, 1, turn), normalOf(start, 2, turn)};
}

}  // namespace angiomesh
