// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace angiomesh {

/// Disjoint sets over 0..n-1 with the smallest member as representative.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count);
  std::uint32_t find(std::uint32_t item);
  void join(std::uint32_t a, std::uint32_t b);
  /// The number of one more item, a set of its own.
  std::uint32_t add();

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace angiomesh
