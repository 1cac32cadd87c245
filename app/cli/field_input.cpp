// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/field_input.h"

#include <algorithm>
#include <utility>

#include "app/cli/session.h"
#include "core/levelset/mask_distance.h"
#include "core/pipeline/wall_step.h"
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

void print(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) printWarning(warning);
}

}  // namespace

Volume<std::uint8_t> readTruth(const std::string& path) {
  MaskImage read = readMask(path);
  print(read.warnings);
  return std::move(read.mask);
}

Volume<float> readPhiOrMask(const std::string& path) {
  const std::vector<ImageSummary> summaries = describeImages(path);
  if (!summaries.empty() && summaries.front().info.pixelType.find("float") == std::string::npos)
    return fieldOfMask(readTruth(path));
  LoadedImage loaded = readImage(path);
  print(screenWarnings(loaded.info));
  Volume<float>& field = loaded.image;
  if (valueRange(field)[0] >= 0.0F)
    for (float& value : field.voxels) value = value != 0.0F ? -kHalf : kHalf;
  return std::move(field);
}

MeshInput readMeshInput(const std::string& path, const std::string& label,
                        const SmoothWallParams& wall, const Progress& progress) {
  MeshInput input;
  if (label.empty()) {
    // Before anything that a label image with layers does not go through.
    const std::vector<ImageSummary> summaries = describeImages(path);
    const bool isFloat =
        !summaries.empty() && summaries.front().info.pixelType.starts_with("float");
    if (isFloat) {
      LoadedImage loaded = readImage(path, {}, progress.sub(0.0, 0.2));
      if (valueRange(loaded.image)[0] < 0.0F) {
        print(screenWarnings(loaded.info));
        input.phi = std::move(loaded.image);
        return input;
      }
    }
  }
  LabelMask chosen = readLabel(path, label, progress.sub(0.0, 0.2));
  print(chosen.warnings);
  input.label = chosen.label;
  input.otherLabels = !chosen.onlyOne;
  MaskDistance made = distanceOfMask(chosen.mask, progress.sub(0.2, 0.7));
  input.phi = smoothMask(std::move(made.phi), wall, progress.sub(0.7, 1.0));
  input.largestShiftVoxels = made.largestShiftVoxels;
  input.maskVolumeMm3 = made.maskVolumeMm3;
  return input;
}

}  // namespace angiomesh::cli
