// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "io/mesh/mesh_io.h"

namespace angiomesh::cli {

/// "lps" or "ras", "mm" or "m", as the parser has checked them.
Frame frameFromOption(const std::string& word);
LengthUnit unitFromOption(const std::string& word);

/// Of the two words; empty: by the file's header.
MeshReadOptions meshReadOptions(const std::string& frame, const std::string& unit);

/// --keep-points and --merge-distance of a command that reads a mesh.
struct MeshReading {
  bool keepPoints = false;
  double mergeDistanceMm = 0.0;

  /// With meshReadOptions().
  [[nodiscard]] MeshReadOptions options(const std::string& frame = {},
                                        const std::string& unit = {}) const;
};
/// Adds both; returns them.
std::vector<CLI::Option*> addMeshReading(CLI::App& command, MeshReading& reading);

/// Names of a file's patches. Those of files that this program wrote (they state a key) are words
/// of its user, and kept. In files of anybody those that may be of files and patients become
/// numbers; `any`: there were some.
std::vector<std::string> plainPatchNames(const LoadedMesh& loaded, bool& any);

/// What a command that writes a surface does with one that a solver could not take.
struct Soundness {
  bool allowed = false;  ///< --allow-unsound
  std::string fault;     ///< "the surface cuts itself in ..."; empty: none

  /// Whether it may be written. Says so in a warning where it may although it has a fault.
  [[nodiscard]] bool mayWrite() const;
  /// One line on stderr; `left` says what of the result was written, in words. Returns the exit
  /// code.
  [[nodiscard]] int refuse(const std::string& left, const std::string& advice) const;
};
/// Adds --allow-unsound.
void addSoundness(CLI::App& command, Soundness& soundness);

/// Writes a mesh, says its warnings with `name`, and reads it back to see that the file holds it.
/// @throws as writeMesh() and checkMeshFile()
void writeChecked(const TriMesh& mesh, const std::filesystem::path& place, const std::string& name,
                  const MeshWriteOptions& options = {});

}  // namespace angiomesh::cli
