// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace angiomesh {

/// How long the edges of the surface are to be (thesis 4.2).
struct SizingParams {
  double rho = 0.4;  ///< eq. 4.1, radians: the angle an edge subtends on the osculating circle
  double etaInverse = 0.8;      ///< 1/eta of eq. 4.2
  bool etaCompensated = true;   ///< eq. 4.4: the ideal length is not scaled by 1/eta
  double curvatureRelax = 1.0;  ///< kappa_max is divided by it
  int edgesAround = 12;         ///< at least so many edges around any vessel; 0: no limit
  std::optional<double> edgeMinMm, edgeMaxMm;
};

}  // namespace angiomesh
