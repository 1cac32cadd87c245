// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/not_finite.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <type_traits>

namespace angiomesh {
namespace {

template <class T>
std::string replaceIn(Volume<T>& volume) {
  T least = std::numeric_limits<T>::infinity(), greatest = -least;
  std::size_t count = 0;
  for (const T value : volume.voxels) {
    if (!std::isfinite(value)) {
      ++count;
      continue;
    }
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  if (count == 0 || least > greatest) return {};
  for (T& value : volume.voxels)
    if (!std::isfinite(value)) value = value > T{0} ? greatest : least;
  std::ostringstream text;
  text << count << (count == 1 ? " voxel is" : " voxels are")
       << " not a finite number: " << (count == 1 ? "it becomes" : "they become")
       << " the least value of the others, " << least << ", or the greatest, " << greatest
       << ", where " << (count == 1 ? "it is" : "they are") << " infinity";
  return text.str();
}

}  // namespace

std::string replaceNotFinite(Volume<float>& volume) { return replaceIn(volume); }

std::string replaceNotFinite(AnyVolume& volume) {
  return std::visit(
      [](auto& v) -> std::string {
        using T = typename std::decay_t<decltype(v.voxels)>::value_type;
        if constexpr (std::is_floating_point_v<T>) return replaceIn(v);
        return {};
      },
      volume);
}

}  // namespace angiomesh
