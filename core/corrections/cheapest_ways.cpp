// SPDX-License-Identifier: BSD-3-Clause
#include "core/corrections/cheapest_ways.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "core/image/voxels.h"

namespace angiomesh {

std::vector<Index3> CheapestWays::wayTo(const Index3& end) const {
  std::vector<Index3> way;
  const Geometry& g = cost.geometry;
  for (auto at = static_cast<std::uint32_t>(g.offset(end[0], end[1], end[2])); at != none;
       at = from[at])
    way.push_back(g.indexOf(at));
  std::reverse(way.begin(), way.end());
  return way;
}

CheapestWays cheapestWays(const Volume<float>& costPerMm, const Index3& start,
                          const Progress& progress) {
  const Geometry& g = costPerMm.geometry;
  std::array<float, 27> lengths{};
  for (std::size_t n = 0; n < lengths.size(); ++n) {
    const Index3& d = kSteps27[n];
    lengths[n] =
        static_cast<float>(g.spacing.cwiseProduct(Eigen::Vector3d(d[0], d[1], d[2])).norm());
  }
  CheapestWays ways{Volume<float>(g, std::numeric_limits<float>::infinity()), {}};
  ways.from.assign(g.voxelCount(), CheapestWays::none);
  // Equal costs come in order of memory.
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto first = static_cast<std::uint32_t>(g.offset(start[0], start[1], start[2]));
  ways.cost.voxels[first] = 0.0F;
  open.emplace(0.0F, first);
  constexpr std::size_t kCheckEvery = 65536;
  std::size_t done = 0;
  while (!open.empty()) {
    const auto [cost, at] = open.top();
    open.pop();
    if (cost > ways.cost.voxels[at]) continue;
    if (++done % kCheckEvery == 0) progress.check();
    const float here = costPerMm.voxels[at];
    forNeighbours(g, at, [&](std::size_t n, std::size_t next) {
      const float through = cost + lengths[n] * 0.5F * (here + costPerMm.voxels[next]);
      if (!(through < ways.cost.voxels[next])) return;
      ways.cost.voxels[next] = through;
      ways.from[next] = at;
      open.emplace(through, static_cast<std::uint32_t>(next));
    });
  }
  return ways;
}

}  // namespace angiomesh
