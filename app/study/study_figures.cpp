// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/study_figures.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/formatted.h"
#include "core/contour/marching_cubes.h"
#include "core/smooth/smoothing.h"
#include "core/surface/zero_set_mesh.h"

namespace angiomesh::cli {
namespace {

// Almost no gradation: the field may rise nearly as fast as the distance, so that each place has
// the length of its own curvature.
constexpr double noGradation = 0.05;

std::string keyOf(const PanelRecipe& r) {
  return formatted("%d %d %.6g %.6g %d %d", r.marchingCubes ? 1 : 0, static_cast<int>(r.spline),
                   r.sizing.rho, r.sizing.etaInverse, r.gradation ? 1 : 0, r.taubin ? 1 : 0);
}

}  // namespace

PanelRecipe::PanelRecipe() { sizing = SizingParams::printed(); }

std::vector<FigurePlan> thesisFigures() {
  const PanelRecipe standard;
  PanelRecipe local;
  local.gradation = false;
  PanelRecipe catmullRom;
  catmullRom.spline = SplineKind::CatmullRom;
  PanelRecipe smooth;
  smooth.taubin = true;
  PanelRecipe cubes;
  cubes.marchingCubes = true;

  std::vector<FigurePlan> figures{
      {"4.1",
       "Surface constructed using only local curvature, and using a guidance field",
       {{"local curvature only", local}, {"guidance field", standard}}},
      {"5.4",
       "Catmull-Rom splines and B-splines, rho = 0.4, 1/eta = 0.8",
       {{"Catmull-Rom", catmullRom}, {"B-spline", standard}}},
      {"5.5",
       "Effect of Taubin smoothing, lambda = 0.50, mu = -0.54, 50 iterations",
       {{"before smoothing", standard}, {"after smoothing", smooth}}},
      {"5.6",
       "Marching cubes and the recommended scheme",
       {{"marching cubes", cubes}, {"recommended scheme", smooth}}}};
  FigurePlan rhos{"B.1", "Varying rho, B-splines, 1/eta = 0.8", {}};
  for (const double rho : {0.6, 0.4, 0.2}) {
    PanelRecipe recipe;
    recipe.sizing.rho = rho;
    rhos.panels.emplace_back("rho = " + formatted("%.1f", rho), recipe);
  }
  FigurePlan etas{"B.2", "Varying eta, B-splines, rho = 0.4", {}};
  for (const double etaInverse : {0.8, 0.65, 0.5}) {
    PanelRecipe recipe;
    recipe.sizing.etaInverse = etaInverse;
    etas.panels.emplace_back("1/eta = " + formatted("%.2f", etaInverse), recipe);
  }
  figures.push_back(std::move(rhos));
  figures.push_back(std::move(etas));
  return figures;
}

TriMesh PanelMaker::surface(const PanelRecipe& recipe, const Progress& progress) const {
  if (recipe.marchingCubes) return marchingCubes(phi_, SurfaceBorder::Open, progress);
  SizingParams sizing = recipe.sizing;
  if (!recipe.gradation) {
    sizing.curvatureRelax *= sizing.startFactor();
    sizing.etaCompensated = true;
    sizing.etaInverse = noGradation;
  }
  const SplineField field(phi_, recipe.spline);
  TriMesh mesh = meshZeroSet(field, sizing, SurfaceMethod::AdvancingFront, SurfaceBorder::Open,
                             progress.sub(0.0, 0.8))
                     .mesh;
  if (!recipe.taubin) return mesh;
  SmoothParams smooth;
  smooth.method = SmoothMethod::Taubin;
  return smoothSurface(mesh, smooth, nullptr, progress.sub(0.8, 1.0));
}

const PanelResult& PanelMaker::make(const PanelRecipe& recipe, const Progress& progress) {
  const std::string key = keyOf(recipe);
  const auto known = made_.find(key);
  if (known != made_.end()) return known->second;
  PanelResult result;
  const auto start = std::chrono::steady_clock::now();
  result.mesh = surface(recipe, progress.sub(0.0, 0.7));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const SplineField field(phi_, SplineKind::InterpolatingBspline);
  result.quality = measureQuality(result.mesh, &field, progress.sub(0.7, 1.0));
  return made_.emplace(key, std::move(result)).first->second;
}

std::array<double, 6> busiestBox(const TriMesh& mesh, double side) {
  // Cubes at every half of their side: a vertex lies in eight of them.
  std::map<std::array<int, 3>, std::size_t> count;
  for (const Eigen::Vector3d& p : mesh.points)
    for (int c = 0; c < 8; ++c) {
      std::array<int, 3> cube{};
      for (int a = 0; a < 3; ++a)
        cube[static_cast<std::size_t>(a)] =
            static_cast<int>(std::floor(2.0 * p[a] / side)) - (c >> a & 1);
      ++count[cube];
    }
  const auto best = std::max_element(
      count.begin(), count.end(), [](const auto& x, const auto& y) { return x.second < y.second; });
  std::array<double, 6> box{};
  if (best == count.end()) return box;
  for (std::size_t a = 0; a < 3; ++a) {
    box[2 * a] = 0.5 * side * best->first[a];
    box[2 * a + 1] = box[2 * a] + side;
  }
  return box;
}

}  // namespace angiomesh::cli
