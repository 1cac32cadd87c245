// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/mesh/mesh_io.h"

namespace angiomesh {

/// The triangles of one patch and their points: an open surface without patches.
TriMesh patchSurface(const TriMesh& mesh, std::size_t patch);

/// Writes each patch that has triangles to a file of its own beside `path`, "vessel_inlet.stl" for
/// vessel.stl, and reads it back; in the names of files, what is no letter, digit, '-' or '.'
/// becomes '_'. All files appear or none. `mesh` has patches; closed parts of it that face inward
/// are turned round in the files. @returns the files, in the patches' order
/// @param warnings if given, `path` is written too, the whole mesh as writeMesh() does, whose
/// warnings these are
/// @throws as writeMesh() and checkMeshFile(): what was there stays
std::vector<std::filesystem::path> writePatchFiles(const TriMesh& mesh,
                                                   const std::filesystem::path& path,
                                                   const MeshWriteOptions& options = {},
                                                   std::vector<std::string>* warnings = nullptr);

/// Names for folders, files and dictionaries: of letters, digits, '-', '_' and '.', not '.' first,
/// all different even where small and capital letters are the same.
std::vector<std::string> fileWords(const std::vector<std::string>& names);

/// Says of each name whose word has a number behind it, because another name would have become the
/// same word: "the patch 'in' is called in-2 `where`, ...".
std::vector<std::string> renamedWords(const std::vector<std::string>& names,
                                      const std::vector<std::string>& words,
                                      const std::string& where);

}  // namespace angiomesh
