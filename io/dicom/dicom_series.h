// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "io/volume/finding.h"
#include "io/volume/loaded_image.h"

namespace angiomesh {

/// How the pixels of a file are stored.
struct PixelLayout {
  int allocated = 16, stored = 16, high = 15;  ///< bits
  bool isSigned = false;
  bool bigEndian = false;
  bool encapsulated = false;  ///< compressed
  bool jpeg2000 = false, rle = false;
  bool deflated = false;
  bool real = false;  ///< Float or Double Float Pixel Data: numbers of 32 or 64 bits
  std::optional<std::array<double, 2>> padding;  ///< stored values, from and to, that are no image

  bool operator==(const PixelLayout&) const = default;
};

/// What all frames of a file share.
struct DicomFile {
  std::filesystem::path path;
  int columns = 0, rows = 0;
  int samples = 1;  ///< values per pixel; colour has 3
  int frames = 1;
  bool mosaic = false;    ///< slices as tiles of one picture
  bool inverted = false;  ///< MONOCHROME1: small values are bright
  bool table = false;     ///< values go through a table (Modality LUT), not a slope
  PixelLayout layout;
  std::string classUid, instanceUid;  ///< of the SOP

  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
};

/// What may tell apart the slices that lie in one place, in the order in which it is tried.
constexpr std::array<const char*, 12> kSplitNames{
    "TemporalPosition",  "EchoTime",          "EchoNumber",      "DiffusionBValue",
    "ImageType",         "StackID",           "CardiacPhase",    "TriggerTime",
    "GradientDirection", "AcquisitionNumber", "AcquisitionTime", "ContentTime"};

/// One 2D image: a classic file, or one frame of an enhanced multi-frame file.
struct DicomFrame {
  std::size_t file = 0;  ///< of DicomSeries::files
  int index = 0;         ///< of the frame in the file
  int instanceNumber = 0;
  bool placed = false;  ///< position, orientation and pixel spacing are stated
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< centre of the first pixel, LPS mm
  Eigen::Vector3d alongRow = Eigen::Vector3d::UnitX();
  Eigen::Vector3d alongColumn = Eigen::Vector3d::UnitY();
  double spacingX = 1.0, spacingY = 1.0;  ///< mm between columns and between rows
  double stepMm = 0.0;                    ///< between slices, or their thickness; 0: not stated
  int segment = 0;                        ///< of a segmentation: whose voxels these are
  double slope = 1.0, intercept = 0.0;
  std::string frameOfReference;
  std::array<std::string, kSplitNames.size()> split;
  std::vector<DisplayWindow> windows;
};

/// A segment of a DICOM segmentation.
struct DicomSegment {
  int number = 0;
  std::string label;
};

/// The files of one series as they were found.
struct DicomSeries {
  std::string uid, description, modality, number, date;
  std::vector<DicomFile> files;
  std::vector<DicomFrame> frames;  ///< in the order of the files' names
  std::vector<Finding> findings;   ///< of the files
  // Of a segmentation alone:
  std::vector<DicomSegment> segments;
  int mostFraction = 0;  ///< the stored value that stands for all of a voxel; 0: bits
};

/// Images of one series that belong to one volume, sorted along the normal of their planes.
struct DicomStack {
  std::string uid, description, modality, number, date;
  int part = 0;       ///< 1-based where a series splits into several volumes, else 0
  std::string label;  ///< what is particular to the part
  std::vector<DicomFile> files;
  std::vector<DicomFrame> frames;
  std::vector<Finding> findings;

  [[nodiscard]] const DicomFile& fileOf(const DicomFrame& frame) const { return files[frame.file]; }
  /// The UID, with "/2" behind it for the second volume of several.
  [[nodiscard]] std::string id() const;
};

/// One slice of a volume: (1 - weight) * frames[first] + weight * frames[first + 1].
struct SliceBlend {
  std::size_t first = 0;
  double weight = 0.0;
};

/// The grid that the frames of a stack form.
struct StackGrid {
  Geometry geometry;  ///< as far as it can be told where a finding refuses
  std::vector<SliceBlend> slices;
  std::vector<Finding> findings;

  [[nodiscard]] const Finding* refusal() const;
};

/// What a DICOM file is that holds no image: "a DICOMDIR", "EncapsulatedPDFStorage" ...; "" where
/// it does not say. @throws IoError
std::string kindWithoutImage(const std::filesystem::path& path);

/// The series of a file, or of a folder and all below it, by UID. Reads headers only, in parallel.
/// What is no DICOM image is left out; `warnings` tells of files whose name says that they should
/// be.
/// @throws IoError (the path cannot be read; the one file is damaged), Cancelled
std::vector<DicomSeries> scanDicom(const std::filesystem::path& path, const Progress& progress,
                                   ScanDepth depth, std::vector<std::string>& warnings);

struct HeaderResult {
  bool image = false;        ///< there was an image, or several
  std::string damage;        ///< what is wrong with the file, without its name; empty: nothing
  bool knowsSeries = false;  ///< the header was readable beyond the series' UID
  std::string kind;          ///< of object, in DICOM's words, where there was no image
};

/// Reads the header of one file and adds its images to `series`, whose describing fields are set as
/// far as the header could be read.
HeaderResult readDicomHeader(const std::filesystem::path& path, DicomSeries& series);

/// Splits a series where its images cannot belong to one volume: size, pixel spacing, orientation,
/// frame of reference, and images in one place that an attribute tells apart.
std::vector<DicomStack> splitSeries(DicomSeries series);

/// Finds the grid and everything that is wrong with it. `evenOut`: missing and uneven slices are
/// resampled instead of refused.
StackGrid gridOfStack(const DicomStack& stack, bool evenOut);

/// Reads the frames of a stack, rescaled, into the slices of `image` (whose k-th slice is frame k),
/// in parallel. Padding becomes the smallest value of the rest.
/// @returns the number of padded voxels   @throws IoError, InputError, Cancelled
std::size_t readFrames(const DicomStack& stack, Volume<float>& image, const Progress& progress);

/// One frame, rescaled. @throws IoError, InputError
std::vector<float> readFrame(const DicomStack& stack, const DicomFrame& frame);

/// "0012.dcm" or "0012.dcm frame 4", for the screen.
std::string frameName(const DicomStack& stack, const DicomFrame& frame);

}  // namespace angiomesh
