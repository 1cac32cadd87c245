// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/large_pages.h"

#include <cstdint>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace angiomesh {
namespace {

constexpr std::size_t kPage = std::size_t{2} << 20;
constexpr std::size_t kLeast = 2 * kPage;  // below it the rounding up would waste too much

}  // namespace

void* allocateLargePages(std::size_t bytes) {
#ifdef __linux__
  if (bytes >= kLeast && bytes <= SIZE_MAX - kPage) {
    const std::size_t whole = (bytes + kPage - 1) / kPage * kPage;
    void* memory = std::aligned_alloc(kPage, whole);
    if (memory == nullptr) throw std::bad_alloc();
    // A refusal leaves small pages: slower, not wrong.
    static_cast<void>(madvise(memory, whole, MADV_HUGEPAGE));
    return memory;
  }
#endif
  return ::operator new(bytes);
}

void freeLargePages(void* memory, std::size_t bytes) noexcept {
#ifdef __linux__
  if (bytes >= kLeast) {
    std::free(memory);
    return;
  }
#endif
  ::operator delete(memory);
}

void releaseFreedMemory() noexcept {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

std::uint64_t physicalMemory() noexcept {
#ifdef __linux__
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGE_SIZE);
  if (pages > 0 && page > 0)
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
#endif
  return 0;
}

}  // namespace angiomesh
