// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/error.h"
#include "fuzz/fuzz_file.h"
#include "io/image_io.h"

/// A DICOM file, whatever its first bytes are: its header, its series and, where they make a
/// volume, its pixels.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace angiomesh;
  const fuzz::MemoryFile file(data, size);
  try {
    for (const ImageSummary& entry : describeImages(file.path())) {
      if (entry.info.format != "DICOM") return 0;
      static_cast<void>(thumbnail(entry, 16));
      static_cast<void>(readImage(entry, file.path(), true));
    }
  } catch (const Error&) {
    return 0;
  }
  return 0;
}
