// SPDX-License-Identifier: BSD-3-Clause
#include <png.h>

#include <algorithm>
#include <string>

#include "core/base/error.h"
#include "io/file/files.h"

namespace angiomesh {

void writePng(const Picture& picture, const std::filesystem::path& path) {
  const auto row = static_cast<std::size_t>(std::max(picture.width, 0)) * 3;
  const auto rows = static_cast<std::size_t>(std::max(picture.height, 0));
  if (row == 0 || rows == 0 || picture.rgb.size() != row * rows)
    throw InputError("the picture is empty", path.string(), "make it from a volume first");
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.rgb.data(), 0, nullptr) ==
      0)
    throw IoError("cannot make the PNG", path.string(), "free some memory");
  bytes.resize(size);
  writeText(path, bytes);
}

}  // namespace angiomesh
