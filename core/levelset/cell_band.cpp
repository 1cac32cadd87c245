// SPDX-License-Identifier: BSD-3-Clause
#include "core/levelset/cell_band.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace angiomesh {

const std::array<Index3, 26> CellBand::kOffsets{
    {{-1, 0, 0},  {1, 0, 0},   {0, -1, 0}, {0, 1, 0},   {0, 0, -1},   {0, 0, 1},   {-1, -1, 0},
     {1, 1, 0},   {-1, 1, 0},  {1, -1, 0}, {-1, 0, -1}, {1, 0, 1},    {-1, 0, 1},  {1, 0, -1},
     {0, -1, -1}, {0, 1, 1},   {0, -1, 1}, {0, 1, -1},  {-1, -1, -1}, {1, -1, -1}, {-1, 1, -1},
     {1, 1, -1},  {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1},  {1, 1, 1}}};

CellBand bandAround(const Volume<std::uint8_t>& set, int layers, const Progress& progress) {
  const Geometry& g = set.geometry;
  CellBand band;
  band.geometry = g;
  Volume<std::uint32_t> number(g, CellBand::none);
  const auto forNeighbours = [&g](std::uint32_t voxel, auto visit) {
    const Index3 p = g.indexOf(voxel);
    for (std::size_t n = 0; n < CellBand::kOffsets.size(); ++n) {
      const Index3& d = CellBand::kOffsets[n];
      const int i = p[0] + d[0], j = p[1] + d[1], k = p[2] + d[2];
      if (g.contains(i, j, k)) visit(n, g.offset(i, j, k));
    }
  };
  std::vector<std::pair<std::uint32_t, std::uint8_t>> cells;
  for (std::size_t i = 0; i < set.voxels.size(); ++i)
    if (set.voxels[i] != 0) {
      number.voxels[i] = 0;
      cells.emplace_back(static_cast<std::uint32_t>(i), std::uint8_t{0});
    }
  std::size_t first = 0;
  for (int layer = 1; layer <= layers; ++layer) {
    progress.check();
    const std::size_t last = cells.size();
    for (; first < last; ++first)
      forNeighbours(cells[first].first, [&](std::size_t, std::size_t next) {
        if (number.voxels[next] != CellBand::none) return;
        number.voxels[next] = 0;
        cells.emplace_back(static_cast<std::uint32_t>(next), static_cast<std::uint8_t>(layer));
      });
  }
  std::sort(cells.begin(), cells.end());
  band.voxel.resize(cells.size());
  band.layer.resize(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    band.voxel[c] = cells[c].first;
    band.layer[c] = cells[c].second;
    number.voxels[cells[c].first] = static_cast<std::uint32_t>(c);
  }
  band.neighbours.resize(cells.size());
  parallelFor(0, cells.size(), 8192, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (std::size_t c = begin; c < end; ++c) {
      band.neighbours[c].fill(CellBand::none);
      forNeighbours(band.voxel[c], [&](std::size_t n, std::size_t next) {
        band.neighbours[c][n] = number.voxels[next];
      });
    }
  });
  return band;
}

}  // namespace angiomesh
