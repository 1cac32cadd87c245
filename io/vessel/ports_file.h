// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/openings/port.h"

namespace angiomesh {

/// MeshWriteOptions::patchNames of a mesh with these ports.
std::vector<std::string> patchNamesOf(const std::vector<Port>& ports);

/// Writes the ports in their order, with their kind (`cut` or `border`) and the slant of those that
/// have one (`vessel`), as JSON (schema 1, LPS, mm), to a temporary name, then renames.
/// @throws InputError: a port without a name, with another's or the wall's, or with a measure that
/// is no number   @throws IoError; nothing is left behind
void writePorts(const std::vector<Port>& ports, const std::filesystem::path& path);

/// Reads what writePorts() wrote: each key must be there and no other, normals of length 1 and
/// diameters of the areas within a thousandth. Without a kind a port is at the border that has a
/// slant or a name such as border_1. @throws IoError: no readable JSON
/// @throws InputError that names the place, such as ports[1].normal
std::vector<Port> readPorts(const std::filesystem::path& path);

}  // namespace angiomesh
