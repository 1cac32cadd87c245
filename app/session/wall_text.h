// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "core/quality/wall_accuracy.h"

namespace angiomesh::cli {

/// `wall` of docs/report.md. @param voxelMm the unit of the radius classes
nlohmann::ordered_json wallJson(const WallAccuracy& wall, double voxelMm);

/// The same as a table, lengths in voxels.
void printWallAccuracy(const WallAccuracy& wall, double voxelMm);

}  // namespace angiomesh::cli
