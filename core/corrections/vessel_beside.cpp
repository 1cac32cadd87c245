// SPDX-License-Identifier: BSD-3-Clause
#include "core/corrections/vessel_beside.h"

#include <limits>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/centreline/vessel_at.h"
#include "core/field/wall_field.h"
#include "core/image/voxel_box.h"
#include "core/image/voxels.h"

namespace angiomesh {
namespace {

/// Voxels: a vessel's section, as far as phi tells its radius.
constexpr int kAround = 10;
/// Of the largest ball, a section's radius at most.
constexpr double kLargest = 1.3;

}  // namespace

std::optional<VesselBeside> vesselBeside(const Volume<float>& phi, const Eigen::Vector3d& placeLps,
                                         double reachVoxels) {
  const Geometry& g = phi.geometry;
  const double reach = (reachVoxels + 0.5) * g.voxelMm();
  const auto box = boxOf(g, {placeLps}, std::max(reach, 0.5 * g.spacing.maxCoeff()));
  if (!box) return std::nullopt;
  std::optional<VesselBeside> found;
  double nearest = std::numeric_limits<double>::max();
  for (int k = box->low[2]; k <= box->high[2]; ++k)
    for (int j = box->low[1]; j <= box->high[1]; ++j)
      for (int i = box->low[0]; i <= box->high[0]; ++i) {
        const double away = (voxelCentre(g, Index3{i, j, k}) - placeLps).norm();
        if (!(phi.at(i, j, k) < 0.0F) || away >= nearest) continue;
        nearest = away;
        found = VesselBeside{{i, j, k}, {i, j, k}, {0.0, 0.0, 0.0}, 0.0, 0.0};
      }
  if (!found) return std::nullopt;
  std::size_t at = g.offset(found->voxel[0], found->voxel[1], found->voxel[2]);
  for (std::size_t before = phi.voxels.size(); before != at;) {
    before = at;
    forNeighbours(g, before, [&](std::size_t, std::size_t next) {
      if (phi.voxels[next] < phi.voxels[at]) at = next;
    });
  }
  found->middle = g.indexOf(at);
  found->centreLps = voxelCentre(g, found->middle);
  found->radiusMm = found->ballMm = -static_cast<double>(phi.voxels[at]);
  const VoxelBox around = VoxelBox{found->middle, found->middle}.widened(kAround, g);
  const SplineField field = wallField(cropped(phi, around), SplineKind::InterpolatingBspline);
  // At a tip or in a branching no section is round: the ball tells enough then.
  const auto vessel = vesselAt(field, found->centreLps);
  if (vessel && vessel->radiusMm < kLargest * found->radiusMm + g.voxelMm()) {
    found->centreLps = vessel->centreLps;
    found->radiusMm = vessel->radiusMm;
  }
  return found;
}

VesselBeside requireVesselBeside(const Volume<float>& phi, const Eigen::Vector3d& placeLps,
                                 const char* where, const char* advice) {
  if (const auto vessel = vesselBeside(phi, placeLps)) return *vessel;
  throw InputError("there is no vessel at " + placeText(placeLps), where, advice);
}

}  // namespace angiomesh
