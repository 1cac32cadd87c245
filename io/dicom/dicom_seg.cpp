// SPDX-License-Identifier: BSD-3-Clause
#include "io/dicom/dicom_seg.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "core/base/error.h"
#include "core/base/large_pages.h"
#include "io/dicom/dicom_source.h"
#include "io/dicom/slice_orientation.h"
#include "io/volume/image_format.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr double kSamePlaceMm = 1e-3;
constexpr double kOffStep = 0.02;  // of the distance of slices
constexpr double kMostSlices = 20000.0;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw InputError("a DICOM segmentation (SEG) " + why, path.string(),
                   "convert it to NRRD or NIfTI with another program");
}

double heightOf(const DicomFrame& frame, const DicomFrame& first) {
  return (frame.position - first.position).dot(sliceNormal(first));
}

/// The distance of slices: as stated, where all places fit it, else the smallest between two.
double stepOf(const std::vector<double>& heights, double stated, const fs::path& path) {
  double least = 0.0;
  for (std::size_t i = 1; i < heights.size(); ++i) {
    const double gap = heights[i] - heights[i - 1];
    if (gap > kSamePlaceMm && (least == 0.0 || gap < least)) least = gap;
  }
  const auto fits = [&](double step) {
    return std::all_of(heights.begin(), heights.end(), [&](double height) {
      const double slices = (height - heights.front()) / step;
      return std::fabs(slices - std::round(slices)) <= kOffStep;
    });
  };
  if (stated > 0.0 && fits(stated)) return stated;
  if (least == 0.0) return 1.0;
  if (!fits(least)) refuse(path, "whose slices are at uneven distances");
  return least;
}

/// The grid of all frames; slices where no segment has voxels may have none.
Geometry gridOf(const DicomStack& stack, const fs::path& path) {
  const DicomFrame& first = stack.frames.front();
  std::vector<double> heights;
  for (const DicomFrame& frame : stack.frames) {
    const bool alike = frame.placed && (frame.alongRow - first.alongRow).norm() < 1e-3 &&
                       (frame.alongColumn - first.alongColumn).norm() < 1e-3;
    if (!alike) refuse(path, "whose frames have no positions or several orientations");
    heights.push_back(heightOf(frame, first));
    const Eigen::Vector3d off =
        frame.position - first.position - heights.back() * sliceNormal(first);
    if (off.norm() > 0.1 * std::min(first.spacingX, first.spacingY))
      refuse(path, "whose frames do not lie above each other");
  }
  std::sort(heights.begin(), heights.end());
  const double step = stepOf(heights, first.stepMm, path);
  const double slices = std::round((heights.back() - heights.front()) / step) + 1.0;
  if (!(slices <= kMostSlices)) refuse(path, "whose slices are too far apart");
  const DicomFile& file = stack.fileOf(first);
  const double needed = static_cast<double>(file.pixels()) * slices * sizeof(float);
  if (physicalMemory() > 0 && needed > static_cast<double>(physicalMemory()))
    refuse(path, "that does not fit into the memory of this machine");
  Geometry g;
  g.size = {file.columns, file.rows, static_cast<int>(slices)};
  g.spacing = {first.spacingX, first.spacingY, step};
  const Eigen::Vector3d normal = sliceNormal(first), x = first.alongRow.stableNormalized();
  g.direction.col(0) = x;
  g.direction.col(1) = normal.cross(x);
  g.direction.col(2) = normal;
  g.direction.array() += 0.0;  // -0 becomes 0
  g.origin = first.position + heights.front() * normal;
  return g;
}

int sliceOf(const DicomFrame& frame, const Geometry& g) {
  const double height = (frame.position - g.origin).dot(g.direction.col(2));
  return static_cast<int>(std::lround(height / g.spacing.z()));
}

/// The frames of a segment.
std::vector<const DicomFrame*> framesOf(const DicomSegmentation& s, std::size_t segment) {
  std::vector<const DicomFrame*> frames;
  for (const DicomFrame& frame : s.stack.frames)
    if (frame.segment == s.segments[segment].value) frames.push_back(&frame);
  return frames;
}

/// One bit for each voxel, the lowest of a byte first; frames follow each other without a gap.
void readBits(const DicomSegmentation& s, const std::vector<const DicomFrame*>& frames,
              std::uint16_t number, Volume<std::uint16_t>& volume, const Progress& progress) {
  const DicomFile& file = s.stack.files.front();
  if (file.layout.encapsulated)
    refuse(file.path.filename(), "of compressed bits, which is not read");
  const DicomSource source(file.path);
  DcmFileFormat format;
  const OFCondition status = format.loadFile(source.path().c_str());
  checkOpened(file.path, status);
  DcmElement* element = nullptr;
  if (status.bad() || format.getDataset()->findAndGetElement(DCM_PixelData, element).bad())
    throw IoError("the pixels are truncated or damaged", file.path.filename().string(),
                  "copy the file again");
  const std::size_t pixels = file.pixels();
  std::vector<unsigned char> bytes;
  for (const DicomFrame* frame : frames) {
    progress.check();
    const std::size_t first = static_cast<std::size_t>(frame->index) * pixels;
    const std::size_t begin = first / 8, end = (first + pixels + 7) / 8;
    bytes.resize(end - begin);
    if (element
            ->getPartialValue(bytes.data(), static_cast<Uint32>(begin),
                              static_cast<Uint32>(bytes.size()))
            .bad())
      throw IoError("the pixels are truncated or damaged", frameName(s.stack, *frame),
                    "copy the file again");
    std::uint16_t* const to =
        volume.voxels.data() + pixels * static_cast<std::size_t>(sliceOf(*frame, s.geometry));
    for (std::size_t i = 0; i < pixels; ++i) {
      const std::size_t bit = first + i - 8 * begin;
      if ((bytes[bit / 8] >> (bit % 8) & 1U) != 0) to[i] = number;
    }
  }
}

}  // namespace

std::optional<DicomSegmentation> openSegmentation(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error) || !imageFormat(path).isDicom()) return {};
  std::vector<std::string> none;
  std::vector<DicomSeries> all = scanDicom(path, {}, ScanDepth::Here, none);
  if (all.empty() || all.front().segments.empty()) return {};
  DicomSeries& series = all.front();
  DicomSegmentation s;
  s.fractional = series.mostFraction > 0;
  for (const DicomSegment& segment : series.segments) {
    Label label;
    label.value = segment.number;
    label.name = segment.label;
    label.layer = static_cast<int>(s.segments.size());
    s.segments.push_back(std::move(label));
  }
  s.stack.files = std::move(series.files);
  s.stack.frames = std::move(series.frames);
  for (DicomFrame& frame : s.stack.frames)
    if (s.fractional) {
      frame.slope = 1.0 / series.mostFraction;
      frame.intercept = 0.0;
    }
  s.geometry = gridOf(s.stack, path);
  s.info.format = "DICOM segmentation";
  s.info.modality = "SEG";
  s.info.pixelType = "uint8";
  if (s.stack.frames.size() == 1 && !(s.stack.frames.front().stepMm > 0.0))
    s.info.warnings.emplace_back("the file does not state the distance of slices: 1 mm is assumed");
  return s;
}

AnyVolume readSegment(const DicomSegmentation& s, std::size_t segment, const Progress& progress) {
  const std::vector<const DicomFrame*> frames = framesOf(s, segment);
  if (!s.fractional) {
    Volume<std::uint16_t> volume(s.geometry);
    readBits(s, frames, static_cast<std::uint16_t>(s.segments[segment].value), volume, progress);
    return volume;
  }
  Volume<float> volume(s.geometry);
  for (const DicomFrame* frame : frames) {
    progress.check();
    const std::vector<float> values = readFrame(s.stack, *frame);
    const auto slice = static_cast<std::size_t>(sliceOf(*frame, s.geometry));
    std::copy(values.begin(), values.end(),
              volume.voxels.begin() + static_cast<std::ptrdiff_t>(slice * values.size()));
  }
  return volume;
}

AnyVolume readSegments(const DicomSegmentation& s, const fs::path& path, const Progress& progress) {
  if (s.segments.size() == 1) return readSegment(s, 0, progress);
  const std::string advice =
      "take one out with --component N, N from 0 to " + std::to_string(s.segments.size() - 1);
  if (s.fractional)
    throw InputError("a DICOM segmentation of several fractional segments", path.string(), advice);
  Volume<std::uint16_t> all(s.geometry);
  for (std::size_t n = 0; n < s.segments.size(); ++n) {
    const auto one = std::get<Volume<std::uint16_t>>(readSegment(s, n, progress));
    for (std::size_t i = 0; i < all.voxels.size(); ++i) {
      if (one.voxels[i] == 0) continue;
      if (all.voxels[i] != 0)
        throw InputError("a DICOM segmentation whose segments overlap", path.string(), advice);
      all.voxels[i] = one.voxels[i];
    }
  }
  return all;
}

}  // namespace angiomesh
