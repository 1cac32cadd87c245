// SPDX-License-Identifier: BSD-3-Clause
#include "io/scan/image_io.h"

#include <algorithm>
#include <cstring>
#include <mutex>
#include <new>
#include <string>
#include <system_error>

#include "core/base/error.h"
#include "io/dicom/dicom.h"
#include "io/dicom/dicom_seg.h"
#include "io/volume/geometry_check.h"
#include "io/volume/header_text.h"
#include "io/volume/image_header.h"
#include "io/volume/mask_values.h"
#include "io/volume/not_finite.h"
#include "io/volume/voxel_convert.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

bool isFolder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

bool isDicom(const fs::path& path) { return isFolder(path) || imageFormat(path).isDicom(); }

/// An image file whose header is read and makes sense.
struct OpenImage {
  fs::path path;
  ImageHeader header;
  Geometry geometry;
  InputInfo info;
  std::uintmax_t value = 0;  ///< which one of a voxel
};

std::uintmax_t chosenValue(const ImageHeader& header, std::optional<int> component,
                           const fs::path& path) {
  const VoxelData& data = header.data;
  if (!component && data.values == 1) return 0;
  if (component && *component >= 0 && static_cast<std::uintmax_t>(*component) < data.values)
    return static_cast<std::uintmax_t>(*component);
  const std::string range = "--component N', N from 0 to " + std::to_string(data.values - 1);
  if (component)
    throw InputError("there is no component " + std::to_string(*component), path.string(),
                     "use '" + range);
  const std::string advice = "take one of them out with 'angiomesh-cli convert " + range;
  if (data.interleaved)
    throw InputError(
        "each voxel holds " + std::to_string(data.values) + " values (a colour or vector image)",
        path.string(), advice);
  throw InputError("a 4D image (" + sizeText(header) + ")", path.string(), advice);
}

OpenImage openImage(const fs::path& path, const std::string& seriesUid,
                    std::optional<int> component) {
  if (!seriesUid.empty())
    throw InputError("a series is chosen, but this is not DICOM", path.string(),
                     "leave the series out");
  OpenImage image;
  image.path = path;
  const ImageFormat& format = imageFormat(path);
  image.header = readHeader(path, format);
  const ImageHeader& header = image.header;
  image.value = chosenValue(header, component, path);
  image.geometry = header.geometry;
  image.info.format = format.name;
  image.info.pixelType = voxelTypeName(header.data.type);
  image.info.modality = header.modality;
  image.info.warnings = header.warnings;
  for (std::string& warning : checkGeometry(image.geometry))
    image.info.warnings.push_back(std::move(warning));
  return image;
}

/// Throws where the voxels, `bytesEach` each, are more than the memory of the machine.
void checkMemory(const OpenImage& image, std::size_t bytesEach) {
  const std::uintmax_t memory = physicalMemory();
  const std::uintmax_t needed = image.header.data.voxels * bytesEach;
  if (memory == 0 || needed <= memory) return;
  const auto gigabytes = [](std::uintmax_t bytes) { return std::to_string((bytes >> 30U) + 1); };
  throw InputError("the volume (" + sizeText(image.header) + " voxels, " + gigabytes(needed) +
                       " GB) does not fit into the memory of this machine (" + gigabytes(memory) +
                       " GB)",
                   image.path.string(), "crop or downsample it first");
}

/// A volume for the image's voxels, which are not set yet.
template <class T>
Volume<T> roomFor(const OpenImage& image) {
  checkMemory(image, sizeof(T));
  Volume<T> volume;
  volume.geometry = image.geometry;
  volume.voxels = unfilled<T>(image.geometry.voxelCount());
  return volume;
}

/// readVoxels(); warns where there are more than the header says.
template <class Take>
void forRuns(const OpenImage& image, const Take& take, std::vector<std::string>& warnings,
             const Progress& progress) {
  const VoxelData& data = image.header.data;
  const std::uintmax_t more = readVoxels(data, image.value, take, progress);
  if (more > 0)
    warnings.push_back(longerText(more, "values", data.pieces.front().file == image.path, false,
                                  more * voxelTypeBytes(data.type) >= kMostCounted));
}

/// checkUsable(), of voxels that are all finite or replaced.
void checkReplaced(LoadedImage& loaded, const fs::path& path) {
  const std::string warning = replaceNotFinite(loaded.image);
  loaded.info.replaced = !warning.empty();
  if (loaded.info.replaced) loaded.info.warnings.push_back(warning);
  checkUsable(loaded.image, path.string());
}

LoadedImage readFloats(const OpenImage& image, bool replace, const Progress& progress) {
  LoadedImage loaded;
  loaded.info = image.info;
  loaded.image = roomFor<float>(image);
  float* const voxels = loaded.image.voxels.data();
  RunFacts facts;
  std::mutex mutex;
  forRuns(
      image,
      [&](std::size_t first, std::span<const std::byte> run) {
        const RunFacts seen = floatsOf(image.header.data, run, first, voxels + first);
        const std::lock_guard lock(mutex);
        facts.values.add(seen.values);
        facts.rounded = facts.rounded || seen.rounded;
      },
      loaded.info.warnings, progress);
  if (replace && facts.values.firstNotFinite != ValueFacts::none) {
    checkReplaced(loaded, image.path);
  } else {
    checkUsable(loaded.image.geometry, facts.values, image.path.string());
  }
  if (facts.rounded)
    loaded.info.warnings.push_back("some of the " + image.info.pixelType +
                                   " values were rounded: Angiomesh works in float32");
  return loaded;
}

template <class T>
Volume<T> readAs(const OpenImage& image, std::vector<std::string>& warnings,
                 const Progress& progress) {
  Volume<T> volume = roomFor<T>(image);
  forRuns(
      image,
      [&](std::size_t first, std::span<const std::byte> run) {
        std::memcpy(volume.voxels.data() + first, run.data(), run.size());
      },
      warnings, progress);
  return volume;
}

/// The rescaled voxels, in double precision at first.
AnyVolume readRescaled(const OpenImage& image, std::vector<std::string>& warnings,
                       const Progress& progress) {
  const VoxelData& data = image.header.data;
  Volume<double> volume = roomFor<double>(image);
  forRuns(
      image,
      [&](std::size_t first, std::span<const std::byte> run) {
        withVoxelType(data.type, [&](auto zero) {
          for (std::size_t i = 0; i < run.size() / sizeof(zero); ++i) {
            auto stored = zero;
            std::memcpy(&stored, run.data() + i * sizeof(zero), sizeof(zero));
            volume.voxels[first + i] = static_cast<double>(stored) * data.slope + data.intercept;
          }
        });
      },
      warnings, progress);
  return inNarrowestType(std::move(volume));
}

MaskImage maskOfWholeNumbers(const OpenImage& image) {
  MaskImage read{roomFor<std::uint8_t>(image), image.info.warnings};
  forRuns(image,
          [&](std::size_t first, std::span<const std::byte> run) {
            maskOf(image.header.data, run, read.mask.voxels.data() + first);
          },
          read.warnings, {});
  return read;
}

Volume<float> floatsOf(const AnyVolume& from) {
  return std::visit(
      [](const auto& volume) {
        Volume<float> image;
        image.geometry = volume.geometry;
        image.voxels.assign(volume.voxels.begin(), volume.voxels.end());
        return image;
      },
      from);
}

/// A volume that the memory cannot hold after all.
template <class Function>
auto inMemory(const fs::path& path, const Function& function) {
  try {
    return function();
  } catch (const std::bad_alloc&) {
    throw InputError("the volume does not fit into memory", path.string(),
                     "crop or downsample it first");
  }
}

}  // namespace

LoadedImage readImage(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  progress.check();
  return inMemory(path, [&] {
    LoadedImage loaded;
    if (const auto segmentation = openSegmentation(path)) {
      loaded.info = segmentation->info;
      loaded.image = floatsOf(readSegments(*segmentation, path, progress));
      checkUsable(loaded.image, path.string());
    } else if (isDicom(path)) {
      loaded = readDicom(path, options, progress);
      if (options.replaceNotFinite)
        checkReplaced(loaded, path);
      else
        checkUsable(loaded.image, path.string());
    } else {
      loaded = readFloats(openImage(path, options.series, {}), options.replaceNotFinite, progress);
    }
    progress.report(1.0);
    return loaded;
  });
}

LoadedImage readImage(const ImageSummary& entry, const fs::path& path, bool evenOut,
                      const Progress& progress) {
  if (!entry.stack) {
    ReadOptions options;
    options.replaceNotFinite = true;
    return readImage(path, options, progress);
  }
  progress.phase("reading");
  LoadedImage loaded = readDicomStack(entry.stack, evenOut, path, progress.sub(0.0, 0.9));
  loaded.info.warnings = entry.info.warnings;
  checkReplaced(loaded, path);
  progress.report(1.0);
  return loaded;
}

MaskImage readMask(const fs::path& path, std::optional<double> threshold) {
  return inMemory(path, [&]() -> MaskImage {
    if (!threshold && !isDicom(path)) {
      const OpenImage image = openImage(path, {}, {});
      const bool whole =
          image.header.data.type < VoxelType::Float32 && !image.header.data.rescaled();
      if (whole) return maskOfWholeNumbers(image);
    }
    NativeImage native = readNative(path);
    MaskImage read{{}, screenWarnings(native.info)};
    for (std::string& warning : makeLabels(native.volume, threshold))
      read.warnings.push_back(std::move(warning));
    std::visit(
        [&](const auto& volume) {
          read.mask = Volume<std::uint8_t>(volume.geometry);
          std::transform(volume.voxels.begin(), volume.voxels.end(), read.mask.voxels.begin(),
                         [](auto value) { return value != 0 ? 1 : 0; });
        },
        native.volume);
    return read;
  });
}

NativeImage readNative(const fs::path& path, const ReadOptions& options,
                       std::optional<int> component, const Progress& progress) {
  progress.check();
  return inMemory(path, [&]() -> NativeImage {
    if (const auto segmentation = openSegmentation(path)) {
      if (!component) return {readSegments(*segmentation, path, progress), segmentation->info};
      const auto n = static_cast<std::size_t>(std::max(*component, 0));
      if (*component < 0 || n >= segmentation->segments.size())
        throw InputError("there is no segment " + std::to_string(*component), path.string(),
                         "count from 0 to " + std::to_string(segmentation->segments.size() - 1));
      return {readSegment(*segmentation, n, progress), segmentation->info};
    }
    if (isDicom(path)) {
      if (component)
        throw InputError("a component is chosen, but this is DICOM", path.string(),
                         "leave the component out, or choose a series");
      LoadedImage loaded = readDicom(path, options, progress);
      return {inNarrowestType(std::move(loaded.image)), std::move(loaded.info)};
    }
    const OpenImage image = openImage(path, options.series, component);
    NativeImage native;
    native.info = image.info;
    std::vector<std::string>& warnings = native.info.warnings;
    if (image.header.data.rescaled())
      native.volume = readRescaled(image, warnings, progress);
    else
      withVoxelType(image.header.data.type, [&](auto zero) {
        native.volume = readAs<decltype(zero)>(image, warnings, progress);
      });
    return native;
  });
}

std::vector<ImageSummary> describeImages(const fs::path& path, const Progress& progress,
                                         ScanDepth depth) {
  if (const auto segmentation = openSegmentation(path))
    return {{segmentation->geometry, segmentation->info, {}}};
  if (isDicom(path)) return describeDicom(path, progress, depth);
  // The layers of a segmentation share their geometry.
  const bool segments = readHeader(path, imageFormat(path)).fields.count("Segment0_Name") != 0;
  const OpenImage image = openImage(path, {}, segments ? std::optional<int>(0) : std::nullopt);
  return {{image.geometry, image.info, {}}};
}

}  // namespace angiomesh
