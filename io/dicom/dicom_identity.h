// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace angiomesh {

/// Who and what a DICOM file is of, as it says it, in UTF-8. For the screen only: nothing of it
/// goes into a file, a log or a picture.
struct DicomIdentityTexts {
  std::string name;  ///< family and given names, without the component groups' marks
  std::string id, birthDate, sex;
  std::string studyDate, studyDescription, accession;
};

/// @throws IoError
DicomIdentityTexts readDicomIdentity(const std::filesystem::path& file);

}  // namespace angiomesh
