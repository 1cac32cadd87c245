// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/phantom/shape.h"

namespace angiomesh {

/// Number (0..8) of the 2x2x2 subvoxels of each voxel, centred +-1/4 voxel around its centre, that
/// lie inside the shape. Parallel; the same for any number of threads.
Volume<std::uint8_t> countSubvoxels(const Shape& shape, const Geometry& geometry,
                                    const Progress& progress = {});

/// How much of each voxel lies inside a shape, and of each voxel that the wall crosses how much of
/// its 4x4x4 equal cells. On a plane every share is exact, on a wall of radius 1.3 voxels right
/// within 0.002.
struct PartialVolumes {
  static constexpr int kCells = 4;
  /// x fastest, 255 is full
  using Cells = std::array<std::uint8_t, std::size_t{kCells} * kCells * kCells>;
  static constexpr std::int32_t kOutside = -1, kInside = -2;

  Geometry grid;
  BigVector<std::int32_t> state;  ///< of each voxel: kOutside, kInside, or its place in `cells`
  std::vector<Cells> cells;

  /// 0..1.
  [[nodiscard]] double share(std::size_t voxel) const;
};

/// @param grid identity direction; may begin anywhere
/// @param soft each cell's share is a mean over boxes of its size whose centres lie in it: so a
/// blur of the cells does not depend on where in a cell the wall is. It is that of a wall blurred
/// by a cell's box.
PartialVolumes partialVolumes(const Shape& shape, const Geometry& grid, bool soft = false,
                              const Progress& progress = {});

/// Which solids of a shape matter where: its signed distance at single points, fast.
class ShapeIndex {
 public:
  /// @param grid identity direction; beyond it all solids are asked
  ShapeIndex(const Shape& shape, const Geometry& grid);
  /// As Shape::signedDistance(), the same bits.
  [[nodiscard]] double signedDistance(const Eigen::Vector3d& point) const;

 private:
  Shape shape_;
  Geometry grid_;
  Index3 bricks_{};
  std::vector<std::vector<int>> solids_;  ///< of each brick of voxels
};

/// The shape's signed distance at the voxel centres, mm.
Volume<float> sampleField(const Shape& shape, const Geometry& geometry,
                          const Progress& progress = {});

}  // namespace angiomesh
