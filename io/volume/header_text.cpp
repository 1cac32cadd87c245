// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/header_text.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <numeric>
#include <sstream>
#include <system_error>

#include "core/base/error.h"
#include "io/file/files.h"

namespace angiomesh {

const char* const kNoSpacing = "the file does not state the voxel spacing: 1 mm is assumed";

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostVoxels = 1ULL << 44U;
constexpr int kMostLines = 100000;
/// Deflate makes at most 258 bytes of 2 bits, 1032 bytes of one; the rest is for small files.
constexpr std::uintmax_t kMostInflation = 1032, kInflationRest = 1024;

std::uintmax_t sizeOf(const fs::path& file, const std::string& name, const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    throw IoError("the voxel file '" + name + "' that the header names is missing", path.string(),
                  "put it beside the header");
  const std::uintmax_t bytes = fs::file_size(file, error);
  return error ? 0 : bytes;
}

[[noreturn]] void throwTooMuch(const fs::path& path, const ImageHeader& header,
                               std::uintmax_t found) {
  throw IoError("the header claims " + sizeText(header) + " voxels, which the " +
                    std::to_string(found) + " bytes of voxels in the file cannot hold",
                path.string(), kCopyAgain);
}

/// "v%03d.raw" with a number. The pattern comes from a file: never through printf.
std::string numberedName(const std::string& pattern, long long number, const fs::path& path) {
  const std::size_t percent = pattern.find('%');
  const std::size_t end = pattern.find_first_not_of("0123456789", percent + 1);
  if (end == std::string::npos || std::string("diu").find(pattern[end]) == std::string::npos ||
      pattern.find('%', end) != std::string::npos || end - percent > 3 || number < 0)
    throwBadHeader(path, "the file pattern is '" + pattern + "'");
  const std::string width = pattern.substr(percent + 1, end - percent - 1);
  std::string digits = std::to_string(number);
  const std::size_t least = width.empty() ? 0 : std::stoul(width);
  if (digits.size() < least) digits.insert(0, least - digits.size(), width[0] == '0' ? '0' : ' ');
  return pattern.substr(0, percent) + digits + pattern.substr(end + 1);
}

/// The names that a place stands for; one, unless it is a list or a pattern.
std::vector<std::string> namesOf(const VoxelPlace& place, const fs::path& path) {
  if (place.file.starts_with("LIST")) return place.list;
  if (place.file.find('%') == std::string::npos) return {place.file};
  std::istringstream in(place.file);
  std::string pattern;
  long long first = 0, last = -1, step = 1;
  in >> pattern >> first >> last;
  if (!in) throwBadHeader(path, "the file pattern is '" + place.file + "'");
  in >> step;
  constexpr long long kMost = 1000000000;
  const auto sane = [](long long n) { return n >= -kMost && n <= kMost; };
  if (!sane(first) || !sane(last) || !sane(step) || step == 0 || (last - first) / step < 0 ||
      (last - first) / step > kMostLines)
    throwBadHeader(path, "the file pattern is '" + place.file + "'");
  std::vector<std::string> names;
  for (long long n = first; step > 0 ? n <= last : n >= last; n += step)
    names.push_back(numberedName(pattern, n, path));
  return names;
}

std::uintmax_t afterLines(const fs::path& file, std::uintmax_t start, long long lines) {
  std::ifstream in(file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(start));
  std::string line;
  for (long long n = 0; n < lines && in; ++n) std::getline(in, line);
  const std::streamoff at = in.tellg();
  return at < 0 ? fs::file_size(file) : static_cast<std::uintmax_t>(at);
}

}  // namespace

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

void throwBadHeader(const fs::path& path, const std::string& what) {
  throw InputError("the image header is not usable (" + what + ")", path.string(),
                   "write the image again with another program");
}

bool saysTheSame(const std::string& one, const std::string& other) {
  if (one == other) return true;
  std::istringstream a(one), b(other);
  double x = 0.0, y = 0.0;
  std::size_t numbers = 0;
  for (; a >> x && b >> y; ++numbers)
    if (x != y) return false;
  return numbers > 0 && a.eof() && (b >> std::ws).eof();
}

void addField(HeaderFields& fields, const std::string& key, const std::string& value,
              const fs::path& path) {
  const auto [field, isNew] = fields.emplace(key, value);
  if (!isNew && !saysTheSame(field->second, value))
    throwBadHeader(path, key + " is '" + field->second + "' and '" + value + "'");
}

HeaderFields textFields(std::istream& in, const char* signs, const std::string& last,
                        const fs::path& path) {
  HeaderFields fields;
  std::string line;
  for (int lines = 0; lines < kMostLines && std::getline(in, line); ++lines) {
    if (trimmed(line).empty()) break;
    const std::size_t sign = line.find_first_of(signs);
    if (sign == std::string::npos || line[0] == '#') continue;
    const std::string key = trimmed(line.substr(0, sign));
    const bool isLast = key == last;
    if (key != "Comment") addField(fields, key, trimmed(line.substr(sign + 1)), path);
    if (isLast) break;
  }
  return fields;
}

std::vector<std::uintmax_t> parseSizes(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::uintmax_t> sizes;
  std::uintmax_t product = 1;
  for (long long size = 0; in >> size;) {
    if (size < 1 || size > (1LL << 31) || sizes.size() > 16) return {};
    product *= static_cast<std::uintmax_t>(size);
    if (product > kMostVoxels) return {};
    sizes.push_back(static_cast<std::uintmax_t>(size));
  }
  return in.eof() ? sizes : std::vector<std::uintmax_t>{};
}

std::uintmax_t productOf(const std::vector<std::uintmax_t>& sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), std::uintmax_t{1}, std::multiplies<>());
}

long long parseWhole(const std::string& text, const std::string& field, const fs::path& path) {
  std::istringstream in(text);
  long long number = 0;
  if (!(in >> number) || !(in >> std::ws).eof()) throwBadHeader(path, field + " is '" + text + "'");
  return number;
}

void placeVoxels(const VoxelPlace& place, const fs::path& path, ImageHeader& header) {
  VoxelData& data = header.data;
  const std::vector<std::string> names =
      place.local ? std::vector<std::string>{path.filename().string()} : namesOf(place, path);
  if (names.empty() || data.bytes() % names.size() != 0)
    throwBadHeader(path, "its " + std::to_string(names.size()) + " voxel files do not divide " +
                             sizeText(header) + " voxels");
  if (data.deflated && (names.size() > 1 || place.atEnd))
    throwBadHeader(path, "compressed voxels in several files, or at the end of one");
  const std::uintmax_t each = data.bytes() / names.size();
  std::uintmax_t more = 0;
  for (const std::string& name : names) {
    const fs::path file = place.local ? path : path.parent_path() / name;
    const std::uintmax_t all = sizeOf(file, name, path);
    std::uintmax_t start = place.start;
    if (place.skipLines > 0) start = afterLines(file, start, place.skipLines);
    start += place.skipBytes;
    if (place.atEnd) start = all >= each ? all - each : 0;
    const std::uintmax_t found = all > start ? all - start : 0;
    if (data.deflated) {
      if ((each + data.skipInflated) / kMostInflation > found + kInflationRest)
        throwTooMuch(path, header, found);
      data.pieces.push_back({file, start, found});
      continue;
    }
    if (each / kMostInflation > found) throwTooMuch(path, header, found);
    if (found < each) throwTruncated(file, each, found);
    more = std::max(more, found - each);
    data.pieces.push_back({file, start, each});
  }
  if (more > 0) header.warnings.push_back(longerText(more, "bytes", place.local, names.size() > 1));
}

void placeText(const VoxelPlace& place, const fs::path& path, VoxelText text, ImageHeader& header) {
  if (!place.local && namesOf(place, path).size() != 1)
    throwBadHeader(path, "voxels as text in several files");
  VoxelData& data = header.data;
  data.text = text;
  const fs::path file = place.local ? path : path.parent_path() / place.file;
  const std::uintmax_t all = sizeOf(file, place.file, path);
  std::uintmax_t start = place.start;
  if (place.skipLines > 0) start = afterLines(file, start, place.skipLines);
  start += place.skipBytes;
  const std::uintmax_t found = all > start ? all - start : 0;
  const std::uintmax_t least =
      text == VoxelText::Numbers ? 2 * data.voxels * data.values - 1 : 2 * data.bytes();
  if (found < least) throwTooMuch(path, header, found);
  data.pieces.push_back({file, start, found});
}

std::string longerText(std::uintmax_t more, const std::string& what, bool local, bool several,
                       bool atLeast) {
  return "the " +
         std::string(local     ? "file"
                     : several ? "voxel files"
                               : "voxel file") +
         " hold" + (several && !local ? "" : "s") + (atLeast ? " at least " : " ") +
         std::to_string(more) + " " + what +
         " more than the header says: either its size is wrong, or the voxels do not begin where "
         "it says";
}

}  // namespace angiomesh
