// SPDX-License-Identifier: BSD-3-Clause
#include "io/dicom/dicom_identity.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "io/dicom/dicom_file_header.h"

namespace angiomesh {
namespace {

std::string textOf(const DicomHeader& header, const DcmTagKey& tag) {
  std::string text;
  // No control character reaches the screen.
  for (const char c : header.text(tag))
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
  DicomHeader header(file);
  header.toUtf8();
  return {nameOf(textOf(header, DCM_PatientName)),      textOf(header, DCM_PatientID),
          dateOf(textOf(header, DCM_PatientBirthDate)), textOf(header, DCM_PatientSex),
          dateOf(textOf(header, DCM_StudyDate)),        textOf(header, DCM_StudyDescription),
          textOf(header, DCM_AccessionNumber)};
}

}  // namespace angiomesh
