// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/phantom/shape.h"

namespace angiomesh {

/// Adds to the image of `phantom` what is bright in scans and no vessel, and fills `clutter` and
/// `pieces`. Where each piece lies follows from the vessels and the random seed:
/// - shell (label 1): a rounded box of 3 mm, like a scalp, 2 voxels inside the volume's border;
/// - plate (2): 2 mm thick, a quarter of the shortest side wide, on the way of no vessel;
/// - blobs (3): two balls of 5 mm and one of 15 mm in diameter;
/// - bone (4): a cap of a ball's shell, 3 mm thick, 12 mm in radius, brighter than the vessels,
///   that touches the wall of one of them;
/// - vein (5): a tube 2 voxels beside one of the vessels, of that one's radius: a true vessel, but
///   not of the truth;
/// - slabs: four steps in z, added to all voxels.
/// Nothing of 1, 2, 3 comes nearer than 3 voxels to a vessel and nothing of 5 nearer than 1.5: what
/// would is left out. The bone ends at the walls.
/// @throws InputError when the volume's shortest side is below 40 mm or 40 voxels
void addClutter(Phantom& phantom, const PhantomParams& params, const Shape& shape,
                const Progress& progress);

}  // namespace angiomesh
