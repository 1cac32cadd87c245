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
  double reach = 0.0;       ///< from the centre to the box's corners
};

Nearby solidsNear(const Shape& shape, const std::vector<int>& candidates, const Geometry& g,
                  const Box& box) {
  Eigen::Vector3d centre;
  Eigen::Vector3d half;
  for (int a = 0; a < 3; ++a) {
    centre[a] = g.origin[a] + 0.5 * (box.first[a] + box.last[a] - 1) * g.spacing[a];
    half[a] = 0.5 * (box.last[a] - box.first[a]) * g.spacing[a];
  }
  Nearby near;
  near.reach = std::sqrt(half.dot(half));
  std::vector<double> distances;
  distances.reserve(candidates.size());
  double least = std::numeric_limits<double>::max();
  for (const int n : candidates) {
    distances.push_back(signedDistance(shape.solids[static_cast<std::size_t>(n)], centre));
    least = std::min(least, distances.back());
  }
  // A solid farther than the nearest by the blend leaves the union as it is, and solids that blend
  // with one another first come nearer by less than the blend.
  const double limit = least + 2.0 * near.reach * (1.0 + 1e-9) + 2.0 * shape.blendMm;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (distances[i] <= limit) near.solids.push_back(candidates[i]);
  near.distance = shape.blendMm > 0.0 ? shape.signedDistance(centre, near.solids) : least;
  return near;
}

Eigen::Vector3d centreOf(const Geometry& g, int i, int j, int k) {
  return g.origin + g.spacing.cwiseProduct(Eigen::Vector3d(i, j, k));
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
  parallelForEach(columns, 1, [&](std::size_t n) {
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
  });
}

template <class Body>
void forEachVoxel(const Box& box, const Body& body) {
  for (int k = box.first[2]; k < box.last[2]; ++k)
    for (int j = box.first[1]; j < box.last[1]; ++j)
      for (int i = box.first[0]; i < box.last[0]; ++i) body(i, j, k);
}

constexpr int kCells = PartialVolumes::kCells;
constexpr double kGaussPoint = 0.28867513459481287;  // of two in an interval of length 1
constexpr std::int32_t kWall = -3;  // of a voxel that waits for its place in the list of cells

/// The share of a box inside the half-space whose border lies `distance` beyond the box's centre
/// (negative: before it). @param extent of the box along each axis times the normal's component
double shareInside(double distance, const Eigen::Vector3d& extent) {
  std::array<double, 3> e{};
  double sum = 0.0;
  for (int a = 0; a < 3; ++a) sum += std::fabs(extent[a]);
  for (int a = 0; a < 3; ++a)  // an edge along the wall: no division by nothing
    e[static_cast<std::size_t>(a)] = std::max(std::fabs(extent[a]), 1e-3 * sum);
  const double full = e[0] + e[1] + e[2];
  const double depth = distance + 0.5 * full;
  if (depth <= 0.0) return 0.0;
  if (depth >= full) return 1.0;
  const auto cube = [&](double x) { return x > 0.0 ? x * x * x : 0.0; };
  // The simplex cut off, less what sticks out of the box (Scardovelli and Zaleski 2000).
  const double volume = cube(depth) - cube(depth - e[0]) - cube(depth - e[1]) - cube(depth - e[2]) +
                        cube(depth - e[0] - e[1]) + cube(depth - e[1] - e[2]) +
                        cube(depth - e[2] - e[0]);
  return std::clamp(volume / (6.0 * e[0] * e[1] * e[2]), 0.0, 1.0);
}

using CellDistances = std::array<double, static_cast<std::size_t>(kCells* kCells* kCells)>;

/// A quadratic fit's parts along one axis: mean slope, and mean second derivative times h^2.
void derivatives(const CellDistances& d, std::size_t stride, double& slope, double& bend) {
  slope = 0.0;
  bend = 0.0;
  for (std::size_t n = 0; n < d.size(); ++n) {
    if (n / stride % kCells != 0) continue;
    slope += 3.0 * (d[n + 3 * stride] - d[n]) + d[n + 2 * stride] - d[n + stride];
    bend += d[n + 3 * stride] - d[n + 2 * stride] - d[n + stride] + d[n];
  }
  slope /= 10.0 * kCells * kCells;
  bend /= 2.0 * kCells * kCells;
}

/// The shares of a voxel's cells: a plane in each, moved by what the wall's curvature adds.
PartialVolumes::Cells cellShares(const Shape& shape, const std::vector<int>& solids,
                                 const Eigen::Vector3d& centre, const Eigen::Vector3d& spacing,
                                 bool soft) {
  const Eigen::Vector3d h = spacing / kCells;
  CellDistances d{};
  for (std::size_t n = 0; n < d.size(); ++n) {
    const Eigen::Vector3d at(static_cast<double>(n % kCells),
                             static_cast<double>(n / kCells % kCells),
                             static_cast<double>(n / kCells / kCells % kCells));
    d[n] = shape.signedDistance(
        centre + h.cwiseProduct(at - Eigen::Vector3d::Constant(0.5 * (kCells - 1))), solids);
  }
  Eigen::Vector3d slope;  // of the distance over one cell
  double bends = 0.0;
  double square = 0.0;
  std::size_t stride = 1;
  for (int a = 0; a < 3; ++a, stride *= kCells) {
    double bend = 0.0;
    derivatives(d, stride, slope[a], bend);
    bends += bend;
    square += slope[a] * slope[a] / (h[a] * h[a]);
  }
  const double steepness = std::max(std::sqrt(square), 0.25);  // 1 of a distance
  // The mean over a cell is h^2/24 times the second derivatives above the value in its centre;
  // where two solids meet in an edge these say nothing.
  const double lift = std::clamp(bends / 24.0, -0.02 * h.minCoeff(), 0.02 * h.minCoeff());
  const Eigen::Vector3d extent = slope / steepness;
  const double reach = extent.cwiseAbs().sum();
  PartialVolumes::Cells shares{};
  for (std::size_t n = 0; n < d.size(); ++n) {
    const double depth = -(d[n] + lift) / steepness;
    double share = 0.0;
    if (!soft || std::fabs(depth) >= reach) {
      share = shareInside(depth, extent);
    } else {
      for (int corner = 0; corner < 8; ++corner) {
        double moved = depth;
        for (int a = 0; a < 3; ++a)
          moved += ((corner >> a & 1) != 0 ? kGaussPoint : -kGaussPoint) * extent[a];
        share += shareInside(moved, extent) / 8.0;
      }
    }
    shares[n] = static_cast<std::uint8_t>(std::floor(255.0 * share + 0.5));
  }
  return shares;
}

}  // namespace

double PartialVolumes::share(std::size_t voxel) const {
  const std::int32_t s = state[voxel];
  if (s < 0) return s == kInside ? 1.0 : 0.0;
  int sum = 0;
  for (const std::uint8_t cell : cells[static_cast<std::size_t>(s)]) sum += cell;
  return sum / (255.0 * kCells * kCells * kCells);
}

PartialVolumes partialVolumes(const Shape& shape, const Geometry& grid, bool soft,
                              const Progress& progress) {
  PartialVolumes out;
  out.grid = grid;
  out.state.assign(grid.voxelCount(), PartialVolumes::kOutside);
  const double diagonal = std::sqrt(grid.spacing.dot(grid.spacing));
  const double reach = (soft ? 0.5 + 0.5 / kCells : 0.5) * diagonal * (1.0 + 1e-9);
  forEachBrick(shape, grid, progress.sub(0.0, 0.3), [&](const Box& brick, const Nearby& near) {
    const double beyond = near.reach + (soft ? 0.5 * diagonal / kCells : 0.0);
    if (near.distance > beyond) return;
    const bool full = near.distance < -beyond;
    forEachVoxel(brick, [&](int i, int j, int k) {
      const double d =
          full ? -near.reach : shape.signedDistance(centreOf(grid, i, j, k), near.solids);
      std::int32_t& state = out.state[grid.offset(i, j, k)];
      if (std::fabs(d) <= reach && !full)
        state = kWall;
      else if (d < 0.0)
        state = PartialVolumes::kInside;
    });
  });
  std::int32_t count = 0;
  for (std::int32_t& state : out.state)
    if (state == kWall) state = count++;
  out.cells.resize(static_cast<std::size_t>(count));
  forEachBrick(shape, grid, progress.sub(0.3, 1.0), [&](const Box& brick, const Nearby& near) {
    if (std::fabs(near.distance) > near.reach + 0.5 * diagonal / kCells) return;
    forEachVoxel(brick, [&](int i, int j, int k) {
      const std::int32_t place = out.state[grid.offset(i, j, k)];
      if (place >= 0)
        out.cells[static_cast<std::size_t>(place)] =
            cellShares(shape, near.solids, centreOf(grid, i, j, k), grid.spacing, soft);
    });
  });
  return out;
}

ShapeIndex::ShapeIndex(const Shape& shape, const Geometry& grid) : shape_(shape), grid_(grid) {
  for (std::size_t a = 0; a < 3; ++a) bricks_[a] = (grid.size[a] + kBrick - 1) / kBrick;
  solids_.resize(static_cast<std::size_t>(bricks_[0]) * static_cast<std::size_t>(bricks_[1]) *
                 static_cast<std::size_t>(bricks_[2]));
  forEachBrick(shape_, grid_, {}, [&](const Box& brick, const Nearby& near) {
    const auto at = [&](std::size_t a) {
      return static_cast<std::size_t>(brick.first[a] / kBrick);
    };
    solids_[at(0) + static_cast<std::size_t>(bricks_[0]) *
                        (at(1) + static_cast<std::size_t>(bricks_[1]) * at(2))] = near.solids;
  });
}

double ShapeIndex::signedDistance(const Eigen::Vector3d& point) const {
  std::size_t place = 0;
  for (int a = 2; a >= 0; --a) {
    const double voxel = (point[a] - grid_.origin[a]) / grid_.spacing[a] + 0.5;
    if (!(voxel >= 0.0 && voxel < grid_.size[static_cast<std::size_t>(a)]))
      return shape_.signedDistance(point);
    place = place * static_cast<std::size_t>(bricks_[static_cast<std::size_t>(a)]) +
            static_cast<std::size_t>(voxel) / kBrick;
  }
  return shape_.signedDistance(point, solids_[place]);
}

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
      const Eigen::Vector3d centre = centreOf(geometry, i, j, k);
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
      const Eigen::Vector3d centre = centreOf(geometry, i, j, k);
      field.at(i, j, k) = static_cast<float>(shape.signedDistance(centre, near.solids));
    });
  });
  return field;
}

}  // namespace angiomesh
