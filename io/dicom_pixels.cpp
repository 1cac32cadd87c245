// SPDX-License-Identifier: BSD-3-Clause
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>

#include <cmath>

#include "core/base/error.h"
#include "io/dicom_series.h"
#include "io/itk_image.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

void registerCodecs() {
  static const bool done = [] {
    DcmRLEDecoderRegistration::registerCodecs();
    DJDecoderRegistration::registerCodecs();
    DJLSDecoderRegistration::registerCodecs();
    return true;
  }();
  static_cast<void>(done);
}

[[noreturn]] void damaged(const fs::path& file, const std::string& what) {
  throw IoError("the pixels are truncated or damaged (" + what + ")", file.filename().string(),
                "copy the file again");
}

struct Layout {
  Uint16 allocated = 16, stored = 16, high = 15, isSigned = 0;
};

/// Value of `stored` bits that end at bit `high`, with its sign.
template <class Word>
float valueOf(Word word, const Layout& layout) {
  const std::uint64_t bits =
      static_cast<std::uint64_t>(word) >> static_cast<unsigned>(layout.high + 1 - layout.stored);
  const std::uint64_t mask = (std::uint64_t{1} << layout.stored) - 1;
  const std::uint64_t value = bits & mask;
  const bool negative = layout.isSigned != 0 && (value >> (layout.stored - 1U)) != 0;
  return negative ? static_cast<float>(static_cast<std::int64_t>(value) -
                                       static_cast<std::int64_t>(mask) - 1)
                  : static_cast<float>(value);
}

template <class Word>
void unpack(const Word* words, const Layout& layout, std::vector<float>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = valueOf(words[i], layout);
}

Layout layoutOf(DcmDataset& data, const fs::path& file) {
  Layout layout;
  if (data.findAndGetUint16(DCM_BitsAllocated, layout.allocated).bad() ||
      (layout.allocated != 8 && layout.allocated != 16 && layout.allocated != 32))
    throw InputError("BitsAllocated is not 8, 16 or 32", file.filename().string(),
                     "convert the series with another program");
  if (data.findAndGetUint16(DCM_BitsStored, layout.stored).bad() || layout.stored < 1 ||
      layout.stored > layout.allocated)
    layout.stored = layout.allocated;
  if (data.findAndGetUint16(DCM_HighBit, layout.high).bad() || layout.high + 1 < layout.stored ||
      layout.high >= layout.allocated)
    layout.high = static_cast<Uint16>(layout.stored - 1);
  if (data.findAndGetUint16(DCM_PixelRepresentation, layout.isSigned).bad()) layout.isSigned = 0;
  return layout;
}

}  // namespace

std::vector<float> decodeDicomFile(const DicomFrame& frame) {
  registerCodecs();
  const fs::path& file = frame.file;
  const std::size_t count = pixelsOf(frame) * static_cast<std::size_t>(frame.framesInFile);
  DcmFileFormat format;
  OFCondition status = format.loadFile(file.c_str());
  if (status.bad()) damaged(file, status.text());
  DcmDataset& data = *format.getDataset();
  const E_TransferSyntax syntax = data.getOriginalXfer();
  if (syntax == EXS_JPEG2000 || syntax == EXS_JPEG2000LosslessOnly ||
      syntax == EXS_JPEG2000Multicomponent || syntax == EXS_JPEG2000MulticomponentLosslessOnly)
    return itkReadDicomPixels(file, count);
  status = data.chooseRepresentation(EXS_LittleEndianExplicit, nullptr);
  if (status.bad()) {
    if (!DcmXfer(syntax).isEncapsulated()) damaged(file, status.text());
    throw InputError(std::string("cannot decompress ") + DcmXfer(syntax).getXferName() + " (" +
                         status.text() + ")",
                     file.filename().string(), "decompress the series with another program");
  }
  DcmElement* pixels = nullptr;
  if (data.findAndGetElement(DCM_PixelData, pixels).bad() || pixels == nullptr)
    damaged(file, "no pixel data");
  const Layout layout = layoutOf(data, file);
  const std::size_t bytes = count * (layout.allocated / 8U);
  const std::size_t present = pixels->getLength();
  if (present < bytes)
    damaged(file, std::to_string(present) + " of " + std::to_string(bytes) + " bytes");
  std::vector<float> values(count);
  Uint8* bytes8 = nullptr;
  Uint16* words16 = nullptr;
  if (layout.allocated == 8 && pixels->getUint8Array(bytes8).good() && bytes8 != nullptr)
    unpack(bytes8, layout, values);
  else if (layout.allocated == 8 && pixels->getUint16Array(words16).good() && words16 != nullptr)
    // Two pixels in a word, as OW stores them.
    unpack(reinterpret_cast<const Uint8*>(words16), layout, values);
  else if (layout.allocated == 16 && pixels->getUint16Array(words16).good() && words16 != nullptr)
    unpack(words16, layout, values);
  else if (layout.allocated == 32 && pixels->getUint16Array(words16).good() && words16 != nullptr)
    for (std::size_t i = 0; i < count; ++i)
      values[i] = valueOf(static_cast<std::uint32_t>(words16[2 * i]) |
                              (static_cast<std::uint32_t>(words16[2 * i + 1]) << 16U),
                          layout);
  else
    damaged(file, "no pixels");
  return values;
}

}  // namespace angiomesh
