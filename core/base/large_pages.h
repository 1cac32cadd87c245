// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace angiomesh {

/// Memory for big arrays, in pages of 2 MB where the system has them: the first touch of a volume
/// in pages of 4 kB costs more time than most filters. @throws std::bad_alloc
void* allocateLargePages(std::size_t bytes);
void freeLargePages(void* memory, std::size_t bytes) noexcept;

/// Gives memory that was freed, but that the C library keeps for later, back to the system: between
/// stages whose arrays differ in size it is of no use to the next one.
void releaseFreedMemory() noexcept;

template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class U>
  LargePages(const LargePages<U>& /*other*/) noexcept {}

  T* allocate(std::size_t count) { return static_cast<T*>(allocateLargePages(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) noexcept {
    freeLargePages(memory, count * sizeof(T));
  }

  friend bool operator==(const LargePages& /*a*/, const LargePages& /*b*/) { return true; }
};

/// A vector that may be as long as a volume.
template <class T>
using BigVector = std::vector<T, LargePages<T>>;

}  // namespace angiomesh
