// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/cuts/cuts.h"
#include "core/openings/port.h"

namespace angiomesh {

/// Where phi < 0 meets the outermost planes of voxel centres: each part of a plane is one opening,
/// without a name, as the surface has them; areas to a share of a voxel.
std::vector<Port> borderOpenings(const Volume<float>& phi);

/// Adds to `away` a cut across the vessel just inside each opening whose slant is flagged, where no
/// cut of `away` has taken that end already. It gets the name that `params` has for the opening's
/// place, else across_1 and on. @returns remarks: openings that could not be cut, and why
/// @throws Cancelled
std::vector<std::string> addBorderCuts(const SplineField& field, const Volume<float>& phi,
                                       CutAway& away, const PortParams& params = {},
                                       const Progress& progress = {});

}  // namespace angiomesh
