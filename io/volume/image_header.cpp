// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/image_header.h"

#include "core/base/error.h"

namespace angiomesh {

std::string sizeText(const ImageHeader& header) {
  std::string text;
  for (const std::uintmax_t size : header.size)
    text += (text.empty() ? "" : " x ") + std::to_string(size);
  if (header.data.values > 1 && !header.data.interleaved)
    text += " x " + std::to_string(header.data.values);
  return text;
}

ImageHeader readHeader(const std::filesystem::path& path, const ImageFormat& format) {
  ImageHeader header = format.read(path);
  if (header.size.size() < 3)
    throw InputError(
        "a " + std::to_string(header.size.size()) + "D image (" + sizeText(header) + ")",
        path.string(), "give a 3D volume");
  for (const std::uintmax_t size : header.size)
    if (size > (1U << 30U))
      throw InputError("the size " + sizeText(header) + " is not usable", path.string(),
                       "give a 3D volume");
  return header;
}

}  // namespace angiomesh
