// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
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

}  // namespace angiomesh
