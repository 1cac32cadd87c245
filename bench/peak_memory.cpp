// SPDX-License-Identifier: BSD-3-Clause
#include "bench/peak_memory.h"

#include <fstream>
#include <string>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace angiomesh::bench {
namespace {

double statusMb(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key + ":")) return std::stod(line.substr(key.size() + 1)) / 1024.0;
  return -1.0;
}

}  // namespace

PeakMemory::PeakMemory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
  std::ofstream reset("/proc/self/clear_refs");
  // 5 sets the largest resident size back to the present one (proc(5)).
  if (reset << "5" && reset.flush()) before_ = statusMb("VmRSS");
}

double PeakMemory::addedMb() const {
  const double peak = statusMb("VmHWM");
  return before_ < 0.0 || peak < 0.0 ? -1.0 : peak - before_;
}

}  // namespace angiomesh::bench
