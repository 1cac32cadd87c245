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
struct Projection {
  int width = 0, height = 0;
  std::vector<float> values;
};
Projection maximumProjection(const Volume<float>& image, int axis);

/// The pictures of preview.png: MIPs along the three grid axes in patient orientation (anterior
/// view and so on, pixels square), of the image in the upper row and of the vessels (depth-shaded)
/// in the lower row. `phi` may live on another grid than `image`.
Picture previewPicture(const Volume<float>& image, const Volume<float>& phi);

}  // namespace angiomesh
