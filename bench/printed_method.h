// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/itk_fronts.h"
#include "bench/itk_hessian.h"
#include "core/image/volume.h"
#include "core/parameters/parameters.h"

namespace angiomesh::bench {

struct PrintedMethodResult {
  Volume<float> vesselness;  ///< v of eq. 3.22, largest magnitude over the scales
  Thresholds thresholds;
  std::size_t seeds = 0;
  ItkFront front;
  double vesselnessSeconds = 0.0, frontSeconds = 0.0;
};

/// The method as the thesis prints it, from ITK's filters and none of ours: Hessian, eigenvalues,
/// eq. 3.22 over the scales of eq. 5.1-5.2, thresholds by eq. 3.20 and their clamping, seeds at
/// sigma_avg, fast marching, sparse field. Reads of `params` what the preset `thesis` leaves to
/// choose: sigmas in mm, alpha, beta, cFraction, topPercent, radiusVoxels, gamma, d, xi, bMin, bMax
/// and the rule of convergence.
/// @throws NumericError when no voxel looks like a vessel
PrintedMethodResult printedMethod(const Volume<float>& image, const Parameters& params,
                                  ItkHessian hessian = ItkHessian::Discrete,
                                  ItkSolver solver = ItkSolver::Serial);

}  // namespace angiomesh::bench
