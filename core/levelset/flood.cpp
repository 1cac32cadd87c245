// SPDX-License-Identifier: BSD-3-Clause
#include "core/levelset/flood.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/levelset/seeds.h"

namespace angiomesh {
namespace {

constexpr float kCoreRatio = 3.0F;  ///< v over b in the core of a vessel

}  // namespace

Volume<float> floodStart(const Volume<float>& vesselness, double b,
                         const Volume<std::uint8_t>& found) {
  Volume<float> phi(vesselness.geometry);
  const auto scale = static_cast<float>(b);
  parallelForEach(phi.voxels.size(), 1 << 16, [&](std::size_t i) {
    const float below = (scale - vesselness.voxels[i]) / scale;
    phi.voxels[i] =
        found.voxels[i] != 0 ? std::clamp(below, -0.5F, -0.01F) : std::clamp(below, 0.01F, 0.5F);
  });
  return phi;
}

Volume<std::uint8_t> floodVessels(const Volume<float>& vesselness, double b,
                                  const std::vector<Eigen::Vector3d>& seedsLps, double radiusVoxels,
                                  std::size_t leastVoxels) {
  const auto least = static_cast<float>(b);
  constexpr std::size_t grain = 1 << 16;
  Volume<std::uint8_t> mask(vesselness.geometry);
  parallelForEach(mask.voxels.size(), grain, [&](std::size_t i) {
    mask.voxels[i] = static_cast<std::uint8_t>(vesselness.voxels[i] >= least);
  });
  const std::vector<std::size_t> seeded =
      voxelsAroundSeeds(vesselness.geometry, seedsLps, radiusVoxels);
  for (const std::size_t voxel : seeded) mask.voxels[voxel] = 1;
  const Components parts = connectedComponents(mask);
  std::vector<std::uint8_t> kept(parts.sizes.size() + 1, 0);
  for (std::size_t l = 0; l < parts.sizes.size(); ++l)
    kept[l + 1] = parts.sizes[l] >= leastVoxels ? 1 : 0;
  for (const std::size_t voxel : seeded)
    kept[static_cast<std::size_t>(parts.labels.voxels[voxel])] = 1;
  parallelForEach(mask.voxels.size(), grain, [&](std::size_t i) {
    mask.voxels[i] = kept[static_cast<std::size_t>(parts.labels.voxels[i])];
    if (mask.voxels[i] != 0 && vesselness.voxels[i] >= kCoreRatio * least) mask.voxels[i] = 2;
  });
  return mask;
}

}  // namespace angiomesh
