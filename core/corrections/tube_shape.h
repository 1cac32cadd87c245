// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/image/voxel_box.h"

namespace angiomesh {

/// What is to be added to a segmentation or taken out of it, on the voxels of a box of its grid.
struct Shape {
  VoxelBox box;
  Volume<float> phi;  ///< distance to it, mm, negative in it; right near its surface
};

/// All within a radius, which changes evenly from point to point, of a line of points in mm LPS.
/// @param radiiMm one for each point   @returns an empty volume where that lies beyond the grid
Shape tubeShape(const Geometry& grid, const std::vector<Eigen::Vector3d>& pointsLps,
                const std::vector<double>& radiiMm);

/// phi of a segmentation with a shape added, or taken out. Where both surfaces meet at an angle the
/// edge between them gets a fillet of about a voxel; where they run along each other there is none.
/// @returns the box of the voxels that changed; nothing changed where it is empty
std::optional<VoxelBox> addShape(Volume<float>& phi, const Shape& shape);
std::optional<VoxelBox> takeShape(Volume<float>& phi, const Shape& shape);

}  // namespace angiomesh
