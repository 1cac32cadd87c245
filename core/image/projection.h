// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/image/volume.h"

namespace angiomesh {

/// An RGB picture, rows from the top, 8 bits per channel.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Largest value along grid axis 0, 1 or 2. Result: the two other axes in order, x fastest.
/// @throws InputError for another axis or an empty volume
struct Projection {
  int width = 0, height = 0;
  std::vector<float> values;
};
Projection maximumProjection(const Volume<float>& image, int axis);

/// Which patient axis (0 L, 1 P, 2 S) each grid axis is nearest to, one each.
std::array<int, 3> nearestPatientAxes(const Geometry& g);

/// The MIP of an image from the front, head up, in greys from the 1st to the 99.8th percentile; its
/// pixels are square, and the volume's longest side would have `longestSide` of them.
/// @throws InputError when the image is empty
Picture mipFromTheFront(const Volume<float>& image, int longestSide);

/// The pictures of preview.png: coronal from the front, sagittal from the patient's left, axial
/// from the feet, each along the grid axis that is nearest, pixels square, one scale for all, the
/// longest side 480 pixels. Upper row: MIP of the image from the 1st to the 99.8th percentile;
/// lower row: the vessels (phi < 0) shaded, nearer ones lighter. Letters name the sides: patient's
/// right on the left, anterior on the left, head or anterior up. `phi` may live on another grid
/// than `image`.
/// @throws InputError when either is empty
Picture previewPicture(const Volume<float>& image, const Volume<float>& phi);

}  // namespace angiomesh
