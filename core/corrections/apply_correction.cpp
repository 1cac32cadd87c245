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
#include "core/image/growing_box.h"
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

/// The voxels at most kReach + 1 steps from where the wall moved.
CellBand touchedBy(const Volume<float>& before, const Volume<float>& after,
                   const Progress& progress) {
  const auto near = static_cast<float>(kNearWall * after.geometry.voxelMm());
  Volume<std::uint8_t> moved(after.geometry);
  for (std::size_t v = 0; v < after.voxels.size(); ++v) {
    const float was = before.voxels[v], is = after.voxels[v];
    moved.voxels[v] = was != is && std::min(std::fabs(was), std::fabs(is)) < near ? 1 : 0;
  }
  return bandAround(moved, kReach + 1, progress);
}

/// Of these the ones that have a wall so near that it counts; the others are far from any.
Volume<std::uint8_t> besideWalls(const Volume<float>& phi, const CellBand& touched,
                                 const Progress& progress) {
  const Geometry& g = phi.geometry;
  Volume<std::uint8_t> walls(g);
  for (std::size_t v = 0; v < phi.voxels.size(); ++v) {
    if (!(phi.voxels[v] < 0.0F)) continue;
    bool atWall = false;
    forFaceNeighbours(g, v, [&](std::size_t next) { atWall |= !(phi.voxels[next] < 0.0F); });
    walls.voxels[v] = atWall ? 1 : 0;
  }
  Volume<std::uint8_t> near(g), both(g);
  for (const std::uint32_t v : bandAround(walls, kReach + 1, progress).voxel) near.voxels[v] = 1;
  for (const std::uint32_t v : touched.voxel) both.voxels[v] = near.voxels[v];
  return both;
}

/// The boxes of the connected parts of a set.
std::vector<GrowingBox> boxesOf(const Components& parts) {
  std::vector<GrowingBox> boxes(parts.sizes.size());
  for (std::size_t v = 0; v < parts.labels.voxels.size(); ++v)
    if (const std::int32_t part = parts.labels.voxels[v]; part != 0)
      boxes[static_cast<std::size_t>(part - 1)].add(parts.labels.geometry.indexOf(v));
  return boxes;
}

/// Distances again around what a correction changed in a box, and nowhere else.
/// @returns the box of what is made anew
VoxelBox redistanceAround(const Volume<float>& before, Volume<float>& phi, const VoxelBox& changed,
                          const Progress& progress) {
  const Geometry& g = phi.geometry;
  // With the walls that are nearest to what is touched.
  const VoxelBox around = changed.widened(2 * (kReach + 1), g);
  Volume<float> part = cropped(phi, around);
  const CellBand touched = touchedBy(cropped(before, around), part, progress);
  const auto far = static_cast<float>(kBandVoxels * g.voxelMm());
  const Components parts = connectedComponents(besideWalls(part, touched, progress));
  for (const std::uint32_t v : touched.voxel)
    if (parts.labels.voxels[v] == 0) part.voxels[v] = std::copysign(far, part.voxels[v]);
  // Each where it is, as a tree that was cut off touches others in few places.
  std::int32_t label = 0;
  for (const GrowingBox& grown : boxesOf(parts)) {
    ++label;
    const VoxelBox& box = *grown.box();
    const VoxelBox inGrid{
        {box.low[0] + around.low[0], box.low[1] + around.low[1], box.low[2] + around.low[2]},
        {box.high[0] + around.low[0], box.high[1] + around.low[1], box.high[2] + around.low[2]}};
    const VoxelBox wide = inGrid.widened(kMargin, g);
    const Volume<float> distance = redistance(cropped(phi, wide), kBandVoxels, progress);
    const VoxelBox inner = inGrid.seenFrom(wide);
    for (int k = box.low[2]; k <= box.high[2]; ++k)
      for (int j = box.low[1]; j <= box.high[1]; ++j)
        for (int i = box.low[0]; i <= box.high[0]; ++i)
          if (parts.labels.at(i, j, k) == label)
            part.at(i, j, k) =
                distance.at(inner.low[0] + i - box.low[0], inner.low[1] + j - box.low[1],
                            inner.low[2] + k - box.low[2]);
  }
  for (const std::uint32_t v : touched.voxel) {
    const Index3 p = part.geometry.indexOf(v);
    phi.at(around.low[0] + p[0], around.low[1] + p[1], around.low[2] + p[2]) = part.voxels[v];
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
