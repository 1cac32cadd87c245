// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "core/centreline/skeleton.h"

namespace angiomesh {

/// "tip", "junction", "border" or "ring".
const char* nodeKindName(NodeKind kind);

/// @throws InputError unless the extension is .csv or .vtp
void checkSkeletonFile(const std::filesystem::path& path);

/// Writes .csv or .vtp by extension, to a temporary name, then renames. Lengths in mm, points LPS.
///
/// CSV: a header and one row for each branch, numbers that read back as the same double.
///
/// VTP: a polyline for each branch. Point data `Radius` (of the circle of the section's area) and
/// `MaximumInscribedSphereRadius` (from the section's centre to the nearest wall in it), the names
/// of 3D Slicer and VMTK; cell data `BranchId` (VMTK's `GroupIds` too), `ComponentId`, `FromNode`,
/// `ToNode`, `Length` and `MeanRadius`. Frame and unit are stated as in mesh files.
/// @throws InputError (another extension), IoError; nothing is left behind
void writeSkeleton(const Skeleton& skeleton, const std::filesystem::path& path);

}  // namespace angiomesh
