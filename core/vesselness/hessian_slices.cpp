// SPDX-License-Identifier: BSD-3-Clause
#include "core/vesselness/hessian_slices.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/vesselness/gauss_kernel.h"
#include "core/vesselness/row_kernels.h"

namespace angiomesh {
namespace {

constexpr int kMostTaps = 32;  // of half a kernel: discreteGaussian() has at most 30

/// The filters along one axis of `size` samples. Samples beyond the border are those at it.
class AxisFilter {
 public:
  AxisFilter(int size, double sigmaSamples)
      : size_(size),
        kernel_(discreteGaussian(sigmaSamples * sigmaSamples)),
        whole_(static_cast<int>(std::floor(sigmaSamples))),
        part_(static_cast<float>(sigmaSamples - std::floor(sigmaSamples))) {}

  [[nodiscard]] int radius() const { return static_cast<int>(kernel_.size()) - 1; }
  /// Samples that a filter reaches to either side.
  [[nodiscard]] int reach() const { return std::max(radius(), whole_ + 1); }

  /// How far differences reach.
  [[nodiscard]] int differenceReach() const { return whole_ + 1; }

  /// Smooths across `size` rows of `width` samples, `pitch` apart, into rows `width` apart.
  void smooth(const float* in, std::size_t pitch, int width, float* out) const {
    for (int i = 0; i < size_; ++i)
      smoothRow(in, pitch, i, width,
                out + static_cast<std::size_t>(i) * static_cast<std::size_t>(width));
  }

  /// Row i of that.
  void smoothRow(const float* in, std::size_t pitch, int i, int width, float* out) const {
    std::array<const float*, kMostTaps> low, high;
    for (int m = 1; m <= radius(); ++m) {
      low[static_cast<std::size_t>(m - 1)] = row(in, pitch, i - m);
      high[static_cast<std::size_t>(m - 1)] = row(in, pitch, i + m);
    }
    sumRows(row(in, pitch, i), low.data(), high.data(), kernel_.data(), radius(), width, out);
  }

  /// The rows at a distance of sigma from row i.
  [[nodiscard]] ShiftedRows shifted(const float* in, std::size_t pitch, int i) const {
    return shifted([&](int k) { return row(in, pitch, k); }, i);
  }
  template <class Row>
  [[nodiscard]] ShiftedRows shifted(const Row& rowAt, int i) const {
    return {rowAt(i - whole_),
            rowAt(i - whole_ - 1),
            rowAt(i + whole_),
            rowAt(i + whole_ + 1),
            part_,
            part_};
  }

  /// Along a row: `padded` points to its first sample and has reach() more on either side.
  void smoothAlong(const float* padded, float* out) const {
    std::array<const float*, kMostTaps> low, high;
    for (int m = 1; m <= radius(); ++m) {
      low[static_cast<std::size_t>(m - 1)] = padded - m;
      high[static_cast<std::size_t>(m - 1)] = padded + m;
    }
    sumRows(padded, low.data(), high.data(), kernel_.data(), radius(), size_, out);
  }
  [[nodiscard]] ShiftedRows shiftedAlong(const float* padded) const {
    return {
        padded - whole_, padded - whole_ - 1, padded + whole_, padded + whole_ + 1, part_, part_};
  }

 private:
  [[nodiscard]] const float* row(const float* in, std::size_t pitch, int i) const {
    return in + static_cast<std::size_t>(std::clamp(i, 0, size_ - 1)) * pitch;
  }

  int size_;
  std::vector<float> kernel_;
  int whole_;
  float part_;
};

enum class Order { First, Second };

void difference(const ShiftedRows& rows, const float* centre, int width, Order order, float* out) {
  if (order == Order::First)
    firstDifference(rows, width, out);
  else
    secondDifference(rows, centre, width, out);
}

/// The filters along x of one row, through copies padded by the end values.
class RowFilter {
 public:
  RowFilter(const AxisFilter& axis, int n)
      : axis_(axis), n_(n), pad_(axis.reach()), in_(length()), smooth_(length()) {}

  const float* smooth(const float* in) {
    std::copy_n(in, n_, in_.begin() + pad_);
    fillEnds(in_);
    axis_.smoothAlong(in_.data() + pad_, smooth_.data() + pad_);
    return smooth_.data() + pad_;
  }

  void differenceInto(const float* in, Order order, float* out) {
    smooth(in);
    fillEnds(smooth_);
    const float* centre = smooth_.data() + pad_;
    difference(axis_.shiftedAlong(centre), centre, n_, order, out);
  }

 private:
  [[nodiscard]] std::size_t length() const { return static_cast<std::size_t>(n_ + 2 * pad_); }
  void fillEnds(std::vector<float>& row) const {
    std::fill_n(row.begin(), pad_, row[static_cast<std::size_t>(pad_)]);
    std::fill_n(row.begin() + pad_ + n_, pad_, row[static_cast<std::size_t>(pad_ + n_ - 1)]);
  }

  const AxisFilter& axis_;
  int n_, pad_;
  std::vector<float> in_, smooth_;
};

/// The planes that one thread works on, kept from slab to slab: giving such blocks back to the
/// system each time takes longer than the filters.
struct Scratch {
  std::vector<float> smoothed;  ///< along z: a slab and what its differences reach
  std::vector<float> along;     ///< one slice, filtered along z
  std::vector<float> across;    ///< and along y
  std::vector<float> row;
  std::array<std::vector<float>, 6> out;
};

Scratch& scratch() {
  thread_local Scratch mine;
  return mine;
}

/// The filters along y and x of one slice that is filtered along z in one way.
class SliceFilter {
 public:
  SliceFilter(const AxisFilter& fx, const AxisFilter& fy, int nx, int ny, Scratch& s)
      : fy_(fy), alongX_(fx, nx), nx_(nx), rows_(static_cast<std::size_t>(ny)), s_(s) {}

  void smoothY(const float* slice) {
    fy_.smooth(slice, static_cast<std::size_t>(nx_), nx_, s_.across.data());
  }
  const float* row(std::size_t j) const {
    return s_.across.data() + j * static_cast<std::size_t>(nx_);
  }
  const float* differenceY(std::size_t j, Order order) {
    const auto width = static_cast<std::size_t>(nx_);
    difference(fy_.shifted(s_.across.data(), width, static_cast<int>(j)), row(j), nx_, order,
               s_.row.data());
    return s_.row.data();
  }
  void differenceX(const float* in, std::size_t component, std::size_t j, Order order) {
    alongX_.differenceInto(in, order, to(component, j));
  }
  void smoothX(const float* in, std::size_t component, std::size_t j) {
    std::copy_n(alongX_.smooth(in), nx_, to(component, j));
  }
  [[nodiscard]] std::size_t rows() const { return rows_; }

 private:
  float* to(std::size_t component, std::size_t j) {
    return s_.out[component].data() + j * static_cast<std::size_t>(nx_);
  }

  const AxisFilter& fy_;
  RowFilter alongX_;
  int nx_;
  std::size_t rows_;
  Scratch& s_;
};

}  // namespace

void forEachHessianSlice(const Volume<float>& image, double sigmaMm,
                         const std::function<void(int, const HessianSlice&)>& consume,
                         const Progress& progress) {
  const Geometry& g = image.geometry;
  const int nz = g.size[2];
  const AxisFilter fx(g.size[0], sigmaMm / g.spacing[0]);
  const AxisFilter fy(g.size[1], sigmaMm / g.spacing[1]);
  const AxisFilter fz(nz, sigmaMm / g.spacing[2]);
  const std::size_t slice = g.offset(0, 0, 1);
  // Large slabs smooth few slices twice, small ones share the work among threads.
  const auto slab = static_cast<std::size_t>(std::clamp(nz / 8, 4, 16));

  parallelFor(0, static_cast<std::size_t>(nz), slab, [&](std::size_t begin, std::size_t end) {
    progress.check();
    Scratch& s = scratch();
    const int low = std::max(static_cast<int>(begin) - fz.differenceReach(), 0);
    const int high = std::min(static_cast<int>(end) - 1 + fz.differenceReach(), nz - 1);
    s.smoothed.resize(static_cast<std::size_t>(high - low + 1) * slice);
    s.along.resize(slice);
    s.across.resize(slice);
    s.row.resize(static_cast<std::size_t>(g.size[0]));
    for (auto& plane : s.out) plane.resize(slice);
    for (int k = low; k <= high; ++k) {
      progress.check();
      fz.smoothRow(image.voxels.data(), slice, k, static_cast<int>(slice),
                   s.smoothed.data() + static_cast<std::size_t>(k - low) * slice);
    }
    // As if the smoothed volume began at its slice 0; only those of the slab are asked for.
    const auto plane = [&](int k) {
      return s.smoothed.data() + static_cast<std::size_t>(std::clamp(k, 0, nz - 1) - low) * slice;
    };
    SliceFilter f(fx, fy, g.size[0], g.size[1], s);
    const auto width = static_cast<int>(slice);
    for (std::size_t at = begin; at < end; ++at) {
      progress.check();
      const int k = static_cast<int>(at);
      f.smoothY(plane(k));
      for (std::size_t j = 0; j < f.rows(); ++j) {
        f.differenceX(f.row(j), 0, j, Order::Second);
        f.smoothX(f.differenceY(j, Order::Second), 1, j);
        f.differenceX(f.differenceY(j, Order::First), 3, j, Order::First);
      }
      const ShiftedRows shifted = fz.shifted(plane, k);
      secondDifference(shifted, plane(k), width, s.along.data());
      f.smoothY(s.along.data());
      for (std::size_t j = 0; j < f.rows(); ++j) f.smoothX(f.row(j), 2, j);
      firstDifference(shifted, width, s.along.data());
      f.smoothY(s.along.data());
      for (std::size_t j = 0; j < f.rows(); ++j) {
        f.differenceX(f.row(j), 4, j, Order::First);
        f.smoothX(f.differenceY(j, Order::First), 5, j);
      }
      consume(k, {s.out[0].data(), s.out[1].data(), s.out[2].data(), s.out[3].data(),
                  s.out[4].data(), s.out[5].data()});
    }
  });
}

void forEachSmoothSlice(const Volume<float>& image, double sigmaMm,
                        const std::function<void(int, const float*)>& consume,
                        const Progress& progress) {
  const Geometry& g = image.geometry;
  const AxisFilter fx(g.size[0], sigmaMm / g.spacing[0]);
  const AxisFilter fy(g.size[1], sigmaMm / g.spacing[1]);
  const AxisFilter fz(g.size[2], sigmaMm / g.spacing[2]);
  const std::size_t slice = g.offset(0, 0, 1);
  parallelFor(0, static_cast<std::size_t>(g.size[2]), 4, [&](std::size_t begin, std::size_t end) {
    Scratch& s = scratch();
    s.along.resize(slice);
    s.across.resize(slice);
    s.out[0].resize(slice);
    SliceFilter f(fx, fy, g.size[0], g.size[1], s);
    for (std::size_t k = begin; k < end; ++k) {
      progress.check();
      fz.smoothRow(image.voxels.data(), slice, static_cast<int>(k), static_cast<int>(slice),
                   s.along.data());
      f.smoothY(s.along.data());
      for (std::size_t j = 0; j < f.rows(); ++j) f.smoothX(f.row(j), 0, j);
      consume(static_cast<int>(k), s.out[0].data());
    }
  });
}

}  // namespace angiomesh
