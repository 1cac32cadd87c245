// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/simd.h"
#include "core/image/volume.h"

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

/// The upper and the lower half of a key, moved so that the least key is 0.
inline std::size_t upperHalf(std::int32_t key) {
  return (static_cast<std::uint32_t>(key) ^ 0x80000000U) >> 16;
}
inline std::size_t lowerHalf(std::int32_t key) { return static_cast<std::uint32_t>(key) & 0xffffU; }

constexpr std::size_t kGrain = std::size_t{1} << 16;
constexpr std::size_t kHalves = std::size_t{1} << 16;
using Counts = std::vector<std::uint64_t>;

/// How many voxels have each number that `binOf` gives for a key; `bins` itself is not counted.
template <class BinOf>
Counts counted(const BigVector<float>& values, std::size_t bins, const BinOf& binOf) {
  // So few blocks that making their counters and adding them up is no work.
  constexpr std::size_t kManyAtOnce = std::size_t{1} << 21;
  Counts counts(bins + 1);
  std::mutex mutex;
  parallelFor(0, values.size(), kManyAtOnce, [&](std::size_t first, std::size_t last) {
    std::vector<std::uint32_t> own(bins + 1);
    for (std::size_t i = first; i < last; ++i) ++own[binOf(keyOf(values[i]))];
    const std::lock_guard lock(mutex);
    for (std::size_t b = 0; b < own.size(); ++b) counts[b] += own[b];
  });
  counts.pop_back();
  return counts;
}

/// The bin that holds the item of a rank, and how many lie in the bins before.
std::pair<std::size_t, std::uint64_t> binOfRank(const std::uint64_t* counts, std::uint64_t rank) {
  std::size_t bin = 0;
  std::uint64_t before = 0;
  while (before + counts[bin] <= rank) before += counts[bin++];
  return {bin, before};
}

/// The values of ascending ranks, found by counting: a radix selection on the halves of the keys,
/// which reads the voxels twice and neither copies nor sorts them.
std::vector<float> valuesOfRanks(const BigVector<float>& values,
                                 const std::vector<std::uint64_t>& ranks) {
  const Counts upper = counted(values, kHalves, [](std::int32_t key) { return upperHalf(key); });
  std::vector<std::pair<std::size_t, std::uint64_t>> place;  // upper half, rank among its own
  std::vector<std::uint32_t> group(kHalves, 0);              // of upper halves that are looked into
  std::uint32_t groups = 0;
  for (const std::uint64_t rank : ranks) {
    const auto [half, before] = binOfRank(upper.data(), rank);
    if (place.empty() || place.back().first != half) group[half] = ++groups;
    place.emplace_back(half, rank - before);
  }
  const std::size_t bins = groups * kHalves;
  const Counts lower = counted(values, bins, [&](std::int32_t key) {
    const std::uint32_t of = group[upperHalf(key)];
    return of == 0 ? bins : (of - 1) * kHalves + lowerHalf(key);
  });
  std::vector<float> found;
  for (const auto& [half, rank] : place) {
    const std::size_t low = binOfRank(lower.data() + (group[half] - 1) * kHalves, rank).first;
    const auto bits = static_cast<std::uint32_t>((half << 16) | low) ^ 0x80000000U;
    found.push_back(valueOf(std::bit_cast<std::int32_t>(bits)));
  }
  return found;
}

}  // namespace

std::array<float, 2> valueRange(const Volume<float>& image) {
  std::int32_t least = std::numeric_limits<std::int32_t>::max(), greatest = -least - 1;
  std::mutex mutex;
  parallelFor(0, image.voxels.size(), kGrain, [&](std::size_t first, std::size_t last) {
    std::int32_t low = 0, high = 0;
    keyRange(image.voxels.data() + first, last - first, &low, &high);
    const std::lock_guard lock(mutex);
    least = std::min(least, low);
    greatest = std::max(greatest, high);
  });
  return {valueOf(least), valueOf(greatest)};
}

std::vector<double> percentiles(const Volume<float>& image, const std::vector<double>& fractions) {
  const std::size_t last = image.voxels.size() - 1;
  std::vector<std::uint64_t> ranks;
  std::vector<double> exact;
  for (const double fraction : fractions) {
    exact.push_back(std::clamp(fraction, 0.0, 1.0) * static_cast<double>(last));
    const auto below = static_cast<std::uint64_t>(exact.back());
    ranks.insert(ranks.end(), {below, std::min<std::uint64_t>(below + 1, last)});
  }
  std::vector<std::uint64_t> ascending = ranks;
  std::sort(ascending.begin(), ascending.end());
  const std::vector<float> values = valuesOfRanks(image.voxels, ascending);
  const auto valueAt = [&](std::uint64_t rank) {
    const auto at = std::lower_bound(ascending.begin(), ascending.end(), rank);
    return static_cast<double>(values[static_cast<std::size_t>(at - ascending.begin())]);
  };
  std::vector<double> result;
  for (std::size_t n = 0; n < fractions.size(); ++n) {
    const double below = valueAt(ranks[2 * n]), above = valueAt(ranks[2 * n + 1]);
    result.push_back(below + (exact[n] - static_cast<double>(ranks[2 * n])) * (above - below));
  }
  return result;
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

}  // namespace angiomesh
