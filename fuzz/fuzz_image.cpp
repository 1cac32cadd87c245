// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/error.h"
#include "fuzz/fuzz_file.h"
#include "io/image_format.h"

/// The header checks of MetaImage, NRRD and NIfTI, which stand before any library.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace angiomesh;
  const fuzz::MemoryFile file(data, size);
  try {
    const ImageFormat format = imageFormat(file.path());
    if (format != ImageFormat::Dicom) static_cast<void>(checkHeader(file.path(), format, true));
  } catch (const Error&) {
    return 0;
  }
  return 0;
}
