// SPDX-License-Identifier: BSD-3-Clause
#include "core/lumen/axis_smoothing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/statistics.h"
#include "core/vesselness/hessian_slices.h"
#include "core/vesselness/vesselness.h"

namespace angiomesh {
namespace {

constexpr std::size_t kGrain = 8192;
using Six = std::array<float, 6>;  // xx, yy, zz, xy, xz, yz

/// Working voxels per voxel along each axis.
std::array<float, 3> stepsOf(const Geometry& g) {
  std::array<float, 3> h{};
  for (std::size_t a = 0; a < 3; ++a)
    h[a] = static_cast<float>(g.spacing[static_cast<Eigen::Index>(a)] / g.voxelMm());
  return h;
}

/// The image at the cells, smoothed by a Gaussian of one working voxel.
std::vector<float> smoothValues(const Volume<float>& image, const CellBand& band,
                                const Progress& progress) {
  const Geometry& g = image.geometry;
  const std::size_t slice = g.offset(0, 0, 1);
  std::vector<float> value(band.size());
  forEachSmoothSlice(
      image, g.voxelMm(),
      [&](int k, const float* smooth) {
        const std::size_t from = static_cast<std::size_t>(k) * slice;
        auto at = std::lower_bound(band.voxel.begin(), band.voxel.end(), from);
        for (; at != band.voxel.end() && *at < from + slice; ++at)
          value[static_cast<std::size_t>(at - band.voxel.begin())] = smooth[*at - from];
      },
      progress);
  return value;
}

/// A unit eigenvector of a symmetric matrix that belongs to its least eigenvalue.
Eigen::Vector3f leastEigenvector(const Six& m) {
  std::array<double, 6> h{};
  for (std::size_t i = 0; i < 6; ++i) h[i] = static_cast<double>(m[i]);
  const std::array<double, 3> values = symmetricEigenvalues(h);
  const double least = *std::min_element(values.begin(), values.end());
  const Eigen::Vector3d r0(h[0] - least, h[3], h[4]), r1(h[3], h[1] - least, h[5]),
      r2(h[4], h[5], h[2] - least);
  Eigen::Vector3d best = r0.cross(r1);
  for (const Eigen::Vector3d& c : {Eigen::Vector3d(r0.cross(r2)), Eigen::Vector3d(r1.cross(r2))})
    if (c.squaredNorm() > best.squaredNorm()) best = c;
  const double norm = best.norm();
  if (!(norm > 1e-30)) return Eigen::Vector3f::UnitZ();
  return (best / norm).cast<float>();
}

/// The system of smoothAlongAxes().
class Smoother {
 public:
  Smoother(const Volume<float>& image, const CellBand& band,
           const std::vector<Eigen::Vector3f>& axes, const std::vector<float>& along,
           const std::vector<float>& across)
      : image_(image), band_(band), axes_(axes), along_(along), across_(across) {
    const std::array<float, 3> h = stepsOf(image.geometry);
    for (std::size_t a = 0; a < 3; ++a) second_[a] = 1.0F / (h[a] * h[a]);
    second_[3] = 0.25F / (h[0] * h[1]);
    second_[4] = 0.25F / (h[0] * h[2]);
    second_[5] = 0.25F / (h[1] * h[2]);
    weighted_.resize(band.size());
  }

  std::vector<float> solve(const Progress& progress) {
    const std::size_t n = band_.size();
    std::vector<float> e(n, 0.0F), r(n), p, q(n);
    weigh([&](std::size_t c, std::size_t k) { return imageAt(c, k); }, progress);
    spread(r);
    parallelForEach(n, kGrain, [&](std::size_t c) { r[c] = -r[c]; });
    p = r;
    double rr = dot(r, r);
    const double enough = 1e-6 * rr;
    for (int iteration = 0; iteration < 40 && rr > enough && rr > 0.0; ++iteration) {
      weigh([&](std::size_t c, std::size_t k) { return k == kHere ? p[c] : valueAt(p, c, k); },
            progress);
      spread(q);
      parallelForEach(n, kGrain, [&](std::size_t c) { q[c] += p[c]; });
      const auto step = static_cast<float>(rr / dot(p, q));
      parallelForEach(n, kGrain, [&](std::size_t c) {
        e[c] += step * p[c];
        r[c] -= step * q[c];
      });
      const double next = dot(r, r);
      const auto keep = static_cast<float>(next / rr);
      rr = next;
      parallelForEach(n, kGrain, [&](std::size_t c) { p[c] = r[c] + keep * p[c]; });
    }
    for (std::size_t c = 0; c < n; ++c) e[c] += image_.voxels[band_.voxel[c]];
    return e;
  }

 private:
  static constexpr std::size_t kHere = 26;

  [[nodiscard]] float valueAt(const std::vector<float>& v, std::size_t c, std::size_t k) const {
    const std::uint32_t n = band_.neighbour(c, k);
    return n == CellBand::none ? 0.0F : v[n];
  }

  [[nodiscard]] float imageAt(std::size_t c, std::size_t k) const {
    const std::uint32_t voxel = band_.voxel[c];
    if (k == kHere) return image_.voxels[voxel];
    const std::uint32_t n = band_.neighbour(c, k);
    if (n != CellBand::none) return image_.voxels[band_.voxel[n]];
    const Geometry& g = image_.geometry;
    const Index3 at = g.indexOf(voxel);
    Index3 p;
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = std::clamp(at[a] + CellBand::kOffsets[k][a], 0, g.size[a] - 1);
    return image_.at(p[0], p[1], p[2]);
  }

  /// The derivative of the energy by the Hessian at each cell, stencil factors included.
  template <class Value>
  void weigh(Value value, const Progress& progress) {
    parallelForEach(band_.size(), kGrain, progress, [&](std::size_t c) {
      const float twice = 2.0F * value(c, kHere);
      Six h{};
      for (std::size_t a = 0; a < 3; ++a)
        h[a] = second_[a] * (value(c, 2 * a) + value(c, 2 * a + 1) - twice);
      for (std::size_t m = 0; m < 3; ++m) {
        const std::size_t k = 6 + 4 * m;
        h[3 + m] =
            second_[3 + m] * (value(c, k) + value(c, k + 1) - value(c, k + 2) - value(c, k + 3));
      }
      weighted_[c] = byHessian(h, axes_[c], along_[c], across_[c]);
    });
  }

  [[nodiscard]] Six byHessian(const Six& h, const Eigen::Vector3f& u, float along,
                              float across) const {
    const std::array<float, 3> hu{h[0] * u[0] + h[3] * u[1] + h[4] * u[2],
                                  h[3] * u[0] + h[1] * u[1] + h[5] * u[2],
                                  h[4] * u[0] + h[5] * u[1] + h[2] * u[2]};
    const float uhu = u[0] * hu[0] + u[1] * hu[1] + u[2] * hu[2];
    const auto entry = [&](std::size_t n, std::size_t i, std::size_t j) {
      const float ui = u[static_cast<Eigen::Index>(i)], uj = u[static_cast<Eigen::Index>(j)];
      const float mixed = hu[i] * uj + ui * hu[j];
      return second_[n] * (0.5F * along * mixed + across * (h[n] - mixed + uhu * ui * uj));
    };
    // Off-diagonal entries stand for two.
    return {entry(0, 0, 0),        entry(1, 1, 1),        entry(2, 2, 2),
            2.0F * entry(3, 0, 1), 2.0F * entry(4, 0, 2), 2.0F * entry(5, 1, 2)};
  }

  /// The adjoint of the differences: they are even in their offsets.
  void spread(std::vector<float>& out) const {
    parallelForEach(band_.size(), kGrain, [&](std::size_t c) {
      const Six& here = weighted_[c];
      float sum = -2.0F * (here[0] + here[1] + here[2]);
      const auto add = [&](std::size_t k, std::size_t n, float sign) {
        const std::uint32_t near = band_.neighbour(c, k);
        if (near != CellBand::none) sum += sign * weighted_[near][n];
      };
      for (std::size_t a = 0; a < 3; ++a) {
        add(2 * a, a, 1.0F);
        add(2 * a + 1, a, 1.0F);
      }
      for (std::size_t m = 0; m < 3; ++m) {
        const std::size_t k = 6 + 4 * m;
        add(k, 3 + m, 1.0F);
        add(k + 1, 3 + m, 1.0F);
        add(k + 2, 3 + m, -1.0F);
        add(k + 3, 3 + m, -1.0F);
      }
      out[c] = sum;
    });
  }

  [[nodiscard]] static double dot(const std::vector<float>& a, const std::vector<float>& b) {
    std::vector<double> part((a.size() + kGrain - 1) / kGrain, 0.0);
    parallelFor(0, a.size(), kGrain, [&](std::size_t first, std::size_t last) {
      double sum = 0.0;
      for (std::size_t c = first; c < last; ++c)
        sum += static_cast<double>(a[c]) * static_cast<double>(b[c]);
      part[first / kGrain] = sum;
    });
    double sum = 0.0;
    for (const double p : part) sum += p;
    return sum;
  }

  const Volume<float>& image_;
  const CellBand& band_;
  const std::vector<Eigen::Vector3f>& axes_;
  const std::vector<float>&along_, &across_;
  std::array<float, 6> second_{};  // factors of the differences
  std::vector<Six> weighted_;
};

}  // namespace

std::vector<Eigen::Vector3f> vesselAxes(const Volume<float>& image, const CellBand& band,
                                        const Progress& progress) {
  const std::vector<float> smooth = smoothValues(image, band, progress);
  const std::array<float, 3> h = stepsOf(image.geometry);
  std::vector<Six> tensor(band.size()), next(band.size());
  parallelForEach(band.size(), kGrain, progress, [&](std::size_t c) {
    std::array<float, 3> d{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::uint32_t low = band.neighbour(c, 2 * a), high = band.neighbour(c, 2 * a + 1);
      const float before = smooth[low != CellBand::none ? low : c];
      const float after = smooth[high != CellBand::none ? high : c];
      d[a] = (after - before) / (2.0F * h[a]);
    }
    tensor[c] = {d[0] * d[0], d[1] * d[1], d[2] * d[2], d[0] * d[1], d[0] * d[2], d[1] * d[2]};
  });
  // Each round of averaging over a cell and its neighbours across faces adds 2/7 voxel^2.
  constexpr int rounds = 8;
  for (int round = 0; round < rounds; ++round) {
    parallelForEach(band.size(), kGrain, progress, [&](std::size_t c) {
      Six sum = tensor[c];
      float count = 1.0F;
      for (std::size_t k = 0; k < 6; ++k) {
        const std::uint32_t n = band.neighbour(c, k);
        if (n == CellBand::none) continue;
        for (std::size_t i = 0; i < 6; ++i) sum[i] += tensor[n][i];
        count += 1.0F;
      }
      for (std::size_t i = 0; i < 6; ++i) next[c][i] = sum[i] / count;
    });
    std::swap(tensor, next);
  }
  std::vector<Eigen::Vector3f> axes(band.size());
  parallelForEach(band.size(), kGrain,
                  [&](std::size_t c) { axes[c] = leastEigenvector(tensor[c]); });
  return axes;
}

std::vector<float> smoothAlongAxes(const Volume<float>& image, const CellBand& band,
                                   const std::vector<Eigen::Vector3f>& axes,
                                   const std::vector<float>& along,
                                   const std::vector<float>& across, const Progress& progress) {
  return Smoother(image, band, axes, along, across).solve(progress);
}

double noiseLevel(const Volume<float>& image, const std::vector<std::uint32_t>& voxels) {
  const Geometry& g = image.geometry;
  const std::size_t row = g.offset(0, 1, 0), slice = g.offset(0, 0, 1);
  // A million differences at most are enough.
  const std::size_t step = std::max<std::size_t>(1, voxels.size() / 1000000);
  std::vector<float> differences;
  std::size_t looked = 0;
  for (std::size_t n = 0; n < voxels.size(); n += step) {
    const Index3 p = g.indexOf(voxels[n]);
    bool inner = true;
    for (std::size_t a = 0; a < 3; ++a) inner = inner && p[a] > 0 && p[a] + 1 < g.size[a];
    if (!inner) continue;
    ++looked;
    const float* v = image.voxels.data() + voxels[n];
    const float mean = (v[-1] + v[1] + *(v - row) + v[row] + *(v - slice) + v[slice]) / 6.0F;
    if (v[-1] == *v && v[1] == *v) continue;
    differences.push_back(std::fabs(*v - mean));
  }
  if (differences.empty() || 10 * differences.size() < looked) return 0.0;
  // 0.6745 is the median of |x| for a standard normal x; the mean of six adds a sixth of variance.
  return static_cast<double>(upperMedian(differences)) / (0.6744897501960817 * 1.0801234497346435);
}

}  // namespace angiomesh
