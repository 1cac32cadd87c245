// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>

class DcmFileFormat;
class DcmTagKey;

namespace angiomesh {

/// What one DICOM file says before its pixels.
class DicomHeader {
 public:
  /// @throws IoError
  explicit DicomHeader(const std::filesystem::path& file);
  ~DicomHeader();
  DicomHeader(const DicomHeader&) = delete;
  DicomHeader& operator=(const DicomHeader&) = delete;

  /// Of an element, in the character set of the file; empty where it is absent or too long for a
  /// text.
  [[nodiscard]] std::string text(const DcmTagKey& tag) const;
  /// Texts are in UTF-8 from now on; as they were where that fails.
  void toUtf8();

 private:
  std::unique_ptr<DcmFileFormat> format_;
};

}  // namespace angiomesh
