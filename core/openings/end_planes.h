// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/image/volume.h"

namespace angiomesh {

/// Ends a vessel: what of it lies on the side of the normal is cut away.
struct CutPlane {
  Eigen::Vector3d pointLps{0.0, 0.0, 0.0};   ///< mm, inside the vessel
  Eigen::Vector3d normalLps{0.0, 0.0, 1.0};  ///< outward, unit
};

/// What a vertex of a surface is bound to: phi = 0, and planes that the surface ends in (see
/// EndPlanes). A wall vertex in one plane is on a rim, in two at a rim's corner (it stays where it
/// is). A vertex that is not on the wall slides in its one plane, along its two planes' edge, or
/// stays in the corner of three.
struct Place {
  std::uint8_t borders = 0;  ///< bit a (0..5): in border plane a
  bool wall = false;         ///< on phi = 0
  std::uint16_t cut = 0;     ///< 1 + the number of the cut it lies in; 0: none

  static Place onWall() { return {0, true, 0}; }
  static Place inPlane(int plane) {
    if (plane < 6) return {static_cast<std::uint8_t>(1U << plane), false, 0};
    return {0, false, static_cast<std::uint16_t>(plane - 5)};
  }

  [[nodiscard]] int planes() const {
    return std::popcount(static_cast<unsigned>(borders)) + (cut != 0 ? 1 : 0);
  }
  /// In how many directions it can move: 0, 1 or 2.
  [[nodiscard]] int freedom() const {
    const int bound = planes() + (wall ? 1 : 0);
    return bound < 3 ? 3 - bound : 0;
  }
  /// The lowest of its planes, -1 without any.
  [[nodiscard]] int firstPlane() const {
    if (borders != 0) return std::countr_zero(static_cast<unsigned>(borders));
    return cut != 0 ? cut + 5 : -1;
  }
  [[nodiscard]] bool liesIn(int plane) const {
    return plane < 6 ? (borders >> plane & 1) != 0 : cut == plane - 5;
  }
  /// What both are bound to.
  [[nodiscard]] Place shared(const Place& other) const {
    return {static_cast<std::uint8_t>(borders & other.borders), wall && other.wall,
            cut == other.cut ? cut : std::uint16_t{0}};
  }
  /// Bound to all that `other` is bound to.
  [[nodiscard]] bool within(const Place& other) const { return shared(other) == other; }
  [[nodiscard]] bool operator==(const Place&) const = default;
};

/// The planes that a surface ends in: the six outermost planes of voxel centres, -x, +x, -y, +y,
/// -z, +z of the grid's index space (0..5), and cuts (6 and on).
class EndPlanes {
 public:
  using Vector3d = Eigen::Vector3d;

  explicit EndPlanes(const Geometry& grid, std::vector<CutPlane> cuts = {});

  [[nodiscard]] const Geometry& grid() const { return grid_; }
  [[nodiscard]] const std::vector<CutPlane>& cuts() const { return cuts_; }
  [[nodiscard]] int count() const { return static_cast<int>(normals_.size()); }
  /// Outward, unit, LPS.
  [[nodiscard]] const Vector3d& normal(int plane) const {
    return normals_[static_cast<std::size_t>(plane)];
  }

  /// The border planes that a point lies in, within 1e-6 voxel.
  [[nodiscard]] Place borders(const Vector3d& pointLps) const;

  /// Calls visit(plane) for each plane of a place.
  template <class Visit>
  void forEachPlane(const Place& place, Visit visit) const {
    for (int a = 0; a < 6; ++a)
      if ((place.borders >> a & 1) != 0) visit(a);
    if (place.cut != 0) visit(place.cut + 5);
  }

  /// The part of a vector that lies in all planes of the place.
  [[nodiscard]] Vector3d along(const Place& place, const Vector3d& step) const;

  /// Moves a point into the planes of its place.
  void snap(const Place& place, Vector3d& pointLps) const;

 private:
  Geometry grid_;
  Eigen::Matrix3d toIndex_;
  std::vector<CutPlane> cuts_;
  std::vector<Vector3d> normals_;
};

}  // namespace angiomesh
