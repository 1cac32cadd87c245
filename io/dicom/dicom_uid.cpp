// SPDX-License-Identifier: BSD-3-Clause
#include "io/dicom/dicom_uid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>

namespace angiomesh {

std::string newDicomUid() {
  std::random_device random;
  std::array<std::uint32_t, 4> words{};  // the highest first
  for (std::uint32_t& word : words) word = random();
  // Version 4, variant 1 (RFC 4122).
  words[1] = (words[1] & 0xffff0fffU) | 0x4000U;
  words[2] = (words[2] & 0x3fffffffU) | 0x80000000U;
  std::string digits;
  while (std::any_of(words.begin(), words.end(), [](std::uint32_t word) { return word != 0; })) {
    std::uint64_t rest = 0;
    for (std::uint32_t& word : words) {
      const std::uint64_t value = (rest << 32U) | word;
      word = static_cast<std::uint32_t>(value / 10);
      rest = value % 10;
    }
    digits += static_cast<char>('0' + rest);
  }
  std::reverse(digits.begin(), digits.end());
  return "2.25." + digits;
}

}  // namespace angiomesh
