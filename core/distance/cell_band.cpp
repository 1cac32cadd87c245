// SPDX-License-Identifier: BSD-3-Clause
#include "core/distance/cell_band.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace angiomesh {

const std::array<Index3, 26> CellBand::kOffsets{
    {{-1, 0, 0},  {1, 0, 0},   {0, -1, 0}, {0, 1, 0},   {0, 0, -1},   {0, 0, 1},   {-1, -1, 0},
     {1, 1, 0},   {-1, 1, 0},  {1, -1, 0}, {-1, 0, -1}, {1, 0, 1},    {-1, 0, 1},  {1, 0, -1},
     {0, -1, -1}, {0, 1, 1},   {0, -1, 1}, {0, 1, -1},  {-1, -1, -1}, {1, -1, -1}, {-1, 1, -1},
     {1, 1, -1},  {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1},  {1, 1, 1}}};

/// A walk along all nine rows at once, as voxels come in ascending order.
void CellBand::findNeighbours() {
  const Geometry& g = geometry;
  near_.resize(size());
  const auto rows = static_cast<std::size_t>(g.size[1]) * static_cast<std::size_t>(g.size[2]);
  const auto width = static_cast<std::uint32_t>(g.size[0]);
  std::vector<std::uint32_t> start(rows + 1, static_cast<std::uint32_t>(size()));
  for (std::size_t c = size(); c-- > 0;) start[voxel[c] / width] = static_cast<std::uint32_t>(c);
  for (std::size_t r = rows; r-- > 0;) start[r] = std::min(start[r], start[r + 1]);
  parallelFor(0, rows, 256, [&](std::size_t first, std::size_t last) {
    for (std::size_t at = first; at < last; ++at) {
      const int j = static_cast<int>(at) % g.size[1], k = static_cast<int>(at) / g.size[1];
      std::array<std::uint32_t, 9> next{}, end{}, origin{};
      for (std::size_t row = 0; row < 9; ++row) {
        const int y = j + static_cast<int>(row % 3) - 1, z = k + static_cast<int>(row / 3) - 1;
        if (y < 0 || y >= g.size[1] || z < 0 || z >= g.size[2]) continue;
        const auto other = static_cast<std::size_t>(y) +
                           static_cast<std::size_t>(z) * static_cast<std::size_t>(g.size[1]);
        next[row] = start[other];
        end[row] = start[other + 1];
        origin[row] = static_cast<std::uint32_t>(other) * width;
      }
      for (std::uint32_t c = start[at]; c < start[at + 1]; ++c) {
        const std::uint32_t x = voxel[c] - static_cast<std::uint32_t>(at) * width;
        Near& near = near_[c];
        near.present = 0;
        for (std::size_t row = 0; row < 9; ++row) {
          while (next[row] < end[row] && voxel[next[row]] - origin[row] + 1 < x) ++next[row];
          near.first[row] = next[row];
          for (std::uint32_t n = next[row]; n < end[row]; ++n) {
            const std::uint32_t step = voxel[n] - origin[row] + 1 - x;  // dx + 1
            if (step > 2) break;
            near.present |= 1U << (3 * static_cast<std::uint32_t>(row) + step);
          }
        }
      }
    }
  });
}

CellBand bandAround(const Volume<std::uint8_t>& set, int layers, const Progress& progress) {
  const Geometry& g = set.geometry;
  CellBand band;
  band.geometry = g;
  Volume<std::uint8_t> reached(g);  // steps + 1
  std::vector<std::uint32_t> front, next;
  for (std::size_t i = 0; i < set.voxels.size(); ++i)
    if (set.voxels[i] != 0) {
      reached.voxels[i] = 1;
      front.push_back(static_cast<std::uint32_t>(i));
    }
  std::size_t count = front.size();
  for (int layer = 1; layer <= layers; ++layer) {
    progress.check();
    for (const std::uint32_t voxel : front) {
      const Index3 p = g.indexOf(voxel);
      for (const Index3& d : CellBand::kOffsets) {
        const int i = p[0] + d[0], j = p[1] + d[1], k = p[2] + d[2];
        if (!g.contains(i, j, k)) continue;
        const std::size_t to = g.offset(i, j, k);
        if (reached.voxels[to] != 0) continue;
        reached.voxels[to] = static_cast<std::uint8_t>(layer + 1);
        next.push_back(static_cast<std::uint32_t>(to));
      }
    }
    count += next.size();
    front.swap(next);
    next.clear();
  }
  band.voxel.reserve(count);
  band.layer.reserve(count);
  for (std::size_t i = 0; i < reached.voxels.size(); ++i)
    if (reached.voxels[i] != 0) {
      band.voxel.push_back(static_cast<std::uint32_t>(i));
      band.layer.push_back(static_cast<std::uint8_t>(reached.voxels[i] - 1));
    }
  progress.check();
  band.findNeighbours();
  return band;
}

}  // namespace angiomesh
