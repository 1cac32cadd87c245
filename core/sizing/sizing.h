// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>

namespace angiomesh {

/// How long the edges of the surface are to be (thesis 4.2).
struct SizingParams {
  double rho = 0.05;  ///< eq. 4.1, radians: the angle an edge subtends on the osculating circle
  double etaInverse = 0.8;      ///< 1/eta of eq. 4.2
  bool etaCompensated = true;   ///< eq. 4.4: the ideal length is not scaled by 1/eta
  double curvatureRelax = 1.0;  ///< kappa_max is divided by it
  int edgesAround = 12;         ///< at least so many edges around any vessel; 0: no limit
  /// Curvature asks for no shorter edge than this, in edges of a cube as large as a voxel: images
  /// tell no more of the wall. But no edge spans more than 0.8 radian of a bend.
  std::optional<double> edgeMinVoxels = 0.4;
  std::optional<double> edgeMinMm, edgeMaxMm;

  /// What the ideal length is multiplied by (eqs. 4.2 and 4.4).
  [[nodiscard]] double startFactor() const { return etaCompensated ? 1.0 : etaInverse; }

  /// As the thesis has it: curvature alone, 1/eta shortens the edges too.
  static SizingParams printed(double rho = 0.4) {
    SizingParams params;
    params.rho = rho;
    params.etaCompensated = false;
    params.edgesAround = 0;
    params.edgeMinVoxels.reset();
    return params;
  }

  bool operator==(const SizingParams&) const = default;
};

/// How many equilateral triangles cover an area.
inline double evenTriangles(double areaMm2, double edgeMm) {
  return areaMm2 / (0.25 * std::sqrt(3.0) * edgeMm * edgeMm);
}

}  // namespace angiomesh
