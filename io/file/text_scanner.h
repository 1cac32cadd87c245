// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

namespace angiomesh {

/// What some editors put before text in UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// The letters A to Z as small ones, whatever the locale: names of files and fields may be in
/// capitals.
inline std::string inSmall(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Words and lines of a text in memory; numbers do not depend on the locale.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text) : rest_(text) {}

  /// The next word on this line or, with `acrossLines`, in the text; empty at its end.
  std::string_view word(bool acrossLines = true) {
    const std::string_view blanks = acrossLines ? " \t\r\n" : " \t\r";
    const std::size_t first = rest_.find_first_not_of(blanks);
    if (first == std::string_view::npos) {
      rest_ = {};
      return {};
    }
    rest_.remove_prefix(first);
    const std::size_t length = std::min(rest_.find_first_of(" \t\r\n"), rest_.size());
    const std::string_view result = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return result;
  }

  /// The rest of this line; moves to the next one.
  std::string_view line() {
    const std::size_t end = rest_.find('\n');
    std::string_view result = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (!result.empty() && result.back() == '\r') result.remove_suffix(1);
    return result;
  }

  /// False when the next word is no number, or there is none.
  bool number(double& value, bool acrossLines = true) {
    std::string_view text = word(acrossLines);
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || end.ptr != text.data() + text.size()) return false;
    if (end.ec != std::errc::result_out_of_range) return end.ec == std::errc();
    value = 0.0;  // too small for a double, unless the exponent is positive
    return text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
  }

  /// The next `count` bytes, whatever they are; empty when there are not so many.
  std::string_view take(std::size_t count) {
    if (count > rest_.size()) return {};
    const std::string_view result = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return result;
  }

  [[nodiscard]] bool done() const { return rest_.empty(); }
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

}  // namespace angiomesh
