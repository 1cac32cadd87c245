// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace angiomesh {

/// Unpacks a frame of DICOM's run-length encoding (PS3.5 annex G) to `pixels` little-endian words
/// of `wordBytes` each. Bytes that are left over do no harm. False when there are too few, or the
/// head names other segments. DCMTK's decoder reads behind the end of damaged ones.
bool unpackRle(const std::vector<unsigned char>& packed, std::size_t pixels, std::size_t wordBytes,
               unsigned char* words);

}  // namespace angiomesh
