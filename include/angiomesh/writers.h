// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Images, meshes and solver cases to files.
#include "io/mesh/mesh_io.h"
#include "io/vessel/openfoam_case.h"
#include "io/vessel/patch_files.h"
#include "io/volume/image_write.h"
