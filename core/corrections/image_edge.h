// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/corrections/tube_shape.h"
#include "core/vesselness/vesselness.h"

namespace angiomesh {

/// Of a brush's tube the part that the image shows as vessel: what is connected to the tube's
/// middle and brighter than half-way between what is brightest there and the surroundings of the
/// tube that phi leaves outside.
/// @param image on phi's grid   @throws InputError where the middle is not brighter than those
Shape vesselInTube(const Volume<float>& image, Polarity polarity, const Volume<float>& phi,
                   const Shape& tube);

/// Of a brush's tube the part that the image does not show as vessel: what is not as bright as
/// half-way between the vessels beside the tube and the surroundings.
/// @throws InputError where there is no vessel within 5 working voxels of the tube, or it is not
/// brighter
Shape backgroundInTube(const Volume<float>& image, Polarity polarity, const Volume<float>& phi,
                       const Shape& tube);

}  // namespace angiomesh
