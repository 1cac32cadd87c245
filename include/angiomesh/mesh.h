// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Triangle meshes.
#include "core/mesh/mesh_edges.h"
#include "core/mesh/tri_mesh.h"
