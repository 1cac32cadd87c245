// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "core/vesselness/speed.h"

namespace angiomesh {

enum class StartRule {
  Flood,  ///< floodVessels(): from the seeds at once over all that the front would reach
  Seeds   ///< the spheres around the seeds
};

struct LevelSetParams {
  StartRule start = StartRule::Flood;
  int floodLeastVoxels = 30;  ///< parts of this size need no seed
  double gamma = 0.7, d = 0.2;
  bool acrossCrests = true;  ///< the front moves where upwind differences vanish, too
  double stepVoxels = 0.5;   ///< no value changes by more in an iteration; at most 0.5
  int maxIterations = 500;
  std::optional<int> stopAfter;  ///< iterations after which it is ended, wherever the front is
  int checkEvery = 20;
  double tolerance = 0.05;
  double toleranceDelta = 0.005;

  bool operator==(const LevelSetParams&) const = default;
};

enum class StopReason { Running, Converged, Settled, Limit, Stopped };

/// Sparse-field evolution (Whitaker 1998) of phi_t = -(gamma p + (1 - gamma) |d kappa|) |grad phi|
/// (eq. 3.20). Units of phi are working voxels. n steps in chunks equal n steps at once, bit for
/// bit, for any number of threads.
class LevelSetEvolution {
 public:
  /// @param vesselness p is taken from it, interpolated at the zero crossing   @param phi0 signed
  /// distance in working voxels near its zero set, same grid; negative inside
  LevelSetEvolution(std::shared_ptr<const Volume<float>> vesselness, const Thresholds& thresholds,
                    Volume<float> phi0, const LevelSetParams& params);
  ~LevelSetEvolution();
  LevelSetEvolution(LevelSetEvolution&&) noexcept;
  LevelSetEvolution& operator=(LevelSetEvolution&&) noexcept;

  /// Runs at most `iterations` steps; ends early once converged() (checked every
  /// params.checkEvery). Returns the number done. @throws Cancelled
  int step(int iterations, const Progress& progress = {});

  [[nodiscard]] bool converged() const { return stopReason() != StopReason::Running; }
  [[nodiscard]] StopReason stopReason() const;
  [[nodiscard]] int iterations() const;
  /// Sum of |phi now - phi at the last check| over the number of inside voxels; negative before the
  /// first check.
  [[nodiscard]] double change() const;
  /// How far the front moved in each iteration so far: the mean over the active voxels, in working
  /// voxels.
  [[nodiscard]] const std::vector<float>& motions() const;
  [[nodiscard]] std::size_t insideVoxels() const;

  /// phi as it stands, working voxels, clamped beyond the layers.
  [[nodiscard]] const Volume<float>& phi() const;
  /// phi without a copy; the evolution is of no use afterwards.
  [[nodiscard]] Volume<float> takePhi();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace angiomesh
