// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "io/file/mesh_number.h"

namespace angiomesh {

/// SimVascular's number of each cell's face, from 1 on, and the faces' names in their order.
inline constexpr const char* kFaceId = "ModelFaceID";
inline constexpr const char* kFaceNames = "ModelFaceNames";
/// VMTK's and Gmsh's number of each cell's face.
inline constexpr const char* kEntityIds = "CellEntityIds";

/// The value of an attribute within an XML tag; empty when there is none.
std::optional<std::string_view> xmlAttribute(std::string_view tag, std::string_view name);

/// How a VTK XML file stores its arrays.
struct VtpEncoding {
  Encoding order = Encoding::LittleEndian;
  std::size_t wordBytes = 4;  ///< of the numbers before the data
  std::string packer;         ///< class of VTK, empty: not packed
};

/// The bytes of one array out of its stored form, raw or base64, packed in blocks or not. `data`
/// may go on behind it. Memory is taken only for what unpacks. Empty: damaged.
std::optional<std::string> vtpArrayBytes(std::string_view data, bool raw,
                                         const VtpEncoding& encoding);

/// Unpacks one block with VTK's class `packer`, to exactly `size` bytes. False: damaged.
bool unpackWithVtk(const std::string& packer, std::string_view packed, std::size_t size,
                   std::string& bytes);

}  // namespace angiomesh
