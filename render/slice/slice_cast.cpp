// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/slice_cast.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"

namespace angiomesh {

namespace {

using Eigen::Vector3d;

constexpr std::size_t kRowsPerBlock = 8;

std::size_t at(int axis) { return static_cast<std::size_t>(axis); }

std::ptrdiff_t strideOf(const Geometry& g, int axis) {
  const std::array<std::ptrdiff_t, 3> strides{1, g.size[0],
                                              static_cast<std::ptrdiff_t>(g.size[0]) * g.size[1]};
  return strides[at(axis)];
}

struct Slices {
  int first, last;
};

/// One row of the image's own voxels.
template <class Combine>
void addOwnRow(const Volume<float>& image, const PaneAxes& axes, const Slices& slices, int row,
               float* target, Combine combine) {
  const Geometry& g = image.geometry;
  const int width = g.size[at(axes.right)];
  const int up = axes.upFlipped ? g.size[at(axes.up)] - 1 - row : row;
  const std::ptrdiff_t across = strideOf(g, axes.across);
  const std::ptrdiff_t right = strideOf(g, axes.right) * (axes.rightFlipped ? -1 : 1);
  const float* source = image.voxels.data() + up * strideOf(g, axes.up) + slices.first * across;
  if (axes.rightFlipped) source -= (width - 1) * right;
  // Along what lies together in memory first: sagittal slabs are then as quick as the others.
  if (across < std::abs(right)) {
    for (int column = 0; column < width; ++column, source += right) {
      float value = target[column];
      const float* voxel = source;
      for (int slice = slices.first; slice <= slices.last; ++slice, voxel += across)
        value = combine(value, *voxel);
      target[column] = value;
    }
    return;
  }
  for (int slice = slices.first; slice <= slices.last; ++slice, source += across) {
    const float* voxel = source;
    for (int column = 0; column < width; ++column, voxel += right)
      target[column] = combine(target[column], *voxel);
  }
}

/// Trilinear values along lines through an image.
class Sampler {
 public:
  explicit Sampler(const Volume<float>& image)
      : voxels_(image.voxels.data()),
        size_(image.geometry.size),
        rowStride_(strideOf(image.geometry, 1)),
        sliceStride_(strideOf(image.geometry, 2)) {}

  /// First and last whole t in 0..count - 1 for which index + t * step lies in the voxels.
  [[nodiscard]] std::array<int, 2> inside(const Vector3d& index, const Vector3d& step,
                                          int count) const {
    return within(index, step, count, -0.5 - kTolerance);
  }

  /// The same for the places that lie amid eight voxels.
  [[nodiscard]] std::array<int, 2> amid(const Vector3d& index, const Vector3d& step,
                                        int count) const {
    return within(index, step, count, kRounding);
  }

  /// take(t, value) for each t in `range`, all of them amid eight voxels.
  template <class Take>
  void alongAmid(const Vector3d& index, const Vector3d& step, const std::array<int, 2>& range,
                 const Take& take) const {
    const auto x0 = static_cast<float>(index[0]), dx = static_cast<float>(step[0]);
    const auto y0 = static_cast<float>(index[1]), dy = static_cast<float>(step[1]);
    const auto z0 = static_cast<float>(index[2]), dz = static_cast<float>(step[2]);
    for (int t = range[0]; t <= range[1]; ++t) {
      const auto way = static_cast<float>(t);
      const float x = x0 + way * dx, y = y0 + way * dy, z = z0 + way * dz;
      const int i = static_cast<int>(x), j = static_cast<int>(y), k = static_cast<int>(z);
      const float tx = x - static_cast<float>(i), ty = y - static_cast<float>(j),
                  tz = z - static_cast<float>(k);
      const float* p = voxels_ + k * sliceStride_ + j * rowStride_ + i;
      const auto along = [tx](const float* q) { return q[0] + tx * (q[1] - q[0]); };
      const auto inSlice = [&](const float* q) {
        const float low = along(q);
        return low + ty * (along(q + rowStride_) - low);
      };
      const float low = inSlice(p);
      take(t, low + tz * (inSlice(p + sliceStride_) - low));
    }
  }

  /// The index must lie in the voxels; beyond their centres the nearest border counts.
  [[nodiscard]] float operator()(const Vector3d& index) const {
    const float* corner = voxels_;
    std::array<float, 3> t{};
    std::array<std::ptrdiff_t, 3> next{1, rowStride_, sliceStride_};
    for (int a = 0; a < 3; ++a) {
      const double clamped = std::clamp(index[a], 0.0, size_[at(a)] - 1.0);
      const int whole = std::min(static_cast<int>(clamped), std::max(0, size_[at(a)] - 2));
      t[at(a)] = static_cast<float>(clamped - whole);
      corner += whole * next[at(a)];
      if (size_[at(a)] < 2) next[at(a)] = 0;
    }
    const auto along = [&](const float* p) { return p[0] + t[0] * (p[next[0]] - p[0]); };
    const auto inSlice = [&](const float* p) {
      const float low = along(p);
      return low + t[1] * (along(p + next[1]) - low);
    };
    const float low = inSlice(corner);
    return low + t[2] * (inSlice(corner + next[2]) - low);
  }

 private:
  static constexpr double kTolerance = 1e-6;  // voxels
  static constexpr double kRounding = 1e-3;   // of indices in single precision, amply

  /// Those that are at least `border` voxels inside the centres of the outermost ones.
  [[nodiscard]] std::array<int, 2> within(const Vector3d& index, const Vector3d& step, int count,
                                          double border) const {
    double from = 0.0, to = count - 1.0;
    for (int a = 0; a < 3; ++a) {
      const double low = border - index[a];
      const double high = size_[at(a)] - 1.0 - border - index[a];
      if (std::abs(step[a]) < 1e-12) {
        if (low > 0.0 || high < 0.0) return {0, -1};
        continue;
      }
      from = std::max(from, std::min(low / step[a], high / step[a]));
      to = std::min(to, std::max(low / step[a], high / step[a]));
    }
    return {static_cast<int>(std::ceil(from)), static_cast<int>(std::floor(to))};
  }

  const float* voxels_;
  Index3 size_;
  std::ptrdiff_t rowStride_, sliceStride_;
};

/// Where the pixels of a grid's slices lie in an image: indices of it.
struct Lattice {
  Vector3d corner, column, row, slice;

  Lattice(const Geometry& image, const Geometry& grid, const PaneAxes& axes) {
    const auto indexOf = [&](const Vector3d& index) {
      return image.toIndex(grid.toPhysical(index));
    };
    Vector3d lowerLeft = Vector3d::Zero();
    if (axes.rightFlipped) lowerLeft[axes.right] = grid.size[at(axes.right)] - 1;
    if (axes.upFlipped) lowerLeft[axes.up] = grid.size[at(axes.up)] - 1;
    corner = indexOf(lowerLeft);
    const auto stepTo = [&](int axis, bool flipped) {
      return Vector3d(indexOf(lowerLeft + (flipped ? -1.0 : 1.0) * Vector3d::Unit(axis)) - corner);
    };
    column = stepTo(axes.right, axes.rightFlipped);
    row = stepTo(axes.up, axes.upFlipped);
    slice = stepTo(axes.across, false);
  }
};

/// One row of trilinear values. `counts`: how many were combined with `target`, per pixel.
template <class Combine>
void addCastRow(const Sampler& sample, const Lattice& lattice, const Slices& slices, int row,
                int width, float* target, int* counts, Combine combine) {
  for (int slice = slices.first; slice <= slices.last; ++slice) {
    const Vector3d begin = lattice.corner + row * lattice.row + slice * lattice.slice;
    const std::array<int, 2> columns = sample.inside(begin, lattice.column, width);
    const auto take = [&](int column, float value) {
      target[column] = combine(target[column], value);
      ++counts[column];
    };
    const auto takeAtBorder = [&](int first, int last) {
      for (int column = first; column <= last; ++column)
        take(column, sample(begin + column * lattice.column));
    };
    const std::array<int, 2> amid = sample.amid(begin, lattice.column, width);
    if (amid[0] > amid[1]) {
      takeAtBorder(columns[0], columns[1]);
      continue;
    }
    takeAtBorder(columns[0], amid[0] - 1);
    sample.alongAmid(begin, lattice.column, amid, take);
    takeAtBorder(amid[1] + 1, columns[1]);
  }
}

/// Calls cast(combine, neutral) with what a mode does with an old and a new value, and with the
/// old value that changes nothing.
template <class Cast>
void byMode(SlabMode mode, const Cast& cast) {
  constexpr float most = std::numeric_limits<float>::max();
  switch (mode) {
    case SlabMode::None:
      return cast([](float, float value) { return value; }, 0.0F);
    case SlabMode::Mip:
      return cast([](float a, float b) { return std::max(a, b); }, -most);
    case SlabMode::MinIp:
      return cast([](float a, float b) { return std::min(a, b); }, most);
    case SlabMode::Mean:
      return cast([](float a, float b) { return a + b; }, 0.0F);
  }
}

}  // namespace

std::array<int, 2> slabSlices(const Geometry& grid, const PaneAxes& axes, int slice,
                              double thicknessMm) {
  const int available = grid.size[at(axes.across)];
  const double wanted = std::round(thicknessMm / grid.spacing[axes.across]);
  const int count = static_cast<int>(std::clamp(wanted, 1.0, 2.0 * available));
  const int first = slice - (count - 1) / 2;
  return {std::max(0, first), std::min(available - 1, first + count - 1)};
}

void castSlab(const Volume<float>& image, const Geometry& grid, const PaneAxes& axes, SlabMode mode,
              int first, int last, std::vector<float>& values) {
  const int width = grid.size[at(axes.right)];
  const auto height = static_cast<std::size_t>(grid.size[at(axes.up)]);
  values.resize(at(width) * height);
  const bool own = grid == image.geometry;
  const Slices slices{first, last};
  const Sampler sample(image);
  const Lattice lattice(image.geometry, grid, axes);
  byMode(mode, [&](const auto& combine, float neutral) {
    parallelFor(0, height, kRowsPerBlock, [&](std::size_t from, std::size_t to) {
      std::vector<int> counts(own ? 0 : at(width));
      for (std::size_t row = from; row < to; ++row) {
        float* target = values.data() + row * at(width);
        std::fill(target, target + width, neutral);
        if (own) {
          addOwnRow(image, axes, slices, static_cast<int>(row), target, combine);
        } else {
          std::fill(counts.begin(), counts.end(), 0);
          addCastRow(sample, lattice, slices, static_cast<int>(row), width, target, counts.data(),
                     combine);
          for (int column = 0; column < width; ++column)
            if (counts[at(column)] == 0) target[column] = kOutside;
        }
        if (mode != SlabMode::Mean) continue;
        for (int column = 0; column < width; ++column) {
          const int count = own ? last - first + 1 : counts[at(column)];
          if (count > 1) target[column] /= static_cast<float>(count);
        }
      }
    });
  });
}

float valueAt(const Volume<float>& image, const Vector3d& lps) {
  const Sampler sample(image);
  const Vector3d index = image.geometry.toIndex(lps);
  return sample.inside(index, Vector3d::Zero(), 1)[1] == 0 ? sample(index) : kOutside;
}

}  // namespace angiomesh
