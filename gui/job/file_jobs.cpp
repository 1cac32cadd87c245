// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/file_jobs.h"

#include <algorithm>
#include <exception>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/report.h"
#include "core/pipeline/segmentation_mask.h"
#include "io/dicom/dicom.h"
#include "io/file/files.h"
#include "io/vessel/openfoam_case.h"
#include "io/vessel/patch_files.h"
#include "io/vessel/ports_file.h"

namespace angiomesh {

namespace {

constexpr double kSampleNoise = 20.0;

void replaceAll(std::string& text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); !what.empty() && at != std::string::npos;
       at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

}  // namespace

std::string withoutPath(std::string message, const std::filesystem::path& path,
                        const std::string& name) {
  replaceAll(message, path.string(), name);
  if (path.has_parent_path() && path.parent_path() != path.root_path())
    replaceAll(message, path.parent_path().string(), "its folder");
  // Where an error names its place.
  replaceAll(message, ", " + path.filename().string() + ":", ", " + name + ":");
  return message;
}

Source makeSampleSource(int size, const Progress& progress) {
  PhantomParams params;
  params.size = {size, size, size};
  params.noiseSigma = kSampleNoise;
  return makeSource(makePhantom(params, progress).image, "sample");
}

LoadJob::LoadJob(std::filesystem::path path, std::string name)
    : path_(std::move(path)), name_(std::move(name)) {}

LoadJob::LoadJob(std::filesystem::path path, std::string name, ImageSummary entry, bool evenOut)
    : path_(std::move(path)), name_(std::move(name)), entry_(std::move(entry)), evenOut_(evenOut) {}

LoadJob::LoadJob(std::filesystem::path path, std::string name, std::optional<Label> label)
    : path_(std::move(path)),
      name_(std::move(name)),
      asScan_(!label.has_value()),
      label_(std::move(label)) {}

LoadJob::LoadJob(Source source) : name_(source.name), source_(std::move(source)) {}

void LoadJob::execute() noexcept {
  try {
    load();
  } catch (const Cancelled&) {
    cancelled_ = true;
  } catch (const std::bad_alloc&) {
    error_ = "not enough memory, " + name_ + ": close other programs or crop the volume first";
  } catch (const std::exception& failure) {
    error_ = withoutPath(failure.what(), path_, name_);
  }
}

Source LoadJob::obtain() {
  if (source_.image) {
    info_.format = "memory";
    return std::move(source_);
  }
  if (path_.empty()) {
    info_.format = "phantom";
    info_.pixelType = "float32";
    return makeSampleSource(kSampleSize, progress_.sub(0.0, 0.8));
  }
  if (!entry_) {
    std::vector<ImageSummary> entries = describeImages(path_, progress_.sub(0.0, 0.2));
    const std::optional<std::size_t> lone = loneVolume(entries);
    if (!lone) {
      choices_ = std::move(entries);
      return {};
    }
    const std::string others = leftOutText(entries);
    entry_ = std::move(entries[*lone]);
    if (!others.empty()) entry_->info.warnings.push_back(others);
  }
  LoadedImage loaded;
  try {
    if (!entry_->stack && segmentationLayers(path_) > 1 && !asScan_) {
      if (!label_) {
        labels_ = readLabels(path_, progress_.sub(0.2, 0.8));
        return {};
      }
      loaded = readLayer(path_, label_->layer, progress_.sub(0.2, 0.8));
    } else {
      loaded = readImage(*entry_, path_, evenOut_, progress_.sub(0.2, 0.8));
      if (!entry_->stack && findLabels(loaded.image)) return {};
    }
  } catch (const UnevenSlicesError& failure) {
    uneven_ = withoutPath(failure.what(), path_, name_);
    return {};
  }
  info_ = std::move(loaded.info);
  progress_.check();
  return makeSource(std::move(loaded.image), name_);
}

bool LoadJob::findLabels(const Volume<float>& image) {
  if (asScan_ || label_) return false;
  labels_ = labelsOfSegmentation(path_, image, progress_);
  if (labels_.size() == 1) {
    label_ = labels_.front();
    labels_.clear();
  }
  return !labels_.empty();
}

void LoadJob::load() {
  Source source = obtain();
  if (!source.image) return;
  progress_.report(0.9);
  const Volume<float>& image = *source.image;
  display_ = displayFacts(image, info_);
  std::tie(facts_.window, facts_.level) = display_.window();
  facts_.voxelMm = image.geometry.voxelMm();
  facts_.volumeMm3 =
      static_cast<double>(image.geometry.voxelCount()) * image.geometry.voxelVolumeMm3();
  facts_.largestValue = display_.values[1];
  const auto pipeline = std::make_shared<Pipeline>(std::move(source));
  prepare(*pipeline);
  pipeline_ = pipeline;
}

void ExportJob::execute() noexcept {
  try {
    write();
  } catch (const std::exception& failure) {
    error_ = withoutPath(failure.what(), request_.path, fileName());
    if (request_.origin) error_ = withoutPath(error_, request_.origin->path, "the scan");
  }
}

void ExportJob::write() {
  switch (request_.kind) {
    case ExportKind::Mesh:
      writeMeshFiles();
      break;
    case ExportKind::OpenFoam:
      warnings_ = writeOpenFoamCase(*request_.mesh, request_.ports, request_.path, request_.replace)
                      .warnings;
      break;
    case ExportKind::Ports:
      writePorts(request_.ports, request_.path);
      break;
    case ExportKind::Mask:
      writeMaskFile();
      break;
  }
}

void ExportJob::writeMaskFile() {
  const RunResult& run = *request_.segmentation;
  const Volume<std::uint8_t> mask = segmentationMask(run, run.source.image->geometry);
  maskVoxels_ = static_cast<std::size_t>(std::count(mask.voxels.begin(), mask.voxels.end(), 1));
  if (maskVoxels_ == 0)
    throw InputError("no voxel of the scan has its centre in the vessels", "mask",
                     "export the mesh instead, or tick parts on");
  if (request_.origin)
    writeMask(mask, *request_.origin, request_.path);
  else
    writeMask(mask, request_.path);
}

void ExportJob::writeMeshFiles() {
  warnings_ = writeMesh(*request_.mesh, request_.path, request_.options);
  facts_ = checkMeshFile(*request_.mesh, request_.path, request_.options);
  std::filesystem::path beside = request_.path;
  if (request_.report)
    writeText(beside.replace_extension(".report.json"),
              runReportJson(*request_.report, {}, request_.extras.review));
  if (request_.extras.ports) {
    beside = request_.path;
    writePorts(request_.ports, beside.replace_extension(".ports.json"));
  }
  if (request_.extras.patches && !request_.mesh->patch.empty())
    patchFiles_ = writePatchFiles(*request_.mesh, request_.path, request_.options).size();
}

}  // namespace angiomesh
