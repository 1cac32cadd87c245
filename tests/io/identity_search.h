// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <zlib.h>

#include <QByteArray>
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/io/io_test.h"

namespace angiomesh::test {

/// Part of every planted name, number and free text, and of the names of files and folders. Long
/// enough not to turn up in voxels by chance.
constexpr const char* kPerson = "Quixberg";
constexpr const char* kBirthDate = "19310527";
constexpr const char* kStudyDate = "20120229";
/// All planted UIDs begin so.
constexpr const char* kUidRoot = "1.2.826.0.99.31415926";

/// What must not stand in any file.
inline std::vector<std::string> identityTexts() {
  return {kPerson, kBirthDate, "1931-05-27", kStudyDate, "2012-02-29", kUidRoot};
}

inline std::string lowered(std::string_view text) {
  std::string low(text);
  for (char& c : low) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return low;
}

/// The text in UTF-16, low byte first; the other order differs in its first byte alone.
inline std::string wide(std::string_view text) {
  std::string bytes;
  for (const char c : text) {
    if (!bytes.empty()) bytes += '\0';
    bytes += c;
  }
  return bytes;
}

/// What stays the same in the base64 form of anything that holds the text.
inline std::array<std::string, 3> base64Cores(std::string_view text) {
  std::array<std::string, 3> cores;
  for (int before = 0; before < 3; ++before) {
    const QByteArray bytes =
        QByteArray(before, '-') + QByteArray(text.data(), static_cast<qsizetype>(text.size()));
    const auto code = bytes.toBase64(QByteArray::OmitTrailingEquals).toStdString();
    // Characters of 6 bits that share some with a neighbour are no part of it.
    const std::size_t first = (8 * static_cast<std::size_t>(before) + 5) / 6;
    const std::size_t end = static_cast<std::size_t>(bytes.size()) * 8 / 6;
    cores[static_cast<std::size_t>(before)] = code.substr(first, end - first);
  }
  return cores;
}

/// What the zlib or gzip stream at the beginning of `bytes` holds, as far as it is one.
inline std::string inflated(std::string_view bytes) {
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 32) != Z_OK) return {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string content;
  std::array<char, 1 << 16> part{};
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    state = inflate(&stream, Z_NO_FLUSH);
    content.append(part.data(), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return content;
}

/// Places where a gzip or zlib stream may begin.
inline std::vector<std::size_t> streamsIn(std::string_view bytes) {
  std::vector<std::size_t> places;
  for (std::size_t at = 0; at + 6 < bytes.size(); ++at) {
    const auto first = static_cast<unsigned char>(bytes[at]);
    const auto second = static_cast<unsigned char>(bytes[at + 1]);
    const bool gzip = first == 0x1F && second == 0x8B && bytes[at + 2] == 8;
    const bool zlib = first == 0x78 && (first * 256 + second) % 31 == 0;
    if (gzip || zlib) places.push_back(at);
  }
  return places;
}

/// The texts that the bytes hold, in any case, as UTF-8, UTF-16 or base64, packed or not; each with
/// some of what follows.
inline std::vector<std::string> foundIn(const std::string& bytes,
                                        const std::vector<std::string>& texts, int depth = 0) {
  std::vector<std::string> found;
  const auto note = [&](std::size_t at, const std::string& how) {
    std::string context = bytes.substr(at > 20 ? at - 20 : 0, 80);
    for (char& c : context)
      if (c < ' ' || c > '~') c = '.';
    found.push_back(how + ": " + context);
  };
  const std::string low = lowered(bytes);
  for (const std::string& text : texts) {
    for (const std::string& form : {lowered(text), wide(lowered(text))})
      if (const std::size_t at = low.find(form); at != std::string::npos) note(at, text);
    for (const std::string& core : base64Cores(text))
      if (const std::size_t at = bytes.find(core); at != std::string::npos)
        note(at, text + " in base64");
  }
  constexpr int kDeepest = 2;
  if (depth == kDeepest) return found;
  for (const std::size_t at : streamsIn(bytes))
    for (const std::string& inner :
         foundIn(inflated(std::string_view(bytes).substr(at)), texts, depth + 1))
      found.push_back("packed, " + inner);
  return found;
}

/// The identity in the files in and below `folder`, and in the names of files and folders.
inline std::vector<std::string> identityIn(
    const fs::path& folder, const std::vector<std::string>& texts = identityTexts()) {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    for (const std::string& what : foundIn(entry.path().filename().string(), texts))
      found.push_back(name + ", its name: " + what);
    if (!entry.is_regular_file()) continue;
    for (const std::string& what : foundIn(bytesOf(entry.path()), texts))
      found.push_back(name + ": " + what);
  }
  return found;
}

inline std::size_t filesBelow(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    count += entry.is_regular_file() ? 1 : 0;
  return count;
}

inline std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// A home of its own for the program and for what it starts: all that it writes of its own accord
/// lies in `folder`. Before the application object is made.
inline void makeHome(const fs::path& folder) {
  for (const auto& [variable, name] :
       {std::pair("HOME", "."), std::pair("XDG_CONFIG_HOME", "config"),
        std::pair("XDG_DATA_HOME", "data"), std::pair("XDG_CACHE_HOME", "cache"),
        std::pair("XDG_STATE_HOME", "state"), std::pair("TMPDIR", "tmp")}) {
    fs::create_directories(folder / name);
    qputenv(variable, (folder / name).c_str());
  }
}

}  // namespace angiomesh::test
