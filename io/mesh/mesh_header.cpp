// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh/mesh_header.h"

#include <algorithm>
#include <cctype>

namespace angiomesh {
namespace {

bool isWordByte(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool isPrintable(char c) { return c > ' ' && c < 127; }

/// 64 bits in hexadecimal, as the pipeline's keys are. Other words behind KEY= are somebody's own
/// and may tell a patient's name.
bool isPipelineKey(std::string_view value) {
  constexpr std::size_t kDigits = 16;
  return value.size() == kDigits &&
         value.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// The values of "NAME=value" in the text. COLORSPACE=sRGB is no SPACE.
std::vector<std::string> valuesOf(std::string_view text, std::string_view name,
                                  bool (*belongs)(char)) {
  std::vector<std::string> values;
  for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at)) {
    const bool whole = at == 0 || !isWordByte(text[at - 1]);
    at += name.size();
    if (!whole || at >= text.size() || text[at] != '=') continue;
    const std::size_t first = ++at;
    while (at < text.size() && belongs(text[at])) ++at;
    if (at > first) values.emplace_back(text.substr(first, at - first));
  }
  return values;
}

}  // namespace

std::string frameWord(Frame frame) { return frame == Frame::Ras ? "RAS" : "LPS"; }

std::string unitWord(LengthUnit unit) { return unit == LengthUnit::Metre ? "m" : "mm"; }

void MeshHeader::read(std::string_view text) {
  const auto take = [&](const char* name, auto& place, const auto& word, const auto& values) {
    for (const std::string& value : valuesOf(text, name, isWordByte)) {
      const auto known = std::find_if(values.begin(), values.end(),
                                      [&](const auto& each) { return word(each) == value; });
      const std::string statement = std::string(name) + "=" + value;
      if (known == values.end()) {
        if (std::find(unknown.begin(), unknown.end(), statement) == unknown.end())
          unknown.push_back(statement);
      } else if (!place) {
        place = *known;
      } else if (*place != *known) {
        contradiction = std::string(name) + "=" + word(*place) + " and " + statement;
      }
    }
  };
  take("SPACE", frame, frameWord, std::vector{Frame::Lps, Frame::Ras});
  take("UNIT", unit, unitWord, std::vector{LengthUnit::Millimetre, LengthUnit::Metre});
  for (const std::string& value : valuesOf(text, "KEY", isPrintable))
    if (key.empty() && isPipelineKey(value)) key = value;
}

std::string cleanKey(const std::string& key) {
  std::string clean;
  for (const char c : key)
    if (isPrintable(c) && c != '=') clean += c;
  return clean;
}

std::string headerWords(const MeshWriteOptions& options, const std::string& separator) {
  std::string words =
      "SPACE=" + frameWord(options.frame) + separator + "UNIT=" + unitWord(options.unit);
  if (const std::string key = cleanKey(options.key); !key.empty())
    words += separator + "KEY=" + key;
  return words;
}

}  // namespace angiomesh
