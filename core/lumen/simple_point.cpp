// SPDX-License-Identifier: BSD-3-Clause
#include "core/lumen/simple_point.h"

#include <cstdlib>

namespace angiomesh {
namespace {

constexpr std::uint32_t kMiddle = 1U << 13;

struct Tables {
  std::array<std::uint32_t, 27> all{}, faces{};    ///< neighbours of each place among the 27
  std::uint32_t faceOfMiddle = 0, nearMiddle = 0;  ///< nearMiddle: those that share face or edge
};

constexpr int distance(int a, int b) { return a > b ? a - b : b - a; }

constexpr Tables makeTables() {
  Tables t;
  for (int a = 0; a < 27; ++a)
    for (int b = 0; b < 27; ++b) {
      const int dx = distance(a % 3, b % 3), dy = distance(a / 3 % 3, b / 3 % 3),
                dz = distance(a / 9, b / 9);
      const int sum = dx + dy + dz;
      if (sum == 0 || dx > 1 || dy > 1 || dz > 1) continue;
      const auto bit = 1U << static_cast<unsigned>(b);
      t.all[static_cast<std::size_t>(a)] |= bit;
      if (sum == 1) t.faces[static_cast<std::size_t>(a)] |= bit;
      if (a == 13 && sum == 1) t.faceOfMiddle |= bit;
      if (a == 13 && sum <= 2) t.nearMiddle |= bit;
    }
  return t;
}
constexpr Tables kTables = makeTables();

/// What can be reached from `start` within `among`.
std::uint32_t reached(std::uint32_t start, std::uint32_t among,
                      const std::array<std::uint32_t, 27>& neighbours) {
  std::uint32_t found = start, open = start;
  while (open != 0) {
    const auto at = static_cast<std::size_t>(__builtin_ctz(open));
    open &= open - 1U;
    const std::uint32_t fresh = neighbours[at] & among & ~found;
    found |= fresh;
    open |= fresh;
  }
  return found;
}

}  // namespace

bool isSimplePoint(Neighbourhood object) {
  const std::uint32_t inside = object & ~kMiddle & ((1U << 27) - 1U);
  const std::uint32_t outside = ~object & kTables.nearMiddle;
  const std::uint32_t touching = outside & kTables.faceOfMiddle;
  if (inside == 0 || touching == 0) return false;
  const std::uint32_t oneInside = inside & (~inside + 1U);
  if (reached(oneInside, inside, kTables.all) != inside) return false;
  const std::uint32_t oneOutside = touching & (~touching + 1U);
  return (touching & ~reached(oneOutside, outside, kTables.faces)) == 0;
}

}  // namespace angiomesh
