// SPDX-License-Identifier: BSD-3-Clause
#include "io/label_image.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>

#include "core/base/error.h"
#include "io/image_header.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLabels = 4096, kListed = 20;
constexpr std::size_t kMostLikely = 255;  ///< labels of what may as well be a scan
constexpr double kLeastAlike = 0.9;
constexpr int kMostLayers = 256;

/// A segment of 3D Slicer: its name by layer and value.
using Names = std::map<std::pair<int, std::int64_t>, std::string>;

struct Segments {
  Names names;
  int layers = 1;
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
  const ImageFormat format = imageFormat(path);
  if (format != ImageFormat::Nrrd) return segments;
  const ImageHeader header = readHeader(path, format);
  for (int n = 0;; ++n) {
    const std::string key = "Segment" + std::to_string(n) + "_";
    const auto name = header.fields.find(key + "Name");
    if (name == header.fields.end()) break;
    const int value = numberIn(header.fields, key + "LabelValue", n + 1);
    segments.names[{numberIn(header.fields, key + "Layer", 0), value}] = name->second;
  }
  if (!segments.names.empty())
    segments.layers = static_cast<int>(std::min<std::uintmax_t>(header.data.values, kMostLayers));
  return segments;
}

NativeImage nativeLayer(const fs::path& path, const Segments& segments, int layer,
                        const Progress& progress) {
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

std::string textOf(const Label& label) {
  std::string text = std::to_string(label.value);
  if (!label.name.empty()) text += " '" + label.name + "'";
  return text + " (" + std::to_string(label.voxels) + " voxels)";
}

std::string listOf(const std::vector<Label>& labels) {
  std::string text;
  for (std::size_t n = 0; n < labels.size() && n < kListed; ++n)
    text += (n == 0 ? "" : ", ") + textOf(labels[n]);
  if (labels.size() > kListed) text += " and " + std::to_string(labels.size() - kListed) + " more";
  return text;
}

const Label& chosen(const std::vector<Label>& labels, const std::string& choice,
                    const fs::path& path) {
  if (choice.empty() && labels.size() == 1) return labels.front();
  if (choice.empty())
    throw InputError("it holds " + std::to_string(labels.size()) + " labels: " + listOf(labels),
                     path.string(), "choose one by its value or name (--label)");
  const Label* found = nullptr;
  for (const Label& label : labels) {
    // A name that is a number goes before the value.
    if (label.name == choice) return label;
    if (std::to_string(label.value) != choice) continue;
    if (found != nullptr)
      throw InputError("several segments have the label " + choice + ", in different layers",
                       path.string(), "choose by name: " + listOf(labels));
    found = &label;
  }
  if (found == nullptr)
    throw InputError("there is no label '" + choice + "'", path.string(),
                     "choose one of " + listOf(labels));
  return *found;
}

void addLabels(const Counts& counts, int layer, const Segments& segments,
               std::vector<Label>& labels) {
  for (const auto& [value, voxels] : counts) {
    const auto name = segments.names.find({layer, value});
    labels.push_back(
        {value, name == segments.names.end() ? std::string() : name->second, layer, voxels});
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

std::vector<Label> labelsOf(const fs::path& path, const Segments& segments,
                            const Progress& progress) {
  std::vector<Label> labels;
  for (int layer = 0; layer < segments.layers; ++layer) {
    const auto counts =
        std::visit([](const auto& volume) { return countValues(volume); },
                   nativeLayer(path, segments, layer, progress.sub(0.0, 0.5)).volume);
    if (!counts) return {};
    addLabels(*counts, layer, segments, labels);
  }
  return labels;
}

}  // namespace

std::vector<Label> readLabels(const fs::path& path, const Progress& progress) {
  return labelsOf(path, segmentsOf(path), progress);
}

std::vector<Label> labelsOfSegmentation(const fs::path& path, const Volume<float>& image,
                                        const Progress& progress) {
  progress.check();
  if (alikeness(image) < kLeastAlike) return {};
  const std::optional<Counts> counts = countValues(image);
  if (!counts || counts->size() > kMostLikely) return {};
  std::vector<Label> labels;
  addLabels(*counts, 0, segmentsOf(path), labels);
  return labels;
}

int segmentationLayers(const fs::path& path) { return segmentsOf(path).layers; }

LoadedImage readLayer(const fs::path& path, int layer, const Progress& progress) {
  const Segments segments = segmentsOf(path);
  if (segments.layers == 1) return readImage(path, {}, progress);
  NativeImage native = nativeLayer(path, segments, layer, progress);
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

LabelMask readLabel(const fs::path& path, const std::string& choice, const Progress& progress) {
  const Segments segments = segmentsOf(path);
  const std::vector<Label> labels = labelsOf(path, segments, progress);
  if (labels.empty())
    throw InputError(
        "there are no labels in it: all is 0, or values are negative or no whole numbers",
        path.string(), "give a mask or a label image");
  LabelMask result;
  result.label = chosen(labels, choice, path);
  result.onlyOne = labels.size() == 1;
  const NativeImage native =
      nativeLayer(path, segments, result.label.layer, progress.sub(0.5, 1.0));
  result.warnings = native.info.warnings;
  std::visit(
      [&](const auto& volume) {
        result.mask = Volume<std::uint8_t>(volume.geometry);
        std::transform(volume.voxels.begin(), volume.voxels.end(), result.mask.voxels.begin(),
                       [&](auto value) {
                         return static_cast<std::int64_t>(value) == result.label.value ? 1 : 0;
                       });
      },
      native.volume);
  return result;
}

}  // namespace angiomesh
