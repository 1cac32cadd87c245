// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/rasterise.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/parallel.h"

namespace angiomesh {
namespace {

constexpr int kBlock = 32;  // voxels; blocks and bricks: two levels of leaving out distant solids
constexpr int kBrick = 8;

struct Box {
  Index3 first, last;  ///< last is not included
};

struct Nearby {
  std::vector<int> solids;  ///< those that can matter in the box
  double distance = 0.0;    ///< of the shape at the box's centre
  double reach = 0.0;       ///< from the centre to the farthest subvoxel
};

Nearby solidsNear(const Shape& shape, const std::vector<int>& candidates, const Geometry& g,
                  const Box& box) {
  Eigen::Vector3d centre;
  Eigen::Vector3d half;
  for (int a = 0; a < 3; ++a) {
    centre[a] = 0.5 * (box.first[a] + box.last[a] - 1) * g.spacing[a];
    half[a] = (0.5 * (box.last[a] - box.first[a] - 1) + 0.25) * g.spacing[a];
  }
  Nearby near;
  near.reach = std::sqrt(half.dot(half));
  if (shape.blendMm > 0.0) {  // every solid may shift the blend
    near.solids = candidates;
    near.distance = shape.signedDistance(centre);
    return near;
  }
  std::vector<double> distances;
  distances.reserve(candidates.size());
  near.distance = std::numeric_limits<double>::max();
  for (const int n : candidates) {
    distances.push_back(signedDistance(shape.solids[static_cast<std::size_t>(n)], centre));
    near.distance = std::min(near.distance, distances.back());
  }
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (distances[i] <= near.distance + 2.0 * near.reach * (1.0 + 1e-9))
      near.solids.push_back(candidates[i]);
  return near;
}

/// Calls body(brick, nearby solids) for all bricks of the grid; slabs of blocks run in parallel.
template <class Body>
void forEachBrick(const Shape& shape, const Geometry& g, const Progress& progress,
                  const Body& body) {
  std::vector<int> all(shape.solids.size());
  std::iota(all.begin(), all.end(), 0);
  const auto blocks = [&](int a) { return (g.size[a] + kBlock - 1) / kBlock; };
  const auto columns = static_cast<std::size_t>(blocks(0)) * static_cast<std::size_t>(blocks(1)) *
                       static_cast<std::size_t>(blocks(2));
  const auto cut = [&](const Index3& first, int edge) {
    Box box{first, {}};
    for (int a = 0; a < 3; ++a) box.last[a] = std::min(first[a] + edge, g.size[a]);
    return box;
  };
  std::atomic<std::size_t> done{0};
  parallelFor(0, columns, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const auto nx = static_cast<std::size_t>(blocks(0));
      const auto ny = static_cast<std::size_t>(blocks(1));
      const Box block =
          cut({static_cast<int>(n % nx) * kBlock, static_cast<int>(n / nx % ny) * kBlock,
               static_cast<int>(n / nx / ny) * kBlock},
              kBlock);
      const Nearby coarse = solidsNear(shape, all, g, block);
      for (int k = block.first[2]; k < block.last[2]; k += kBrick)
        for (int j = block.first[1]; j < block.last[1]; j += kBrick) {
          progress.check();
          for (int i = block.first[0]; i < block.last[0]; i += kBrick) {
            const Box brick = cut({i, j, k}, kBrick);
            body(brick, solidsNear(shape, coarse.solids, g, brick));
          }
        }
      progress.report(static_cast<double>(++done) / static_cast<double>(columns));
    }
  });
}

template <class Body>
void forEachVoxel(const Box& box, const Body& body) {
  for (int k = box.first[2]; k < box.last[2]; ++k)
    for (int j = box.first[1]; j < box.last[1]; ++j)
      for (int i = box.first[0]; i < box.last[0]; ++i) body(i, j, k);
}

}  // namespace

Volume<std::uint8_t> countSubvoxels(const Shape& shape, const Geometry& geometry,
                                    const Progress& progress) {
  Volume<std::uint8_t> counts(geometry);
  const Eigen::Vector3d quarter = 0.25 * geometry.spacing;
  const double voxelReach = std::sqrt(quarter.dot(quarter)) * (1.0 + 1e-9);
  forEachBrick(shape, geometry, progress, [&](const Box& brick, const Nearby& near) {
    if (near.distance > near.reach) return;
    const bool full = near.distance < -near.reach;
    forEachVoxel(brick, [&](int i, int j, int k) {
      std::uint8_t& count = counts.at(i, j, k);
      const Eigen::Vector3d centre = geometry.spacing.cwiseProduct(Eigen::Vector3d(i, j, k));
      const double d = full ? near.distance : shape.signedDistance(centre, near.solids);
      if (std::fabs(d) > voxelReach) {
        count = d < 0.0 ? 8 : 0;
        return;
      }
      for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d sign((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0,
                                   (corner & 4) != 0 ? 1.0 : -1.0);
        if (shape.signedDistance(centre + sign.cwiseProduct(quarter), near.solids) < 0.0) ++count;
      }
    });
  });
  return counts;
}

Volume<float> sampleField(const Shape& shape, const Geometry& geometry, const Progress& progress) {
  Volume<float> field(geometry);
  forEachBrick(shape, geometry, progress, [&](const Box& brick, const Nearby& near) {
    forEachVoxel(brick, [&](int i, int j, int k) {
      const Eigen::Vector3d centre = geometry.spacing.cwiseProduct(Eigen::Vector3d(i, j, k));
      field.at(i, j, k) = static_cast<float>(shape.signedDistance(centre, near.solids));
    });
  });
  return field;
}

}  // namespace angiomesh
