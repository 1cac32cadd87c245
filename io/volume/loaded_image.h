// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/image/volume.h"
#include "io/volume/finding.h"

namespace angiomesh {

struct DicomStack;

/// A window that a file proposes, as stated in it (DICOM PS3.3 C.11.2).
struct DisplayWindow {
  double width = 0.0, level = 0.0;
  std::string function = "LINEAR";  ///< or LINEAR_EXACT, SIGMOID
  std::string name;

  /// Values that are drawn black and white.
  [[nodiscard]] std::array<double, 2> range() const;
};

/// What `info` says of an input, beside the volume. Nothing here identifies a patient.
struct InputInfo {
  std::string format;     ///< "MetaImage", "NRRD", "NIfTI", "DICOM"
  std::string modality;   ///< "MR", "CT", "" when the file does not say
  std::string pixelType;  ///< "int16" ...
  // DICOM only:
  std::string seriesUid;  ///< with "/2" behind it for the second volume of several in a series
  std::string seriesDescription, seriesNumber;
  std::string date;         ///< YYYY-MM-DD, of the series or the acquisition
  std::string orientation;  ///< "axial", "oblique coronal" ...
  std::vector<Finding> findings;
  int files = 1;
  bool replaced = false;               ///< some voxels were no finite numbers, see ReadOptions
  std::vector<DisplayWindow> windows;  ///< from the file
  std::vector<std::string> warnings;   ///< hold no name of a file
};

/// Warnings and the texts of findings that do not refuse, for a report: no name of a file.
std::vector<std::string> reportWarnings(const InputInfo& info);
/// The same for the screen.
std::vector<std::string> screenWarnings(const InputInfo& info);

struct LoadedImage {
  Volume<float> image;
  InputInfo info;
};

struct ReadOptions {
  std::string series;    ///< UID of a DICOM series, or the end of it; "/2" for a part of it
  bool evenOut = false;  ///< missing or uneven DICOM slices: resample instead of refusing
  /// Give voxels that are no finite numbers a value, with a warning, instead of refusing them; see
  /// replaceNotFinite(). For scans: in a level set function they stand for nothing.
  bool replaceNotFinite = false;
};

/// What the headers say of one volume: geometry, format and pixel type.
struct ImageSummary {
  Geometry geometry;
  InputInfo info;
  std::shared_ptr<const DicomStack> stack;  ///< DICOM only

  /// The finding for which no volume can be made of it, or null.
  [[nodiscard]] const Finding* refusal() const;
};
/// How far a folder is searched.
enum class ScanDepth { Here, AllBelow };

/// One label of a segmentation.
struct Label {
  std::int64_t value = 0;
  std::string name;  ///< of 3D Slicer's segmentations, else ""
  int layer = 0;     ///< of 3D Slicer's segmentations whose segments overlap
  std::size_t voxels = 0;
  std::string id = {};  ///< of 3D Slicer's segmentations: unlike the name, of one segment only
};

}  // namespace angiomesh
