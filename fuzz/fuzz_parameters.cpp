// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/fuzz_parameters.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  angiomesh::fuzz::readParametersInput(data, size);
  return 0;
}
