// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/error.h"
#include "fuzz/fuzz_file.h"
#include "io/image_header.h"
#include "io/image_io.h"

/// The header checks of MetaImage, NRRD and NIfTI, and the voxels where they let it pass.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace angiomesh;
  const fuzz::MemoryFile file(data, size);
  try {
    const ImageFormat format = imageFormat(file.path());
    if (format == ImageFormat::Dicom) return 0;
    static_cast<void>(readHeader(file.path(), format));
    static_cast<void>(readNative(file.path()));
  } catch (const Error&) {
    return 0;
  }
  return 0;
}
