// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "render/surface/volume_look.h"

namespace angiomesh {

/// Rays from an eye through the middles of a picture's pixels, in the indices of a volume: at depth
/// 1 mm in front of the eye they are at eye + forward + x * right + y * up, x and y from -1 to 1
/// across the picture.
struct CastView {
  Eigen::Vector3d eye, forward, right, up;
  Eigen::Vector3d lightAxes;  ///< towards the light, a unit vector along the volume's axes
  Eigen::Vector3d eyeAxes;    ///< towards the viewer, likewise
  int width = 0, height = 0;  ///< pixels
};

/// What a volume looks like along the rays: RGBA, colours multiplied by the opacity, rows from the
/// bottom. In parallel.
/// @param stepMm between the samples, in depth   @param depthsMm at which each pixel's ray ends;
/// empty: none does
std::vector<std::uint8_t> castRays(const DrawnVolume& volume, const VolumeLook& look,
                                   const CastView& view, double stepMm,
                                   const std::vector<float>& depthsMm = {});

}  // namespace angiomesh
