// SPDX-License-Identifier: BSD-3-Clause
#include "io/scan/mask_file.h"

#include <vector>

#include "core/base/error.h"
#include "io/dicom/dicom.h"
#include "io/file/files.h"
#include "io/scan/image_io.h"
#include "io/volume/geometry_check.h"
#include "io/volume/image_write.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

void checkHolds(const fs::path& file, const Volume<std::uint8_t>& mask, const fs::path& path) {
  const Volume<std::uint8_t> back = readMask(file).mask;
  if (!sameGrid(back.geometry, mask.geometry) || back.voxels != mask.voxels)
    throw IoError("what was written does not read back as the same mask", path.string(),
                  "choose another place");
}

}  // namespace

void writeMask(const Volume<std::uint8_t>& mask, const fs::path& path) {
  writeAtomically(path, [&](const fs::path& temporary) {
    writeVolume(mask, temporary);
    checkHolds(temporary, mask, path);
  });
}

DicomIdentityTexts readIdentity(const DicomOrigin& origin) {
  std::vector<std::string> warnings;  // the scan has been read before
  return readDicomIdentity(findDicom(origin.path, origin.series, {}, warnings)->files.front().path);
}

void writeMask(const Volume<std::uint8_t>& mask, const DicomOrigin& origin, const fs::path& path) {
  std::vector<std::string> warnings;  // the scan has been read before
  const auto series = findDicom(origin.path, origin.series, {}, warnings);
  writeAtomically(path, [&](const fs::path& temporary) {
    writeSegmentation(mask, *series, origin.identity, temporary);
    checkHolds(temporary, mask, path);
  });
}

}  // namespace angiomesh
