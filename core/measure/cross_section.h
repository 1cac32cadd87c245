// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/field/spline_field.h"
#include "core/measure/measurement.h"
#include "core/openings/section.h"

namespace angiomesh {

/// What callipers and planimetry say of a section; see CrossSection.
/// @param section with an outline
CrossSection crossSectionOf(const Section& section);

/// The vessel at a place, mm LPS, that lies inside it or up to 2 working voxels off its wall, cut
/// across its axis there.
/// @param wall signed distance, mm, negative inside
/// @throws InputError where there is no vessel, and where the border of the volume slices it
CrossSection crossSectionAt(const SplineField& wall, const Eigen::Vector3d& placeLps);

}  // namespace angiomesh
