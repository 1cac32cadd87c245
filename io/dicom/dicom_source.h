// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>

#include "io/file/memory_file.h"

class OFCondition;

namespace angiomesh {

/// Where DCMTK is to read a DICOM file: the file itself or, where its data set is deflated, an
/// inflated copy. From a deflated stream DCMTK reads each element as a whole, and makes room for
/// whatever length the element states.
class DicomSource {
 public:
  explicit DicomSource(const std::filesystem::path& file);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] bool inflated() const { return copy_ != nullptr; }

 private:
  std::filesystem::path path_;
  std::unique_ptr<MemoryFile> copy_;
};

/// Throws where DCMTK's status says that the file could not be opened, which says nothing of what
/// is in it. @throws IoError
void checkOpened(const std::filesystem::path& file, const OFCondition& status);

}  // namespace angiomesh
