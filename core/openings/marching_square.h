// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace angiomesh {

/// The pieces of a contour in a square whose corners are inside or not, counter-clockwise: calls
/// join(from, to) with the sides (side k goes from corner k to the next) where a piece begins,
/// which is crossed inwards counter-clockwise, and where it ends. `joined()` tells, where two
/// opposite corners alone are inside, whether they are one piece of the inside.
template <class Joined, class Join>
void forEachPiece(const std::array<bool, 4>& inside, Joined joined, Join join) {
  std::array<std::size_t, 2> enters{}, exits{};
  std::size_t entering = 0, exiting = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (inside[k] && !inside[(k + 1) % 4]) exits[exiting++] = k;
    if (!inside[k] && inside[(k + 1) % 4]) enters[entering++] = k;
  }
  if (entering == 1) join(enters[0], exits[0]);
  if (entering < 2) return;
  const std::size_t turn = joined() ? 3 : 1;
  for (const std::size_t from : enters) join(from, (from + turn) % 4);
}

}  // namespace angiomesh
