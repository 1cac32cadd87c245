// SPDX-License-Identifier: BSD-3-Clause
#include "core/vesselness/thickest.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/parallel.h"

namespace angiomesh {
namespace {

constexpr double kBlockVoxels = 4.0;
constexpr int kReachBlocks = 12;  // thicker than the largest scale can follow
constexpr double kLeastVoxels = 6.0, kMostVoxels = 15.0;  // of the largest scale

/// Means over blocks that are about as long in each direction; those at the far border are smaller.
Volume<float> blockMeans(const Volume<float>& image) {
  const Geometry& g = image.geometry;
  Geometry coarse = g;
  Index3 block{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    block[a] =
        std::max(1, static_cast<int>(std::lround(kBlockVoxels * g.voxelMm() / g.spacing[axis])));
    coarse.size[a] = (g.size[a] + block[a] - 1) / block[a];
    coarse.spacing[axis] = g.spacing[axis] * block[a];
  }
  Volume<float> means(coarse);
  parallelForEach(means.voxels.size(), 256, [&](std::size_t n) {
    const Index3 at = coarse.indexOf(n);
    Index3 low{};
    Index3 high{};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = at[a] * block[a];
      high[a] = std::min(low[a] + block[a], g.size[a]);
    }
    double sum = 0.0;
    for (int k = low[2]; k < high[2]; ++k)
      for (int j = low[1]; j < high[1]; ++j)
        for (int i = low[0]; i < high[0]; ++i) sum += static_cast<double>(image.at(i, j, k));
    means.voxels[n] = static_cast<float>(
        sum / (1.0 * (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2])));
  });
  return means;
}

/// Squared distances in mm between centres, to the nearest block that is not inside, as far as the
/// reach; blocks beyond the border do not count. Axis by axis (Saito and Toriwaki 1994).
std::vector<float> squaredDepth(const std::vector<char>& inside, const Geometry& g) {
  const double reach = kReachBlocks * g.spacing.minCoeff();
  const auto far = static_cast<float>(reach * reach);
  std::vector<float> from(inside.size()), to(inside.size());
  for (std::size_t n = 0; n < inside.size(); ++n) from[n] = inside[n] != 0 ? far : 0.0F;
  std::size_t stride = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto spacing = static_cast<float>(g.spacing[static_cast<Eigen::Index>(a)]);
    const auto step = static_cast<std::ptrdiff_t>(stride);
    parallelForEach(from.size(), 4096, [&](std::size_t n) {
      const int at = g.indexOf(n)[a];
      const int low = std::max(-kReachBlocks, -at);
      const int high = std::min(kReachBlocks, g.size[a] - 1 - at);
      float least = from[n];
      for (int m = low; m <= high; ++m) {
        const float along = static_cast<float>(m) * spacing;
        least = std::min(least,
                         from[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(n) + m * step)] +
                             along * along);
      }
      to[n] = least;
    });
    std::swap(from, to);
    stride *= static_cast<std::size_t>(g.size[a]);
  }
  return from;
}

}  // namespace

double thickestRadiusMm(const Volume<float>& image, Polarity polarity) {
  const Volume<float> means = blockMeans(image);
  const Geometry& g = means.geometry;
  const bool bright = polarity == Polarity::Bright;
  const std::vector<double> p = percentiles(means, {bright ? 0.999 : 0.001, 0.5});
  const double middle = 0.5 * (p[0] + p[1]);

  std::vector<char> inside(means.voxels.size());
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const auto value = static_cast<double>(means.voxels[i]);
    inside[i] = static_cast<char>(bright ? value > middle : value < middle);
  }
  const auto count = std::count(inside.begin(), inside.end(), 1);
  if (count == 0 || count == static_cast<std::ptrdiff_t>(inside.size())) return 0.0;
  const std::vector<float> depth = squaredDepth(inside, g);
  // To the centres of the nearest blocks outside: the surface is half a block nearer.
  return std::sqrt(static_cast<double>(*std::max_element(depth.begin(), depth.end()))) -
         0.5 * g.spacing.minCoeff();
}

VesselnessParams withScalesFromImage(VesselnessParams params, const Volume<float>& image) {
  if (params.sigmaMaxMm || !params.scalesFromImage) return params;
  const double voxel = image.geometry.voxelMm();
  params.sigmaMaxMm = std::clamp(0.5 * thickestRadiusMm(image, params.polarity),
                                 kLeastVoxels * voxel, kMostVoxels * voxel);
  return params;
}

}  // namespace angiomesh
