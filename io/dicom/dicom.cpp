// SPDX-License-Identifier: BSD-3-Clause
#include "io/dicom/dicom.h"

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "io/dicom/dicom_series.h"
#include "io/dicom/slice_orientation.h"
#include "io/volume/geometry_check.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

using Stacks = std::vector<std::shared_ptr<const DicomStack>>;

const char* const kChoose = "choose one with --series and its UID or the end of it";
/// Fewer slices are a localizer or a single picture, not a volume.
constexpr std::size_t kLeastSlices = 3;

[[noreturn]] void refuseWithoutImage(const fs::path& path) {
  const std::string kind = kindWithoutImage(path);
  if (kind == "MediaStorageDirectoryStorage")
    throw InputError("a DICOMDIR, which lists the images of a medium and holds none", path.string(),
                     "give the folder that it lies in");
  throw InputError("the DICOM file holds no image" + (kind.empty() ? kind : ": it is " + kind),
                   path.string(), "give a file with an image");
}

Stacks stacksOf(const fs::path& path, const Progress& progress, ScanDepth depth,
                std::vector<std::string>& warnings) {
  Stacks stacks;
  for (DicomSeries& series : scanDicom(path, progress, depth, warnings))
    for (DicomStack& stack : splitSeries(std::move(series)))
      stacks.push_back(std::make_shared<const DicomStack>(std::move(stack)));
  if (!stacks.empty()) return stacks;
  std::error_code error;
  if (!fs::is_directory(path, error)) refuseWithoutImage(path);
  throw InputError("there is no DICOM image in the folder or below it", path.string(),
                   "give the folder that holds the series");
}

/// The shortest ending, of 8 characters at least, that only this volume's id has.
std::string shortId(const DicomStack& one, const Stacks& all) {
  const std::string id = one.id();
  for (std::size_t length = std::min<std::size_t>(8, id.size()); length < id.size(); ++length) {
    std::string ending = id.substr(id.size() - length);
    if (std::count_if(all.begin(), all.end(),
                      [&](const auto& other) { return other->id().ends_with(ending); }) == 1)
      return ending;
  }
  return id;
}

std::string lineOf(const DicomStack& stack, const Stacks& all) {
  std::string line =
      shortId(stack, all) + " \"" + stack.description.substr(0, 40) + "\" " + stack.modality + " ";
  if (stack.frames.empty()) return line + "damaged";
  const DicomFile& file = stack.fileOf(stack.frames.front());
  line += std::to_string(file.columns) + " x " + std::to_string(file.rows) + " x " +
          std::to_string(stack.frames.size());
  return stack.label.empty() ? line : line + ", " + stack.label;
}

std::string listOf(const Stacks& all) {
  const std::size_t shown = std::min<std::size_t>(all.size(), 12);
  std::string list;
  for (std::size_t i = 0; i < shown; ++i) list += (i == 0 ? "" : "; ") + lineOf(*all[i], all);
  if (shown < all.size()) list += "; and " + std::to_string(all.size() - shown) + " more";
  return list;
}

/// Slices that ought to be a volume, whatever may be wrong with them.
bool isVolume(const DicomStack& stack) {
  if (std::any_of(stack.findings.begin(), stack.findings.end(),
                  [](const Finding& finding) { return finding.kind == FindingKind::Segmentation; }))
    return false;
  if (stack.frames.empty()) return true;  // a damaged series: nobody knows
  const DicomFrame& first = stack.frames.front();
  return stack.frames.size() >= kLeastSlices && first.placed && stack.fileOf(first).samples == 1;
}

std::string seriesWord(const Stacks& all) {
  std::set<std::string> uids;
  for (const auto& stack : all) uids.insert(stack->uid);
  return uids.size() == all.size() ? " series"
                                   : " volumes in " + std::to_string(uids.size()) + " series";
}

/// The only one, or the only one that is a volume.
std::optional<std::size_t> loneOf(const Stacks& all) {
  if (all.size() == 1) return 0;
  std::optional<std::size_t> lone;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!isVolume(*all[i])) continue;
    if (lone) return std::nullopt;
    lone = i;
  }
  return lone;
}

Stacks stacksOf(const std::vector<ImageSummary>& entries) {
  Stacks stacks;
  for (const ImageSummary& entry : entries) stacks.push_back(entry.stack);
  return stacks;
}

std::string textOfLeftOut(const Stacks& all) {
  return "of " + std::to_string(all.size()) + seriesWord(all) + " all but one hold fewer than " +
         std::to_string(kLeastSlices) +
         " slices with a position, or segmentations, and were left out";
}

std::shared_ptr<const DicomStack> chooseAlone(const Stacks& all, const fs::path& path,
                                              std::vector<std::string>& warnings) {
  const std::optional<std::size_t> lone = loneOf(all);
  if (!lone)
    throw InputError(
        "there are " + std::to_string(all.size()) + seriesWord(all) + " (" + listOf(all) + ")",
        path.string(), kChoose);
  if (all.size() > 1) warnings.push_back(textOfLeftOut(all));
  return all[*lone];
}

std::shared_ptr<const DicomStack> choose(const Stacks& all, const std::string& id,
                                         const fs::path& path, std::vector<std::string>& warnings) {
  if (id.empty()) return chooseAlone(all, path, warnings);
  Stacks fitting;
  for (const auto& stack : all) {
    if (stack->id() == id) return stack;
    if (fitsSeries(stack->id(), id)) fitting.push_back(stack);
  }
  if (fitting.size() == 1) return fitting.front();
  throw InputError((fitting.empty() ? "there is no series " + id + " ("
                                    : std::to_string(fitting.size()) + seriesWord(fitting) +
                                          " fit " + id + " (") +
                       listOf(fitting.empty() ? all : fitting) + ")",
                   path.string(), kChoose);
}

InputInfo infoOf(const DicomStack& stack, const StackGrid& grid) {
  InputInfo info;
  info.format = "DICOM";
  info.modality = stack.modality;
  info.seriesUid = stack.id();
  info.seriesDescription = stack.description;
  if (!stack.label.empty())
    info.seriesDescription += (info.seriesDescription.empty() ? "" : ", ") + stack.label;
  info.seriesNumber = stack.number;
  info.date = stack.date;
  info.findings = grid.findings;
  info.files = static_cast<int>(stack.files.size());
  if (stack.frames.empty()) return info;
  const DicomFrame& middle = stack.frames[stack.frames.size() / 2];
  const PixelLayout& layout = stack.fileOf(middle).layout;
  info.pixelType = (layout.real       ? "float"
                    : layout.isSigned ? "int"
                                      : "uint") +
                   std::to_string(layout.allocated);
  info.windows = middle.windows;
  if (middle.placed) info.orientation = orientationText(middle.alongRow, middle.alongColumn);
  return info;
}

std::string adviceFor(FindingKind kind) {
  switch (kind) {
    case FindingKind::MissingSlices:
    case FindingKind::UnevenSpacing:
      return "add the missing slices, or have the series resampled with --uneven-slices resample";
    case FindingKind::DuplicatePosition:
      return "take the slice that does not belong to the volume out of the folder";
    case FindingKind::GantryTilt:
      return "resample the series to an upright stack with another program";
    case FindingKind::SingleSlice:
      return "give the folder that holds the whole series";
    case FindingKind::DamagedFile:
      return "copy the file again, or take it out of the folder";
    case FindingKind::Segmentation:
      return "name the file of the segmentation instead of its folder";
    case FindingKind::ColourImage:
      return "give a series with one value per pixel";
    default:
      return "give a series of slices (MR or CT) as the scanner wrote it";
  }
}

[[noreturn]] void refuse(const StackGrid& grid, const fs::path& path) {
  const Finding& worst = *grid.refusal();
  std::string what = screenText(worst);
  for (const Finding& finding : grid.findings)
    if (&finding != &worst && (finding.refuses || finding.kind == FindingKind::MixedSize ||
                               finding.kind == FindingKind::MixedOrientation ||
                               finding.kind == FindingKind::MixedSpacing))
      what += "; also, " + screenText(finding);
  if (worst.kind == FindingKind::DamagedFile)
    throw IoError(what, path.string(), adviceFor(worst.kind));
  if (canBeEvenedOut(worst.kind))
    throw UnevenSlicesError(what, path.string(), adviceFor(worst.kind));
  throw InputError(what, path.string(), adviceFor(worst.kind));
}

/// `slices` holds one slice per frame; each slice of the result is one of them or between two.
Volume<float> blend(const Volume<float>& slices, const StackGrid& grid) {
  Volume<float> image(grid.geometry);
  const std::size_t pixels = static_cast<std::size_t>(grid.geometry.size[0]) *
                             static_cast<std::size_t>(grid.geometry.size[1]);
  for (std::size_t k = 0; k < grid.slices.size(); ++k) {
    const auto [first, weight] = grid.slices[k];
    const float* a = slices.voxels.data() + first * pixels;
    const float* b = weight > 0.0 ? a + pixels : a;
    float* to = image.voxels.data() + k * pixels;
    for (std::size_t i = 0; i < pixels; ++i)
      to[i] = static_cast<float>((1.0 - weight) * static_cast<double>(a[i]) +
                                 weight * static_cast<double>(b[i]));
  }
  return image;
}

}  // namespace

LoadedImage readDicomStack(const std::shared_ptr<const DicomStack>& stack, bool evenOut,
                           const fs::path& path, const Progress& progress) {
  const StackGrid grid = gridOfStack(*stack, evenOut);
  if (grid.refusal() != nullptr) refuse(grid, path);
  LoadedImage loaded;
  loaded.info = infoOf(*stack, grid);
  Geometry frames = grid.geometry;
  frames.size[2] = static_cast<int>(stack->frames.size());
  Volume<float> image;
  image.geometry = frames;
  image.voxels = unfilled<float>(frames.voxelCount());
  const std::size_t padded = readFrames(*stack, image, progress);
  if (padded > 0)
    loaded.info.findings.push_back(
        {FindingKind::PaddedValues,
         false,
         std::to_string(padded) + " voxels of padding were set to the smallest value of the image",
         {},
         {}});
  const bool plain = grid.slices.size() == stack->frames.size() &&
                     std::all_of(grid.slices.begin(), grid.slices.end(),
                                 [](const SliceBlend& slice) { return slice.weight == 0.0; });
  loaded.image = plain ? std::move(image) : blend(image, grid);
  return loaded;
}

std::shared_ptr<const DicomStack> findDicom(const fs::path& path, const std::string& series,
                                            const Progress& progress,
                                            std::vector<std::string>& warnings) {
  const Stacks all = stacksOf(path, progress, ScanDepth::AllBelow, warnings);
  return choose(all, series, path, warnings);
}

LoadedImage readDicom(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  progress.phase("reading");
  std::vector<std::string> warnings;
  const auto stack = findDicom(path, options.series, progress.sub(0.0, 0.3), warnings);
  LoadedImage loaded = readDicomStack(stack, options.evenOut, path, progress.sub(0.3, 0.9));
  for (std::string& warning : checkGeometry(loaded.image.geometry))
    warnings.push_back(std::move(warning));
  loaded.info.warnings.insert(loaded.info.warnings.begin(), warnings.begin(), warnings.end());
  return loaded;
}

std::optional<std::size_t> loneVolume(const std::vector<ImageSummary>& entries) {
  return entries.size() == 1 ? std::optional<std::size_t>(0) : loneOf(stacksOf(entries));
}

std::string leftOutText(const std::vector<ImageSummary>& entries) {
  return entries.size() > 1 ? textOfLeftOut(stacksOf(entries)) : std::string();
}

bool fitsSeries(const std::string& id, const std::string& wanted) {
  return id.ends_with(wanted) || id.substr(0, id.find('/')).ends_with(wanted);
}

std::vector<ImageSummary> describeDicom(const fs::path& path, const Progress& progress,
                                        ScanDepth depth) {
  std::vector<ImageSummary> summaries;
  std::vector<std::string> common;
  for (const auto& stack : stacksOf(path, progress, depth, common)) {
    const StackGrid grid = gridOfStack(*stack, false);
    ImageSummary summary;
    summary.geometry = grid.geometry;
    summary.info = infoOf(*stack, grid);
    summary.info.warnings = common;
    if (grid.refusal() == nullptr)
      for (std::string& warning : checkGeometry(summary.geometry))
        summary.info.warnings.push_back(std::move(warning));
    summary.stack = stack;
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

}  // namespace angiomesh
