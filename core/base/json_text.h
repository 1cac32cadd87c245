// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace angiomesh {

/// What a JSON text of a stranger may hold at most.
struct JsonLimits {
  /// Arrays and objects in one another: the parser's values are taken apart by recursion.
  std::size_t depth = 64;
  /// Members of objects in all: looking them up takes a time that grows with their square where an
  /// object keeps their order.
  std::size_t members = 20000;
};

/// Whether a text keeps within the limits, if it is JSON at all.
inline bool isModestJson(std::string_view text, const JsonLimits& limits = {}) {
  std::size_t depth = 0, members = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      if (++depth > limits.depth) return false;
    } else if (c == ']' || c == '}') {
      if (depth > 0) --depth;
    } else if (c == ':' && ++members > limits.members) {
      return false;
    }
  }
  return true;
}

/// A text of a stranger as nlohmann's value; a discarded one where it is no JSON or beyond the
/// limits.
template <class Json>
Json parseJson(std::string_view text, const JsonLimits& limits = {}) {
  if (!isModestJson(text, limits)) return Json(Json::value_t::discarded);
  return Json::parse(text, nullptr, false);
}

/// The value at a dotted key, made where there is none: "a.b" is member b of member a.
template <class Json>
Json& placeAt(Json& object, std::string_view key) {
  const std::size_t dot = key.find('.');
  Json& member = object[std::string(key.substr(0, dot))];
  return dot == std::string_view::npos ? member : placeAt(member, key.substr(dot + 1));
}

/// A count: a whole number from 0 on that an int can hold, and one more. nlohmann's get<int>()
/// takes true, 1.5 and 1e300 too, and what it makes of numbers beyond an int is another number.
/// @throws std::out_of_range
template <class Json>
int countIn(const Json& json) {
  const bool whole = json.is_number_integer();
  // Of one beyond an int64 the sign is another.
  const std::int64_t count = whole ? json.template get<std::int64_t>() : -1;
  if (count < 0 || count >= std::numeric_limits<int>::max())
    throw std::out_of_range("a value is no count");
  return static_cast<int>(count);
}

}  // namespace angiomesh
