// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>
#include <vector>

namespace angiomesh {

/// Memory for big arrays, in pages of 2 MB where the system has them: the first touch of a volume
/// in pages of 4 kB costs more time than most filters. @throws std::bad_alloc
void* allocateLargePages(std::size_t bytes);
void freeLargePages(void* memory, std::size_t bytes) noexcept;

/// Gives memory that was freed, but that the C library keeps for later, back to the system: between
/// stages whose arrays differ in size it is of no use to the next one.
void releaseFreedMemory() noexcept;

/// Bytes of memory that the machine has; 0 when that is not known.
std::uint64_t physicalMemory() noexcept;

template <class T>
struct LargePages {
  using value_type = T;
  using is_always_equal = std::true_type;

  /// Whether values that come without an initial value become T(). Off, the memory is touched by
  /// whoever writes it first; see unfilled().
  bool fill = true;

  LargePages() = default;
  template <class U>
  LargePages(const LargePages<U>& /*other*/) noexcept {}
  [[nodiscard]] LargePages select_on_container_copy_construction() const { return {}; }

  T* allocate(std::size_t count) { return static_cast<T*>(allocateLargePages(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) noexcept {
    freeLargePages(memory, count * sizeof(T));
  }
  template <class U>
  void construct(U* place) {
    if (fill) ::new (static_cast<void*>(place)) U();
  }

  friend bool operator==(const LargePages& /*a*/, const LargePages& /*b*/) { return true; }
};

/// A vector that may be as long as a volume.
template <class T>
using BigVector = std::vector<T, LargePages<T>>;

/// `count` values for a parallel loop to write before anything reads them: a pass that only fills
/// them would cost as much as the loop. Move it into a vector that exists already: that one fills
/// what it adds later, as ever.
template <class T>
BigVector<T> unfilled(std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  LargePages<T> memory;
  memory.fill = false;
  return BigVector<T>(count, memory);
}

}  // namespace angiomesh
