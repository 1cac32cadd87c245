// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "render/surface/drawn_volume.h"

namespace angiomesh {

/// How a volume is seen in 3D: not, by its maximum intensity projection, as a lit body with the
/// colours of a preset, or, of a distance function, what is inside (below 0) as a white shape.
enum class VolumeView { None, Mip, MrAngio, CtAngio, Inside };

/// How a value is seen by a ray. Between two of them all goes linearly; below the first nothing is
/// seen, beyond the last all is seen as there.
struct TransferPoint {
  double value = 0.0;
  std::array<double, 3> colour{1.0, 1.0, 1.0};
  double opacity = 0.0;  ///< 0..1, of one voxel's way through it
};

/// The greatest value of a ray, the least one, or all of them lit, from front to back.
enum class RayKind { Greatest, Least, Lit };

struct VolumeLook {
  RayKind kind = RayKind::Greatest;
  /// Rising values, at least two. Least: nothing is seen beyond the last, all below the first.
  std::vector<TransferPoint> transfer;
};

/// From transparent to white between two values.
VolumeLook projectionLook(double from, double to);
/// MrAngio follows the brightness of the volume, CtAngio takes its values for HU. @pre not None
VolumeLook lookOf(VolumeView view, const DrawnVolume& volume);

}  // namespace angiomesh
