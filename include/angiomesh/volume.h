// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Volumes: voxels on a grid in patient space (LPS, mm).
#include "core/image/volume.h"
