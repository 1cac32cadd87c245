// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/segmentation_doubts.h"

#include <cstdio>

#include "core/base/few_warnings.h"
#include "core/pipeline/brighter_around.h"
#include "core/pipeline/segments.h"

namespace angiomesh {
namespace {

/// Of a part's surroundings: of a vessel that lies in a canal of bone for a stretch less is.
constexpr double kBrighterShare = 0.5;
/// Of all voxels: smaller parts matter little.
constexpr double kWorthAWord = 0.01;
/// Noise alone leaves less: next to none in phantoms, one in 1,500 voxels in scans.
constexpr std::size_t kManyHoles = 50;
constexpr double kManyHolesPerVoxel = 1e-3;

std::vector<std::string> brighterParts(const Volume<float>& image, const Volume<float>& phi,
                                       const Components& parts, std::size_t inside,
                                       Polarity polarity) {
  std::size_t large = 0;  // the largest come first
  while (large < parts.sizes.size() &&
         static_cast<double>(parts.sizes[large]) >= kWorthAWord * static_cast<double>(inside))
    ++large;
  const std::vector<double> shares = brighterAround(image, phi, parts.labels, large, polarity);
  std::vector<std::string> texts;
  std::vector<Eigen::Vector3d> inner;
  for (std::size_t n = 0; n < shares.size(); ++n) {
    if (!(shares[n] > kBrighterShare)) continue;
    if (inner.empty()) inner = innerPoints(phi, parts);
    const Eigen::Vector3d& p = inner[n];
    char text[300];
    std::snprintf(text, sizeof text,
                  "a part that is %.0f %% of the segmentation is no vessel: %.0f %% of what lies "
                  "around it is %s than it is, as around the marrow of a bone; leave it out with "
                  "segmentation.drop = %.1f,%.1f,%.1f",
                  100.0 * static_cast<double>(parts.sizes[n]) / static_cast<double>(inside),
                  100.0 * shares[n], polarity == Polarity::Bright ? "brighter" : "darker", p.x(),
                  p.y(), p.z());
    texts.emplace_back(text);
  }
  return texts;
}

}  // namespace

std::vector<std::string> segmentationDoubts(const Volume<float>& image, const EvolveResult& result,
                                            const Parameters& params, double c) {
  std::vector<std::string> doubts;
  const Components parts = connectedComponents(insideMask(*result.phi));
  std::size_t inside = 0;
  for (const std::size_t size : parts.sizes) inside += size;
  addFew(doubts, brighterParts(image, *result.phi, parts, inside, params.vesselness.polarity),
         " more parts are no vessels: what lies around them is brighter than they are");
  const std::size_t holes = result.wall ? result.wall->filledHoles + result.wall->cutHandles : 0;
  if (holes >= kManyHoles &&
      static_cast<double>(holes) > kManyHolesPerVoxel * static_cast<double>(inside)) {
    char text[400];
    std::snprintf(
        text, sizeof text,
        "the vessels are full of holes, %zu were closed: much of what was found is none, "
        "or they are fainter or wider than what was looked for; lower vesselness.c, which "
        "is %.3g here, give vesselness.sigmaMaxMm half of the largest radius, or draw a "
        "region of interest without bone and scalp",
        holes, c);
    doubts.emplace_back(text);
  }
  return doubts;
}

}  // namespace angiomesh
