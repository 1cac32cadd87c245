// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace angiomesh::bench {

/// Writes an axial MR series of uncompressed 16-bit slices, with the header that a scanner writes,
/// and returns the files. The order of the names is not that of the slices. @throws
/// std::runtime_error
std::vector<std::filesystem::path> writeDicomFolder(const std::filesystem::path& folder,
                                                    int columns, int rows, int slices);

}  // namespace angiomesh::bench
