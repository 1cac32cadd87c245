// SPDX-License-Identifier: BSD-3-Clause
#include "io/dicom/dicom_file_header.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "core/base/error.h"
#include "io/dicom/dicom_source.h"
#include "io/file/files.h"

namespace angiomesh {
namespace {

constexpr std::uint32_t kLongestText = 1024;

}  // namespace

DicomHeader::DicomHeader(const std::filesystem::path& file)
    : format_(std::make_unique<DcmFileFormat>()) {
  const DicomSource source(file);
  const OFCondition status =
      format_->loadFileUntilTag(source.path().c_str(), EXS_Unknown, EGL_noChange, kLongestText,
                                ERM_autoDetect, DCM_PixelData);
  checkOpened(file, status);
  if (status.bad())
    throw IoError("the header of a source image is damaged", file.filename().string(), kCopyAgain);
}

DicomHeader::~DicomHeader() = default;

std::string DicomHeader::text(const DcmTagKey& tag) const {
  DcmElement* element = nullptr;
  OFString value;
  if (format_->getDataset()->findAndGetElement(tag, element).bad() ||
      element->getLengthField() > kLongestText || element->getOFStringArray(value).bad())
    return {};
  return value.c_str();
}

void DicomHeader::toUtf8() { format_->getDataset()->convertToUTF8(); }

}  // namespace angiomesh
