// SPDX-License-Identifier: BSD-3-Clause
#include "core/vesselness/hessian_slices.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/vesselness/gauss_kernel.h"

namespace angiomesh {
namespace {

/// Linear interpolation at i - step and i + step on a line of n samples, clamped to its ends.
struct Stencil {
  struct Place {
    int low, high;
    float t;
  };
  std::vector<Place> below, above;

  Stencil(int n, double step) {
    const auto place = [n](double x) {
      x = std::clamp(x, 0.0, static_cast<double>(n - 1));
      const int low = static_cast<int>(x);
      return Place{low, std::min(low + 1, n - 1), static_cast<float>(x - low)};
    };
    for (int i = 0; i < n; ++i) {
      below.push_back(place(i - step));
      above.push_back(place(i + step));
    }
  }
};

struct AxisFilter {
  std::vector<float> kernel;
  Stencil stencil;

  AxisFilter(int n, double sigmaSamples)
      : kernel(discreteGaussian(sigmaSamples * sigmaSamples)), stencil(n, sigmaSamples) {}
};

/// Rows of `width` samples at a distance of `pitch`; a filter across rows works on whole rows.
struct Rows {
  const float* data;
  std::size_t pitch;
  [[nodiscard]] const float* row(int i) const { return data + static_cast<std::size_t>(i) * pitch; }
};

void smoothAcrossRows(const Rows& in, int n, int width, const std::vector<float>& kernel,
                      float* out) {
  const int radius = static_cast<int>(kernel.size()) - 1;
  for (int i = 0; i < n; ++i) {
    float* to = out + static_cast<std::size_t>(i) * static_cast<std::size_t>(width);
    const float* centre = in.row(i);
    for (int x = 0; x < width; ++x) to[x] = kernel[0] * centre[x];
    for (int m = 1; m <= radius; ++m) {
      const float* low = in.row(std::max(i - m, 0));
      const float* high = in.row(std::min(i + m, n - 1));
      const float w = kernel[static_cast<std::size_t>(m)];
      for (int x = 0; x < width; ++x) to[x] += w * (low[x] + high[x]);
    }
  }
}

enum class Order { First, Second };

/// Row i of the derivative across rows, times step (First) or step^2 (Second).
void differenceRow(const Rows& in, int i, int width, const Stencil& stencil, Order order,
                   float* out) {
  const auto& b = stencil.below[static_cast<std::size_t>(i)];
  const auto& a = stencil.above[static_cast<std::size_t>(i)];
  const float* b0 = in.row(b.low);
  const float* b1 = in.row(b.high);
  const float* a0 = in.row(a.low);
  const float* a1 = in.row(a.high);
  const float* centre = in.row(i);
  if (order == Order::First) {
    for (int x = 0; x < width; ++x)
      out[x] = 0.5F * ((a0[x] + a.t * (a1[x] - a0[x])) - (b0[x] + b.t * (b1[x] - b0[x])));
  } else {
    for (int x = 0; x < width; ++x)
      out[x] = (a0[x] + a.t * (a1[x] - a0[x])) + (b0[x] + b.t * (b1[x] - b0[x])) - 2.0F * centre[x];
  }
}

/// The filters along x of one row, through a copy padded by its end values.
class RowFilter {
 public:
  RowFilter(const AxisFilter& axis, int n)
      : axis_(axis),
        radius_(static_cast<int>(axis.kernel.size()) - 1),
        n_(n),
        padded_(static_cast<std::size_t>(n + 2 * radius_)),
        smooth_(static_cast<std::size_t>(n)) {}

  const float* smooth(const float* in) {
    std::fill_n(padded_.begin(), radius_, in[0]);
    std::copy_n(in, n_, padded_.begin() + radius_);
    std::fill_n(padded_.begin() + radius_ + n_, radius_, in[n_ - 1]);
    const float* centre = padded_.data() + radius_;
    for (int x = 0; x < n_; ++x) smooth_[static_cast<std::size_t>(x)] = axis_.kernel[0] * centre[x];
    for (int m = 1; m <= radius_; ++m) {
      const float w = axis_.kernel[static_cast<std::size_t>(m)];
      for (int x = 0; x < n_; ++x)
        smooth_[static_cast<std::size_t>(x)] += w * (centre[x - m] + centre[x + m]);
    }
    return smooth_.data();
  }

  void difference(const float* in, Order order, float* out) {
    const float* s = smooth(in);
    for (int x = 0; x < n_; ++x) {
      const auto& b = axis_.stencil.below[static_cast<std::size_t>(x)];
      const auto& a = axis_.stencil.above[static_cast<std::size_t>(x)];
      const float below = s[b.low] + b.t * (s[b.high] - s[b.low]);
      const float above = s[a.low] + a.t * (s[a.high] - s[a.low]);
      out[x] = order == Order::First ? 0.5F * (above - below) : above + below - 2.0F * s[x];
    }
  }

 private:
  const AxisFilter& axis_;
  int radius_;
  int n_;
  std::vector<float> padded_;
  std::vector<float> smooth_;
};

/// Smoothed, first and second difference along z of the whole image.
struct AlongZ {
  std::vector<float> smooth, first, second;
};

AlongZ filterAlongZ(const Volume<float>& image, const AxisFilter& filter,
                    const Progress& progress) {
  const Geometry& g = image.geometry;
  const int nx = g.size[0];
  const int nz = g.size[2];
  AlongZ out{std::vector<float>(image.voxels.size()), std::vector<float>(image.voxels.size()),
             std::vector<float>(image.voxels.size())};
  const std::size_t slice = g.offset(0, 0, 1);
  parallelFor(0, static_cast<std::size_t>(g.size[1]), 4, [&](std::size_t begin, std::size_t end) {
    progress.check();
    std::vector<float> column(static_cast<std::size_t>(nx) * static_cast<std::size_t>(nz));
    for (std::size_t j = begin; j < end; ++j) {
      const std::size_t start = g.offset(0, static_cast<int>(j), 0);
      smoothAcrossRows({image.voxels.data() + start, slice}, nz, nx, filter.kernel, column.data());
      const Rows rows{column.data(), static_cast<std::size_t>(nx)};
      for (int k = 0; k < nz; ++k) {
        const std::size_t at = start + static_cast<std::size_t>(k) * slice;
        std::copy_n(rows.row(k), nx, out.smooth.data() + at);
        differenceRow(rows, k, nx, filter.stencil, Order::First, out.first.data() + at);
        differenceRow(rows, k, nx, filter.stencil, Order::Second, out.second.data() + at);
      }
    }
  });
  return out;
}

}  // namespace

void forEachHessianSlice(const Volume<float>& image, double sigmaMm,
                         const std::function<void(int, const HessianSlice&)>& consume,
                         const Progress& progress) {
  const Geometry& g = image.geometry;
  const int nx = g.size[0];
  const int ny = g.size[1];
  const AxisFilter fx(nx, sigmaMm / g.spacing[0]);
  const AxisFilter fy(ny, sigmaMm / g.spacing[1]);
  const AxisFilter fz(g.size[2], sigmaMm / g.spacing[2]);
  const AlongZ z = filterAlongZ(image, fz, progress);
  const std::size_t slice = g.offset(0, 0, 1);
  const auto width = static_cast<std::size_t>(nx);

  parallelFor(0, static_cast<std::size_t>(g.size[2]), 1, [&](std::size_t k, std::size_t) {
    progress.check();
    std::vector<float> smooth(slice);
    std::vector<float> row(width);
    std::array<std::vector<float>, 6> out;
    for (auto& plane : out) plane.resize(slice);
    RowFilter alongX(fx, nx);
    const auto differenceX = [&](const float* in, std::size_t component, std::size_t j,
                                 Order order) {
      alongX.difference(in, order, out[component].data() + j * width);
    };
    const auto smoothX = [&](const float* in, std::size_t component, std::size_t j) {
      std::copy_n(alongX.smooth(in), nx, out[component].data() + j * width);
    };
    const Rows rows{smooth.data(), width};
    const auto smoothY = [&](const std::vector<float>& in) {
      smoothAcrossRows({in.data() + k * slice, width}, ny, nx, fy.kernel, smooth.data());
    };
    smoothY(z.smooth);
    for (int j = 0; j < ny; ++j) {
      const auto r = static_cast<std::size_t>(j);
      differenceX(rows.row(j), 0, r, Order::Second);
      differenceRow(rows, j, nx, fy.stencil, Order::Second, row.data());
      smoothX(row.data(), 1, r);
      differenceRow(rows, j, nx, fy.stencil, Order::First, row.data());
      differenceX(row.data(), 3, r, Order::First);
    }
    smoothY(z.second);
    for (int j = 0; j < ny; ++j) smoothX(rows.row(j), 2, static_cast<std::size_t>(j));
    smoothY(z.first);
    for (int j = 0; j < ny; ++j) {
      differenceX(rows.row(j), 4, static_cast<std::size_t>(j), Order::First);
      differenceRow(rows, j, nx, fy.stencil, Order::First, row.data());
      smoothX(row.data(), 5, static_cast<std::size_t>(j));
    }
    consume(static_cast<int>(k), {out[0].data(), out[1].data(), out[2].data(), out[3].data(),
                                  out[4].data(), out[5].data()});
  });
}

}  // namespace angiomesh
