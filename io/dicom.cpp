// SPDX-License-Identifier: BSD-3-Clause
#include "io/dicom.h"

#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "io/dicom_series.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

std::vector<DicomSeries> seriesOf(const fs::path& path, const Progress& progress,
                                  std::vector<std::string>& warnings) {
  std::vector<DicomSeries> series = scanDicom(path, progress, warnings);
  if (!series.empty()) return series;
  if (!fs::is_directory(path))
    throw InputError("the DICOM file holds no image", path.string(), "give a file with an image");
  for (const auto& entry : fs::directory_iterator(path))
    if (entry.is_directory())
      throw InputError("the folder itself holds no DICOM image", path.string(),
                       "give the subfolder that holds the series");
  throw InputError("the folder holds no DICOM image", path.string(),
                   "give the folder that holds the series");
}

/// The shortest ending, of 8 characters at least, that only this series' UID has.
std::string shortUid(const DicomSeries& one, const std::vector<DicomSeries>& all) {
  for (std::size_t length = 8; length < one.uid.size(); ++length) {
    std::string ending = one.uid.substr(one.uid.size() - length);
    if (std::count_if(all.begin(), all.end(),
                      [&](const DicomSeries& other) { return other.uid.ends_with(ending); }) == 1)
      return ending;
  }
  return one.uid;
}

std::string listOf(const std::vector<DicomSeries>& all) {
  const std::size_t shown = std::min<std::size_t>(all.size(), 12);
  std::string list;
  for (std::size_t i = 0; i < shown; ++i) {
    const DicomSeries& one = all[i];
    const DicomFrame& frame = one.frames.front();
    list += (i == 0 ? "" : "; ") + shortUid(one, all) + " \"" + one.description.substr(0, 40) +
            "\" " + one.modality + " " + std::to_string(frame.columns) + " x " +
            std::to_string(frame.rows) + " x " + std::to_string(one.frames.size());
  }
  if (shown < all.size()) list += "; and " + std::to_string(all.size() - shown) + " more";
  return list;
}

DicomSeries choose(std::vector<DicomSeries> all, const std::string& uid, const fs::path& path) {
  if (uid.empty()) {
    if (all.size() == 1) return std::move(all.front());
    throw InputError(
        "the folder holds " + std::to_string(all.size()) + " series (" + listOf(all) + ")",
        path.string(), "choose one with --series and its UID or the end of it");
  }
  std::vector<std::size_t> fitting;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].uid == uid) return std::move(all[i]);
    if (all[i].uid.ends_with(uid)) fitting.push_back(i);
  }
  if (fitting.size() == 1) return std::move(all[fitting.front()]);
  throw InputError((fitting.empty() ? "there is no series " : "several series end in ") + uid +
                       " (" + listOf(all) + ")",
                   path.string(), "choose one with --series and its UID or the end of it");
}

InputInfo infoOf(const DicomSeries& series) {
  InputInfo info;
  info.format = "DICOM";
  info.modality = series.modality;
  info.pixelType = series.pixelType;
  info.seriesUid = series.uid;
  info.seriesDescription = series.description;
  info.files = series.files;
  const DicomFrame& middle = series.frames[series.frames.size() / 2];
  info.window = middle.window;
  info.level = middle.level;
  return info;
}

void readPixels(const DicomSeries& series, Volume<float>& image, const Progress& progress) {
  // Frames of one file are decoded together, and put where the sorting wants them.
  std::map<fs::path, std::vector<std::size_t>> slicesOfFile;
  for (std::size_t slice = 0; slice < series.frames.size(); ++slice)
    slicesOfFile[series.frames[slice].file].push_back(slice);
  std::size_t done = 0;
  for (const auto& [file, slices] : slicesOfFile) {
    progress.report(static_cast<double>(done++) / static_cast<double>(slicesOfFile.size()));
    const DicomFrame& any = series.frames[slices.front()];
    const std::vector<float> stored = decodeDicomFile(any);
    const std::size_t pixels = pixelsOf(any);
    for (const std::size_t slice : slices) {
      const DicomFrame& frame = series.frames[slice];
      const float* from = stored.data() + static_cast<std::size_t>(frame.index) * pixels;
      float* to = image.voxels.data() + slice * pixels;
      for (std::size_t i = 0; i < pixels; ++i)
        to[i] = static_cast<float>(frame.slope * static_cast<double>(from[i]) + frame.intercept);
    }
  }
}

}  // namespace

LoadedImage readDicom(const fs::path& path, const std::string& seriesUid,
                      const Progress& progress) {
  progress.phase("reading");
  std::vector<std::string> warnings;
  DicomSeries series = choose(seriesOf(path, progress.sub(0.0, 0.3), warnings), seriesUid, path);
  LoadedImage loaded;
  const Geometry geometry = stackFrames(series, path.string(), warnings);
  loaded.info = infoOf(series);
  loaded.info.warnings = std::move(warnings);
  loaded.image = Volume<float>(geometry);
  readPixels(series, loaded.image, progress.sub(0.3, 0.9));
  return loaded;
}

std::vector<ImageSummary> describeDicom(const fs::path& path) {
  std::vector<ImageSummary> summaries;
  std::vector<std::string> common;
  for (DicomSeries& series : seriesOf(path, {}, common)) {
    ImageSummary summary;
    const DicomFrame first = series.frames.front();
    std::vector<std::string> warnings = common;
    try {
      summary.geometry = stackFrames(series, {}, warnings);
    } catch (const InputError& error) {
      summary.geometry.size = {first.columns, first.rows, static_cast<int>(series.frames.size())};
      warnings.push_back(std::string("not a usable volume: ") + error.what());
    }
    summary.info = infoOf(series);
    summary.info.warnings = std::move(warnings);
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

}  // namespace angiomesh
