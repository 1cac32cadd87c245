// SPDX-License-Identifier: BSD-3-Clause
#include "core/levelset/evolution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/parallel.h"
#include "core/image/voxels.h"
#include "core/levelset/front_speed.h"

namespace angiomesh {
namespace {

constexpr std::size_t kGrain = 2048;
constexpr float kFar = 3.0F;  ///< |phi| beyond the layers
constexpr std::int8_t kFarStatus = 3;
constexpr float kCheckScale = 8192.0F;
constexpr std::size_t kVoxelGrain = 1 << 16;

}  // namespace

/// The layers live in index space: phi grows by one per voxel along any axis, whatever the spacing;
/// spacing enters through |grad phi| and kappa alone, so that the front moves right in mm while the
/// layers stay one voxel thick on anisotropic grids.
struct LevelSetEvolution::State {
  std::shared_ptr<const Volume<float>> vesselness;
  LevelSetParams params;
  FrontSpeed speed;
  Volume<float> phi;
  Volume<std::int8_t> status;                        ///< 0 active, +-1, +-2, +-3 far
  std::array<std::vector<std::uint32_t>, 5> layers;  ///< [status + 2]
  BigVector<std::int16_t> checkpoint;                ///< phi * kCheckScale at the last check
  std::vector<float> changes;                        ///< of the active voxels
  std::vector<std::uint8_t> held;
  int iterations = 0;
  std::vector<float> motions;  ///< of each iteration
  double change = -1.0;
  int steadyChecks = 0;
  StopReason stop = StopReason::Running;

  State(std::shared_ptr<const Volume<float>> v, const Thresholds& thresholds, Volume<float> phi0,
        const LevelSetParams& p)
      : vesselness(std::move(v)),
        params(p),
        speed(*vesselness, thresholds, p.gamma, p.d, p.acrossCrests),
        phi(std::move(phi0)),
        status(phi.geometry) {
    build();
  }

  std::vector<std::uint32_t>& layer(int s) { return layers[static_cast<std::size_t>(s + 2)]; }

  std::vector<std::pair<std::uint32_t, float>> findActive();
  void build();
  void remember();
  void buildLayer(int s);
  double computeChanges(const Progress& progress);
  [[nodiscard]] float meanChange() const;
  void moveActive(double timeStep);
  void updateLayer(int s, std::array<std::vector<std::uint32_t>, 5>& entering);
  void enter(std::array<std::vector<std::uint32_t>, 5>& entering);
  void iterate(const Progress& progress);
  void check();
};

/// Active voxels with their values, and the status of all voxels, far but for those. Of two
/// neighbours on either side of the surface, the nearer one is active (both at a tie).
std::vector<std::pair<std::uint32_t, float>> LevelSetEvolution::State::findActive() {
  const Index3& size = phi.geometry.size;
  const std::array<std::size_t, 3> stride{1, phi.geometry.offset(0, 1, 0),
                                          phi.geometry.offset(0, 0, 1)};
  std::vector<std::vector<std::pair<std::uint32_t, float>>> found(
      static_cast<std::size_t>(size[2]));
  parallelFor(0, found.size(), 1, [&](std::size_t k, std::size_t) {
    std::size_t voxel = k * stride[2];
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i, ++voxel) {
        const float value = phi.voxels[voxel];
        status.voxels[voxel] = value < 0.0F ? -kFarStatus : kFarStatus;
        if (std::fabs(value) >= kFar) continue;
        const Index3 p{i, j, static_cast<int>(k)};
        bool active = false;
        const auto look = [&](std::size_t next) {
          const float other = phi.voxels[next];
          active |= (value < 0.0F) != (other < 0.0F) && std::fabs(value) <= std::fabs(other);
        };
        for (std::size_t a = 0; a < 3; ++a) {
          if (p[a] > 0) look(voxel - stride[a]);
          if (p[a] + 1 < size[a]) look(voxel + stride[a]);
        }
        if (!active) continue;
        status.voxels[voxel] = 0;
        found[k].emplace_back(static_cast<std::uint32_t>(voxel), std::clamp(value, -0.5F, 0.5F));
      }
  });
  std::vector<std::pair<std::uint32_t, float>> active;
  for (const auto& slice : found) active.insert(active.end(), slice.begin(), slice.end());
  return active;
}

void LevelSetEvolution::State::build() {
  const std::vector<std::pair<std::uint32_t, float>> active = findActive();
  parallelForEach(phi.voxels.size(), kVoxelGrain,
                  [&](std::size_t i) { phi.voxels[i] = status.voxels[i] < 0 ? -kFar : kFar; });
  for (const auto& [voxel, value] : active) {
    layer(0).push_back(voxel);
    phi.voxels[voxel] = value;
  }
  for (const int s : {-1, 1, -2, 2}) buildLayer(s);
  remember();
  stop = layer(0).empty() ? StopReason::Converged : StopReason::Running;
}

void LevelSetEvolution::State::remember() {
  checkpoint.resize(phi.voxels.size());
  parallelForEach(phi.voxels.size(), kVoxelGrain, [&](std::size_t i) {
    checkpoint[i] = static_cast<std::int16_t>(phi.voxels[i] * kCheckScale);
  });
}

void LevelSetEvolution::State::buildLayer(int s) {
  const int side = s < 0 ? -1 : 1;
  for (const std::uint32_t voxel : layer(s - side))
    forFaceNeighbours(phi.geometry, voxel, [&](std::uint32_t next) {
      if (status.voxels[next] != kFarStatus * side) return;
      status.voxels[next] = static_cast<std::int8_t>(s);
      layer(s).push_back(next);
    });
  for (const std::uint32_t voxel : layer(s)) {
    float nearest = side * kFar;
    forFaceNeighbours(phi.geometry, voxel, [&](std::uint32_t next) {
      if (status.voxels[next] != s - side) return;
      nearest =
          side < 0 ? std::max(nearest, phi.voxels[next]) : std::min(nearest, phi.voxels[next]);
    });
    phi.voxels[voxel] = nearest + static_cast<float>(side);
  }
}

double LevelSetEvolution::State::computeChanges(const Progress& progress) {
  const std::vector<std::uint32_t>& active = layer(0);
  changes.resize(active.size());
  std::vector<float> largest((active.size() + kGrain - 1) / kGrain, 0.0F);
  parallelFor(0, active.size(), kGrain, [&](std::size_t first, std::size_t last) {
    progress.check();
    float most = 0.0F;
    for (std::size_t n = first; n < last; ++n) {
      changes[n] = speed.change(phi, active[n]);
      most = std::max(most, std::fabs(changes[n]));
    }
    largest[first / kGrain] = most;
  });
  float most = 0.0F;
  for (const float value : largest) most = std::max(most, value);
  return static_cast<double>(most);
}

float LevelSetEvolution::State::meanChange() const {
  double sum = 0.0;
  for (const float value : changes) sum += static_cast<double>(std::fabs(value));
  return changes.empty() ? 0.0F : static_cast<float>(sum / static_cast<double>(changes.size()));
}

/// Adds the changes; a voxel that leaves the active set while an active neighbour leaves it on the
/// other side stays, so that the layers never tear.
void LevelSetEvolution::State::moveActive(double timeStep) {
  const std::vector<std::uint32_t>& active = layer(0);
  held.assign(active.size(), 0);
  const auto step = static_cast<float>(timeStep);
  parallelForEach(active.size(), kGrain,
                  [&](std::size_t n) { phi.voxels[active[n]] += step * changes[n]; });
  parallelForEach(active.size(), kGrain, [&](std::size_t n) {
    const float value = phi.voxels[active[n]];
    if (std::fabs(value) <= 0.5F) return;
    forFaceNeighbours(phi.geometry, active[n], [&](std::uint32_t next) {
      if (status.voxels[next] != 0) return;
      const float other = phi.voxels[next];
      if (value > 0.5F ? other < -0.5F : other > 0.5F) held[n] = 1;
    });
  });
  for (std::size_t n = 0; n < active.size(); ++n)
    if (held[n] != 0) phi.voxels[active[n]] = std::clamp(phi.voxels[active[n]], -0.5F, 0.5F);
}

/// New values of layer s from the next inner layer; voxels that have to change layer go to
/// `entering`.
void LevelSetEvolution::State::updateLayer(int s,
                                           std::array<std::vector<std::uint32_t>, 5>& entering) {
  const int side = s < 0 ? -1 : 1;
  const int inner = s - side;
  std::vector<std::uint32_t>& list = layer(s);
  held.assign(list.size(), 0);  // 0 stays, 1 moves in, 2 moves out
  const float inside = static_cast<float>(std::abs(s)) - 0.5F;
  parallelForEach(list.size(), kGrain, [&](std::size_t n) {
    const std::uint32_t voxel = list[n];
    float nearest = kFar;  // of side * phi
    bool found = false;
    forFaceNeighbours(phi.geometry, voxel, [&](std::uint32_t next) {
      if (status.voxels[next] != inner) return;
      found = true;
      nearest = std::min(nearest, static_cast<float>(side) * phi.voxels[next]);
    });
    if (!found) {
      held[n] = 2;
      return;
    }
    const float distance = nearest + 1.0F;
    phi.voxels[voxel] = static_cast<float>(side) * distance;
    if (distance <= inside)
      held[n] = 1;
    else if (distance > inside + 1.0F)
      held[n] = 2;
  });
  std::size_t kept = 0;
  for (std::size_t n = 0; n < list.size(); ++n) {
    const std::uint32_t voxel = list[n];
    if (held[n] == 0) {
      list[kept++] = voxel;
    } else if (held[n] == 1) {
      entering[static_cast<std::size_t>(inner + 2)].push_back(voxel);
    } else if (std::abs(s) == 1) {
      entering[static_cast<std::size_t>(2 * side + 2)].push_back(voxel);
    } else {
      status.voxels[voxel] = static_cast<std::int8_t>(kFarStatus * side);
      phi.voxels[voxel] = static_cast<float>(side) * kFar;
    }
  }
  list.resize(kept);
}

void LevelSetEvolution::State::enter(std::array<std::vector<std::uint32_t>, 5>& entering) {
  for (const int s : {0, -1, 1}) {
    for (const std::uint32_t voxel : entering[static_cast<std::size_t>(s + 2)]) {
      status.voxels[voxel] = static_cast<std::int8_t>(s);
      layer(s).push_back(voxel);
    }
  }
  for (const int side : {-1, 1}) {
    auto& outer = entering[static_cast<std::size_t>(2 * side + 2)];
    for (const std::uint32_t voxel : outer) {
      status.voxels[voxel] = static_cast<std::int8_t>(2 * side);
      phi.voxels[voxel] = std::clamp(phi.voxels[voxel], -2.5F, 2.5F);
      layer(2 * side).push_back(voxel);
    }
    for (const std::uint32_t voxel : entering[static_cast<std::size_t>(side + 2)])
      forFaceNeighbours(phi.geometry, voxel, [&](std::uint32_t next) {
        if (status.voxels[next] != kFarStatus * side) return;
        status.voxels[next] = static_cast<std::int8_t>(2 * side);
        phi.voxels[next] = phi.voxels[voxel] + static_cast<float>(side);
        layer(2 * side).push_back(next);
      });
  }
}

void LevelSetEvolution::State::iterate(const Progress& progress) {
  const double most = computeChanges(progress);
  // Half a voxel, the largest step, keeps the layers right. The second bound stops a front that has
  // all but settled from being thrown about.
  const double timeStep = most > 0.0 ? std::min(params.stepVoxels / most, 1.0) : 1.0;
  moveActive(timeStep);
  motions.push_back(meanChange() * static_cast<float>(timeStep));

  std::array<std::vector<std::uint32_t>, 5> entering;
  std::vector<std::uint32_t>& active = layer(0);
  std::size_t kept = 0;
  for (const std::uint32_t voxel : active) {
    const float value = phi.voxels[voxel];
    if (value > 0.5F)
      entering[3].push_back(voxel);
    else if (value < -0.5F)
      entering[1].push_back(voxel);
    else
      active[kept++] = voxel;
  }
  for (const int s : {-1, 1, -2, 2}) updateLayer(s, entering);
  active.resize(kept);
  enter(entering);
  ++iterations;
  if (iterations % 20 == 0)  // lists in order of memory make the next steps faster
    for (auto& list : layers) std::sort(list.begin(), list.end());
}

void LevelSetEvolution::State::check() {
  const std::size_t count = phi.voxels.size();
  std::vector<double> sums((count + kVoxelGrain - 1) / kVoxelGrain, 0.0);
  std::vector<std::size_t> inside(sums.size(), 0);
  parallelFor(0, count, kVoxelGrain, [&](std::size_t first, std::size_t last) {
    std::int64_t sum = 0;
    std::size_t negative = 0;
    for (std::size_t i = first; i < last; ++i) {
      sum += std::abs(static_cast<int>(phi.voxels[i] * kCheckScale) - checkpoint[i]);
      negative += phi.voxels[i] < 0.0F ? 1 : 0;
    }
    sums[first / kVoxelGrain] = static_cast<double>(sum) / static_cast<double>(kCheckScale);
    inside[first / kVoxelGrain] = negative;
  });
  double sum = 0.0;
  std::size_t negative = 0;
  for (std::size_t b = 0; b < sums.size(); ++b) {
    sum += sums[b];
    negative += inside[b];
  }
  const double previous = change;
  change = sum / static_cast<double>(std::max<std::size_t>(negative, 1));
  remember();
  if (previous >= 0.0) {
    const double delta = std::fabs(change - previous);
    steadyChecks = delta < params.toleranceDelta ? steadyChecks + 1 : 0;
    if (change < params.tolerance && delta < params.toleranceDelta)
      stop = StopReason::Converged;
    else if (steadyChecks >= 3)
      stop = StopReason::Settled;
  }
}

LevelSetEvolution::LevelSetEvolution(std::shared_ptr<const Volume<float>> vesselness,
                                     const Thresholds& thresholds, Volume<float> phi0,
                                     const LevelSetParams& params)
    : state_(std::make_unique<State>(std::move(vesselness), thresholds, std::move(phi0), params)) {}

LevelSetEvolution::~LevelSetEvolution() = default;
LevelSetEvolution::LevelSetEvolution(LevelSetEvolution&&) noexcept = default;
LevelSetEvolution& LevelSetEvolution::operator=(LevelSetEvolution&&) noexcept = default;

int LevelSetEvolution::step(int wanted, const Progress& progress) {
  State& s = *state_;
  int done = 0;
  while (done < wanted && s.stop == StopReason::Running) {
    if (s.params.stopAfter && s.iterations >= *s.params.stopAfter) {
      s.stop = StopReason::Stopped;
      break;
    }
    s.iterate(progress);
    ++done;
    if (s.layer(0).empty())
      s.stop = StopReason::Converged;
    else if (s.iterations % s.params.checkEvery == 0)
      s.check();
    if (s.stop == StopReason::Running && s.iterations >= s.params.maxIterations)
      s.stop = StopReason::Limit;
    progress.evolution(s.iterations, s.change);
  }
  return done;
}

StopReason LevelSetEvolution::stopReason() const { return state_->stop; }
int LevelSetEvolution::iterations() const { return state_->iterations; }
const std::vector<float>& LevelSetEvolution::motions() const { return state_->motions; }
double LevelSetEvolution::change() const { return state_->change; }
const Volume<float>& LevelSetEvolution::phi() const { return state_->phi; }
Volume<float> LevelSetEvolution::takePhi() { return std::move(state_->phi); }

std::size_t LevelSetEvolution::insideVoxels() const {
  const auto& voxels = state_->phi.voxels;
  return static_cast<std::size_t>(
      std::count_if(voxels.begin(), voxels.end(), [](float v) { return v < 0.0F; }));
}

}  // namespace angiomesh
