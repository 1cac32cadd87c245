// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// The voxels of a set and those around it, numbered in the order of memory, with their neighbours.
struct CellBand {
  static constexpr std::uint32_t none = 0xffffffffU;
  Geometry geometry;
  std::vector<std::uint32_t> voxel;  ///< ascending
  std::vector<std::uint8_t> layer;   ///< 0 in the set, else the number of 26-neighbour steps to it

  /// Steps to the 26 neighbours: first the six across faces, then the twelve across edges, then the
  /// eight across corners. Faces: -x, +x, -y, +y, -z, +z. Edges: for the axes xy, xz, yz the steps
  /// --, ++, -+, +-.
  static const std::array<Index3, 26> kOffsets;

  [[nodiscard]] std::size_t size() const { return voxel.size(); }

  /// The number of the neighbour at kOffsets[k]; none outside the band or the volume.
  [[nodiscard]] std::uint32_t neighbour(std::size_t cell, std::size_t k) const {
    const Near& near = near_[cell];
    const unsigned bit = kBits[k];
    if ((near.present >> bit & 1U) == 0) return none;
    const unsigned row = bit / 3;
    const unsigned before = near.present >> (3 * row) & ((1U << bit % 3) - 1U);
    return near.first[row] + (before & 1U) + (before >> 1U);
  }

  /// The cells of one of the nine rows along x around a cell, row = dy + 1 + 3 (dz + 1), that are
  /// its neighbours or itself: consecutive numbers.
  struct Run {
    std::uint32_t first, count;
  };
  [[nodiscard]] Run run(std::size_t cell, std::size_t row) const {
    const unsigned three = near_[cell].present >> (3 * row) & 7U;
    return {near_[cell].first[row], (three & 1U) + (three >> 1 & 1U) + (three >> 2)};
  }

 private:
  /// By the nine rows along x around a cell, row = dy + 1 + 3 (dz + 1): the number of the first
  /// neighbour in the row, and bit 3 row + dx + 1 for each that there is.
  struct Near {
    std::array<std::uint32_t, 9> first;
    std::uint32_t present;
  };
  static constexpr std::array<std::uint8_t, 26> kBits{
      12, 14, 10, 16, 4, 22, 9, 17, 15, 11, 3, 23, 21, 5, 1, 25, 19, 7, 0, 2, 6, 8, 18, 20, 24, 26};
  std::vector<Near> near_;

  void findNeighbours();
  friend CellBand bandAround(const Volume<std::uint8_t>& set, int layers, const Progress& progress);
};

/// The voxels where `set` is not 0, and those within `layers` steps over 26-neighbours.
CellBand bandAround(const Volume<std::uint8_t>& set, int layers, const Progress& progress = {});

}  // namespace angiomesh
