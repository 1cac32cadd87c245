// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/image/volume.h"
#include "core/levelset/evolution.h"

namespace angiomesh::bench {

enum class ItkSolver { Serial, Parallel };

struct ItkFront {
  Volume<float> phi;  ///< sparse-field phi, working voxels
  int iterations = 0;
  StopReason stop = StopReason::Running;
};

/// itk::SparseFieldLevelSetImageFilter or itk::ParallelSparseFieldLevelSetImageFilter with the
/// thesis's F = gamma p + (1 - gamma) |d kappa| (eq. 3.19), p of eq. 3.21 from the vesselness
/// interpolated at the zero crossing and upwinded by ITK, |kappa| <= 2 / voxel by central
/// differences and upwinded as an expansion. Stops by the rule of LevelSetEvolution; the time step
/// is ITK's, |grad phi| on crests as params.acrossCrests says. `phi0`: signed distance, working
/// voxels.
ItkFront evolveItk(const Volume<float>& vesselness, const Thresholds& thresholds,
                   const Volume<float>& phi0, const LevelSetParams& params, ItkSolver solver);

}  // namespace angiomesh::bench
