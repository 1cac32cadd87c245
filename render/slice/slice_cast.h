// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "core/image/volume.h"
#include "render/slice/pane_axes.h"
#include "render/slice/slice_raster.h"

namespace angiomesh {

/// The value of a pixel where no voxel lies.
constexpr float kOutside = std::numeric_limits<float>::lowest();

/// First and last slice of a slab of `thicknessMm` around `slice`, inside the grid: the number of
/// slices nearest to the thickness, at least one.
std::array<int, 2> slabSlices(const Geometry& grid, const PaneAxes& axes, int slice,
                              double thicknessMm);

/// The values of an image in slices first..last of a grid, combined by `mode`, in screen order:
/// rows from the bottom. On the image's own grid they are its voxels, on another one trilinear. In
/// parallel.
void castSlab(const Volume<float>& image, const Geometry& grid, const PaneAxes& axes, SlabMode mode,
              int first, int last, std::vector<float>& values);

/// Trilinear value at a point: that of the nearest border in the outer half of the outermost
/// voxels, kOutside beyond.
float valueAt(const Volume<float>& image, const Eigen::Vector3d& lps);

}  // namespace angiomesh
