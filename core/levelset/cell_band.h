// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// The voxels of a set and those around it, with their neighbours by number.
struct CellBand {
  static constexpr std::uint32_t none = 0xffffffffU;
  Geometry geometry;
  std::vector<std::uint32_t> voxel;  ///< ascending
  std::vector<std::uint8_t> layer;   ///< 0 in the set, else the number of 26-neighbour steps to it
  /// Numbers of the 26 neighbours in the order of kOffsets: first the six across faces, then the
  /// twelve across edges, then the eight across corners; none outside the band or the volume.
  std::vector<std::array<std::uint32_t, 26>> neighbours;

  /// Faces: -x, +x, -y, +y, -z, +z. Edges: for the axes xy, xz, yz the steps --, ++, -+, +-.
  static const std::array<Index3, 26> kOffsets;

  [[nodiscard]] std::size_t size() const { return voxel.size(); }
};

/// The voxels where `set` is not 0, and those within `layers` steps over 26-neighbours.
CellBand bandAround(const Volume<std::uint8_t>& set, int layers, const Progress& progress = {});

}  // namespace angiomesh
