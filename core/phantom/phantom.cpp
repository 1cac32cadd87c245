// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/phantom.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/phantom/rasterise.h"
#include "core/phantom/shape.h"
#include "core/phantom/vascular_tree.h"

namespace angiomesh {
namespace {

constexpr std::uint8_t kSubvoxelsOfTruth = 4;  // 4 * 32 = 128 is more than 127

Shape makeShape(const PhantomParams& params, const Progress& progress) {
  progress.phase("phantom: shape");
  if (params.kind == PhantomKind::Tree)
    return vascularTree(params, phantomGeometry(params), progress);
  return analyticShape(params);
}

void addNoise(Volume<float>& image, double sigma, std::uint64_t seed, const Progress& progress) {
  constexpr std::size_t grain = 1U << 16;
  parallelFor(0, image.voxels.size(), grain, [&](std::size_t first, std::size_t last) {
    progress.check();
    for (std::size_t i = first; i < last; ++i)
      image.voxels[i] =
          static_cast<float>(static_cast<double>(image.voxels[i]) + sigma * randomNormal(seed, i));
  });
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

nlohmann::json toJson(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

}  // namespace

Phantom makePhantom(const PhantomParams& params, const Progress& progress) {
  const Geometry geometry = phantomGeometry(params);
  if (!std::isfinite(params.noiseSigma) || params.noiseSigma < 0.0)
    throw InputError("the noise has no usable standard deviation", "phantom noise",
                     "give 0 or a positive number of intensities");
  const Shape shape = makeShape(params, progress.sub(0.0, 0.6));
  progress.phase("phantom: voxels");
  Phantom phantom;
  phantom.centreLines = shape.centreLines;
  phantom.truth = countSubvoxels(shape, geometry, progress.sub(0.6, 0.9));
  phantom.image = Volume<float>(geometry);
  for (std::size_t i = 0; i < phantom.truth.voxels.size(); ++i) {
    const std::uint8_t count = phantom.truth.voxels[i];
    phantom.image.voxels[i] = static_cast<float>(std::min(255, 32 * count));
    phantom.truth.voxels[i] = count >= kSubvoxelsOfTruth ? 1 : 0;
  }
  if (params.noiseSigma > 0.0)
    addNoise(phantom.image, params.noiseSigma, params.randomSeed, progress);
  progress.report(1.0);
  return phantom;
}

Volume<float> phantomField(const PhantomParams& params) {
  const Progress progress;
  return sampleField(makeShape(params, progress), phantomGeometry(params), progress);
}

std::string truthJson(const PhantomParams& params, const Phantom& phantom) {
  const auto voxels = static_cast<std::size_t>(
      std::count(phantom.truth.voxels.begin(), phantom.truth.voxels.end(), std::uint8_t{1}));
  nlohmann::json json;
  json["schema"] = 1;
  json["kind"] = phantomKindNames()[static_cast<std::size_t>(params.kind)];
  json["size"] = params.size;
  json["spacing_mm"] = toJson(params.spacingMm);
  nlohmann::json& values = json["parameters"];
  values["random_seed"] = params.randomSeed;
  values["noise_sigma"] = params.noiseSigma;
  if (params.kind == PhantomKind::Tree) {
    values["radius_range_voxels"] = {params.radiusMin, params.radiusMax};
    values["volume_percent"] = params.volumePercent;
    if (params.terminals > 0) values["terminals"] = params.terminals;
  } else {
    values["radius_voxels"] = params.radius;
    values["axis"] = toJson(params.axis);
    values["offset_voxels"] = toJson(params.offset);
    if (params.kind == PhantomKind::Kissing) values["gap_voxels"] = params.gap;
  }
  json["truth"] = {{"voxels", voxels},
                   {"percent", 100.0 * static_cast<double>(voxels) /
                                   static_cast<double>(phantom.truth.voxels.size())}};
  json["frame"] = "LPS";
  nlohmann::json& lines = json["centre_lines"] = nlohmann::json::array();
  for (const CentreLineSegment& s : phantom.centreLines) {
    nlohmann::json line = {{"from_mm", toJson(s.from)},
                           {"to_mm", toJson(s.to)},
                           {"radius_from_mm", s.radiusFromMm},
                           {"radius_to_mm", s.radiusToMm}};
    if (s.parent >= 0) line["parent"] = s.parent;
    lines.push_back(std::move(line));
  }
  return json.dump(1) + "\n";
}

const std::vector<std::string>& phantomKindNames() {
  static const std::vector<std::string> names{"tree",        "tube",     "torus",
                                              "bifurcation", "kissing",  "helix",
                                              "stenosis",    "aneurysm", "capsule-tree"};
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
