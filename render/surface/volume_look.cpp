// SPDX-License-Identifier: BSD-3-Clause
#include "render/surface/volume_look.h"

#include <algorithm>
#include <cmath>

namespace angiomesh {

namespace {

using Colour = std::array<double, 3>;
constexpr Colour kDarkRed{0.45, 0.09, 0.07}, kRed{0.80, 0.25, 0.16}, kSkin{0.95, 0.70, 0.52},
    kIvory{1.0, 0.96, 0.88};

VolumeLook mrAngio(const DrawnVolume& volume) {
  const auto [from, to] = volume.vessels;
  const auto between = [from = from, to = to](double share) { return from + share * (to - from); };
  return {RayKind::Lit,
          {{from, kDarkRed, 0.0},
           {between(0.35), kRed, 0.12},
           {between(0.7), kSkin, 0.5},
           {between(1.2), kIvory, 0.9}}};
}

/// In HU: contrast medium in vessels from 150 up, calcifications and cortical bone from 600.
VolumeLook ctAngio() {
  return {RayKind::Lit,
          {{130.0, kDarkRed, 0.0}, {200.0, kRed, 0.12}, {350.0, kSkin, 0.5}, {600.0, kIvory, 0.9}}};
}

/// Half a voxel wide, as an edge is smooth on a screen.
VolumeLook inside(const DrawnVolume& volume) {
  const double half = 0.25 * volume.image->geometry.voxelMm();
  return {RayKind::Least, {{-half, kIvory, 1.0}, {half, kIvory, 0.0}}};
}

}  // namespace

VolumeLook projectionLook(double from, double to) {
  const double end = std::max(to, from + 1e-6 * std::max(1.0, std::abs(from)));
  constexpr Colour white{1.0, 1.0, 1.0};
  return {RayKind::Greatest, {{from, white, 0.0}, {end, white, 1.0}}};
}

VolumeLook lookOf(VolumeView view, const DrawnVolume& volume) {
  switch (view) {
    case VolumeView::MrAngio:
      return mrAngio(volume);
    case VolumeView::CtAngio:
      return ctAngio();
    case VolumeView::Inside:
      return inside(volume);
    case VolumeView::None:
    case VolumeView::Mip:
      break;
  }
  return projectionLook(volume.bright[0], volume.bright[1]);
}

}  // namespace angiomesh
