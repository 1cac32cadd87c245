// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "core/image/volume.h"
#include "core/vesselness/speed.h"

namespace angiomesh {

/// phi_t of eq. 3.20 at a voxel beside the front. Units are working voxels. Keeps a reference to
/// the vesselness.
class FrontSpeed {
 public:
  FrontSpeed(const Volume<float>& vesselness, const Thresholds& thresholds, double gamma, double d,
             bool acrossCrests);

  /// -(gamma p |grad phi| + (1 - gamma) |d kappa| |grad phi|): p from the vesselness interpolated
  /// at the zero crossing nearest to the voxel, kappa by central differences (eq. 3.4) limited to
  /// 2, |grad phi| by the upwind scheme of Osher and Sethian (1988), the curvature term upwinded as
  /// an expansion.
  [[nodiscard]] float change(const Volume<float>& phi, std::size_t voxel) const;

  /// kappa = div(grad phi / |grad phi|) by central differences, 1 / working voxel, unlimited: 2 / r
  /// on a ball.
  [[nodiscard]] double curvature(const Volume<float>& phi, std::size_t voxel) const;

 private:
  struct Neighbourhood;
  [[nodiscard]] Neighbourhood gather(const Volume<float>& phi, std::size_t voxel) const;
  [[nodiscard]] double curvature(const Volume<float>& phi, const Neighbourhood& n) const;
  [[nodiscard]] double vesselnessAtFront(const Neighbourhood& n) const;

  const Volume<float>& vesselness_;
  Thresholds thresholds_;
  double gamma_, d_;
  bool acrossCrests_;
  std::array<double, 3> inverseStep_{};  ///< working voxels per voxel, inverted
};

}  // namespace angiomesh
