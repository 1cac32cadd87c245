// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/phantom.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/phantom/appearance.h"
#include "core/phantom/clutter.h"
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

void fadeVessels(Phantom& phantom, const PhantomParams& params, const Shape& shape,
                 const Progress& progress) {
  const VesselFade fade(params, shape);
  const Geometry& g = phantom.image.geometry;
  parallelFor(0, phantom.image.voxels.size(), 1U << 14, [&](std::size_t first, std::size_t last) {
    progress.check();
    for (std::size_t i = first; i < last; ++i) {
      float& value = phantom.image.voxels[i];
      if (value == 0.0F) continue;
      const Index3 at = g.indexOf(i);
      const Eigen::Vector3d point = g.spacing.cwiseProduct(Eigen::Vector3d(at[0], at[1], at[2]));
      value = static_cast<float>(static_cast<double>(value) * fade.at(point));
    }
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

nlohmann::json toJson(const ClutterPiece& piece) {
  nlohmann::json json = {{"kind", piece.kind},
                         {"intensity", piece.intensity},
                         {"from_mm", toJson(piece.from)},
                         {"to_mm", toJson(piece.to)}};
  if (piece.label > 0) json["label"] = piece.label;
  if (piece.segment >= 0) json["centre_line"] = piece.segment;
  return json;
}

}  // namespace

Phantom makePhantom(const PhantomParams& params, const Progress& progress) {
  const Geometry geometry = phantomGeometry(params);
  checkAppearance(params);
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
  if (params.fadePercent < 100.0) fadeVessels(phantom, params, shape, progress);
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
  values["noise_model"] = params.noiseModel == NoiseModel::Rician ? "rician" : "gaussian";
  values["drift_percent"] = params.driftPercent;
  values["fade_percent"] = params.fadePercent;
  values["clutter"] = params.clutter;
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
  for (const ClutterPiece& piece : phantom.pieces) json["clutter"].push_back(toJson(piece));
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
