// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/study_surface.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/base/random.h"
#include "core/pipeline/pipeline.h"

namespace angiomesh::cli {
namespace {

using Eigen::Vector3d;

constexpr int kTreeSide = 128, kShapeSide = 96;  // voxels

/// What is asked of a wall at a noise; lengths in voxels, angles in degrees.
struct Limits {
  double noise, spread, bias, normalMean, normal95, triangles;
};
constexpr Limits kLimits[] = {{0.0, 0.02, 0.03, 1.5, 4.0, 1.0},
                              {20.0, 0.045, 0.03, 2.5, 6.0, 1.15},
                              {60.0, 0.09, 0.06, 4.0, 9.0, 1.3}};
constexpr double kStenosisNoise = 20.0, kStenosisPercent = 5.0;

SurfaceShape shapeOf(const std::string& name, PhantomKind kind, double radius, std::uint64_t seed) {
  SurfaceShape shape{name, {}};
  PhantomParams& p = shape.phantom;
  p.kind = kind;
  p.radius = radius;
  p.randomSeed = seed;
  const int side = kind == PhantomKind::VesselTree ? kTreeSide : kShapeSide;
  p.size = {side, side, side};
  // Neither along the voxels nor at the same place in one.
  for (int a = 0; a < 3; ++a) {
    const auto n = static_cast<std::uint64_t>(a);
    p.axis[a] = a == 2 ? 1.0 : 0.6 * randomUniform(seed, n) - 0.3;
    p.offset[a] = randomUniform(seed, 8 + n) - 0.5;
  }
  return shape;
}

MeasuredMesh measured(const TriMesh& mesh, const MeshQuality& quality, const WallTruth& truth,
                      const Progress& progress) {
  return {quality, wallAccuracy(mesh, truth, progress)};
}

}  // namespace

std::vector<SurfaceShape> surfaceShapes(std::uint64_t seed) {
  std::vector<SurfaceShape> shapes;
  for (const char* name : {"vessel-tree-1", "vessel-tree-2"})
    shapes.push_back(shapeOf(name, PhantomKind::VesselTree, 4.0, 2 * seed + shapes.size()));
  std::uint64_t stream = 1000 * seed;
  const auto add = [&](const char* name, PhantomKind kind, double radius) {
    shapes.push_back(shapeOf(name, kind, radius, ++stream));
  };
  add("tube-1.5", PhantomKind::Tube, 1.5);
  add("tube-3", PhantomKind::Tube, 3.0);
  add("tube-8", PhantomKind::Tube, 8.0);
  add("bent-tube", PhantomKind::BentTube, 3.0);
  add("helix", PhantomKind::Helix, 2.5);
  add("cone", PhantomKind::Cone, 4.0);
  add("bifurcation", PhantomKind::Bifurcation, 4.0);
  add("neck-aneurysm", PhantomKind::NeckAneurysm, 4.0);
  for (const double percent : {50.0, 70.0, 90.0}) {
    add("stenosis", PhantomKind::Stenosis, 4.0);
    shapes.back().name += formatted("-%.0f", percent);
    shapes.back().phantom.stenosisPercent = percent;
  }
  return shapes;
}

std::vector<SurfaceShape> chooseShapes(std::vector<SurfaceShape> shapes, const std::string& names) {
  std::set<std::string> wanted;
  std::istringstream words(names);
  for (std::string word; std::getline(words, word, ',');)
    if (!word.empty()) wanted.insert(word);
  if (wanted.empty()) return shapes;
  for (const std::string& word : wanted)
    if (std::none_of(shapes.begin(), shapes.end(),
                     [&](const SurfaceShape& shape) { return shape.name == word; }))
      throw InputError("no shape is called '" + word + "'", "--shapes",
                       "name some of " + joined(shapes, ", ", &SurfaceShape::name));
  std::erase_if(shapes, [&](const SurfaceShape& s) { return wanted.count(s.name) == 0; });
  return shapes;
}

SurfaceCase runSurfaceCase(const SurfaceShape& shape, const Parameters& params,
                           const Progress& progress) {
  SurfaceCase made;
  made.shape = shape;
  const WallTruth truth(shape.phantom);
  made.voxelMm = truth.grid().voxelMm();
  Phantom phantom = makePhantom(shape.phantom, progress.sub(0.0, 0.05));
  try {
    Pipeline pipeline(makeSource(std::move(phantom.image), shape.name));
    RunOptions options;
    options.keepResults = false;
    const RunResult run = pipeline.run(params, options, progress.sub(0.05, 0.8));
    made.seconds = run.totalSeconds;
    made.exported = measured(*run.smoothed, run.quality->mesh, truth, progress.sub(0.8, 0.9));
    made.marchingCubes = measured(*run.surface->marchingCubes, run.quality->marchingCubes, truth,
                                  progress.sub(0.9, 1.0));
  } catch (const NumericError& error) {  // the pipeline found no vessel at all
    made.failure = error.what();
  }
  progress.report(1.0);
  return made;
}

std::vector<SurfaceBar> barsOf(const SurfaceCase& made) {
  std::vector<SurfaceBar> bars;
  if (!made.failure.empty()) return {{"a vessel is found", "vessel", false}};
  const double noise = made.shape.phantom.noiseSigma;
  const auto* limits = std::find_if(std::begin(kLimits), std::end(kLimits),
                                    [&](const Limits& l) { return l.noise == noise; });
  if (limits == std::end(kLimits)) return bars;
  const WallAccuracy& wall = made.exported.wall;
  const auto atMost = [&](const char* name, double value, double limit) {
    bars.push_back({name + formatted(" <= %g", limit), name, std::fabs(value) <= limit});
  };
  atMost("spread", wall.all.spreadMm / made.voxelMm, limits->spread);
  double bias = std::fabs(wall.all.meanMm);
  for (const WallAgreement& part : wall.byRadius)
    if (part.vertices > 0) bias = std::max(bias, std::fabs(part.meanMm));
  atMost("bias", bias / made.voxelMm, limits->bias);
  atMost("normals", wall.all.normalMeanDeg, limits->normalMean);
  atMost("normals 95 %", wall.all.normal95Deg, limits->normal95);
  if (noise > 0.0 && made.trianglesAgainstNoNoise)
    atMost("triangles", *made.trianglesAgainstNoNoise, limits->triangles);
  if (made.shape.phantom.kind == PhantomKind::Stenosis && noise == kStenosisNoise)
    atMost("diameter, %", wall.stenosis ? wall.stenosis->errorPercent() : -100.0, kStenosisPercent);
  bars.push_back({"genus 0", "genus", made.exported.quality.genus == 0});
  return bars;
}

}  // namespace angiomesh::cli
