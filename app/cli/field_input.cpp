// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/field_input.h"

#include <algorithm>

#include "io/image_io.h"

namespace angiomesh::cli {
namespace {

constexpr float kHalf = 0.5F;

Volume<float> fieldOfMask(const Volume<std::uint8_t>& mask) {
  Volume<float> field(mask.geometry);
  std::transform(mask.voxels.begin(), mask.voxels.end(), field.voxels.begin(),
                 [](std::uint8_t inside) { return inside != 0 ? -kHalf : kHalf; });
  return field;
}

}  // namespace

Volume<float> readPhiOrMask(const std::string& path) {
  const std::vector<ImageSummary> summaries = describeImages(path);
  if (!summaries.empty() && summaries.front().info.pixelType.find("float") == std::string::npos)
    return fieldOfMask(readMask(path));
  Volume<float> field = readImage(path).image;
  if (valueRange(field)[0] >= 0.0F)
    for (float& value : field.voxels) value = value != 0.0F ? -kHalf : kHalf;
  return field;
}

}  // namespace angiomesh::cli
