// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/vesselness_step.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/vesselness/thickest.h"

namespace angiomesh {

VesselnessResult computeVesselness(const Volume<float>& image, const VesselnessParams& params,
                                   const Progress& progress) {
  VesselnessResult result;
  VesselnessParams fixed = withScalesFromImage(params, image);
  result.scalesMm = scalesMm(fixed, image.geometry);
  result.c = contrastC(params, image);
  if (!(result.c > 0.0))
    throw InputError("the image has no contrast", "vesselness.c", "give vesselness.c by hand");
  fixed.c = result.c;
  fixed.sigmaMinMm = result.scalesMm.front();
  result.multiScale = std::make_shared<const Volume<float>>(vesselness(image, fixed, progress));
  return result;
}

SeedsResult computeSeeds(const Volume<float>& image, const VesselnessResult& vessels,
                         const Parameters& params, const Progress& progress) {
  if (!params.seeds.automatic) return {findSeeds(Volume<float>(image.geometry), params.seeds)};
  VesselnessParams fixed = params.vesselness;
  fixed.sigmaMinMm = vessels.scalesMm.front();
  const double average = 0.5 * (vessels.scalesMm.front() + vessels.scalesMm.back());
  return {findSeeds(vesselnessAtScale(image, average, fixed, vessels.c, progress), params.seeds)};
}

Thresholds thresholdsFor(const VesselnessResult& vessels, const ThresholdParams& params) {
  return thresholds(*vessels.multiScale, params,
                    vessels.scalesMm.back() / vessels.scalesMm.front());
}

Volume<float> speedVolume(const Volume<float>& vesselness, const Thresholds& thresholds) {
  Volume<float> out(vesselness.geometry);
  parallelForEach(out.voxels.size(), 1 << 16, [&](std::size_t i) {
    out.voxels[i] =
        static_cast<float>(vesselSpeed(static_cast<double>(vesselness.voxels[i]), thresholds));
  });
  return out;
}

}  // namespace angiomesh
