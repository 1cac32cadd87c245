// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/phantom.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/phantom/appearance.h"
#include "core/phantom/clutter.h"
#include "core/phantom/rasterise.h"
#include "core/phantom/scan.h"
#include "core/phantom/shape.h"
#include "core/phantom/vascular_tree.h"

namespace angiomesh {
namespace {

constexpr std::uint8_t kSubvoxelsOfTruth = 4;  // 4 * 32 = 128 is more than 127

void fadeVessels(Phantom& phantom, const PhantomParams& params, const Shape& shape,
                 const Progress& progress) {
  const VesselFade fade(params, shape);
  const Geometry& g = phantom.image.geometry;
  parallelForEach(phantom.image.voxels.size(), 1U << 14, progress, [&](std::size_t i) {
    float& value = phantom.image.voxels[i];
    if (value == 0.0F) return;
    const Index3 at = g.indexOf(i);
    const Eigen::Vector3d point = g.spacing.cwiseProduct(Eigen::Vector3d(at[0], at[1], at[2]));
    value = static_cast<float>(static_cast<double>(value) * fade.at(point));
  });
}

/// The literature's phantom: a staircase.
void drawSubvoxels(Phantom& phantom, const PhantomParams& params, const Shape& shape,
                   const Geometry& geometry, const Progress& progress) {
  phantom.truth = countSubvoxels(shape, geometry, progress);
  phantom.image = Volume<float>(geometry);
  for (std::size_t i = 0; i < phantom.truth.voxels.size(); ++i) {
    const std::uint8_t count = phantom.truth.voxels[i];
    phantom.image.voxels[i] = static_cast<float>(std::min(255, 32 * count));
    phantom.truth.voxels[i] = count >= kSubvoxelsOfTruth ? 1 : 0;
  }
  if (params.fadePercent < 100.0) fadeVessels(phantom, params, shape, progress);
}

void scanVessels(Phantom& phantom, const PhantomParams& params, const Shape& shape,
                 const Geometry& geometry, const Progress& progress) {
  const PartialVolumes volumes =
      partialVolumes(shape, withMargin(geometry, params.psf), isWide(params.psf, geometry),
                     progress.sub(0.0, 0.7));
  phantom.truth = Volume<std::uint8_t>(geometry);
  Index3 margin;
  for (std::size_t a = 0; a < 3; ++a) margin[a] = (volumes.grid.size[a] - geometry.size[a]) / 2;
  for (std::size_t i = 0; i < phantom.truth.voxels.size(); ++i) {
    const Index3 at = geometry.indexOf(i);
    const std::size_t voxel =
        volumes.grid.offset(at[0] + margin[0], at[1] + margin[1], at[2] + margin[2]);
    phantom.truth.voxels[i] = volumes.share(voxel) >= 0.5 ? 1 : 0;
  }
  std::optional<VesselFade> fade;
  if (params.fadePercent < 100.0) fade.emplace(params, shape);
  phantom.image =
      seenThrough(params.psf, volumes, fade ? &*fade : nullptr, geometry, progress.sub(0.7, 1.0));
}

/// Number of insertions, deletions and replacements between two words (Levenshtein 1966).
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

Shape makeShape(const PhantomParams& params, const Progress& progress) {
  progress.phase("phantom: shape");
  if (params.kind == PhantomKind::Tree)
    return vascularTree(params, phantomGeometry(params), progress);
  return analyticShape(params);
}

Phantom makePhantom(const PhantomParams& params, const Progress& progress) {
  const Geometry geometry = phantomGeometry(params);
  checkAppearance(params);
  checkPointSpread(params.psf);
  const Shape shape = makeShape(params, progress.sub(0.0, 0.6));
  progress.phase("phantom: voxels");
  Phantom phantom;
  phantom.centreLines = shape.centreLines;
  if (params.psf.kind == PointSpread::Kind::Subvoxels)
    drawSubvoxels(phantom, params, shape, geometry, progress.sub(0.6, 0.9));
  else
    scanVessels(phantom, params, shape, geometry, progress.sub(0.6, 0.9));
  if (params.clutter) addClutter(phantom, params, shape, progress.sub(0.9, 0.98));
  if (params.driftPercent > 0.0) addDrift(phantom.image, params, progress);
  if (params.noiseSigma > 0.0) addNoise(phantom.image, params, progress);
  progress.report(1.0);
  return phantom;
}

Volume<float> phantomField(const PhantomParams& params) {
  const Progress progress;
  return sampleField(makeShape(params, progress), phantomGeometry(params), progress);
}

std::function<double(const Eigen::Vector3d&)> phantomDistance(const PhantomParams& params) {
  const auto shape = std::make_shared<const Shape>(makeShape(params, {}));
  return [shape](const Eigen::Vector3d& point) { return shape->signedDistance(point); };
}

const std::vector<std::string>& phantomKindNames() {
  static const std::vector<std::string> names{
      "tree",  "tube",          "torus",      "bifurcation",  "kissing",
      "helix", "stenosis",      "aneurysm",   "capsule-tree", "bent-tube",
      "cone",  "neck-aneurysm", "vessel-tree"};
  return names;
}

PhantomKind phantomKindFromName(const std::string& name) {
  const auto& names = phantomKindNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<PhantomKind>(found - names.begin());
  const auto nearest = std::min_element(
      names.begin(), names.end(),
      [&](const auto& a, const auto& b) { return editDistance(name, a) < editDistance(name, b); });
  throw InputError("there is no phantom \"" + name + "\"", "phantom kind",
                   "the nearest is \"" + *nearest + "\"");
}

}  // namespace angiomesh
