// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/voxel_reason.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/image/voxel_box.h"
#include "core/levelset/front_speed.h"
#include "core/vesselness/hessian_slices.h"
#include "core/vesselness/vesselness.h"

namespace angiomesh {
namespace {

constexpr int kNearVoxels = 6;  // where lumen and surroundings are looked for
constexpr int kWidestKernel = 30;

/// The same vesselness as in the whole image: the part holds all that the kernels reach.
VoxelAtScale atScale(const Volume<float>& image, const Index3& voxel, double sigmaMm,
                     const VesselnessParams& params, double c) {
  VoxelBox box;
  Index3 centre{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double sigma = sigmaMm / image.geometry.spacing[static_cast<Eigen::Index>(a)];
    const int margin =
        std::min(kWidestKernel, static_cast<int>(4.0 * sigma) + 1) + static_cast<int>(sigma) + 3;
    box.low[a] = std::max(voxel[a] - margin, 0);
    box.high[a] = std::min(voxel[a] + margin, image.geometry.size[a] - 1);
    centre[a] = voxel[a] - box.low[a];
  }
  const Volume<float> part = cropped(image, box);
  const auto [i, j, k] = centre;
  VoxelAtScale found;
  found.sigmaMm = sigmaMm;
  found.vesselness = vesselnessAtScale(part, sigmaMm, params, c).at(i, j, k);
  std::array<double, 6> hessian{};
  forEachHessianSlice(
      part, sigmaMm,
      [&, slice = k, at = part.geometry.offset(i, j, 0)](int which, const HessianSlice& h) {
        if (which != slice) return;
        for (std::size_t n = 0; n < h.size(); ++n) hessian[n] = h[n][at];
      },
      {});
  found.eigenvalues = symmetricEigenvalues(hessian);
  return found;
}

void addBrightness(VoxelReason& reason, const Volume<float>& image, const Volume<float>& phi) {
  const Geometry& g = image.geometry;
  const double clear = 0.5 * g.voxelMm();  // the voxels that the wall goes through are neither
  double inside = 0.0, outside = 0.0;
  int insideCount = 0, outsideCount = 0;
  for (int k = -kNearVoxels; k <= kNearVoxels; ++k)
    for (int j = -kNearVoxels; j <= kNearVoxels; ++j)
      for (int i = -kNearVoxels; i <= kNearVoxels; ++i) {
        const int x = reason.voxel[0] + i, y = reason.voxel[1] + j, z = reason.voxel[2] + k;
        if (!g.contains(x, y, z) || i * i + j * j + k * k > kNearVoxels * kNearVoxels) continue;
        const double distance = phi.at(x, y, z);
        if (distance < -clear) {
          inside += image.at(x, y, z);
          ++insideCount;
        } else if (distance > 2.0 * clear) {
          outside += image.at(x, y, z);
          ++outsideCount;
        }
      }
  if (insideCount > 0) reason.lumen = inside / insideCount;
  if (outsideCount > 0) reason.surroundings = outside / outsideCount;
}

}  // namespace

std::optional<double> VoxelReason::brightness() const {
  if (!lumen || !surroundings || *lumen == *surroundings) return std::nullopt;
  return (value - *surroundings) / (*lumen - *surroundings);
}

std::string VoxelReason::text(const Parameters& params) const {
  const double v = vesselness();
  const bool vessel = v > thresholds.b;
  const std::string looks = v <= 0.0 ? "it does not look like a vessel at any scale"
                                     : formatted("its vesselness of %.3g is %s b = %.3g", v,
                                                 vessel ? "above" : "below", thresholds.b);
  const std::string moves =
      vessel ? "so the front moves outwards here" : "so the front moves inwards here";
  if (leftOut)
    return "Outside: the segmentation holds it, but its part is left out (segmentation.keep, "
           "segmentation.drop, segmentation.minVolumeMm3).";
  if (inside() == vessel) return (vessel ? "Inside: " : "Outside: ") + looks + ", " + moves + ".";
  const std::optional<double> share = brightness();
  const std::string wall =
      params.lumen.enabled && share
          ? formatted(
                "the wall is placed by brightness, at %.0f %% of the way from the "
                "surroundings to the lumen, and this voxel lies at %.0f %%",
                100.0 * params.lumen.level, 100.0 * *share)
          : std::string();
  if (inside())
    return "Inside, though " + looks + ": " +
           (wall.empty() ? "the curvature term or its neighbours hold the front here" : wall) + ".";
  if (!lumen)
    return "Outside, though " + looks + ": no vessel that a seed reaches is near. Put a seed here.";
  return "Outside, though " + looks + ": " +
         (wall.empty() ? "the front came to rest before it" : wall) + ".";
}

VoxelReason reasonAt(const Eigen::Vector3d& pointLps, const Volume<float>& image,
                     const VesselnessResult& vessels, const EvolveResult& evolve,
                     const Volume<float>* keptPhi, const Parameters& params) {
  if (params.segmentation.method != SegmentationMethod::LevelSet || !vessels.multiScale)
    throw InputError("there are no reasons to give", "segmentation.method",
                     "choose the level set and run to Evolve");
  const Eigen::Vector3d index = image.geometry.toIndex(pointLps).array().round();
  VoxelReason reason;
  for (std::size_t a = 0; a < 3; ++a)
    reason.voxel[a] = static_cast<int>(index[static_cast<Eigen::Index>(a)]);
  const auto [i, j, k] = reason.voxel;
  if (!image.geometry.contains(i, j, k))
    throw InputError("the place lies outside what was segmented", placeText(pointLps),
                     "choose one inside the region of interest");
  reason.value = image.at(i, j, k);
  reason.phiMm = evolve.phi->at(i, j, k);
  reason.leftOut = reason.phiMm < 0.0 && keptPhi != nullptr && keptPhi->at(i, j, k) >= 0.0F;

  VesselnessParams fixed = params.vesselness;
  fixed.sigmaMinMm = vessels.scalesMm.front();
  for (const double sigmaMm : vessels.scalesMm)
    reason.scales.push_back(atScale(image, reason.voxel, sigmaMm, fixed, vessels.c));
  const auto best = std::max_element(reason.scales.begin(), reason.scales.end(),
                                     [](const VoxelAtScale& a, const VoxelAtScale& b) {
                                       return std::abs(a.vesselness) < std::abs(b.vesselness);
                                     });
  reason.best = static_cast<std::size_t>(best - reason.scales.begin());

  const LevelSetParams& levelset = params.levelset;
  reason.thresholds = evolve.thresholds;
  reason.p = vesselSpeed(reason.vesselness(), reason.thresholds);
  const FrontSpeed speed(*vessels.multiScale, evolve.thresholds, levelset.gamma, levelset.d,
                         levelset.acrossCrests);
  reason.curvature = speed.curvature(*evolve.phi, image.geometry.offset(i, j, k));
  reason.curvatureTerm = (1.0 - levelset.gamma) * std::abs(levelset.d * reason.curvature);
  reason.speed = levelset.gamma * reason.p + reason.curvatureTerm;
  addBrightness(reason, image, *evolve.phi);
  return reason;
}

}  // namespace angiomesh
