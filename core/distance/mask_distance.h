// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

struct MaskDistance {
  Volume<float> phi;
  double largestShiftVoxels = 0.0;  ///< of the surface from the voxel faces along grid edges, < 0.5
  double maskVolumeMm3 = 0.0;       ///< of its voxels, those at the volume's border by the share of
                                    ///< them that lies between the outermost voxel centres
};
/// A smooth signed distance in mm (negative inside, clamped at +-5 working voxels) to a surface
/// between the voxels of a mask: phi < 0 where mask != 0 and nowhere else, so that the surface
/// crosses each grid edge between two voxel centres of different kind, at most half a voxel from
/// the face between them, and nothing of the mask is lost, however thin.
///
/// Of all such surfaces one is taken that is smooth: phi minimises the square of its Laplacian over
/// a band, with bounds that keep every voxel on its side and within the distance of the nearest
/// voxel of the other kind (after Whitaker 2000, "Reducing aliasing artifacts in iso-surfaces of
/// binary volumes", and Lempitsky 2010, "Surface extraction from binary volumes with higher-order
/// smoothness"), and is shifted, by an amount that varies slowly along it, until it encloses as
/// much volume as the voxels do. Smoothing goes by voxels, whatever the spacing, because a mask is
/// uncertain by half a voxel in each direction. The same for any number of threads.
/// @throws InputError when the mask is empty or full, Cancelled
MaskDistance distanceOfMask(const Volume<std::uint8_t>& mask, const Progress& progress = {});

/// Of a mask's voxels, as MaskDistance counts them, mm3.
double volumeBetweenCentres(const Volume<std::uint8_t>& mask);

}  // namespace angiomesh
