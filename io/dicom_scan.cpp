// SPDX-License-Identifier: BSD-3-Clause
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <map>
#include <optional>
#include <system_error>

#include "core/base/error.h"
#include "io/dicom_series.h"
#include "io/image_format.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

/// DCMTK sets the output of its find functions to 0 when the element is missing.
std::optional<double> number(DcmItem& item, const DcmTagKey& tag, unsigned long index = 0) {
  Float64 value = 0.0;
  if (item.findAndGetFloat64(tag, value, index).bad()) return std::nullopt;
  return value;
}

int integer(DcmItem& item, const DcmTagKey& tag, int otherwise) {
  // IS elements are text, US elements are not: both have a text form.
  OFString text;
  if (item.findAndGetOFString(tag, text).bad() || text.empty()) return otherwise;
  return std::atoi(text.c_str());
}

/// Printable ASCII only: descriptions come in many character sets.
std::string text(DcmItem& item, const DcmTagKey& tag) {
  OFString value;
  if (item.findAndGetOFStringArray(tag, value).bad()) return {};
  std::string clean;
  for (const char c : value) clean += c >= ' ' && c < 127 ? c : '?';
  while (!clean.empty() && clean.back() == ' ') clean.pop_back();
  return clean;
}

/// The first item of a sequence, or null.
DcmItem* itemOf(DcmItem* item, const DcmTagKey& sequence) {
  DcmItem* found = nullptr;
  if (item == nullptr || item->findAndGetSequenceItem(sequence, found, 0).bad()) return nullptr;
  return found;
}

bool vectorOf(DcmItem& item, const DcmTagKey& tag, unsigned long first, Eigen::Vector3d& result) {
  for (unsigned long a = 0; a < 3; ++a) {
    const auto value = number(item, tag, first + a);
    if (!value) return false;
    result[static_cast<Eigen::Index>(a)] = *value;
  }
  return result.allFinite();
}

struct Macros {
  DcmItem* position;
  DcmItem* orientation;
  DcmItem* measures;
  DcmItem* transform;
  DcmItem* window;
};

void readFrame(const Macros& from, DicomFrame& frame) {
  frame.placed = from.position != nullptr && from.orientation != nullptr &&
                 from.measures != nullptr &&
                 vectorOf(*from.position, DCM_ImagePositionPatient, 0, frame.position) &&
                 vectorOf(*from.orientation, DCM_ImageOrientationPatient, 0, frame.alongRow) &&
                 vectorOf(*from.orientation, DCM_ImageOrientationPatient, 3, frame.alongColumn);
  if (frame.placed) {
    // Row spacing (between rows, along y) comes first.
    const auto y = number(*from.measures, DCM_PixelSpacing, 0);
    const auto x = number(*from.measures, DCM_PixelSpacing, 1);
    frame.placed = x && y && *x > 0.0 && *y > 0.0;
    frame.spacingX = x.value_or(1.0);
    frame.spacingY = y.value_or(1.0);
  }
  if (from.transform != nullptr) {
    frame.slope = number(*from.transform, DCM_RescaleSlope).value_or(1.0);
    frame.intercept = number(*from.transform, DCM_RescaleIntercept).value_or(0.0);
  }
  if (from.window != nullptr) {
    frame.window = number(*from.window, DCM_WindowWidth);
    frame.level = number(*from.window, DCM_WindowCenter);
    if (!frame.window || !frame.level || !(*frame.window > 0.0))
      frame.window = frame.level = std::nullopt;
  }
}

std::string pixelTypeOf(DcmItem& data) {
  const int bits = integer(data, DCM_BitsAllocated, 16);
  return (integer(data, DCM_PixelRepresentation, 0) == 1 ? "int" : "uint") + std::to_string(bits);
}

/// The frames of one file; none when it holds no image.
std::vector<DicomFrame> framesOf(DcmItem& data, const fs::path& file) {
  DicomFrame common;
  common.file = file;
  common.columns = integer(data, DCM_Columns, 0);
  common.rows = integer(data, DCM_Rows, 0);
  common.samples = integer(data, DCM_SamplesPerPixel, 1);
  common.instanceUid = text(data, DCM_SOPInstanceUID);
  common.framesInFile = std::max(integer(data, DCM_NumberOfFrames, 1), 1);
  if (common.columns < 1 || common.rows < 1) return {};

  DcmItem* shared = itemOf(&data, DCM_SharedFunctionalGroupsSequence);
  DcmSequenceOfItems* perFrame = nullptr;
  data.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, perFrame);
  if (perFrame == nullptr) {
    readFrame({&data, &data, &data, &data, &data}, common);
    // A multi-frame object without functional groups does not say where its frames lie.
    common.placed = common.placed && common.framesInFile == 1;
    std::vector<DicomFrame> frames(static_cast<std::size_t>(common.framesInFile), common);
    for (std::size_t f = 0; f < frames.size(); ++f) frames[f].index = static_cast<int>(f);
    return frames;
  }
  std::vector<DicomFrame> frames;
  for (int f = 0; f < common.framesInFile; ++f) {
    DcmItem* own = static_cast<unsigned long>(f) < perFrame->card()
                       ? perFrame->getItem(static_cast<unsigned long>(f))
                       : nullptr;
    const auto macro = [&](const DcmTagKey& sequence) {
      DcmItem* item = itemOf(own, sequence);
      return item != nullptr ? item : itemOf(shared, sequence);
    };
    DicomFrame frame = common;
    frame.index = f;
    readFrame({macro(DCM_PlanePositionSequence), macro(DCM_PlaneOrientationSequence),
               macro(DCM_PixelMeasuresSequence), macro(DCM_PixelValueTransformationSequence),
               macro(DCM_FrameVOILUTSequence)},
              frame);
    frames.push_back(std::move(frame));
  }
  return frames;
}

void scanFile(const fs::path& file, std::map<std::string, DicomSeries>& series) {
  DcmFileFormat format;
  const OFCondition status = format.loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, 1024,
                                                     ERM_autoDetect, DCM_PixelData);
  if (status.bad())
    throw IoError(std::string("the DICOM header is damaged (") + status.text() + ")",
                  file.filename().string(), "copy the file again, or take it out of the folder");
  DcmDataset& data = *format.getDataset();
  std::vector<DicomFrame> frames = framesOf(data, file);
  if (frames.empty()) {
    // An image whose header ends before it states its size was cut off between two elements.
    const std::string kind = text(*format.getMetaInfo(), DCM_MediaStorageSOPClassUID);
    if (dcmIsImageStorageSOPClassUID(kind.c_str()))
      throw IoError("the DICOM file is truncated", file.filename().string(),
                    "copy the file again, or take it out of the folder");
    return;
  }
  DicomSeries& one = series[text(data, DCM_SeriesInstanceUID)];
  if (one.files == 0) {
    one.uid = text(data, DCM_SeriesInstanceUID);
    one.description = text(data, DCM_SeriesDescription);
    one.modality = text(data, DCM_Modality);
    one.pixelType = pixelTypeOf(data);
    one.inverted = text(data, DCM_PhotometricInterpretation) == "MONOCHROME1";
  }
  ++one.files;
  one.frames.insert(one.frames.end(), frames.begin(), frames.end());
}

std::vector<fs::path> filesOf(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored)) files.push_back(entry->path());
  }
  if (error)
    throw IoError("cannot read the folder (" + error.message() + ")", folder.string(),
                  "check the permissions");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<DicomSeries> scanDicom(const fs::path& path, const Progress& progress,
                                   std::vector<std::string>& warnings) {
  // DCMTK logs to the terminal; what matters comes back as a status.
  static const bool ready = [] {
    OFLog::configure(OFLogger::OFF_LOG_LEVEL);
    // Archives that turn implicit into explicit files may mark known elements as unknown ones.
    dcmEnableUnknownVRConversion.set(OFTrue);
    return true;
  }();
  static_cast<void>(ready);
  std::map<std::string, DicomSeries> series;
  std::error_code error;
  if (fs::is_directory(path, error)) {
    const std::vector<fs::path> files = filesOf(path);
    int misnamed = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
      progress.report(static_cast<double>(i) / static_cast<double>(files.size()));
      if (looksLikeDicom(files[i]))
        scanFile(files[i], series);
      else if (files[i].extension() == ".dcm" || files[i].extension() == ".DCM")
        ++misnamed;
    }
    if (misnamed > 0)
      warnings.push_back(std::to_string(misnamed) +
                         " files named .dcm are not DICOM or empty and were left out");
  } else {
    scanFile(path, series);
  }
  std::vector<DicomSeries> result;
  result.reserve(series.size());
  for (auto& [uid, one] : series) result.push_back(std::move(one));
  return result;
}

std::size_t pixelsOf(const DicomFrame& frame) {
  return static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
}

}  // namespace angiomesh
