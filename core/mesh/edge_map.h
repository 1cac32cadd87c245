// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace angiomesh {

/// Directed edges (from, to) of a mesh -> the triangle on their left. The edges that leave a vertex
/// lie together in blocks of one cache line, as a query's neighbours are likely to be asked next.
class EdgeMap {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;
  static constexpr std::uint32_t rim = 0xfffffffeU;  ///< nothing will ever lie there

  void reserve(std::size_t vertices) { first_.reserve(vertices); }

  /// The triangle, or none.
  [[nodiscard]] std::uint32_t find(std::uint32_t from, std::uint32_t to) const {
    if (from >= first_.size()) return none;
    for (const Block* block = &first_[from];; block = &more_[block->next]) {
      for (std::size_t i = 0; i < kSlots; ++i)
        if (block->to[i] == to) return block->value[i];
      if (block->next == none) return none;
    }
  }
  [[nodiscard]] bool has(std::uint32_t from, std::uint32_t to) const {
    return find(from, to) != none;
  }

  /// An edge that is set to `none` is given up.
  void set(std::uint32_t from, std::uint32_t to, std::uint32_t triangle) {
    if (from >= first_.size()) first_.resize(from + std::size_t{1});
    Block* open = nullptr;  // the first block with room
    std::size_t room = 0;
    Block* block = &first_[from];
    for (;; block = &more_[block->next]) {
      for (std::size_t i = 0; i < kSlots; ++i) {
        if (block->to[i] == to) {
          block->value[i] = triangle;
          if (triangle == none) block->to[i] = none;
          return;
        }
        if (open == nullptr && block->to[i] == none) {
          open = block;
          room = i;
        }
      }
      if (block->next == none) break;
    }
    if (triangle == none) return;
    if (open == nullptr) {
      block->next = static_cast<std::uint32_t>(more_.size());
      open = &more_.emplace_back();
    }
    open->to[room] = to;
    open->value[room] = triangle;
  }

 private:
  static constexpr std::size_t kSlots = 7;

  struct alignas(64) Block {
    Block() {
      to.fill(none);
      value.fill(none);
    }
    std::array<std::uint32_t, kSlots> to;  ///< none: free, and so is its value
    std::uint32_t next = none;             ///< in `more_`
    std::array<std::uint32_t, kSlots> value;
  };

  std::vector<Block> first_;  ///< per vertex
  std::vector<Block> more_;   ///< of vertices that more edges leave
};

}  // namespace angiomesh
