// SPDX-License-Identifier: BSD-3-Clause
#include "io/image_io.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <system_error>

#include "core/base/error.h"
#include "io/dicom.h"
#include "io/files.h"
#include "io/image_format.h"
#include "io/itk_image.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

void addFacts(InputInfo& info, HeaderFacts facts) {
  info.modality = std::move(facts.modality);
  for (std::string& warning : facts.warnings) info.warnings.push_back(std::move(warning));
}

bool isFolder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

LoadedImage read(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  progress.check();
  if (isFolder(path)) return readDicom(path, options, progress);
  const ImageFormat format = imageFormat(path);
  if (format == ImageFormat::Dicom) return readDicom(path, options, progress);
  if (!options.series.empty())
    throw InputError("a series is chosen, but this is not DICOM", path.string(),
                     "leave the series out");
  HeaderFacts facts = checkHeader(path, format, true);
  progress.report(0.4);
  LoadedImage loaded = itkRead(path, format);
  addFacts(loaded.info, std::move(facts));
  progress.report(0.9);
  return loaded;
}

template <class T>
void write(const Volume<T>& volume, const fs::path& path) {
  const std::string name = path.filename().string();
  bool known = false;
  for (const char* extension : {".mha", ".nrrd", ".nii", ".nii.gz"})
    known = known || name.ends_with(extension);
  if (!known)
    throw InputError("cannot tell the image format from the name", path.string(),
                     "end the name in .mha, .nrrd, .nii or .nii.gz");
  if (volume.voxels.empty() || volume.voxels.size() != volume.geometry.voxelCount())
    throw InputError("there are no voxels to write", path.string(), "compute the volume first");
  writeAtomically(path, [&](const fs::path& temporary) {
    try {
      itkWrite(volume, temporary);
      // A full disk does not always reach us through ITK: count what arrived.
      checkHeader(temporary, imageFormat(temporary), true);
    } catch (const Error&) {
      throw IoError("cannot write the image", path.string(),
                    "check that the folder may be written to and has free space");
    }
  });
}

}  // namespace

std::array<double, 2> DisplayWindow::range() const {
  // PS3.3 C.11.2.1.2.1: the plain linear function is off by half a step and one step.
  if (function == "LINEAR" && width > 1.0)
    return {level - 0.5 - 0.5 * (width - 1.0), level - 0.5 + 0.5 * (width - 1.0)};
  return {level - 0.5 * width, level + 0.5 * width};
}

std::vector<std::string> reportWarnings(const InputInfo& info) {
  std::vector<std::string> texts = info.warnings;
  for (const Finding& finding : info.findings) texts.push_back(finding.text);
  return texts;
}

std::vector<std::string> screenWarnings(const InputInfo& info) {
  std::vector<std::string> texts = info.warnings;
  for (const Finding& finding : info.findings) texts.push_back(screenText(finding));
  return texts;
}

const Finding* ImageSummary::refusal() const {
  const auto found = std::find_if(info.findings.begin(), info.findings.end(),
                                  [](const Finding& finding) { return finding.refuses; });
  return found != info.findings.end() ? &*found : nullptr;
}

LoadedImage readImage(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  LoadedImage loaded = read(path, options, progress);
  checkUsable(loaded.image, path.string());
  progress.report(1.0);
  return loaded;
}

LoadedImage readImage(const ImageSummary& entry, const fs::path& path, bool evenOut,
                      const Progress& progress) {
  if (!entry.stack) return readImage(path, {}, progress);
  progress.phase("reading");
  LoadedImage loaded = readDicomStack(entry.stack, evenOut, path, progress.sub(0.0, 0.9));
  checkUsable(loaded.image, path.string());
  progress.report(1.0);
  return loaded;
}

Volume<std::uint8_t> readMask(const fs::path& path) {
  const LoadedImage loaded = read(path, {}, {});
  Volume<std::uint8_t> mask(loaded.image.geometry);
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    const float value = loaded.image.voxels[i];
    if (std::isnan(value))
      throw InputError("the mask holds values that are not numbers", path.string(),
                       "replace NaN by 0 before loading it");
    mask.voxels[i] = value != 0.0F ? 1 : 0;
  }
  return mask;
}

std::vector<ImageSummary> describeImages(const fs::path& path, const Progress& progress,
                                         ScanDepth depth) {
  if (isFolder(path)) return describeDicom(path, progress, depth);
  const ImageFormat format = imageFormat(path);
  if (format == ImageFormat::Dicom) return describeDicom(path, progress, depth);
  HeaderFacts facts = checkHeader(path, format, false);
  ImageSummary summary = itkDescribe(path, format);
  addFacts(summary.info, std::move(facts));
  return {std::move(summary)};
}

void writeVolume(const Volume<float>& volume, const fs::path& path) { write(volume, path); }

void writeVolume(const Volume<std::uint8_t>& volume, const fs::path& path) { write(volume, path); }

}  // namespace angiomesh
