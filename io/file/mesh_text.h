// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <cstring>
#include <string>

namespace angiomesh {

/// The shortest text that reads back as the same float or double.
template <class T>
void appendShortest(std::string& text, T value) {
  char number[32];
  const auto end = std::to_chars(number, number + sizeof(number), value);
  text.append(number, end.ptr);
}

/// As appendShortest(), with an exponent and at least 9 significant digits.
inline void appendScientific(std::string& text, double value) {
  char number[32];
  const auto shortest =
      std::to_chars(number, number + sizeof(number), value, std::chars_format::scientific);
  int digits = 0;
  for (const char* c = number; c != shortest.ptr && *c != 'e'; ++c) digits += *c >= '0' ? 1 : 0;
  constexpr int kDigits = 9;
  const auto end = digits >= kDigits ? shortest
                                     : std::to_chars(number, number + sizeof(number), value,
                                                     std::chars_format::scientific, kDigits - 1);
  text.append(number, end.ptr);
}

/// The value's bytes as they lie in memory.
template <class T>
void appendRaw(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

}  // namespace angiomesh
