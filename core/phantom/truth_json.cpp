// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/truth_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/phantom/shape.h"

namespace angiomesh {
namespace {

constexpr int kSchema = 1;

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

/// Reads values and says of a wrong one where it is.
class TruthReader {
 public:
  TruthReader(const std::string& text, const std::string& where) : where_(where) {
    json_ = parseJson<nlohmann::json>(text, {.members = 1000000});
    if (json_.is_discarded() || !json_.is_object() || !json_.contains("kind"))
      fail("it is no truth.json of a phantom");
    if (!json_.contains("schema") || json_["schema"] != kSchema)
      fail("it is of another schema than this version reads");
  }

  [[nodiscard]] PhantomParams params() {
    PhantomParams p;
    p.kind = phantomKindFromName(value<std::string>(json_, "kind"));
    p.size = value<Index3>(json_, "size");
    p.spacingMm = vector(json_, "spacing_mm");
    const nlohmann::json values = value<nlohmann::json>(json_, "parameters");
    p.randomSeed = value<std::uint64_t>(values, "random_seed");
    p.noiseSigma = value<double>(values, "noise_sigma");
    p.noiseModel = value<std::string>(values, "noise_model") == "rician" ? NoiseModel::Rician
                                                                         : NoiseModel::Gaussian;
    p.driftPercent = value<double>(values, "drift_percent");
    p.fadePercent = value<double>(values, "fade_percent");
    p.clutter = value<bool>(values, "clutter");
    // Files from before there was a choice do not say it.
    p.psf = pointSpreadFromText(values.contains("psf") ? value<std::string>(values, "psf")
                                                       : std::string("subvoxels"));
    if (p.kind == PhantomKind::Tree) {
      const auto radii = value<std::array<double, 2>>(values, "radius_range_voxels");
      p.radiusMin = radii[0];
      p.radiusMax = radii[1];
      p.volumePercent = value<double>(values, "volume_percent");
      if (values.contains("terminals")) p.terminals = value<int>(values, "terminals");
      return p;
    }
    p.radius = value<double>(values, "radius_voxels");
    p.axis = vector(values, "axis");
    p.offset = vector(values, "offset_voxels");
    if (p.kind == PhantomKind::Kissing) p.gap = value<double>(values, "gap_voxels");
    if (p.kind == PhantomKind::Stenosis && values.contains("stenosis_percent"))
      p.stenosisPercent = value<double>(values, "stenosis_percent");
    return p;
  }

  /// Whether the vessels of `params` are those that the file lists.
  void compareLines(const PhantomParams& params) {
    const std::vector<CentreLineSegment> made = makeShape(params).centreLines;
    const nlohmann::json lines = value<nlohmann::json>(json_, "centre_lines");
    bool same = lines.is_array() && lines.size() == made.size();
    const double tolerance = 1e-6 * params.spacingMm.minCoeff();
    for (std::size_t n = 0; same && n < made.size(); ++n)
      same =
          (vector(lines[n], "from_mm") - made[n].from).norm() < tolerance &&
          (vector(lines[n], "to_mm") - made[n].to).norm() < tolerance &&
          std::fabs(value<double>(lines[n], "radius_from_mm") - made[n].radiusFromMm) < tolerance &&
          std::fabs(value<double>(lines[n], "radius_to_mm") - made[n].radiusToMm) < tolerance;
    if (!same)
      throw InputError("its centre lines are not those that its parameters give", where_,
                       "make the phantom again with this version");
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(what, where_, "give the truth.json that `phantom` wrote");
  }

  template <class T>
  [[nodiscard]] T value(const nlohmann::json& block, const char* key) const {
    if (!block.is_object() || !block.contains(key))
      fail("it does not say \"" + std::string(key) + "\"");
    try {
      return block[key].get<T>();
    } catch (const nlohmann::json::exception&) {
      fail("its \"" + std::string(key) + "\" is not what it should be");
    }
  }
  [[nodiscard]] Eigen::Vector3d vector(const nlohmann::json& block, const char* key) const {
    const auto v = value<std::array<double, 3>>(block, key);
    return {v[0], v[1], v[2]};
  }

  nlohmann::json json_;
  const std::string& where_;
};

}  // namespace

std::string truthJson(const PhantomParams& params, const Phantom& phantom) {
  const auto voxels = static_cast<std::size_t>(
      std::count(phantom.truth.voxels.begin(), phantom.truth.voxels.end(), std::uint8_t{1}));
  nlohmann::json json;
  json["schema"] = kSchema;
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
  values["psf"] = pointSpreadText(params.psf);
  if (params.kind == PhantomKind::Tree) {
    values["radius_range_voxels"] = {params.radiusMin, params.radiusMax};
    values["volume_percent"] = params.volumePercent;
    if (params.terminals > 0) values["terminals"] = params.terminals;
  } else {
    values["radius_voxels"] = params.radius;
    values["axis"] = toJson(params.axis);
    values["offset_voxels"] = toJson(params.offset);
    if (params.kind == PhantomKind::Kissing) values["gap_voxels"] = params.gap;
    if (params.kind == PhantomKind::Stenosis) values["stenosis_percent"] = params.stenosisPercent;
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

PhantomParams phantomFromTruthJson(const std::string& text, const std::string& where) {
  TruthReader reader(text, where);
  const PhantomParams params = reader.params();
  reader.compareLines(params);
  return params;
}

}  // namespace angiomesh
