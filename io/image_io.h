// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/projection.h"
#include "core/image/volume.h"
#include "io/any_volume.h"
#include "io/finding.h"

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

/// Reads .mha/.mhd, .nrrd/.nhdr, .nii/.nii.gz (any pixel type, any direction; NIfTI turned to LPS),
/// one DICOM file, or a folder in or below which a DICOM series lies (`series` chooses among
/// several). What the header claims is compared with the sizes of the files and with the memory of
/// the machine before anything is allocated. Checked by checkUsable().
/// @throws IoError (missing, unreadable, truncated), InputError (not 3D, not an image, constant,
/// NaN, several series, more than the memory), UnevenSlicesError
LoadedImage readImage(const std::filesystem::path& path, const ReadOptions& options = {},
                      const Progress& progress = {});

struct MaskImage {
  Volume<std::uint8_t> mask;  ///< 1 inside
  std::vector<std::string> warnings;
};

/// As readImage() but without checkUsable(), for masks: a mask may be constant. 1 where not 0, once
/// makeLabels() has seen to values that are no whole numbers, or where the threshold is reached.
MaskImage readMask(const std::filesystem::path& path, std::optional<double> threshold = {});

struct NativeImage {
  AnyVolume volume;
  InputInfo info;
};

/// The voxels in the type of the file, bit for bit. Rescaled ones (DICOM, NIfTI's scl_slope) in the
/// narrowest of int16, uint16, float32 and float64 that holds them exactly. `component` takes one
/// of several values per voxel or one of several points in time, from 0 on. Not checked by
/// checkUsable(). @throws as readImage()
NativeImage readNative(const std::filesystem::path& path, const ReadOptions& options = {},
                       std::optional<int> component = {}, const Progress& progress = {});

/// Geometry, format and pixel type from the headers; DICOM folders give one entry per series.
struct ImageSummary {
  Geometry geometry;
  InputInfo info;
  std::shared_ptr<const DicomStack> stack;  ///< DICOM only

  /// The finding for which no volume can be made of it, or null.
  [[nodiscard]] const Finding* refusal() const;
};
/// `depth`: how far a folder is searched.
enum class ScanDepth { Here, AllBelow };
std::vector<ImageSummary> describeImages(const std::filesystem::path& path,
                                         const Progress& progress = {},
                                         ScanDepth depth = ScanDepth::AllBelow);

/// The entry that is meant when none is chosen: the only one, or the only one of three slices and
/// more with a position, so that localizers and single pictures do not stand in the way.
std::optional<std::size_t> loneVolume(const std::vector<ImageSummary>& entries);

/// That others were left out beside a loneVolume(); "" where there were none.
std::string leftOutText(const std::vector<ImageSummary>& entries);

/// True when `wanted` is the end of a volume's id, or of the UID of its series.
bool fitsSeries(const std::string& id, const std::string& wanted);

/// Reads an entry of a DICOM folder without looking through the folder again, or a scan in another
/// format. Voxels that are no finite numbers are replaced.
/// @throws as readImage()
LoadedImage readImage(const ImageSummary& entry, const std::filesystem::path& path, bool evenOut,
                      const Progress& progress = {});

/// The middle slice of a DICOM entry, in the window of the file or the 1st to the 99.8th
/// percentile, pixels square, the longer side `size` pixels. Empty when it cannot be read.
Picture thumbnail(const ImageSummary& entry, int size);

/// Writes by extension: .mha, .nrrd and .nii.gz compressed, .nii plain, .mhd with a .raw beside it,
/// .nhdr with a .raw.gz. All but NIfTI keep the geometry to the last bit or the one before it;
/// NIfTI keeps it in float32 and holds no skewed axes and no side above 32767 voxels. Files get
/// temporary names, then are renamed: those of a pair so that no header ever stands beside other
/// voxels than its own, and a voxel file that belongs to something else is left alone (another name
/// is taken).
/// @throws InputError (a name or a geometry that the format does not hold), IoError (no such
/// folder, no permission, disk full): nothing is left behind
void writeVolume(const Volume<float>& volume, const std::filesystem::path& path);
void writeVolume(const Volume<std::uint8_t>& volume, const std::filesystem::path& path);
void writeVolume(const AnyVolume& volume, const std::filesystem::path& path);

}  // namespace angiomesh
