// SPDX-License-Identifier: BSD-3-Clause
#include "core/topology/handles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/exact_math.h"
#include "core/topology/voxel_topology.h"

namespace angiomesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Loops that are longer than so many voxels are not looked for in all of a section: where it is
/// crossed changes little of their length.
constexpr double kShortLoopVoxels = 40.0;
constexpr std::size_t kMostOfASection = 64;

/// Steps of all searches together, and of each one when these are spent.
constexpr std::size_t kSteps = 30000000, kFewSteps = 20000;

/// Voxels looked at to find out whether a part of the background is closed in.
constexpr std::size_t kCavityVoxels = 20000;

class Growth {
 public:
  explicit Growth(const Volume<float>& phi) : phi_(phi), g_(phi.geometry) {
    Components parts = connectedComponents(insideMask(phi));
    number_ = std::move(parts.labels);
    seeds_.assign(parts.sizes.size(), 0);
    std::vector<bool> seeded(seeds_.size(), false);
    for (std::size_t i = 0; i < number_.voxels.size(); ++i) {
      std::int32_t& label = number_.voxels[i];
      if (label == 0) continue;
      const auto n = static_cast<std::uint32_t>(voxels_.size());
      const auto part = static_cast<std::size_t>(label - 1);
      voxels_.push_back(i);
      component_.push_back(label);
      if (!seeded[part] || value(n) < value(seeds_[part])) seeds_[part] = n;
      seeded[part] = true;
      label = static_cast<std::int32_t>(n + 1);
    }
    state_.assign(voxels_.size(), 0);
    for (std::size_t b = 0; b < lengthMm_.size(); ++b) {
      const Index3& d = kSteps27[b];
      lengthMm_[b] = g_.spacing.cwiseProduct(Eigen::Vector3d(d[0], d[1], d[2])).norm();
    }
  }

  std::vector<Handle> find(const Progress& progress) {
    for (const std::uint32_t seed : seeds_) add(seed);
    std::size_t steps = 0;
    while (!queue_.empty() || !waiting_.empty()) {
      if (++steps % 65536 == 0) progress.check();
      const bool simpleOnes = !queue_.empty();
      Queue& from = simpleOnes ? queue_ : waiting_;
      const std::uint32_t n = from.top().second;
      from.pop();
      state_[n] = static_cast<std::uint8_t>(state_[n] & ~(simpleOnes ? kQueued : kWaiting));
      if ((state_[n] & kGrown) != 0) continue;
      const VoxelTopology topology = voxelTopology(bitsAt(n, kGrown));
      if (!topology.simple() && simpleOnes) {
        if ((state_[n] & kWaiting) == 0) waiting_.emplace(value(n), n);
        state_[n] |= kWaiting;
        continue;
      }
      if (!topology.simple()) changeTopology(n, topology);
      add(n);
    }
    return std::move(handles_);
  }

 private:
  static constexpr std::uint8_t kGrown = 1, kQueued = 2, kWaiting = 4;
  using Entry = std::pair<float, std::uint32_t>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

  [[nodiscard]] float value(std::uint32_t n) const { return phi_.voxels[voxels_[n]]; }
  [[nodiscard]] Eigen::Vector3d pointOf(std::uint32_t n) const {
    return voxelCentre(g_, voxels_[n]);
  }

  /// Calls visit(bit, number) for the neighbours of a voxel in the components.
  template <class F>
  void forKnown(std::uint32_t n, F visit) const {
    forNeighbours(g_, voxels_[n], [&](std::size_t b, std::size_t at) {
      const std::int32_t number = number_.voxels[at];
      if (number != 0) visit(b, static_cast<std::uint32_t>(number - 1));
    });
  }

  [[nodiscard]] VoxelBits bitsAt(std::uint32_t n, std::uint8_t state) const {
    VoxelBits bits = 0;
    forKnown(n, [&](std::size_t b, std::uint32_t next) {
      if ((state_[next] & state) != 0) bits |= VoxelBits{1} << b;
    });
    return bits;
  }

  void add(std::uint32_t n) {
    state_[n] |= kGrown;
    forKnown(n, [&](std::size_t, std::uint32_t next) {
      if ((state_[next] & (kGrown | kQueued)) != 0) return;
      state_[next] |= kQueued;
      queue_.emplace(value(next), next);
    });
  }

  /// What adding a voxel closes: a loop for each further part of what has grown that it touches; a
  /// hole or a cavity for each further part of the background.
  void changeTopology(std::uint32_t n, const VoxelTopology& topology) {
    for (int part = 1; part < topology.object; ++part) handles_.push_back(handleAt(n, topology));
    for (int filled = holesFilled(n, topology); filled > 0 && !handles_.empty(); --filled) {
      const Eigen::Vector3d at = pointOf(n);
      handles_.erase(
          std::min_element(handles_.begin(), handles_.end(), [&](const Handle& a, const Handle& b) {
            return (a.placeLps - at).squaredNorm() < (b.placeLps - at).squaredNorm();
          }));
    }
  }

  Handle handleAt(std::uint32_t n, const VoxelTopology& topology) {
    Handle handle;
    handle.component = component_[n];
    handle.placeLps = handle.centreLps = pointOf(n);
    handle.depthMm = -static_cast<double>(value(n));
    handle.lengthMm = kInfinity;
    measureLoop(n, topology, handle);
    const double shortLoop = kShortLoopVoxels * g_.voxelMm();
    if (handle.lengthIsLeast || handle.lengthMm > shortLoop) return handle;
    for (const std::uint32_t other : sectionAt(n)) {
      const VoxelTopology there = voxelTopology(bitsAt(other, kGrown));
      if (there.object > 1) measureLoop(other, there, handle);
    }
    return handle;
  }

  /// The voxels that have not grown yet and are connected to one, without that; not all of many.
  [[nodiscard]] std::vector<std::uint32_t> sectionAt(std::uint32_t start) const {
    std::vector<std::uint32_t> section{start};
    for (std::size_t at = 0; at < section.size() && section.size() < kMostOfASection; ++at)
      forKnown(section[at], [&](std::size_t, std::uint32_t next) {
        if ((state_[next] & kGrown) == 0 &&
            std::find(section.begin(), section.end(), next) == section.end())
          section.push_back(next);
      });
    section.erase(section.begin());
    return section;
  }

  struct Reached {
    double mm = kInfinity;
    std::uint32_t from = 0;
    bool start = false;
  };

  /// The shortest way through what has grown from the first part that a voxel touches to another,
  /// and back over the voxel, if it is shorter than the handle's.
  void measureLoop(std::uint32_t n, const VoxelTopology& topology, Handle& handle) {
    std::unordered_map<std::uint32_t, Reached> reached;
    std::unordered_map<std::uint32_t, double> goals;
    using Place = std::pair<double, std::uint32_t>;
    std::priority_queue<Place, std::vector<Place>, std::greater<>> front;
    forKnown(n, [&](std::size_t b, std::uint32_t next) {
      if ((state_[next] & kGrown) == 0) return;
      const double mm = lengthMm_[b];
      if ((topology.objectParts[0] >> b & 1) == 0) {
        goals[next] = mm;
        return;
      }
      reached[next] = {mm, next, true};
      front.emplace(mm, next);
    });
    double best = handle.lengthIsLeast ? kInfinity : handle.lengthMm;
    std::uint32_t last = n;
    const std::size_t most = stepsLeft_ > kFewSteps ? stepsLeft_ : kFewSteps;
    std::size_t steps = 0;
    while (!front.empty() && front.top().first < best) {
      const auto [mm, at] = front.top();
      front.pop();
      if (mm > reached[at].mm) continue;
      if (const auto goal = goals.find(at); goal != goals.end() && mm + goal->second < best) {
        best = mm + goal->second;
        last = at;
      }
      if (++steps > most) {
        if (last == n && std::isinf(handle.lengthMm)) {
          handle.lengthMm = mm;
          handle.lengthIsLeast = true;
        }
        break;
      }
      const double before = mm;
      const std::uint32_t from = at;
      forKnown(at, [&](std::size_t b, std::uint32_t next) {
        if ((state_[next] & kGrown) == 0) return;
        const double length = before + lengthMm_[b];
        Reached& r = reached[next];
        if (!(length < r.mm - 1e-12)) return;
        r = {length, from, false};
        front.emplace(length, next);
      });
    }
    stepsLeft_ -= std::min(steps, stepsLeft_);
    if (last == n) return;
    handle.lengthMm = best;
    handle.lengthIsLeast = false;
    Eigen::Vector3d sum = pointOf(n);
    double count = 1.0;
    for (std::uint32_t at = last;; at = reached[at].from) {
      sum += pointOf(at);
      count += 1.0;
      if (reached[at].start) break;
    }
    handle.centreLps = sum / count;
  }

  /// Of the parts of the background that a voxel parts, those that go on around what has grown:
  /// between them it fills a hole. Parts that do not are cavities.
  int holesFilled(std::uint32_t n, const VoxelTopology& topology) const {
    if (topology.background < 2) return 0;
    const auto parts = static_cast<std::uint32_t>(topology.background);
    const std::uint32_t outside = parts;
    DisjointSets sets(parts + 1);
    const auto joined = [&] {
      int fewer = 0;
      for (std::uint32_t part = 0; part < parts; ++part) fewer += sets.find(part) != part ? 1 : 0;
      return fewer;
    };
    std::unordered_map<std::size_t, std::uint32_t> seen;
    std::vector<std::pair<std::size_t, std::uint32_t>> open;
    const std::size_t centre = voxels_[n];
    const auto visit = [&](const Index3& p, std::uint32_t part) {
      if (!g_.contains(p[0], p[1], p[2])) {
        sets.join(part, outside);
        return;
      }
      const std::size_t at = g_.offset(p[0], p[1], p[2]);
      const std::int32_t number = number_.voxels[at];
      if (at == centre ||
          (number != 0 && (state_[static_cast<std::size_t>(number - 1)] & kGrown) != 0))
        return;
      const auto [known, fresh] = seen.try_emplace(at, part);
      if (fresh)
        open.emplace_back(at, part);
      else
        sets.join(part, known->second);
    };
    static constexpr std::array<Index3, 6> faces{
        {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};
    const Index3 p = g_.indexOf(centre);
    for (const Index3& d : faces) {
      const int bit = static_cast<int>(kMiddle27) + d[0] + 3 * d[1] + 9 * d[2];
      for (std::uint32_t part = 0; part < parts; ++part)
        if ((topology.backgroundParts[part] >> bit & 1) != 0)
          visit({p[0] + d[0], p[1] + d[1], p[2] + d[2]}, part);
    }
    for (std::size_t next = 0; next < open.size() && next < kCavityVoxels; ++next) {
      if (joined() >= topology.background - 1) break;
      const auto [at, part] = open[next];
      const Index3 q = g_.indexOf(at);
      for (const Index3& d : faces) visit({q[0] + d[0], q[1] + d[1], q[2] + d[2]}, part);
    }
    // What is too large to be looked through is no cavity.
    return open.size() >= kCavityVoxels ? topology.background - 1 : joined();
  }

  const Volume<float>& phi_;
  const Geometry& g_;
  Volume<std::int32_t> number_;  ///< 1 + number of a voxel in the components, 0 outside
  std::vector<std::size_t> voxels_;
  std::vector<std::int32_t> component_;
  std::vector<std::uint8_t> state_;
  std::vector<std::uint32_t> seeds_;
  std::array<double, 27> lengthMm_{};
  Queue queue_, waiting_;
  std::size_t stepsLeft_ = kSteps;
  std::vector<Handle> handles_;
};

}  // namespace

std::vector<Handle> handlesOf(const Volume<float>& phi, const Progress& progress) {
  std::vector<Handle> handles = Growth(phi).find(progress);
  const double voxel = portableCubeRoot(phi.geometry.voxelVolumeMm3());
  for (Handle& handle : handles)
    if (!handle.lengthIsLeast && handle.lengthMm < 8.0 * voxel)
      handle.kind = HandleKind::Hole;
    else if (handle.depthMm < 0.5 * phi.geometry.voxelMm())
      handle.kind = HandleKind::Thin;
  std::stable_sort(handles.begin(), handles.end(),
                   [](const Handle& a, const Handle& b) { return a.lengthMm < b.lengthMm; });
  progress.report(1.0);
  return handles;
}

}  // namespace angiomesh
