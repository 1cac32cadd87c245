// SPDX-License-Identifier: BSD-3-Clause
#include "io/dicom/dicom_rle.h"

#include <algorithm>
#include <cstdint>

namespace angiomesh {
namespace {

constexpr std::size_t kHead = 64;  // the number of segments and 15 offsets

std::size_t number(const std::vector<unsigned char>& bytes, std::size_t index) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = (value << 8U) | bytes[4 * index + i];
  return value;
}

/// To every `step`-th byte, `count` of them.
bool unpackSegment(const unsigned char* from, const unsigned char* end, std::size_t count,
                   std::size_t step, unsigned char* to) {
  while (count > 0) {
    if (from == end) return false;
    const std::size_t code = *from++;
    if (code == 128) continue;
    const bool repeated = code > 128;
    const std::size_t length = std::min(repeated ? 257 - code : code + 1, count);
    if (static_cast<std::size_t>(end - from) < (repeated ? 1 : length)) return false;
    for (std::size_t i = 0; i < length; ++i, to += step) *to = repeated ? *from : from[i];
    from += repeated ? 1 : length;
    count -= length;
  }
  return true;
}

}  // namespace

bool unpackRle(const std::vector<unsigned char>& packed, std::size_t pixels, std::size_t wordBytes,
               unsigned char* words) {
  if (packed.size() < kHead || number(packed, 0) != wordBytes) return false;
  for (std::size_t s = 0; s < wordBytes; ++s) {
    const std::size_t begin = number(packed, s + 1);
    const std::size_t end = s + 1 < wordBytes ? number(packed, s + 2) : packed.size();
    if (begin < kHead || end < begin || end > packed.size()) return false;
    // The most significant bytes come first.
    if (!unpackSegment(packed.data() + begin, packed.data() + end, pixels, wordBytes,
                       words + (wordBytes - 1 - s)))
      return false;
  }
  return true;
}

}  // namespace angiomesh
