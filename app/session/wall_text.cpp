// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/wall_text.h"

#include <cmath>
#include <cstdio>
#include <string>

#include "core/base/formatted.h"

namespace angiomesh::cli {
namespace {

using Json = nlohmann::ordered_json;

Json agreementJson(const WallAgreement& a) {
  Json json{{"vertices", a.vertices}, {"triangles", a.triangles}};
  if (a.vertices > 0)
    json["distance_mm"] = {{"mean", a.meanMm}, {"spread", a.spreadMm}, {"p95", a.distance95Mm}};
  if (a.triangles > 0) json["normal_deg"] = {{"mean", a.normalMeanDeg}, {"p95", a.normal95Deg}};
  if (!std::isnan(a.curvatureErrorMedian)) json["curvature_error"] = a.curvatureErrorMedian;
  return json;
}

void printLine(const std::string& name, const WallAgreement& a, double voxel) {
  std::printf("%-12s %9zu %9.4f %9.4f %9.4f %9.2f %9.2f %9.3f\n", name.c_str(), a.vertices,
              a.meanMm / voxel, a.spreadMm / voxel, a.distance95Mm / voxel, a.normalMeanDeg,
              a.normal95Deg, a.curvatureErrorMedian);
}

std::string className(std::size_t n) {
  if (n + 2 == kRadiusClasses.size()) return formatted("radius > %g", kRadiusClasses[n]);
  return formatted("%g to %g", kRadiusClasses[n], kRadiusClasses[n + 1]);
}

}  // namespace

Json wallJson(const WallAccuracy& wall, double voxelMm) {
  Json json = agreementJson(wall.all);
  json["left_out"] = wall.leftOut;
  json["by_radius"] = Json::array();
  for (std::size_t n = 0; n < wall.byRadius.size(); ++n) {
    if (wall.byRadius[n].vertices == 0) continue;
    Json part{{"from_mm", kRadiusClasses[n] * voxelMm}};
    if (n + 1 < wall.byRadius.size()) part["to_mm"] = kRadiusClasses[n + 1] * voxelMm;
    part.update(agreementJson(wall.byRadius[n]));
    json["by_radius"].push_back(std::move(part));
  }
  if (wall.stenosis)
    json["stenosis"] = {{"true_diameter_mm", wall.stenosis->trueMm},
                        {"diameter_mm", wall.stenosis->foundMm},
                        {"error_percent", wall.stenosis->errorPercent()}};
  return json;
}

void printWallAccuracy(const WallAccuracy& wall, double voxelMm) {
  std::printf("\nagainst the true wall; lengths in voxels of %g mm, angles in degrees\n", voxelMm);
  std::printf("%-12s %9s %9s %9s %9s %9s %9s %9s\n", "vessels", "vertices", "mean", "spread",
              "95 %", "normals", "95 %", "curvature");
  printLine("all", wall.all, voxelMm);
  for (std::size_t n = 0; n < wall.byRadius.size(); ++n)
    if (wall.byRadius[n].vertices > 0) printLine(className(n), wall.byRadius[n], voxelMm);
  std::printf("%zu vertices near branchings and at the volume's border do not count\n",
              wall.leftOut);
  if (wall.stenosis)
    std::printf("narrowest     %.4g mm, true %.4g mm (%+.1f %%)\n", wall.stenosis->foundMm,
                wall.stenosis->trueMm, wall.stenosis->errorPercent());
}

}  // namespace angiomesh::cli
