// SPDX-License-Identifier: BSD-3-Clause
#include "core/image/projection.h"

#include <algorithm>
#include <string>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace angiomesh {

Projection maximumProjection(const Volume<float>& image, int axis) {
  if (axis < 0 || axis > 2)
    throw InputError("there is no grid axis " + std::to_string(axis), "maximum projection",
                     "give 0, 1 or 2");
  const Index3& n = image.geometry.size;
  if (image.geometry.voxelCount() == 0)
    throw InputError("the volume is empty", "maximum projection", "give a volume with voxels");
  const int acrossAxis = axis == 0 ? 1 : 0;
  const int downAxis = axis == 2 ? 1 : 2;
  Projection result;
  result.width = n[acrossAxis];
  result.height = n[downAxis];
  result.values.resize(static_cast<std::size_t>(result.width) *
                       static_cast<std::size_t>(result.height));
  parallelForEach(static_cast<std::size_t>(result.height), 4, [&](std::size_t row) {
    Index3 at{0, 0, 0};
    at[downAxis] = static_cast<int>(row);
    for (int u = 0; u < result.width; ++u) {
      at[acrossAxis] = u;
      at[axis] = 0;
      float largest = image.at(at[0], at[1], at[2]);
      for (at[axis] = 1; at[axis] < n[axis]; ++at[axis])
        largest = std::max(largest, image.at(at[0], at[1], at[2]));
      result.values[row * static_cast<std::size_t>(result.width) + static_cast<std::size_t>(u)] =
          largest;
    }
  });
  return result;
}

}  // namespace angiomesh
