// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace angiomesh {

/// A new DICOM UID, from a random UUID (PS3.5 B.2): it says nothing of the machine or the time.
std::string newDicomUid();

}  // namespace angiomesh
