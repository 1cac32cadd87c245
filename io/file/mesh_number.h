// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "io/file/text_scanner.h"

namespace angiomesh {

enum class Encoding { Ascii, LittleEndian, BigEndian };
enum class Scalar {
  None,
  Int8,
  Uint8,
  Int16,
  Uint16,
  Int32,
  Uint32,
  Int64,
  Uint64,
  Float32,
  Float64
};

std::size_t bytesOf(Scalar type);

/// Takes the next number, in words or in binary, off `text`.
/// @throws IoError when the text of `path` ends before it, or holds something else
double takeNumber(TextScanner& text, Encoding encoding, Scalar type,
                  const std::filesystem::path& path);

/// The error for a mesh file that ends too early or makes no sense.
[[noreturn]] void throwTruncated(const std::filesystem::path& path);

}  // namespace angiomesh
