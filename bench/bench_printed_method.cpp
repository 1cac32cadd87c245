// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/printed_method.h"
#include "bench/program.h"
#include "core/base/parallel.h"
#include "core/parameters/field.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "core/quality/overlap.h"

using namespace angiomesh;

namespace {

struct Options {
  int size = 256;
  std::vector<std::uint64_t> randomSeeds{1, 2, 3};
  std::vector<double> noises{20.0, 60.0};
  std::vector<std::string> settings;
  bool recursive = false, serial = false, clip = false;
  int threads = 0;
};

double overlapOf(const Volume<float>& phi, const Volume<std::uint8_t>& truth) {
  return compareMasks(insideMask(phi), truth).overlap;
}

double meanDifference(const Volume<float>& a, const Volume<float>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.voxels.size(); ++i)
    sum += std::fabs(static_cast<double>(a.voxels[i]) - static_cast<double>(b.voxels[i]));
  return sum / static_cast<double>(a.voxels.size());
}

int run(const Options& options) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  setThreads(options.threads);
  Parameters params = preset("thesis");
  for (const std::string& setting : options.settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw std::invalid_argument("write --set key=value");
    setFieldFromText(params, setting.substr(0, equals), setting.substr(equals + 1));
  }
  const auto hessian =
      options.recursive ? bench::ItkHessian::Recursive : bench::ItkHessian::Discrete;
  const auto solver = options.serial ? bench::ItkSolver::Serial : bench::ItkSolver::Parallel;
  std::printf(
      "| noise | tree | ours, %% | ITK, %% | difference | alike, %% | b ours | b ITK | iterations "
      "| ITK | mean \\|v - v ITK\\| |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const double noise : options.noises) {
    double sum = 0.0;
    for (const std::uint64_t seed : options.randomSeeds) {
      PhantomParams phantom;
      phantom.psf.kind = PointSpread::Kind::Subvoxels;
      phantom.size = {options.size, options.size, options.size};
      phantom.randomSeed = seed;
      phantom.noiseSigma = noise;
      Phantom tree = makePhantom(phantom);
      if (options.clip)
        for (float& value : tree.image.voxels) value = std::clamp(value, 0.0F, 255.0F);
      Pipeline pipeline(makeSource(tree.image, "tree"));
      RunOptions until;
      until.until = Step::Evolve;
      const RunResult ours = pipeline.run(params, until);
      const auto itk = bench::printedMethod(tree.image, params, hessian, solver);
      const double our = overlapOf(*ours.evolve->phi, tree.truth);
      const double their = overlapOf(itk.front.phi, tree.truth);
      sum += our - their;
      std::printf("| %g | %llu | %.2f | %.2f | %+.2f | %.2f | %.4f | %.4f | %d | %d | %.5f |\n",
                  noise, static_cast<unsigned long long>(seed), our, their, our - their,
                  overlapOf(*ours.evolve->phi, insideMask(itk.front.phi)),
                  ours.evolve->thresholds.b, itk.thresholds.b, ours.evolve->iterations,
                  itk.front.iterations,
                  meanDifference(*ours.vesselness->multiScale, itk.vesselness));
    }
    std::printf("| %g | mean | | | %+.2f | | | | | | |\n", noise,
                sum / static_cast<double>(options.randomSeeds.size()));
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("The preset thesis beside an implementation of the same equations by ITK's filters");
  Options options;
  app.add_option("--size", options.size, "voxels along each side of the tree")
      ->check(CLI::Range(32, 512))
      ->capture_default_str();
  app.add_option("--random-seed", options.randomSeeds, "trees")->capture_default_str();
  app.add_option("--noise", options.noises, "sigmas of the noise")->capture_default_str();
  app.add_option("--set", options.settings, "key=value, a parameter of both");
  app.add_flag("--recursive", options.recursive, "ITK's recursive Gaussian, not the discrete one");
  app.add_flag("--serial", options.serial, "ITK's serial sparse field, not the parallel one");
  app.add_flag("--clip", options.clip, "noise clipped to the thesis's range, 0..255");
  app.add_option("--threads", options.threads, "0: all cores")->capture_default_str();
  return bench::runProgram(app, argc, argv, [&] { return run(options); });
}
