// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/base/progress.h"
#include "core/phantom/shape.h"

namespace angiomesh {

/// Number (0..8) of the 2x2x2 subvoxels of each voxel, centred +-1/4 voxel around its centre, that
/// lie inside the shape. Parallel; the same for any number of threads.
Volume<std::uint8_t> countSubvoxels(const Shape& shape, const Geometry& geometry,
                                    const Progress& progress = {});

/// The shape's signed distance at the voxel centres, mm.
Volume<float> sampleField(const Shape& shape, const Geometry& geometry,
                          const Progress& progress = {});

}  // namespace angiomesh
