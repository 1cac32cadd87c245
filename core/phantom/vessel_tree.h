// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/phantom/shape_frame.h"

namespace angiomesh {

/// A tree of bent vessels with an aneurysm, drawn by the random seed, in the volume's largest cube:
/// a main vessel that enters along the axis and tapers from radius 1.55 r to 0.8 r, branches and
/// twigs on its sides down to 0.325 r (r = 4 voxels: 6.2 to 1.3), as many as find room, with ball
/// tips inside the volume, and a ball of 1.3 times the main vessel's radius there on a narrower
/// neck. A smooth union over 0.4 r; vessels that do not join keep 3 voxels apart. No handles.
void buildVesselTree(Shape& shape, const ShapeFrame& frame, std::uint64_t randomSeed);

}  // namespace angiomesh
