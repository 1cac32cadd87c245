// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/scan.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/parallel.h"

namespace angiomesh {
namespace {

constexpr int kCells = PartialVolumes::kCells;
constexpr double kSoftWidth = 0.408248290463863 / kCells;  // of two boxes of a cell, sqrt(1 / 6)
constexpr int kSlab = 16;  // slices of the image that are made together

std::array<AxisKernel, 3> kernelsOf(const PointSpread& psf, const Geometry& g) {
  std::array<AxisKernel, 3> kernels;
  for (int a = 0; a < 3; ++a)
    kernels[static_cast<std::size_t>(a)] = axisKernel(psf, psf.sigma * g.voxelMm() / g.spacing[a],
                                                      kCells, isWide(psf, g) ? kSoftWidth : 0.0);
  return kernels;
}

/// Blurs the cells of one slice of the margin's grid after another into slices of the image.
class Blur {
 public:
  Blur(const PointSpread& psf, const PartialVolumes& volumes, const VesselFade* fade,
       const Geometry& grid)
      : volumes_(volumes), grid_(grid), kernels_(kernelsOf(psf, grid)) {
    if (fade != nullptr) measureBrightness(*fade);
    for (std::size_t a = 0; a < 3; ++a) margin_[a] = kernels_[a].reach;
    const Geometry& g = volumes.grid;
    used_.assign(static_cast<std::size_t>(g.size[1]) * static_cast<std::size_t>(g.size[2]), {0, 0});
    for (std::size_t row = 0; row < used_.size(); ++row) {
      const auto length = static_cast<std::size_t>(g.size[0]);
      for (std::size_t i = 0; i < length; ++i) {
        if (volumes.state[row * length + i] == PartialVolumes::kOutside) continue;
        if (used_[row][1] == 0) used_[row][0] = static_cast<int>(i);
        used_[row][1] = static_cast<int>(i) + 1;
      }
    }
    for (int s = 0; s < kernels_[0].span(); ++s) {
      double sum = 0.0;
      for (int cell = 0; cell < kCells; ++cell) sum += kernels_[0].of(cell)[s];
      whole_.push_back(static_cast<float>(sum));
    }
  }

  /// Slices [first, last) of the image.
  void fill(Volume<float>& image, int first, int last, const Progress& progress) const {
    const auto area =
        static_cast<std::size_t>(grid_.size[0]) * static_cast<std::size_t>(grid_.size[1]);
    std::vector<float> plane(area), row(static_cast<std::size_t>(grid_.size[0]));
    const AxisKernel& kernel = kernels_[2];
    for (int k = first - kernel.reach; k < last + kernel.reach; ++k)
      for (int cell = 0; cell < kCells; ++cell) {
        progress.check();
        std::array<int, 2> rows{};
        if (!makePlane(k + margin_[2], cell, plane, row, rows)) continue;
        const std::size_t from =
            static_cast<std::size_t>(rows[0]) * static_cast<std::size_t>(grid_.size[0]);
        const std::size_t to =
            static_cast<std::size_t>(rows[1]) * static_cast<std::size_t>(grid_.size[0]);
        for (int out = std::max(first, k - kernel.reach);
             out <= std::min(last - 1, k + kernel.reach); ++out) {
          const auto weight = static_cast<float>(kernel.of(cell)[out - k + kernel.reach]);
          float* slice = image.voxels.data() + static_cast<std::size_t>(out) * area;
          for (std::size_t n = from; n < to; ++n) slice[n] += weight * plane[n];
        }
      }
  }

 private:
  /// The cells of one layer, blurred along x and y. @return whether there was any
  /// @param rows those of the plane that were written
  bool makePlane(int slice, int cellZ, std::vector<float>& plane, std::vector<float>& row,
                 std::array<int, 2>& rows) const {
    const Geometry& g = volumes_.grid;
    const AxisKernel& kernel = kernels_[1];
    const int height = grid_.size[1];
    bool any = false;
    for (int j = 0; j < g.size[1]; ++j) {
      if (usedOf(j, slice)[1] == 0) continue;
      const int middle = j - margin_[1];
      const int low = std::max(0, middle - kernel.reach);
      const int high = std::min(height - 1, middle + kernel.reach);
      if (low > high) continue;
      if (!any) {
        rows = {low, low};
        any = true;
      }
      std::fill(plane.begin() + at(rows[1]), plane.begin() + at(std::max(rows[1], high + 1)), 0.0F);
      rows[1] = std::max(rows[1], high + 1);
      for (int cellY = 0; cellY < kCells; ++cellY) {
        makeRow(j, slice, kCells * (cellY + kCells * cellZ), row);
        for (int out = low; out <= high; ++out) {
          const auto weight = static_cast<float>(kernel.of(cellY)[out - middle + kernel.reach]);
          float* line = plane.data() + at(out);
          for (std::size_t i = 0; i < row.size(); ++i) line[i] += weight * row[i];
        }
      }
    }
    return any;
  }

  /// The four cells of each voxel that begin at number `cell` in it, blurred along x.
  void makeRow(int j, int slice, int cell, std::vector<float>& row) const {
    const Geometry& g = volumes_.grid;
    const AxisKernel& kernel = kernels_[0];
    std::fill(row.begin(), row.end(), 0.0F);
    const auto [first, last] = usedOf(j, slice);
    const int width = grid_.size[0];
    for (int i = first; i < last; ++i) {
      const std::size_t voxel = g.offset(i, j, slice);
      const std::int32_t state = volumes_.state[voxel];
      if (state == PartialVolumes::kOutside) continue;
      const int middle = i - margin_[0];
      const int low = std::max(0, middle - kernel.reach);
      const int high = std::min(width - 1, middle + kernel.reach);
      const float bright = brightness_.empty() ? 1.0F : brightness_[voxel];
      const int shift = kernel.reach - middle;
      if (state == PartialVolumes::kInside) {
        for (int out = low; out <= high; ++out)
          row[static_cast<std::size_t>(out)] +=
              255.0F * bright * whole_[static_cast<std::size_t>(out + shift)];
        continue;
      }
      const PartialVolumes::Cells& cells = volumes_.cells[static_cast<std::size_t>(state)];
      for (int cellX = 0; cellX < kCells; ++cellX) {
        const float value = bright * cells[static_cast<std::size_t>(cell + cellX)];
        if (value == 0.0F) continue;
        const double* weights = kernel.of(cellX);
        for (int out = low; out <= high; ++out)
          row[static_cast<std::size_t>(out)] += value * static_cast<float>(weights[out + shift]);
      }
    }
  }

  void measureBrightness(const VesselFade& fade) {
    const Geometry& g = volumes_.grid;
    brightness_.assign(volumes_.state.size(), 1.0F);
    parallelForEach(brightness_.size(), 1U << 14, [&](std::size_t n) {
      if (volumes_.state[n] == PartialVolumes::kOutside) return;
      const Index3 at = g.indexOf(n);
      brightness_[n] = static_cast<float>(
          fade.at(g.origin + g.spacing.cwiseProduct(Eigen::Vector3d(at[0], at[1], at[2]))));
    });
  }

  [[nodiscard]] const std::array<int, 2>& usedOf(int j, int slice) const {
    return used_[static_cast<std::size_t>(j) +
                 static_cast<std::size_t>(volumes_.grid.size[1]) * static_cast<std::size_t>(slice)];
  }
  [[nodiscard]] std::ptrdiff_t at(int row) const {
    return static_cast<std::ptrdiff_t>(row) * grid_.size[0];
  }

  const PartialVolumes& volumes_;
  const Geometry& grid_;
  std::array<AxisKernel, 3> kernels_;
  std::array<int, 3> margin_{};
  std::vector<std::array<int, 2>> used_;  ///< of each row: the voxels that are not all outside
  BigVector<float> brightness_;           ///< of the voxels of the margin's grid; empty: 1
  std::vector<float> whole_;              ///< along x, of a voxel all of whose cells are full
};

}  // namespace

Geometry withMargin(const Geometry& grid, const PointSpread& psf) {
  Geometry wide = grid;
  const std::array<AxisKernel, 3> kernels = kernelsOf(psf, grid);
  for (std::size_t a = 0; a < 3; ++a) {
    wide.size[a] += 2 * kernels[a].reach;
    const auto axis = static_cast<Eigen::Index>(a);
    wide.origin[axis] -= kernels[a].reach * grid.spacing[axis];
  }
  return wide;
}

Volume<float> seenThrough(const PointSpread& psf, const PartialVolumes& volumes,
                          const VesselFade* fade, const Geometry& grid, const Progress& progress) {
  Volume<float> image(grid);
  const Blur blur(psf, volumes, fade, grid);
  const auto slices = static_cast<std::size_t>(grid.size[2]);
  parallelFor(0, slices, kSlab, [&](std::size_t first, std::size_t last) {
    blur.fill(image, static_cast<int>(first), static_cast<int>(last), progress);
  });
  progress.report(1.0);
  return image;
}

}  // namespace angiomesh
