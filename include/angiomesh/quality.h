// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What a mesh is worth to a solver, and how well a segmentation agrees with another.
#include "core/quality/mesh_quality.h"
#include "core/quality/overlap.h"
#include "core/quality/quality_table.h"
