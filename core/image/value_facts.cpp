// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>
#include <mutex>

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

}  // namespace

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

}  // namespace angiomesh
