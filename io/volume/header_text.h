// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <istream>
#include <map>
#include <string>
#include <vector>

#include "io/volume/image_header.h"

namespace angiomesh {

extern const char* const kNoSpacing;  ///< a warning

[[noreturn]] void throwBadHeader(const std::filesystem::path& path, const std::string& what);

/// Without blanks at its ends.
std::string trimmed(const std::string& text);

/// Whether two values are the same text, or the same numbers.
bool saysTheSame(const std::string& one, const std::string& other);

using HeaderFields = std::map<std::string, std::string>;

/// @throws InputError where the field stands in the header already, with another value
void addField(HeaderFields& fields, const std::string& key, const std::string& value,
              const std::filesystem::path& path);

/// "key SIGN value" lines up to an empty line or the key `last`; `in` then stands behind it. Lines
/// that begin with # and comments are left out. @throws InputError as addField()
HeaderFields textFields(std::istream& in, const char* signs, const std::string& last,
                        const std::filesystem::path& path);

/// "2 3 4" as positive numbers whose product is below 2^44; empty when it is anything else.
std::vector<std::uintmax_t> parseSizes(const std::string& text);
std::uintmax_t productOf(const std::vector<std::uintmax_t>& sizes);

/// The whole number in the text. @throws InputError naming `field`
long long parseWhole(const std::string& text, const std::string& field,
                     const std::filesystem::path& path);

/// A number of a binary header; `swap`: of the other byte order.
template <class T>
T fromBytes(const std::string& bytes, std::size_t at, bool swap) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), bytes.data() + at, sizeof(T));
  if (swap)
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  return std::bit_cast<T>(raw);
}

/// How the header says where the voxels are.
struct VoxelPlace {
  bool local = false;             ///< in the header's file, from `start` on
  std::string file;               ///< a name, "LIST ...", or a pattern with its numbers
  std::vector<std::string> list;  ///< the names after LIST
  std::uintmax_t start = 0;       ///< first, bytes to skip in each file
  long long skipLines = 0;        ///< then lines
  std::uintmax_t skipBytes = 0;   ///< then bytes of what is not compressed
  bool atEnd = false;             ///< the voxels are the last bytes of the file
};

/// Finds the files and compares their sizes with what `header.data` needs; fills its pieces.
/// @throws IoError, InputError
void placeVoxels(const VoxelPlace& place, const std::filesystem::path& path, ImageHeader& header);

/// The same for voxels written as text.
void placeText(const VoxelPlace& place, const std::filesystem::path& path, VoxelText text,
               ImageHeader& header);

/// A warning: so many bytes or values more than the header says.
std::string longerText(std::uintmax_t more, const std::string& what, bool local, bool several,
                       bool atLeast = false);

}  // namespace angiomesh
