// SPDX-License-Identifier: BSD-3-Clause
#include "io/dicom/dicom_identity.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "core/base/error.h"
#include "io/dicom/dicom_source.h"

namespace angiomesh {
namespace {

// A longer one is no text of these elements, see PS3.5, table 6.2-1.
constexpr std::uint32_t kLongestText = 1024;

std::string textOf(DcmItem& item, const DcmTagKey& tag) {
  DcmElement* element = nullptr;
  OFString value;
  if (item.findAndGetElement(tag, element).bad() || element->getLengthField() > kLongestText ||
      element->getOFStringArray(value).bad())
    return {};
  std::string text;
  // No control character reaches the screen.
  for (const char c : value)
    if (static_cast<unsigned char>(c) >= ' ' && c != 127) text += c;
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

/// YYYY-MM-DD where it is a date.
std::string dateOf(const std::string& text) {
  if (text.size() != 8 || text.find_first_not_of("0123456789") != std::string::npos) return text;
  return text.substr(0, 4) + '-' + text.substr(4, 2) + '-' + text.substr(6);
}

/// "Family, Given Middle" of the first group, see PS3.5, 6.2.1.
std::string nameOf(std::string text) {
  text = text.substr(0, text.find('='));
  const std::size_t family = text.find('^');
  if (family == std::string::npos) return text;
  std::string name = text.substr(0, family) + ',';
  for (const char c : text.substr(family)) name += c == '^' ? ' ' : c;
  while (name.back() == ' ' || name.back() == ',') name.pop_back();
  return name;
}

}  // namespace

DicomIdentityTexts readDicomIdentity(const std::filesystem::path& file) {
  const DicomSource source(file);
  DcmFileFormat format;
  const OFCondition status =
      format.loadFileUntilTag(source.path().c_str(), EXS_Unknown, EGL_noChange, kLongestText,
                              ERM_autoDetect, DCM_PixelData);
  if (status.bad())
    throw IoError("the header cannot be read", file.filename().string(),
                  "check that the series is still there and can be read");
  DcmDataset& data = *format.getDataset();
  // Where it fails, the texts are as they are in the file.
  data.convertToUTF8();
  return {nameOf(textOf(data, DCM_PatientName)),      textOf(data, DCM_PatientID),
          dateOf(textOf(data, DCM_PatientBirthDate)), textOf(data, DCM_PatientSex),
          dateOf(textOf(data, DCM_StudyDate)),        textOf(data, DCM_StudyDescription),
          textOf(data, DCM_AccessionNumber)};
}

}  // namespace angiomesh
