// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/field_input.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "app/session/session.h"
#include "core/distance/mask_distance.h"
#include "core/pipeline/segments.h"
#include "core/pipeline/wall_step.h"
#include "core/topology/mask_contacts.h"
#include "io/scan/image_io.h"
#include "io/volume/mask_values.h"

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

/// A level set function of a float file, or nothing: a mask.
std::optional<Volume<float>> fieldOf(const std::string& path, const Progress& progress) {
  const std::vector<ImageSummary> summaries = describeImages(path);
  if (summaries.empty() || !summaries.front().info.pixelType.starts_with("float")) return {};
  ReadOptions options;
  options.replaceNotFinite = true;
  LoadedImage loaded = readImage(path, options, progress);
  const float least = valueRange(loaded.image)[0];
  if (least >= 0.0F || looksLikeResampledMask(loaded.image)) return {};
  // Voxels that are no numbers are read as outside of a mask, but are nothing in such a function.
  if (loaded.info.replaced) loaded = readImage(path, {}, progress);
  print(screenWarnings(loaded.info));
  return std::move(loaded.image);
}

/// Says that the outside of vessels was taken for their inside.
void sayInsideOut(double shareOfBorder, const char* what, const char* hint) {
  if (shareOfBorder > kInsideOut)
    printWarning(std::string(what) + " on " + std::to_string(std::lround(100.0 * shareOfBorder)) +
                 " % of the volume's border, where vessels are not: " + hint);
}

std::size_t countInside(const Volume<std::uint8_t>& mask) {
  return mask.voxels.size() - static_cast<std::size_t>(std::count(
                                  mask.voxels.begin(), mask.voxels.end(), std::uint8_t{0}));
}

/// Leaves the parts of a mask out of which the surface has none. Its wall is smooth: some voxels of
/// a part lie beyond.
void leaveOut(const Segments& segments, MaskConnectivity connectivity, Volume<std::uint8_t>& mask) {
  const Components parts = connectedComponents(mask, connectivity != MaskConnectivity::Faces);
  std::vector<bool> kept(parts.sizes.size() + 1), left(kept.size());
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    const std::int32_t label = segments.labels.voxels[i];
    if (label == 0) continue;
    const auto part = static_cast<std::size_t>(parts.labels.voxels[i]);
    (segments.components[static_cast<std::size_t>(label - 1)].kept ? kept : left)[part] = true;
  }
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    const auto part = static_cast<std::size_t>(parts.labels.voxels[i]);
    if (left[part] && !kept[part]) mask.voxels[i] = 0;
  }
}

/// Leaves the parts out that are not to be kept, of the mask, too.
void keepParts(const Parameters& params, Volume<std::uint8_t>* mask, MeshInput& input,
               const Progress& progress) {
  SegmentationParams choice = params.segmentation;
  if (mask != nullptr) choice.method = SegmentationMethod::Label;
  if (keepsAll(choice)) return;
  auto phi = std::make_shared<const Volume<float>>(std::move(input.phi));
  const Segments segments =
      selectSegments(*phi, choice, params.seeds.points, progress.sub(0.0, 0.5));
  input.phi = *withoutDropped(phi, segments, progress.sub(0.5, 1.0));
  if (mask == nullptr) return;
  leaveOut(segments, choice.connectivity, *mask);
  input.maskVolumeMm3 = volumeBetweenCentres(*mask);
}

}  // namespace

Volume<std::uint8_t> readTruth(const std::string& path, std::optional<double> threshold) {
  MaskImage read = readMask(path, threshold);
  print(read.warnings);
  return std::move(read.mask);
}

void addMaskChoice(CLI::App& command, MaskChoice& choice) {
  command.add_option("--label", choice.label,
                     "Which labels of a label image, several between commas: value, or name in a "
                     ".seg.nrrd; value:7, name:7, id:Segment_1 say which is meant");
  command.add_option("--threshold", choice.threshold,
                     "Of a mask of probabilities or any other image: voxels of this value and more "
                     "are inside");
}

Volume<float> readPhiOrMask(const std::string& path, std::optional<double> threshold) {
  if (!threshold)
    if (auto field = fieldOf(path, {})) return std::move(*field);
  return fieldOfMask(readTruth(path, threshold));
}

MeshInput readMeshInput(const std::string& path, const MaskChoice& choice, const Parameters* params,
                        const Progress& progress) {
  MeshInput input;
  if (choice.label.empty() && !choice.threshold)
    if (auto field = fieldOf(path, progress.sub(0.0, 0.2))) {
      input.phi = std::move(*field);
      sayInsideOut(shareOfBorder(insideMask(input.phi)), "the function is negative",
                   "is it positive inside? Then give --threshold 0");
      if (params != nullptr) keepParts(*params, nullptr, input, progress.sub(0.2, 1.0));
      return input;
    }
  LabelMask chosen = readLabel(path, choice, progress.sub(0.0, 0.2));
  print(chosen.warnings);
  input.labels = std::move(chosen.labels);
  input.otherLabels = !chosen.onlyOne;
  MaskDistance made = distanceOfMask(chosen.mask, progress.sub(0.2, 0.7));
  input.largestShiftVoxels = made.largestShiftVoxels;
  input.maskVolumeMm3 = made.maskVolumeMm3;
  input.phi = smoothMask(std::move(made.phi), params ? params->wall : SmoothWallParams{},
                         progress.sub(0.7, 0.8));
  if (params != nullptr) {
    const MaskContacts contacts = settleContacts(
        input.phi, chosen.mask, params->segmentation.connectivity, progress.sub(0.8, 0.9));
    if (const std::string words = contactText(contacts); !words.empty()) printWarning(words);
    keepParts(*params, &chosen.mask, input, progress.sub(0.9, 1.0));
  }
  const double atBorder = shareOfBorder(chosen.mask);
  sayInsideOut(atBorder, "the mask lies", "is it 0 inside? Then turn it round");
  input.atBorder = atBorder > 0.0;
  input.voxels = countInside(chosen.mask);
  return input;
}

}  // namespace angiomesh::cli
