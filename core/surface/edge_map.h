// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace angiomesh {

/// Directed edges (from, to) of a mesh -> the triangle on their left. Open addressing; entries are
/// never removed, an edge that is given up keeps the value `none`.
class EdgeMap {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;
  static constexpr std::uint32_t rim = 0xfffffffeU;  ///< nothing will ever lie there

  EdgeMap() : slots_(4096) {}

  /// The triangle, or none.
  [[nodiscard]] std::uint32_t find(std::uint32_t from, std::uint32_t to) const {
    const std::uint64_t key = keyOf(from, to);
    for (std::size_t i = start(key);; i = (i + 1) & (slots_.size() - 1)) {
      if (slots_[i].key == key) return slots_[i].value;
      if (slots_[i].key == kEmpty) return none;
    }
  }
  [[nodiscard]] bool has(std::uint32_t from, std::uint32_t to) const {
    return find(from, to) != none;
  }

  void set(std::uint32_t from, std::uint32_t to, std::uint32_t triangle) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    put(keyOf(from, to), triangle);
  }

 private:
  static constexpr std::uint64_t kEmpty = ~0ULL;
  struct Slot {
    std::uint64_t key = kEmpty;
    std::uint32_t value = none;
  };

  static std::uint64_t keyOf(std::uint32_t from, std::uint32_t to) {
    return (static_cast<std::uint64_t>(from) << 32U) | to;
  }
  [[nodiscard]] std::size_t start(std::uint64_t key) const {
    const std::uint64_t h = (key ^ (key >> 29U)) * 0x9e3779b97f4a7c15ULL;
    return static_cast<std::size_t>(h >> 20U) & (slots_.size() - 1);
  }
  void put(std::uint64_t key, std::uint32_t value) {
    std::size_t i = start(key);
    while (slots_[i].key != key && slots_[i].key != kEmpty) i = (i + 1) & (slots_.size() - 1);
    if (slots_[i].key == kEmpty) ++count_;
    slots_[i] = {key, value};
  }
  void grow() {
    std::vector<Slot> old(4 * slots_.size());
    old.swap(slots_);
    count_ = 0;
    for (const Slot& slot : old)
      if (slot.key != kEmpty && slot.value != none) put(slot.key, slot.value);
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

}  // namespace angiomesh
