// SPDX-License-Identifier: BSD-3-Clause
#include "core/image/volume.h"

#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>
#include <mutex>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/simd.h"

namespace angiomesh {
namespace {

/// Floats in their order as whole numbers, NaN beyond the infinities: unlike those of floats, their
/// minimum and maximum may be taken in any order, and so by a vector at a time.
inline std::int32_t keyOf(float value) {
  const auto bits = std::bit_cast<std::int32_t>(value);
  return bits ^ ((bits >> 31) & 0x7fffffff);
}
inline float valueOf(std::int32_t key) {
  return std::bit_cast<float>(key ^ ((key >> 31) & 0x7fffffff));
}

ANGIOMESH_SIMD
void keyRange(const float* values, std::size_t count, std::int32_t* least, std::int32_t* greatest) {
  std::int32_t low = std::numeric_limits<std::int32_t>::max(), high = -low - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t key = keyOf(values[i]);
    low = key < low ? key : low;
    high = key > high ? key : high;
  }
  *least = low;
  *greatest = high;
}

}  // namespace

Eigen::Matrix3d Geometry::physicalToIndexMatrix() const {
  return spacing.cwiseInverse().asDiagonal() * direction.inverse();
}

Eigen::Vector3d Geometry::toIndex(const Eigen::Vector3d& pointLps) const {
  return physicalToIndexMatrix() * (pointLps - origin);
}

bool Geometry::operator==(const Geometry& other) const {
  const double tolerance = 1e-5;
  return size == other.size && (spacing - other.spacing).cwiseAbs().maxCoeff() < tolerance &&
         (origin - other.origin).cwiseAbs().maxCoeff() < tolerance * 100 &&
         (direction - other.direction).cwiseAbs().maxCoeff() < tolerance;
}

std::array<float, 2> valueRange(const Volume<float>& image) {
  const auto [lo, hi] = std::minmax_element(image.voxels.begin(), image.voxels.end());
  return {*lo, *hi};
}

std::vector<double> percentiles(const Volume<float>& image, const std::vector<double>& fractions) {
  BigVector<float> values = image.voxels;
  std::vector<double> result;
  const auto last = static_cast<double>(values.size() - 1);
  for (const double fraction : fractions) {
    const double rank = std::clamp(fraction, 0.0, 1.0) * last;
    const auto low = static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), values.begin() + low, values.end());
    const double below = values[static_cast<std::size_t>(low)];
    const double above = low + 1 < static_cast<std::ptrdiff_t>(values.size())
                             ? *std::min_element(values.begin() + low + 1, values.end())
                             : below;
    result.push_back(below + (rank - static_cast<double>(low)) * (above - below));
  }
  return result;
}

double interpolateLinear(const Volume<float>& image, const Eigen::Vector3d& index) {
  const Geometry& g = image.geometry;
  int low[3];
  int high[3];
  double t[3];
  for (int a = 0; a < 3; ++a) {
    const double x = std::clamp(index[a], 0.0, static_cast<double>(g.size[a] - 1));
    low[a] = static_cast<int>(x);
    high[a] = std::min(low[a] + 1, g.size[a] - 1);
    t[a] = x - low[a];
  }
  const auto along = [&](int j, int k) {
    const double v0 = image.at(low[0], j, k);
    return v0 + t[0] * (static_cast<double>(image.at(high[0], j, k)) - v0);
  };
  const double v00 = along(low[1], low[2]);
  const double v10 = along(high[1], low[2]);
  const double v01 = along(low[1], high[2]);
  const double v11 = along(high[1], high[2]);
  const double v0 = v00 + t[1] * (v10 - v00);
  const double v1 = v01 + t[1] * (v11 - v01);
  return v0 + t[2] * (v1 - v0);
}

void ValueFacts::add(const ValueFacts& other) {
  least = std::min(least, other.least);
  greatest = std::max(greatest, other.greatest);
  firstNotFinite = std::min(firstNotFinite, other.firstNotFinite);
}

ValueFacts valueFacts(const float* values, std::size_t count, std::size_t first) {
  std::int32_t least = 0, greatest = 0;
  keyRange(values, count, &least, &greatest);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  ValueFacts facts;
  if (least > keyOf(-kInfinity) && greatest < keyOf(kInfinity)) {
    facts.least = valueOf(least);
    facts.greatest = valueOf(greatest);
    return facts;
  }
  for (std::size_t i = 0; i < count; ++i)
    if (!std::isfinite(values[i])) {
      facts.firstNotFinite = first + i;
      break;
    }
  return facts;
}

ValueFacts valueFacts(const Volume<float>& image) {
  constexpr std::size_t kGrain = std::size_t{1} << 16;
  ValueFacts facts;
  std::mutex mutex;
  parallelFor(0, image.voxels.size(), kGrain, [&](std::size_t first, std::size_t last) {
    const ValueFacts own = valueFacts(image.voxels.data() + first, last - first, first);
    const std::lock_guard lock(mutex);
    facts.add(own);
  });
  return facts;
}

void checkUsable(const Volume<float>& image, const std::string& where) {
  checkUsable(image.geometry, valueFacts(image), where);
}

void checkUsable(const Geometry& g, const ValueFacts& values, const std::string& where) {
  for (int a = 0; a < 3; ++a) {
    if (g.size[a] < 2)
      throw InputError("not a 3D volume (" + std::to_string(g.size[0]) + " x " +
                           std::to_string(g.size[1]) + " x " + std::to_string(g.size[2]) +
                           " voxels)",
                       where, "give a volume with at least two voxels in every direction");
    if (!(g.spacing[a] > 0.0) || !std::isfinite(g.spacing[a]))
      throw InputError("the voxel spacing is not a positive number", where,
                       "repair the spacing in the file's header");
  }
  if (!g.origin.allFinite() || !g.direction.allFinite() ||
      std::fabs(g.direction.determinant()) < 0.1)
    throw InputError("the direction matrix or the origin is not usable", where,
                     "repair the geometry in the file's header");
  if (values.firstNotFinite != ValueFacts::none) {
    const Index3 at = g.indexOf(values.firstNotFinite);
    throw InputError("the volume holds values that are not finite numbers",
                     where + ", first at voxel " + std::to_string(at[0]) + "," +
                         std::to_string(at[1]) + "," + std::to_string(at[2]),
                     "replace NaN and infinity before loading it");
  }
  if (values.least == values.greatest)
    throw InputError("all voxels have the same value", where, "give an image that shows vessels");
}

Volume<std::uint8_t> insideMask(const Volume<float>& phi) {
  Volume<std::uint8_t> mask(phi.geometry);
  for (std::size_t i = 0; i < phi.voxels.size(); ++i) mask.voxels[i] = phi.voxels[i] < 0.0F ? 1 : 0;
  return mask;
}

Components connectedComponents(const Volume<std::uint8_t>& mask, bool fullyConnected) {
  const Geometry& g = mask.geometry;
  Components result{Volume<std::int32_t>(g), {}};
  BigVector<std::int32_t>& labels = result.labels.voxels;
  std::vector<std::size_t> stack;
  std::vector<std::size_t> sizes;
  for (std::size_t seed = 0; seed < labels.size(); ++seed) {
    if (mask.voxels[seed] == 0 || labels[seed] != 0) continue;
    const auto label = static_cast<std::int32_t>(sizes.size() + 1);
    std::size_t count = 0;
    labels[seed] = label;
    stack.push_back(seed);
    while (!stack.empty()) {
      const std::size_t at = stack.back();
      stack.pop_back();
      ++count;
      const Index3 p = g.indexOf(at);
      for (int dk = -1; dk <= 1; ++dk)
        for (int dj = -1; dj <= 1; ++dj)
          for (int di = -1; di <= 1; ++di) {
            if (!fullyConnected && std::abs(di) + std::abs(dj) + std::abs(dk) != 1) continue;
            if (!g.contains(p[0] + di, p[1] + dj, p[2] + dk)) continue;
            const std::size_t next = g.offset(p[0] + di, p[1] + dj, p[2] + dk);
            if (mask.voxels[next] == 0 || labels[next] != 0) continue;
            labels[next] = label;
            stack.push_back(next);
          }
    }
    sizes.push_back(count);
  }
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  std::vector<std::int32_t> rank(sizes.size() + 1, 0);
  for (std::size_t r = 0; r < order.size(); ++r) {
    rank[order[r] + 1] = static_cast<std::int32_t>(r + 1);
    result.sizes.push_back(sizes[order[r]]);
  }
  for (std::int32_t& label : labels) label = rank[static_cast<std::size_t>(label)];
  return result;
}

}  // namespace angiomesh
