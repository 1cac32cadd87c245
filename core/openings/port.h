// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// How an opening at the volume's border lies to its vessel, see borderSlant().
struct BorderSlant {
  double angleDeg = 0.0;        ///< between the port's normal and the vessel's axis
  double areaRatio = 1.0;       ///< of the port to the section across the vessel just inside
  double sectionAreaMm2 = 0.0;  ///< of that section
  Eigen::Vector3d centreLps{0.0, 0.0, 0.0};  ///< of that section, mm
  Eigen::Vector3d axisLps{0.0, 0.0, 1.0};    ///< outward, unit

  /// Beyond 30 degrees, or 1.3 times larger or smaller: a solver's inflow would be wrong by as
  /// much.
  [[nodiscard]] bool flagged() const {
    constexpr double kMostDeg = 30.0, kMostRatio = 1.3;
    return angleDeg > kMostDeg || areaRatio > kMostRatio || areaRatio * kMostRatio < 1.0;
  }
};

/// An opening of a surface: a cut through a vessel, or where a vessel leaves the volume. Port n of
/// a list is patch 1 + n of its mesh.
struct Port {
  std::string name;
  Eigen::Vector3d centreLps{0.0, 0.0, 0.0};  ///< of its area, mm
  Eigen::Vector3d normalLps{0.0, 0.0, 1.0};  ///< outward, unit
  double areaMm2 = 0.0;
  bool atBorder = false;                  ///< where a vessel leaves the volume; else a cut
  std::optional<BorderSlant> slant = {};  ///< of a port at the border, where it is known

  /// Of the circle of the same area.
  [[nodiscard]] double equivalentDiameterMm() const;
  /// Whether a point of an open rim is one of the port's: in its plane, as far as single precision
  /// tells, and not far from it.
  [[nodiscard]] bool opensAt(const Eigen::Vector3d& pointLps) const;
};

/// The wall's name among patches; no port may have it.
constexpr const char* kWallName = "wall";
/// Openings at the volume's border are called so and numbered, until they get a name.
constexpr const char* kBorderPrefix = "border_";

/// Area, its centre and mean normal of each patch 1..count of a mesh, without names. A patch
/// without triangles has area 0.
std::vector<Port> measurePatches(const TriMesh& mesh, std::size_t count);

/// The ports as a mesh has them: patches as measurePatches() measures them, and of those without
/// triangles the flat area inside the open rim in their plane. Where there is neither the area is 0
/// and the rest as it was.
std::vector<Port> measuredPorts(const std::vector<Port>& ports, const TriMesh& mesh);

/// What became of `expected`, a sentence for each port that is not the same patch of `mesh` any
/// more: its area differs by more than a tenth (a rim is a polygon, divided anew by each mesher),
/// its centre by more than a tenth of its diameter, its normal by more than two degrees, or it has
/// no triangles. Empty: all are there.
std::vector<std::string> portFaults(const std::vector<Port>& expected, const TriMesh& mesh);

}  // namespace angiomesh
