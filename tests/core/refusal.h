// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/base/error.h"

namespace angiomesh {

/// What the InputError says that some work throws; empty where it throws none.
template <class Work>
std::string messageOf(Work work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace angiomesh
