// SPDX-License-Identifier: BSD-3-Clause
#include "core/corrections/apply_correction.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/corrections/bridge_vessels.h"
#include "core/corrections/close_hole.h"
#include "core/corrections/cut_off.h"
#include "core/corrections/image_edge.h"
#include "core/corrections/separate_vessels.h"
#include "core/corrections/tube_shape.h"
#include "core/distance/cell_band.h"
#include "core/distance/redistance.h"
#include "core/image/voxels.h"

namespace angiomesh {
namespace {

constexpr double kBandVoxels = 5.0;
/// How far from where the wall moved phi may change, in voxels of the finest axis, and how much
/// farther the walls lie that may be the nearest one then, with what their interpolant reaches.
constexpr int kReach = 5, kMargin = 9;
/// Working voxels: so near to the wall phi tells where it is.
constexpr double kNearWall = 1.5;

const Volume<float>& imageOf(const CorrectionGround& ground, const Correction& correction) {
  if (ground.image == nullptr)
    throw InputError("a segmentation has no edges in an image", correctionWord(correction.kind),
                     "use the brush that does not look at the image");
  return *ground.image;
}

Shape brushShape(const Volume<float>& phi, const Correction& correction,
                 const CorrectionGround& ground) {
  Shape tube = tubeShape(phi.geometry, correction.placesLps,
                         std::vector<double>(correction.placesLps.size(), correction.radiusMm));
  if (tube.phi.voxels.empty())
    throw InputError("the brush lies outside the volume", correctionWord(correction.kind),
                     "give places in the volume, in mm LPS");
  const Polarity polarity = ground.vesselness.polarity;
  if (correction.kind == CorrectionKind::AddToEdge)
    return vesselInTube(imageOf(ground, correction), polarity, phi, tube);
  if (correction.kind == CorrectionKind::EraseToEdge)
    return backgroundInTube(imageOf(ground, correction), polarity, phi, tube);
  return tube;
}

/// Changes signs, and distances near the change only. @returns the box of what changed
std::optional<VoxelBox> edit(Volume<float>& phi, const Correction& correction,
                             const CorrectionGround& ground, const Progress& progress) {
  const std::vector<Eigen::Vector3d>& places = correction.placesLps;
  switch (correction.kind) {
    case CorrectionKind::Add:
    case CorrectionKind::AddToEdge:
      return addShape(phi, brushShape(phi, correction, ground));
    case CorrectionKind::Erase:
    case CorrectionKind::EraseToEdge:
      return takeShape(phi, brushShape(phi, correction, ground));
    case CorrectionKind::Bridge:
      return addShape(
          phi, bridgeBetween(ground.image, ground.vesselness, phi, places[0], places[1], progress));
    case CorrectionKind::Separate: {
      const float sign = ground.vesselness.polarity == Polarity::Bright ? 1.0F : -1.0F;
      return takeShape(phi, gapBetween(ground.image, sign, phi, places[0], places[1], progress));
    }
    case CorrectionKind::CutOff:
      return correction.normalLps == Eigen::Vector3d::Zero()
                 ? cutOffSmallerSide(phi, places[0])
                 : cutOff(phi, places[0], correction.normalLps);
    case CorrectionKind::FillHole:
      return fillHole(phi, places[0], progress);
    case CorrectionKind::OpenLoop:
      return openLoop(phi, places[0], progress);
  }
  return std::nullopt;
}

/// Distances again around what a correction changed in a box. @returns the box of what is made anew
VoxelBox redistanceAround(const Volume<float>& before, Volume<float>& phi, const VoxelBox& changed,
                          const Progress& progress) {
  const Geometry& g = phi.geometry;
  const VoxelBox box = changed.widened(kReach, g);
  const VoxelBox around = box.widened(kMargin, g);
  Volume<float> part = cropped(phi, around);
  const Volume<float> was = cropped(before, around);
  const auto near = static_cast<float>(kNearWall * g.voxelMm());
  Volume<std::uint8_t> moved(part.geometry);
  bool anyInside = false, anyOutside = false;
  for (std::size_t v = 0; v < part.voxels.size(); ++v) {
    const float a = was.voxels[v], b = part.voxels[v];
    moved.voxels[v] = a != b && std::min(std::fabs(a), std::fabs(b)) < near ? 1 : 0;
    (b < 0.0F ? anyInside : anyOutside) = true;
  }
  if (anyInside && anyOutside) {
    part = redistance(std::move(part), kBandVoxels, progress);
  } else {
    const double far = kBandVoxels * g.voxelMm();
    std::fill(part.voxels.begin(), part.voxels.end(), static_cast<float>(anyInside ? -far : far));
  }
  // The walls beside it are not made anew.
  const Index3& low = around.low;
  for (const std::uint32_t v : bandAround(moved, kReach + 1, progress).voxel) {
    const Index3 p = part.geometry.indexOf(v);
    phi.at(low[0] + p[0], low[1] + p[1], low[2] + p[2]) = part.voxels[v];
  }
  return changed.widened(kReach + 1, g);
}

}  // namespace

Corrected applyCorrection(const Volume<float>& phi, const Correction& correction,
                          const CorrectionGround& ground, const Progress& progress) {
  Corrected made{phi, {}};
  const std::optional<VoxelBox> changed = edit(made.phi, correction, ground, progress);
  if (!changed) return made;
  made.box = redistanceAround(phi, made.phi, *changed, progress);
  const auto [low, high] = made.box;
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i) {
        const bool was = phi.at(i, j, k) < 0.0F, is = made.phi.at(i, j, k) < 0.0F;
        made.added += is && !was ? 1 : 0;
        made.removed += was && !is ? 1 : 0;
      }
  return made;
}

}  // namespace angiomesh
