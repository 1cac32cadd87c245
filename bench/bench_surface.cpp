// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>
#include <string>
#include <vector>

#include "bench/contestants.h"
#include "bench/program.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/phantom/phantom.h"
#include "core/quality/mesh_quality.h"
#include "core/sizing/guidance_field.h"
#include "io/scan/image_io.h"

using namespace angiomesh;

namespace {

struct Options {
  std::string input;
  std::string only;
  int size = 128;
  double radius = 4.0;
  double noise = 0.0;
  std::optional<double> rho;
  int threads = 0;
  int repeat = 3;
  bool defaults = false;
};

Volume<float> makePhi(const Options& options) {
  Volume<float> phi;
  if (options.input.empty()) {
    PhantomParams params;
    params.kind = PhantomKind::CapsuleTree;
    params.size = {options.size, options.size, options.size};
    params.radius = options.radius;
    phi = phantomField(params);
  } else {
    phi = readImage(options.input).image;
  }
  const double voxel = phi.geometry.voxelMm();
  if (options.noise > 0.0)
    for (std::size_t i = 0; i < phi.voxels.size(); ++i)
      phi.voxels[i] += static_cast<float>(options.noise * voxel * randomNormal(1, i));
  return phi;
}

void printRow(const bench::Contestant& contestant, const SplineField& field, int repeat) {
  std::vector<double> wall;
  std::vector<double> processor;
  TriMesh mesh;
  for (int n = 0; n < repeat; ++n) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t before = std::clock();
    mesh = contestant.make();
    processor.push_back(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    wall.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::printf("%-32s %8.3f %8.3f", contestant.name.c_str(), bench::median(wall),
              bench::median(processor));
  if (mesh.triangles.empty()) {
    std::printf("\n");
    return;
  }
  const MeshQuality q = measureQuality(mesh, &field);
  const double voxel = field.geometry().voxelMm();
  std::printf(" %9zu %6.2f %7.3f %7.2f %6.3f %6.3f %9.2e %9.2e %9.2e %9.2e", q.triangles,
              q.minAngleMin, q.below30Percent, q.maxAngleMax, q.radiusRatioMean, q.radiusRatioMin,
              q.vertexDeviation->meanMm / voxel, q.vertexDeviation->maxMm / voxel,
              q.centroidDeviation->meanMm / voxel, q.centroidDeviation->maxMm / voxel);
  std::printf(
      " %5d %5d %4zu %s\n", q.components, q.genus,
      q.nonManifoldEdges + q.nonManifoldVertices + q.degenerateTriangles + q.selfIntersections,
      q.closed ? "closed" : "open");
  std::fflush(stdout);
}

int run(const Options& options) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  setThreads(options.threads);
  const Volume<float> phi = makePhi(options);
  SizingParams sizing = options.defaults ? SizingParams{} : SizingParams::printed();
  if (options.rho) sizing.rho = *options.rho;
  const SplineField field(phi, SplineKind::InterpolatingBspline);
  const GuidanceField guidance(field, sizing);
  const double triangleMm2 = guidance.estimatedAreaMm2() / guidance.estimatedTriangles();
  const double edge = std::sqrt(4.0 / std::sqrt(3.0) * triangleMm2);
  std::printf(
      "%d x %d x %d voxels, noise %g voxel, %d threads, median of %d runs; wanted: %.0f triangles, "
      "mean edge %.3f voxel\n\n",
      phi.geometry.size[0], phi.geometry.size[1], phi.geometry.size[2], options.noise, threads(),
      options.repeat, guidance.estimatedTriangles(), edge / phi.geometry.voxelMm());
  std::printf("%-32s %8s %8s %9s %6s %7s %7s %6s %6s %9s %9s %9s %9s %5s %5s %4s\n", "", "wall s",
              "cpu s", "triangles", "min", "<30 %", "max", "2r/R", "min", "vertex", "max",
              "centroid", "max", "comp", "genus", "bad");
  for (const bench::Contestant& contestant : bench::contestants(phi, sizing, edge)) {
    if (contestant.name.find(options.only) == std::string::npos) continue;
    try {
      printRow(contestant, field, options.repeat);
    } catch (const std::exception& error) {
      std::printf("%-32s failed: %s\n", contestant.name.c_str(), error.what());
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Surfaces of one level set function, made in several ways, in one table");
  Options options;
  app.add_option("phi", options.input, "level set function, negative inside (default: a phantom)");
  app.add_option("--size", options.size, "voxels along each side of the phantom");
  app.add_option("--radius", options.radius, "the phantom's radius, voxels");
  app.add_option("--noise", options.noise, "sigma of Gaussian noise on phi, voxels");
  app.add_option("--rho", options.rho, "the wanted accuracy, radians");
  app.add_option("--threads", options.threads, "0: all cores");
  app.add_option("--repeat", options.repeat, "runs of each")->check(CLI::PositiveNumber);
  app.add_option("--only", options.only, "those alone whose name holds this text");
  app.add_flag("--defaults", options.defaults, "the product's own sizing, not the thesis's");
  return bench::runProgram(app, argc, argv, [&] { return run(options); });
}
