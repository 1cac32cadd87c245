// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "core/openings/end_planes.h"

namespace angiomesh {

/// An opening of the vessels as the panes mark it: a disc with an arrow along the outward normal.
struct PortMark {
  std::string name;
  CutPlane plane;
  double radiusMm = 0.0;  ///< of the vessel there; the disc is a little larger
  std::array<double, 3> colour{1.0, 1.0, 1.0};  ///< RGB, 0..1
  bool selected = false;
  bool movable = true;
  std::vector<Eigen::Vector3d> path;  ///< the vessel's centre line, to slide along; may be empty

  [[nodiscard]] bool operator==(const PortMark& other) const {
    return name == other.name && plane.pointLps == other.plane.pointLps &&
           plane.normalLps == other.plane.normalLps && radiusMm == other.radiusMm &&
           colour == other.colour && selected == other.selected && movable == other.movable &&
           path == other.path;
  }
  /// Of the disc.
  [[nodiscard]] double discRadiusMm() const { return 1.3 * radiusMm; }
};

}  // namespace angiomesh
