// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace angiomesh {

/// Whether sequences stand in sequences of a DICOM file more than a hundred deep, or there are some
/// in its group 2. DCMTK's reader calls itself for each level, until the stack is full and the
/// program ends. A deflated data set is not looked into.
bool nestsTooDeeply(const std::filesystem::path& file);

}  // namespace angiomesh
