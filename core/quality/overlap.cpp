// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/statistics.h"
#include "core/image/voxels.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

/// The interface that nanoflann asks of a point set.
struct PointSet {
  std::vector<Vector3d> points;
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return points[i][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointSet>,
                                                 PointSet, 3, std::size_t>;

/// Centres, in LPS mm, of the mask's voxels that have a 6-neighbour outside the mask. The volume's
/// border is not a surface: a vessel that leaves the volume has no wall there.
PointSet surfaceVoxels(const Volume<std::uint8_t>& mask) {
  const Geometry& g = mask.geometry;
  std::vector<std::vector<Vector3d>> slices(static_cast<std::size_t>(g.size[2]));
  const auto empty = [&](int i, int j, int k) {
    return g.contains(i, j, k) && mask.at(i, j, k) == 0;
  };
  parallelForEach(slices.size(), 1, [&](std::size_t slice) {
    const int k = static_cast<int>(slice);
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i)
        if (mask.at(i, j, k) != 0 &&
            (empty(i - 1, j, k) || empty(i + 1, j, k) || empty(i, j - 1, k) || empty(i, j + 1, k) ||
             empty(i, j, k - 1) || empty(i, j, k + 1)))
          slices[slice].push_back(voxelCentre(g, {i, j, k}));
  });
  PointSet set;
  for (const auto& slice : slices) set.points.insert(set.points.end(), slice.begin(), slice.end());
  return set;
}

/// For each point of `from` the distance to the nearest of `to`; empty when either is.
std::vector<double> nearestDistances(const PointSet& from, const PointSet& to,
                                     const Progress& progress) {
  if (to.points.empty()) return {};
  const Tree tree(3, to, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  std::vector<double> distances(from.points.size());
  parallelForEach(distances.size(), 4096, progress, [&](std::size_t i) {
    std::size_t nearest = 0;
    double square = 0.0;
    tree.knnSearch(from.points[i].data(), 1, &nearest, &square);
    distances[i] = std::sqrt(square);
  });
  return distances;
}

double sumOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum;
}

/// Coordinates that rounding in a file's header moved off the voxel centre are put back, so that
/// aligned grids reproduce the sign of phi exactly.
double snapped(double index) {
  constexpr double tolerance = 1e-3;
  const double nearest = std::round(index);
  return std::fabs(index - nearest) < tolerance ? nearest : index;
}

}  // namespace

VoxelRatios voxelRatios(const Volume<std::uint8_t>& result, const Volume<std::uint8_t>& truth) {
  if (!(result.geometry == truth.geometry))
    throw InputError("result and truth are on different grids", "comparison with the truth",
                     "give a truth mask of the same size, spacing, origin and direction");
  std::array<std::size_t, 4> counts{};  // neither, result only, truth only, both
  for (std::size_t i = 0; i < truth.voxels.size(); ++i)
    ++counts[(result.voxels[i] != 0 ? 1U : 0U) + (truth.voxels[i] != 0 ? 2U : 0U)];
  if (counts[2] + counts[3] == 0)
    throw InputError("the truth mask is empty", "comparison with the truth",
                     "give a mask whose vessel voxels are not 0");
  const double share = 100.0 / static_cast<double>(truth.voxels.size());
  const auto both = static_cast<double>(counts[3]);
  const auto wrong = static_cast<double>(counts[1] + counts[2]);
  VoxelRatios ratios;
  ratios.trueNegative = share * static_cast<double>(counts[0]);
  ratios.falsePositive = share * static_cast<double>(counts[1]);
  ratios.falseNegative = share * static_cast<double>(counts[2]);
  ratios.truePositive = share * both;
  ratios.overlap = 100.0 * 2.0 * both / (2.0 * both + wrong);
  return ratios;
}

OverlapMeasures compareMasks(const Volume<std::uint8_t>& result, const Volume<std::uint8_t>& truth,
                             const Progress& progress) {
  const VoxelRatios ratios = voxelRatios(result, truth);
  progress.report(0.1);

  OverlapMeasures measures;
  measures.overlap = ratios.overlap;
  measures.sensitivity = ratios.truePositive / (ratios.truePositive + ratios.falseNegative);
  const double positive = ratios.truePositive + ratios.falsePositive;
  if (positive > 0.0) measures.precision = ratios.truePositive / positive;

  const PointSet resultSurface = surfaceVoxels(result);
  const PointSet truthSurface = surfaceVoxels(truth);
  progress.report(0.3);
  std::vector<double> there = nearestDistances(resultSurface, truthSurface, progress);
  progress.report(0.65);
  std::vector<double> back = nearestDistances(truthSurface, resultSurface, progress);
  if (there.empty() || back.empty()) {
    const bool same = ratios.falsePositive + ratios.falseNegative == 0.0;
    measures.assdMm = same ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    measures.hd95Mm = measures.assdMm;
  } else {
    measures.assdMm =
        (sumOf(there) + sumOf(back)) / static_cast<double>(there.size() + back.size());
    measures.hd95Mm = std::max(percentile(there, 0.95), percentile(back, 0.95));
  }
  progress.report(1.0);
  return measures;
}

Volume<std::uint8_t> maskOnGrid(const Volume<float>& phi, const Geometry& grid, double level) {
  Volume<std::uint8_t> mask(grid);
  const Eigen::Matrix3d toIndex = phi.geometry.physicalToIndexMatrix();
  const Eigen::Matrix3d step = toIndex * grid.direction * grid.spacing.asDiagonal();
  const Vector3d start = toIndex * (grid.origin - phi.geometry.origin);
  const auto rows = static_cast<std::size_t>(grid.size[1]) * static_cast<std::size_t>(grid.size[2]);
  parallelForEach(rows, 64, [&](std::size_t row) {
    const int j = static_cast<int>(row % static_cast<std::size_t>(grid.size[1]));
    const int k = static_cast<int>(row / static_cast<std::size_t>(grid.size[1]));
    for (int i = 0; i < grid.size[0]; ++i) {
      Vector3d index = start + step * Vector3d(i, j, k);
      bool inVolume = true;
      for (int a = 0; a < 3; ++a) {
        index[a] = snapped(index[a]);
        inVolume = inVolume && index[a] >= -0.5 && index[a] <= phi.geometry.size[a] - 0.5;
      }
      if (inVolume && interpolateLinear(phi, index) < level) mask.at(i, j, k) = 1;
    }
  });
  return mask;
}

}  // namespace angiomesh
