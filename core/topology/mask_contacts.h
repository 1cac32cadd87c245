// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// Which voxels of a mask are joined: those that share a face (6 neighbours), an edge too (18), or
/// a corner too (26).
enum class MaskConnectivity { Faces, Edges, Corners };

/// What was done where voxels of a mask touch by an edge or a corner alone.
struct MaskContacts {
  std::size_t joined = 0, parted = 0;
  std::size_t left = 0;  ///< where the surface still goes the other way
};

/// Joins or parts the surface phi = 0 where voxels of a mask touch by an edge or a corner alone, as
/// `connectivity` says and wherever it went the other way. phi is changed at the voxels around such
/// contacts, until the spline through it (wallField()) has the right sign between them: of parted
/// voxels the others around are outside, joined ones are inside.
/// @param phi signed distance of the mask, mm, negative inside, as smooth as it may be
/// @throws Cancelled
MaskContacts settleContacts(Volume<float>& phi, const Volume<std::uint8_t>& mask,
                            MaskConnectivity connectivity, const Progress& progress = {});

/// In words, with what to do; empty: nothing was done.
std::string contactText(const MaskContacts& contacts);

}  // namespace angiomesh
