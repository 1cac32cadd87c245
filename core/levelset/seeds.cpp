// SPDX-License-Identifier: BSD-3-Clause
#include "core/levelset/seeds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <string>

#include "core/base/error.h"
#include "core/image/voxels.h"

namespace angiomesh {
namespace {

Eigen::Vector3d asVector(const Index3& p) { return {1.0 * p[0], 1.0 * p[1], 1.0 * p[2]}; }

/// Offsets of the `count` voxels of largest positive value, in order of memory; ties go to the
/// first.
std::vector<std::size_t> brightestVoxels(const Volume<float>& v, std::size_t count) {
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < v.voxels.size(); ++i)
    if (v.voxels[i] > 0.0F) candidates.push_back(i);
  count = std::min(count, candidates.size());
  const auto brighter = [&v](std::size_t a, std::size_t b) {
    return v.voxels[a] != v.voxels[b] ? v.voxels[a] > v.voxels[b] : a < b;
  };
  const auto end = candidates.begin() + static_cast<std::ptrdiff_t>(count);
  std::nth_element(candidates.begin(), end, candidates.end(), brighter);
  candidates.resize(count);
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

/// Distance from a set of points by fast marching, in working voxels.
class FastMarching {
 public:
  FastMarching(const Geometry& geometry, double limit)
      : geometry_(geometry),
        limit_(limit),
        distance_(geometry, std::numeric_limits<float>::max()),
        accepted_(geometry) {
    for (int a = 0; a < 3; ++a) step_[a] = geometry.spacing[a] / geometry.voxelMm();
  }

  void start(std::size_t voxel, double distance) {
    if (distance < static_cast<double>(distance_.voxels[voxel])) push(voxel, distance);
  }

  const Volume<float>& march() {
    while (!heap_.empty()) {
      const auto [distance, voxel] = heap_.top();
      heap_.pop();
      if (accepted_.voxels[voxel] != 0) continue;
      accepted_.voxels[voxel] = 1;
      forFaceNeighbours(geometry_, voxel, [&](std::size_t next) {
        if (accepted_.voxels[next] == 0) start(next, solve(geometry_.indexOf(next)));
      });
    }
    return distance_;
  }

 private:
  using Entry = std::pair<double, std::size_t>;

  void push(std::size_t voxel, double distance) {
    if (distance > limit_) return;
    distance_.voxels[voxel] = static_cast<float>(distance);
    heap_.emplace(distance, voxel);
  }

  /// Upwind solution of |grad T| = 1 from the accepted neighbours (Sethian 1996).
  [[nodiscard]] double solve(const Index3& p) const {
    std::array<std::pair<double, double>, 3> sides;  // value, step
    std::size_t known = 0;
    for (int a = 0; a < 3; ++a) {
      double best = std::numeric_limits<double>::max();
      for (int side = -1; side <= 1; side += 2) {
        Index3 q = p;
        q[a] += side;
        if (q[a] < 0 || q[a] >= geometry_.size[a]) continue;
        const std::size_t at = geometry_.offset(q[0], q[1], q[2]);
        if (accepted_.voxels[at] != 0)
          best = std::min(best, static_cast<double>(distance_.voxels[at]));
      }
      if (best == std::numeric_limits<double>::max()) continue;
      std::size_t place = known++;
      for (; place > 0 && sides[place - 1].first > best; --place) sides[place] = sides[place - 1];
      sides[place] = {best, step_[a]};
    }
    double a = 0.0;
    double b = 0.0;
    double c = -1.0;
    double solution = std::numeric_limits<double>::max();
    for (std::size_t n = 0; n < known; ++n) {
      if (sides[n].first >= solution) break;
      const double w = 1.0 / (sides[n].second * sides[n].second);
      a += w;
      b += w * sides[n].first;
      c += w * sides[n].first * sides[n].first;
      solution = (b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
    }
    return solution;
  }

  Geometry geometry_;
  double limit_;
  std::array<double, 3> step_{};
  Volume<float> distance_;
  Volume<std::uint8_t> accepted_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap_;
};

/// Calls visit(voxel, distance) for the voxels of a box around the ball, at least one voxel to
/// either side. Lengths in working voxels.
template <class Visit>
void forBall(const Geometry& geometry, const Eigen::Vector3d& centreLps, double radius,
             Visit visit) {
  const Eigen::Vector3d index = geometry.toIndex(centreLps);
  Index3 low;
  Index3 high;
  for (int a = 0; a < 3; ++a) {
    const double reach = std::max(radius * geometry.voxelMm() / geometry.spacing[a], 1.0);
    low[a] = std::max(static_cast<int>(std::ceil(index[a] - reach)), 0);
    high[a] = std::min(static_cast<int>(std::floor(index[a] + reach)), geometry.size[a] - 1);
  }
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i) {
        const Eigen::Vector3d away =
            geometry.spacing.cwiseProduct(Eigen::Vector3d(i, j, k) - index);
        visit(geometry.offset(i, j, k), away.norm() / geometry.voxelMm());
      }
}

}  // namespace

std::vector<Eigen::Vector3d> findSeeds(const Volume<float>& single, const SeedParams& params) {
  const Geometry& g = single.geometry;
  std::vector<Eigen::Vector3d> seeds;
  if (params.automatic) {
    const double wanted = params.topPercent / 100.0 * static_cast<double>(single.voxels.size());
    const auto count = static_cast<std::size_t>(std::max(1.0, std::floor(wanted + 0.5)));
    std::vector<std::size_t> voxels = brightestVoxels(single, count);
    const auto best = std::max_element(
        voxels.begin(), voxels.end(),
        [&](std::size_t a, std::size_t b) { return single.voxels[a] < single.voxels[b]; });
    const auto least =
        voxels.empty() ? 0.0F : std::min(static_cast<float>(params.least), single.voxels[*best]);
    for (const std::size_t voxel : voxels)
      if (single.voxels[voxel] >= least) seeds.push_back(g.toPhysical(asVector(g.indexOf(voxel))));
  }
  for (std::size_t i = 0; i + 2 < params.points.size(); i += 3) {
    const Eigen::Vector3d point(params.points[i], params.points[i + 1], params.points[i + 2]);
    const Eigen::Vector3d index = g.toIndex(point);
    for (int a = 0; a < 3; ++a)
      if (!(index[a] >= -0.5 && index[a] <= g.size[a] - 0.5))
        throw InputError("the seed " + std::to_string(point[0]) + "," + std::to_string(point[1]) +
                             "," + std::to_string(point[2]) + " lies outside the volume",
                         "seeds.points", "give points in mm LPS inside the volume");
    seeds.push_back(point);
  }
  if (seeds.empty())
    throw NumericError("no seed was found", "seeds",
                       "widen the range of vessel sizes (vesselness.sigmaMinMm, "
                       "vesselness.sigmaMaxMm), raise seeds.topPercent or give a seed by hand");
  return seeds;
}

Volume<float> fastMarchingStart(const Geometry& geometry,
                                const std::vector<Eigen::Vector3d>& seedsLps, double radiusVoxels) {
  constexpr double band = 4.0;
  FastMarching marching(geometry, radiusVoxels + band);
  // Exact distances as far as one voxel from the sphere: a march from a single point would be
  // coarse there.
  for (const Eigen::Vector3d& seed : seedsLps)
    forBall(geometry, seed, radiusVoxels + 1.0,
            [&](std::size_t voxel, double distance) { marching.start(voxel, distance); });
  Volume<float> phi = marching.march();
  for (float& value : phi.voxels)
    value = static_cast<float>(std::min(static_cast<double>(value) - radiusVoxels, band));
  return phi;
}

std::vector<std::size_t> voxelsAroundSeeds(const Geometry& geometry,
                                           const std::vector<Eigen::Vector3d>& seedsLps,
                                           double radiusVoxels) {
  std::vector<std::size_t> voxels;
  for (const Eigen::Vector3d& seed : seedsLps)
    forBall(geometry, seed, radiusVoxels, [&](std::size_t voxel, double distance) {
      if (distance < radiusVoxels) voxels.push_back(voxel);
    });
  std::sort(voxels.begin(), voxels.end());
  voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
  return voxels;
}

}  // namespace angiomesh
