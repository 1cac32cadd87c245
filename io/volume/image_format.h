// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace angiomesh {

struct ImageHeader;
struct WritableImage;

/// An ending of names, and what writes files with it.
struct ImageEnding {
  const char* text;  ///< ".nii.gz"
  /// As writeVolume(); null: such files are only read.
  void (*write)(const WritableImage& image, const std::filesystem::path& path);
};

/// A file format of volumes. All that lists formats (reading, writing, the desktop's dialogs, help
/// and messages) comes from their table.
struct ImageFormat {
  const char* name;
  std::vector<ImageEnding> endings;  ///< the first one that is written: of a single, packed file
  bool zipped;                       ///< is read where the whole file is compressed with gzip, too
  /// By the first 4096 bytes. @throws IoError (truncated), InputError (a version that is not read)
  bool (*begins)(const std::string& head, const std::filesystem::path& path);
  /// As readHeader(); null of DICOM, of which a volume takes many files.
  ImageHeader (*read)(const std::filesystem::path& path);

  [[nodiscard]] bool isDicom() const { return read == nullptr; }
};

const std::vector<ImageFormat>& imageFormats();

/// The format by content, whatever the name says. @throws IoError (missing, unreadable, empty),
/// InputError (not an image that Angiomesh reads)
const ImageFormat& imageFormat(const std::filesystem::path& path);

/// All of them, or those that are written.
std::vector<std::string> imageEndings(bool onlyWritten);

/// That of the name; null: none of a volume.
const ImageEnding* imageEndingOf(const std::filesystem::path& path);

/// True when the first bytes are those of a DICOM file. @throws IoError (the file cannot be opened
/// or read, which says nothing of what it is)
bool looksLikeDicom(const std::filesystem::path& path);

}  // namespace angiomesh
