// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// One 2D image of a series: a classic file, or one frame of an enhanced multi-frame file.
struct DicomFrame {
  std::filesystem::path file;
  int index = 0;  ///< of the frame in the file
  int framesInFile = 1;
  std::string instanceUid;
  int columns = 0, rows = 0;
  int samples = 1;      ///< values per pixel; colour has 3
  bool placed = false;  ///< position, orientation and pixel spacing are stated
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< centre of the first pixel, LPS mm
  Eigen::Vector3d alongRow = Eigen::Vector3d::UnitX();
  Eigen::Vector3d alongColumn = Eigen::Vector3d::UnitY();
  double spacingX = 1.0, spacingY = 1.0;  ///< mm between columns and between rows
  double slope = 1.0, intercept = 0.0;
  std::optional<double> window, level;
};

struct DicomSeries {
  std::string uid, description, modality, pixelType;
  bool inverted = false;  ///< MONOCHROME1: small values are bright
  int files = 0;
  std::vector<DicomFrame> frames;
};

/// The series of a folder or file by UID, frames in the order of file names; files that are not
/// DICOM images are left out, with a warning where their name says that they should be.
/// @throws IoError (folder not readable, a damaged header), Cancelled
std::vector<DicomSeries> scanDicom(const std::filesystem::path& path, const Progress& progress,
                                   std::vector<std::string>& warnings);

/// Sorts the frames along the normal of their planes (row x column) and returns the grid that they
/// form; what is harmless goes to `warnings`. `where` names the source in messages.
/// @throws InputError (gap, two slices in one place, tilted stack, varying size or orientation)
Geometry stackFrames(DicomSeries& series, const std::string& where,
                     std::vector<std::string>& warnings);

/// Number of the frame's pixels.
std::size_t pixelsOf(const DicomFrame& frame);

/// Stored values of all frames of a file, before rescaling, in the file's order.
/// @throws IoError, InputError
std::vector<float> decodeDicomFile(const DicomFrame& anyFrameOfIt);

}  // namespace angiomesh
