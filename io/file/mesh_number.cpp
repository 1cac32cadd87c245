// SPDX-License-Identifier: BSD-3-Clause
#include "io/file/mesh_number.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "core/base/error.h"

namespace angiomesh {
namespace {

template <class T>
double decode(std::string_view bytes, Encoding encoding) {
  std::array<char, sizeof(T)> part{};
  std::memcpy(part.data(), bytes.data(), sizeof(T));
  if (encoding == Encoding::BigEndian) std::reverse(part.begin(), part.end());
  T value;
  std::memcpy(&value, part.data(), sizeof(T));
  return static_cast<double>(value);
}

}  // namespace

std::size_t bytesOf(Scalar type) {
  switch (type) {
    case Scalar::None:
      return 0;
    case Scalar::Int8:
    case Scalar::Uint8:
      return 1;
    case Scalar::Int16:
    case Scalar::Uint16:
      return 2;
    case Scalar::Int32:
    case Scalar::Uint32:
    case Scalar::Float32:
      return 4;
    default:
      return 8;
  }
}

double takeNumber(TextScanner& text, Encoding encoding, Scalar type,
                  const std::filesystem::path& path) {
  if (encoding == Encoding::Ascii) {
    double value = 0.0;
    if (!text.number(value)) throwTruncated(path);
    return value;
  }
  const std::string_view bytes = text.take(bytesOf(type));
  if (bytes.empty()) throwTruncated(path);
  switch (type) {
    case Scalar::Int8:
      return decode<std::int8_t>(bytes, encoding);
    case Scalar::Uint8:
      return decode<std::uint8_t>(bytes, encoding);
    case Scalar::Int16:
      return decode<std::int16_t>(bytes, encoding);
    case Scalar::Uint16:
      return decode<std::uint16_t>(bytes, encoding);
    case Scalar::Int32:
      return decode<std::int32_t>(bytes, encoding);
    case Scalar::Uint32:
      return decode<std::uint32_t>(bytes, encoding);
    case Scalar::Int64:
      return decode<std::int64_t>(bytes, encoding);
    case Scalar::Uint64:
      return decode<std::uint64_t>(bytes, encoding);
    case Scalar::Float32:
      return decode<float>(bytes, encoding);
    default:
      return decode<double>(bytes, encoding);
  }
}

void throwTruncated(const std::filesystem::path& path) {
  throw IoError("the mesh file is truncated or damaged", path.string(),
                "copy it again or write it with another program");
}

}  // namespace angiomesh
