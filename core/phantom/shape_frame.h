// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/phantom/shape.h"

// What the builders of the analytic shapes share.

namespace angiomesh {

/// What they need to know about the volume; lengths in mm.
struct ShapeFrame {
  double unit = 1.0;                    // the smallest spacing
  Eigen::Vector3d centre;               // of the volume, moved by the sub-voxel offset
  Eigen::Vector3d first, second, axis;  // right-handed, orthonormal
  Eigen::Vector3d low, high;            // the volume's corners
  double halfSide = 0.0;                // half the shortest side
  double through = 0.0;                 // a length that leaves the volume from anywhere
  double radius = 0.0;                  // of the vessel

  [[nodiscard]] Eigen::Vector3d at(double u, double v, double w) const {
    return centre + u * first + v * second + w * axis;
  }
};

/// @throws InputError for an axis, offset or radius that makes no sense
ShapeFrame makeShapeFrame(const PhantomParams& params, const Geometry& g);

/// @param halfWidth largest distance of the wall from the volume's centre that has to fit, mm
/// @throws InputError when it does not
void requireRoom(const ShapeFrame& frame, double halfWidth, const char* kind);

/// The part of a segment inside the volume, as shares of its length (Liang and Barsky 1984).
std::optional<std::array<double, 2>> clipToVolume(const ShapeFrame& frame,
                                                  const Eigen::Vector3d& from,
                                                  const Eigen::Vector3d& to);

/// Appends what lies in the volume of the line through `points`. @return the last piece's number,
/// -1 where nothing was inside
int addCentreLine(Shape& shape, const ShapeFrame& frame, const std::vector<Eigen::Vector3d>& points,
                  const std::vector<double>& radii, int parent = -1);

}  // namespace angiomesh
