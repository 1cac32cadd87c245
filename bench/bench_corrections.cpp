// SPDX-License-Identifier: BSD-3-Clause
// How long corrections of a segmentation take, each at many places.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/centreline/vessel_at.h"
#include "core/corrections/apply_correction.h"
#include "core/field/wall_field.h"
#include "core/image/voxels.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

double share(const std::vector<double>& sample, double fraction) {
  return sample[static_cast<std::size_t>(fraction * static_cast<double>(sample.size() - 1))];
}

/// Times of a kind's corrections, ms, and how many could not be made.
struct Times {
  std::vector<double> ms;
  int refused = 0;
};

class Bench {
 public:
  explicit Bench(const RunResult& run)
      : phi_(*run.evolve->phi),
        ground_{run.preprocessed.get(), run.params.vesselness},
        voxel_(phi_.geometry.voxelMm()) {}

  void at(const Vector3d& place) {
    const VoxelBox near = boxAround(phi_.geometry, place, {kNear, kNear, kNear});
    const SplineField field = wallField(cropped(phi_, near), SplineKind::InterpolatingBspline);
    const auto vessel = vesselAt(field, place);
    if (!vessel) return;
    const Vector3d& middle = vessel->centreLps;
    const Vector3d axis = vessel->axisLps;
    const Vector3d across = axis.unitOrthogonal();
    const double r = vessel->radiusMm;
    const auto on = [&](double voxels) { return Vector3d(middle + voxels * voxel_ * axis); };
    std::vector<Vector3d> line;
    for (int n = -8; n <= 8; ++n) line.emplace_back(on(n) + r * across);
    for (const CorrectionKind kind : {CorrectionKind::Add, CorrectionKind::AddToEdge,
                                      CorrectionKind::Erase, CorrectionKind::EraseToEdge})
      (void)time(phi_, {kind, 3.0 * voxel_, line, {}});
    (void)time(phi_, {CorrectionKind::CutOff, 0.0, {middle}, axis});
    const auto gap =
        applyCorrection(phi_, {CorrectionKind::Erase, r + 2.0 * voxel_, {middle}, {}}, ground_);
    const double beside = r / voxel_ + 5.0;
    const auto bridged =
        time(gap.phi, {CorrectionKind::Bridge, 0.0, {on(-beside), on(beside)}, {}});
    if (bridged)
      (void)time(*bridged, {CorrectionKind::Separate, 0.0, {on(-beside), on(beside)}, {}});
    // A pit through the vessel's wall, then its lid, make a hole.
    const auto cavity =
        applyCorrection(phi_, {CorrectionKind::Erase, 0.5 * r, {middle}, {}}, ground_);
    (void)time(cavity.phi, {CorrectionKind::FillHole, 0.0, {middle}, {}});
    const Vector3d out = 2.5 * r * across;
    const auto loop = applyCorrection(
        phi_,
        {CorrectionKind::Add, 1.2 * voxel_, {on(-4.0), on(-4.0) + out, on(4.0) + out, on(4.0)}, {}},
        ground_);
    (void)time(loop.phi, {CorrectionKind::OpenLoop, 0.0, {middle + out}, {}});
  }

  void print() {
    std::printf("%-16s %6s %8s %8s %8s %9s\n", "correction", "made", "p50 ms", "p95 ms", "most ms",
                "refused");
    for (auto& [word, times] : times_) {
      if (times.ms.empty()) continue;
      std::sort(times.ms.begin(), times.ms.end());
      std::printf("%-16s %6zu %8.0f %8.0f %8.0f %9d\n", word.c_str(), times.ms.size(),
                  share(times.ms, 0.5), share(times.ms, 0.95), times.ms.back(), times.refused);
    }
  }

 private:
  static constexpr int kNear = 41;

  std::optional<Volume<float>> time(const Volume<float>& phi, const Correction& correction) {
    Times& times = times_[correctionWord(correction.kind)];
    const Clock::time_point start = Clock::now();
    try {
      Corrected made = applyCorrection(phi, correction, ground_);
      times.ms.push_back(1e3 * secondsSince(start));
      return std::move(made.phi);
    } catch (const InputError&) {
      ++times.refused;
      return std::nullopt;
    }
  }

  const Volume<float>& phi_;
  CorrectionGround ground_;
  double voxel_;
  std::map<std::string, Times> times_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App options("How long corrections of a segmentation take");
  int size = 256, places = 20;
  options.add_option("--size", size, "of a noisy tree, voxels along each axis");
  options.add_option("--places", places, "in its vessels, at random");
  CLI11_PARSE(options, argc, argv);
  PhantomParams phantom;
  phantom.size = {size, size, size};
  phantom.noiseSigma = 20.0;
  Pipeline pipeline(makeSource(makePhantom(phantom).image, "tree"));
  RunOptions until;
  until.until = Step::Evolve;
  const RunResult run = pipeline.run(Parameters(), until);
  const Volume<float>& phi = *run.evolve->phi;
  std::vector<std::size_t> inside;
  for (std::size_t v = 0; v < phi.voxels.size(); ++v)
    if (phi.voxels[v] < -phi.geometry.voxelMm()) inside.push_back(v);
  std::printf("%d^3 voxels, %d places\n", size, places);
  Bench bench(run);
  std::mt19937 random(1);
  for (int n = 0; n < places; ++n)
    bench.at(voxelCentre(phi.geometry, inside[random() % inside.size()]));
  bench.print();
  return 0;
}
