// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/surface/tri_mesh.h"

namespace angiomesh {

/// Where a triangle of the surface came from.
enum class FaceOrigin : std::uint8_t {
  Front,    ///< a free or connection triangle of the advancing front
  Closing,  ///< put in to close what the front left open
  Remesh    ///< of the remesher
};

/// The surface between phi = 0 and the border of the volume while it is being made: the wall, and
/// flat caps in the six outermost planes of voxel centres.
struct PatchMesh {
  /// Of a vertex: bit a (0..5) set when it lies in border plane a: -x, +x, -y, +y, -z, +z of the
  /// grid's index space; bit 6 (`wallBit`) when it lies on phi = 0. A wall vertex with one plane
  /// bit is on a rim, with two at a rim's corner (it stays in place). A vertex that is not on the
  /// wall slides in its one plane, along its two planes' edge, or stays in the corner of three.
  static constexpr std::uint8_t wallBit = 64;
  static constexpr std::uint8_t planeBits = 63;

  TriMesh mesh;
  std::vector<std::uint8_t> place;  ///< per vertex
  std::vector<std::uint8_t> patch;  ///< per triangle: 0 wall, 1 + a the cap in border plane a
  std::vector<FaceOrigin> origin;   ///< per triangle
};

}  // namespace angiomesh
