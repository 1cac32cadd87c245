// SPDX-License-Identifier: BSD-3-Clause
#include "io/scan/label_image.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <type_traits>

#include "core/base/error.h"
#include "io/dicom/dicom_seg.h"
#include "io/scan/label_choice.h"
#include "io/volume/image_header.h"
#include "io/volume/mask_values.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLabels = 4096;
constexpr std::size_t kMostLikely = 255;  ///< labels of what may as well be a scan
constexpr double kLeastAlike = 0.9;
constexpr int kMostLayers = 256;

struct Segments {
  std::vector<Label> named;  ///< without their voxels
  int layers = 1;
  std::shared_ptr<const DicomSegmentation> dicom;  ///< where it is one
};

int numberIn(const std::map<std::string, std::string>& fields, const std::string& key, int other) {
  const auto found = fields.find(key);
  if (found == fields.end()) return other;
  try {
    return std::stoi(found->second);
  } catch (const std::exception&) {
    return other;
  }
}

Segments segmentsOf(const fs::path& path) {
  Segments segments;
  std::error_code error;
  if (fs::is_directory(path, error)) return segments;
  const ImageFormat& format = imageFormat(path);
  if (format.isDicom()) {
    if (auto dicom = openSegmentation(path)) {
      segments.named = dicom->segments;
      segments.layers = static_cast<int>(dicom->segments.size());
      segments.dicom = std::make_shared<const DicomSegmentation>(std::move(*dicom));
    }
    return segments;
  }
  const ImageHeader header = readHeader(path, format);
  const auto& fields = header.fields;
  for (int n = 0;; ++n) {
    const std::string key = "Segment" + std::to_string(n) + "_";
    const auto name = fields.find(key + "Name"), id = fields.find(key + "ID");
    if (name == fields.end()) break;
    Label segment;
    segment.value = numberIn(fields, key + "LabelValue", n + 1);
    segment.layer = numberIn(fields, key + "Layer", 0);
    segment.name = name->second;
    if (id != fields.end()) segment.id = id->second;
    segments.named.push_back(std::move(segment));
  }
  if (!segments.named.empty())
    segments.layers = static_cast<int>(std::min<std::uintmax_t>(header.data.values, kMostLayers));
  return segments;
}

NativeImage nativeLayer(const fs::path& path, const Segments& segments, int layer,
                        const Progress& progress) {
  if (segments.dicom)
    return {readSegment(*segments.dicom, static_cast<std::size_t>(layer), progress),
            segments.dicom->info};
  const std::optional<int> component =
      segments.layers > 1 ? std::optional<int>(layer) : std::nullopt;
  return readNative(path, {}, component, progress);
}

using Counts = std::map<std::int64_t, std::size_t>;

/// How often each value is there; nothing when one is no label.
template <class T>
std::optional<Counts> countValues(const Volume<T>& volume) {
  Counts counts;
  std::int64_t last = 0;
  std::size_t run = 0;
  for (const T value : volume.voxels) {
    if constexpr (std::is_floating_point_v<T>) {
      if (!(value >= T{0}) || value > T{1e9} || value != std::floor(value)) return {};
    } else if (value < T{0} || static_cast<std::uint64_t>(value) > 1000000000U) {
      return {};
    }
    const auto label = static_cast<std::int64_t>(value);
    if (label == last) {
      ++run;
      continue;
    }
    counts[last] += run;
    if (counts.size() > kMostLabels) return {};
    last = label;
    run = 1;
  }
  counts[last] += run;
  counts.erase(0);
  return counts;
}

void addLabels(const Counts& counts, int layer, const Segments& segments,
               std::vector<Label>& labels) {
  for (const auto& [value, voxels] : counts) {
    Label label{value, {}, layer, voxels, {}};
    for (const Label& segment : segments.named)
      if (segment.layer == layer && segment.value == value) {
        label.name = segment.name;
        label.id = segment.id;
      }
    labels.push_back(std::move(label));
  }
}

/// The share of alike ones among neighbours along x of which neither is 0; 1 without any.
double alikeness(const Volume<float>& image) {
  const auto nx = static_cast<std::size_t>(image.geometry.size[0]);
  std::size_t pairs = 0, alike = 0;
  for (std::size_t row = 0; row < image.voxels.size(); row += nx)
    for (std::size_t i = row + 1; i < row + nx; ++i) {
      const float a = image.voxels[i - 1], b = image.voxels[i];
      const bool both = a != 0.0F && b != 0.0F;
      pairs += both ? 1 : 0;
      alike += both && a == b ? 1 : 0;
    }
  return pairs > 0 ? static_cast<double>(alike) / static_cast<double>(pairs) : 1.0;
}

/// `value` where a mask is not 0.
Volume<std::uint16_t> numbered(const AnyVolume& mask, std::int64_t value) {
  return std::visit(
      [&](const auto& volume) {
        Volume<std::uint16_t> labels(volume.geometry);
        std::transform(
            volume.voxels.begin(), volume.voxels.end(), labels.voxels.begin(),
            [&](auto voxel) { return static_cast<std::uint16_t>(voxel != 0 ? value : 0); });
        return labels;
      },
      mask);
}

/// A layer, its values made labels.
NativeImage labelledLayer(const fs::path& path, const Segments& segments, int layer,
                          const MaskChoice& choice, const Progress& progress) {
  NativeImage native = nativeLayer(path, segments, layer, progress);
  if (segments.dicom && !segments.dicom->fractional) return native;
  for (std::string& warning : makeLabels(native.volume, choice.threshold))
    native.info.warnings.push_back(std::move(warning));
  if (segments.dicom)
    native.volume = numbered(native.volume, segments.named[static_cast<std::size_t>(layer)].value);
  return native;
}

std::vector<Label> labelsOf(const fs::path& path, const Segments& segments,
                            const MaskChoice& choice, const Progress& progress) {
  std::vector<Label> labels;
  for (int layer = 0; layer < segments.layers; ++layer) {
    const auto counts =
        std::visit([](const auto& volume) { return countValues(volume); },
                   labelledLayer(path, segments, layer, choice, progress.sub(0.0, 0.5)).volume);
    if (!counts) return {};
    addLabels(*counts, layer, segments, labels);
  }
  return labels;
}

/// Sets the voxels of the wanted labels of one layer; those of its `labels` that are in it.
void addToMask(const AnyVolume& layer, const std::vector<Label>& labels, int number,
               Volume<std::uint8_t>& mask) {
  std::set<std::int64_t> values;
  for (const Label& label : labels)
    if (label.layer == number) values.insert(label.value);
  if (values.empty()) return;
  std::visit(
      [&](const auto& volume) {
        for (std::size_t i = 0; i < mask.voxels.size(); ++i)
          if (volume.voxels[i] != 0 &&
              values.count(static_cast<std::int64_t>(volume.voxels[i])) != 0)
            mask.voxels[i] = 1;
      },
      layer);
}

}  // namespace

std::vector<Label> readLabels(const fs::path& path, const Progress& progress) {
  return labelsOf(path, segmentsOf(path), {}, progress);
}

std::vector<Label> labelsOfSegmentation(const fs::path& path, const Volume<float>& image,
                                        const Progress& progress) {
  progress.check();
  if (!areNearlyWhole(image)) return {};
  Volume<float> rounded;
  const bool whole = std::all_of(image.voxels.begin(), image.voxels.end(),
                                 [](float value) { return value == std::floor(value); });
  if (!whole) {
    rounded = image;
    makeLabels(rounded);
  }
  const Volume<float>& values = whole ? image : rounded;
  if (alikeness(values) < kLeastAlike) return {};
  const std::optional<Counts> counts = countValues(values);
  if (!counts || counts->size() > kMostLikely) return {};
  std::vector<Label> labels;
  addLabels(*counts, 0, segmentsOf(path), labels);
  return labels;
}

int segmentationLayers(const fs::path& path) { return segmentsOf(path).layers; }

LoadedImage readLayer(const fs::path& path, int layer, const Progress& progress) {
  const Segments segments = segmentsOf(path);
  if (segments.layers == 1) return readImage(path, {}, progress);
  NativeImage native = labelledLayer(path, segments, layer, {}, progress);
  LoadedImage loaded;
  loaded.info = std::move(native.info);
  std::visit(
      [&](const auto& volume) {
        loaded.image.geometry = volume.geometry;
        loaded.image.voxels.assign(volume.voxels.begin(), volume.voxels.end());
      },
      native.volume);
  return loaded;
}

LabelMask readLabel(const fs::path& path, const MaskChoice& choice, const Progress& progress) {
  const Segments segments = segmentsOf(path);
  if (choice.threshold && !choice.label.empty() && !segments.dicom)
    throw InputError("a label and a threshold are both given", path.string(),
                     "give --label or --threshold");
  const std::vector<Label> labels = labelsOf(path, segments, choice, progress);
  if (labels.empty() && choice.threshold)
    throw InputError("no voxel reaches the threshold", path.string(), "choose a smaller one");
  if (labels.empty())
    throw InputError(
        "there are no labels in it: all is 0, or values are negative or no whole numbers",
        path.string(), "give a mask or a label image, or the least value inside (--threshold)");
  LabelMask result;
  result.labels = chosenLabels(labels, choice.label, path);
  result.onlyOne = labels.size() == 1;
  for (int layer = 0; layer < segments.layers; ++layer) {
    if (std::none_of(result.labels.begin(), result.labels.end(),
                     [&](const Label& label) { return label.layer == layer; }))
      continue;
    const NativeImage native = labelledLayer(path, segments, layer, choice, progress.sub(0.5, 1.0));
    if (result.mask.voxels.empty()) {
      result.mask = Volume<std::uint8_t>(geometryOf(native.volume));
      result.warnings = native.info.warnings;
    }
    addToMask(native.volume, result.labels, layer, result.mask);
  }
  return result;
}

}  // namespace angiomesh
