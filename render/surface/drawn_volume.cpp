// SPDX-License-Identifier: BSD-3-Clause
#include "render/surface/drawn_volume.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/parallel.h"
#include "render/slice/slice_raster.h"

namespace angiomesh {

namespace {

std::size_t at(int n) { return static_cast<std::size_t>(n); }

/// First and last voxel that the cells of a block lie between.
std::array<int, 2> voxelsOf(int block, int size) {
  return {block * kBlockCells, std::min(block * kBlockCells + kBlockCells, size - 1)};
}

std::array<float, 2> rangeOf(const Volume<float>& image, const Index3& block) {
  const Index3& size = image.geometry.size;
  const auto [x0, x1] = voxelsOf(block[0], size[0]);
  const auto [y0, y1] = voxelsOf(block[1], size[1]);
  const auto [z0, z1] = voxelsOf(block[2], size[2]);
  float least = std::numeric_limits<float>::max();
  float greatest = -least;
  for (int z = z0; z <= z1; ++z)
    for (int y = y0; y <= y1; ++y) {
      const float* row = &image.at(x0, y, z);
      for (int x = 0; x <= x1 - x0; ++x) {
        least = std::min(least, row[x]);
        greatest = std::max(greatest, row[x]);
      }
    }
  return {least, greatest};
}

}  // namespace

std::shared_ptr<const DrawnVolume> drawnVolume(std::shared_ptr<const Volume<float>> image) {
  if (!image || image->voxels.empty()) return nullptr;
  const Index3& size = image->geometry.size;
  if (*std::min_element(size.begin(), size.end()) < 2) return nullptr;
  auto drawn = std::make_shared<DrawnVolume>();
  for (std::size_t a = 0; a < 3; ++a)
    drawn->blocks[a] = (size[a] - 1 + kBlockCells - 1) / kBlockCells;
  const auto [bx, by, bz] = drawn->blocks;
  drawn->least.resize(at(bx) * at(by) * at(bz));
  drawn->greatest.resize(drawn->least.size());
  parallelForEach(at(by) * at(bz), 1, [&, bx = bx, by = by](std::size_t row) {
    const auto y = static_cast<int>(row % at(by));
    const auto z = static_cast<int>(row / at(by));
    for (int x = 0; x < bx; ++x) {
      const auto [least, greatest] = rangeOf(*image, {x, y, z});
      drawn->least[row * at(bx) + at(x)] = least;
      drawn->greatest[row * at(bx) + at(x)] = greatest;
    }
  });
  drawn->bright = displayRange(*image, 0.90, 0.9995);
  drawn->vessels = displayRange(*image, 0.97, 0.998);
  drawn->image = std::move(image);
  return drawn;
}

}  // namespace angiomesh
