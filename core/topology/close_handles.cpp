// SPDX-License-Identifier: BSD-3-Clause
#include "core/topology/close_handles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <queue>
#include <unordered_map>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/topology/voxel_topology.h"

namespace angiomesh {
namespace {

/// One pass over the voxels between phi = 0 and a level, which stands for the uncertainty.
class Pass {
 public:
  Pass(Volume<float>& phi, const HandleLimits& limits, const Volume<float>* uncertainty,
       double level, std::vector<HandleChange>& changes)
      : phi_(phi),
        g_(phi.geometry),
        limits_(limits),
        uncertainty_(uncertainty),
        level_(static_cast<float>(level)),
        changes_(changes),
        state_(phi.geometry) {}

  /// From phi < level inwards: what cannot go without opening a hole or a cavity fills one.
  void fill(const Progress& progress) {
    begin([&](float value) { return value < level_; },
          [&](float value) { return value >= 0.0F && value < level_; });
    work(
        progress, -1.0F,
        [&](std::size_t at, const VoxelTopology& t) {
          const bool opens = t.object == 1 && t.background != 1;
          if (!opens || !fillHole(at)) remove(at);
        },
        [&](std::size_t at) { remove(at); });
    finishFills();
  }

  /// From phi < -level outwards: where parts that are joined already meet, a handle closes.
  void cut(const Progress& progress) {
    Volume<std::uint8_t> deep(g_);
    for (std::size_t i = 0; i < deep.voxels.size(); ++i)
      deep.voxels[i] = phi_.voxels[i] < -level_ ? 1 : 0;
    Components parts = connectedComponents(deep);
    labels_ = std::move(parts.labels);
    joined_ = DisjointSets(parts.sizes.size() + 1);
    begin([&](float value) { return value < -level_; },
          [&](float value) { return value >= -level_ && value < 0.0F; });
    work(
        progress, 1.0F,
        [&](std::size_t at, const VoxelTopology& t) {
          if (!cutHandle(at, t)) add(at);
        },
        [&](std::size_t at) { add(at); });
    finishCuts();
  }

 private:
  static constexpr std::uint8_t kObject = 1, kOpen = 2, kQueued = 4, kWaiting = 8;
  using Entry = std::pair<float, std::size_t>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

  /// Whether phi may be wrong by as much as it is there.
  [[nodiscard]] bool mayChange(std::size_t at) const {
    const float bound =
        uncertainty_ != nullptr ? std::min(level_, uncertainty_->voxels[at]) : level_;
    return std::fabs(phi_.voxels[at]) <= bound;
  }

  [[nodiscard]] VoxelBits bitsAt(std::size_t at) const {
    VoxelBits bits = 0;
    forNeighbours(g_, at, [&](std::size_t b, std::size_t next) {
      if ((state_.voxels[next] & kObject) != 0) bits |= VoxelBits{1} << b;
    });
    return bits;
  }

  template <class Object, class Candidate>
  void begin(Object object, Candidate candidate) {
    for (std::size_t i = 0; i < state_.voxels.size(); ++i) {
      const float value = phi_.voxels[i];
      state_.voxels[i] = static_cast<std::uint8_t>((object(value) ? kObject : 0) |
                                                   (candidate(value) ? kOpen | kQueued : 0));
    }
  }

  /// Takes the candidates in order of `sign` * phi, those that change no topology first: `change`
  /// decides on the others.
  template <class Change, class Move>
  void work(const Progress& progress, float sign, Change change, Move move) {
    sign_ = sign;
    for (std::size_t i = 0; i < state_.voxels.size(); ++i)
      if ((state_.voxels[i] & kQueued) != 0) queue_.emplace(sign * phi_.voxels[i], i);
    std::size_t steps = 0;
    while (!queue_.empty() || !waiting_.empty()) {
      if (++steps % 65536 == 0) progress.check();
      const bool simpleOnes = !queue_.empty();
      Queue& from = simpleOnes ? queue_ : waiting_;
      const std::size_t at = from.top().second;
      from.pop();
      std::uint8_t& state = state_.voxels[at];
      state = static_cast<std::uint8_t>(state & ~(simpleOnes ? kQueued : kWaiting));
      if ((state & kOpen) == 0) continue;
      const VoxelTopology topology = voxelTopology(bitsAt(at));
      if (topology.simple()) {
        move(at);
      } else if (!simpleOnes) {
        change(at, topology);
      } else if ((state & kWaiting) == 0) {
        state |= kWaiting;
        waiting_.emplace(sign * phi_.voxels[at], at);
      }
    }
  }

  void settle(std::size_t at, bool object) {
    std::uint8_t& state = state_.voxels[at];
    state = static_cast<std::uint8_t>((state & ~(kOpen | kObject)) | (object ? kObject : 0));
    forNeighbours(g_, at, [&](std::size_t, std::size_t next) {
      std::uint8_t& other = state_.voxels[next];
      if ((other & kOpen) == 0 || (other & kQueued) != 0) return;
      other |= kQueued;
      queue_.emplace(sign_ * phi_.voxels[next], next);
    });
  }
  void remove(std::size_t at) { settle(at, false); }

  void add(std::size_t at) {
    std::uint32_t own = 0;
    forNeighbours(g_, at, [&](std::size_t, std::size_t next) {
      if ((state_.voxels[next] & kObject) == 0) return;
      const std::uint32_t other = rootAt(next);
      if (own != 0) joined_.join(own, other);
      own = own == 0 ? other : std::min(own, other);
    });
    labels_.voxels[at] = static_cast<std::int32_t>(own == 0 ? joined_.add() : own);
    settle(at, true);
  }

  [[nodiscard]] std::uint32_t rootAt(std::size_t voxel) {
    return joined_.find(static_cast<std::uint32_t>(labels_.voxels[voxel]));
  }

  /// The undecided voxels that are connected to one, if they are no more than `most`.
  [[nodiscard]] std::vector<std::size_t> sectionAt(std::size_t start, std::size_t most) const {
    std::vector<std::size_t> section{start};
    for (std::size_t n = 0; n < section.size() && section.size() <= most; ++n)
      forNeighbours(g_, section[n], [&](std::size_t, std::size_t next) {
        if ((state_.voxels[next] & kOpen) != 0 &&
            std::find(section.begin(), section.end(), next) == section.end())
          section.push_back(next);
      });
    if (section.size() > most) section.clear();
    return section;
  }

  bool fillHole(std::size_t at) {
    if (!mayChange(at) || sectionAt(at, limits_.holeVoxels).empty()) return false;
    settle(at, true);
    fills_.push_back(at);
    return true;
  }

  /// Takes back what would join parts, and records the rest.
  void finishFills() {
    if (fills_.empty()) return;
    Components parts = connectedComponents(insideMask(phi_));
    labels_ = std::move(parts.labels);
    std::sort(fills_.begin(), fills_.end());
    std::vector<std::size_t> accepted;
    for (bool more = true; more;) {
      more = false;
      for (const std::size_t at : fills_) {
        if (labels_.voxels[at] != 0) continue;
        std::int32_t own = 0;
        bool joins = false;
        forNeighbours(g_, at, [&](std::size_t, std::size_t next) {
          const std::int32_t other = labels_.voxels[next];
          joins = joins || (other != 0 && own != 0 && other != own);
          if (other != 0) own = other;
        });
        if (own == 0 || joins) continue;
        labels_.voxels[at] = own;
        accepted.push_back(at);
        more = true;
      }
    }
    for (const std::size_t at : fills_)
      if (labels_.voxels[at] == 0) state_.voxels[at] = 0;
    for (std::vector<std::size_t>& one : groupsOf(std::move(accepted))) {
      const std::size_t needed = one.size();
      fillPits(one);
      record(one, needed, true);
    }
  }

  /// Voxels that are neighbours together.
  [[nodiscard]] std::vector<std::vector<std::size_t>> groupsOf(
      std::vector<std::size_t> voxels) const {
    std::sort(voxels.begin(), voxels.end());
    std::vector<std::vector<std::size_t>> groups;
    while (!voxels.empty()) {
      std::vector<std::size_t> one{voxels.front()};
      voxels.erase(voxels.begin());
      for (std::size_t n = 0; n < one.size(); ++n)
        forNeighbours(g_, one[n], [&](std::size_t, std::size_t next) {
          const auto found = std::lower_bound(voxels.begin(), voxels.end(), next);
          if (found == voxels.end() || *found != next) return;
          one.push_back(next);
          voxels.erase(found);
        });
      groups.push_back(std::move(one));
    }
    return groups;
  }

  /// What is left of a hole on either side: voxels that the vessel surrounds, as far as phi allows.
  void fillPits(std::vector<std::size_t>& filled) {
    for (std::size_t n = 0; n < filled.size() && filled.size() < 20 * limits_.holeVoxels; ++n)
      forNeighbours(g_, filled[n], [&](std::size_t, std::size_t next) {
        const float value = phi_.voxels[next];
        if ((state_.voxels[next] & kObject) != 0 || value < 0.0F || value >= level_ ||
            !mayChange(next))
          return;
        const VoxelBits bits = bitsAt(next);
        constexpr VoxelBits faces = 1U << 4 | 1U << 10 | 1U << 12 | 1U << 14 | 1U << 16 | 1U << 22;
        if (std::popcount(bits & faces) < 4 || !voxelTopology(bits).simple()) return;
        state_.voxels[next] = kObject;
        filled.push_back(next);
      });
  }

  /// The parts that a voxel touches: how many there are, and how many that are not joined yet.
  [[nodiscard]] std::pair<int, int> partsAt(std::size_t at, const VoxelTopology& topology) {
    std::array<std::uint32_t, 8> roots{};
    forNeighbours(g_, at, [&](std::size_t b, std::size_t next) {
      for (int part = 0; part < topology.object; ++part)
        if ((topology.objectParts[static_cast<std::size_t>(part)] >> b & 1) != 0)
          roots[static_cast<std::size_t>(part)] = rootAt(next);
    });
    int different = 0;
    for (std::size_t a = 0; a < static_cast<std::size_t>(topology.object); ++a)
      if (std::find(roots.data(), roots.data() + a, roots[a]) == roots.data() + a) ++different;
    return {topology.object, different};
  }

  bool cutHandle(std::size_t at, const VoxelTopology& topology) {
    const auto [parts, different] = partsAt(at, topology);
    if (parts < 2 || different > 1 || !mayChange(at) || !hasShortLoop(at, topology) ||
        sectionAt(at, limits_.cutVoxels).empty())
      return false;
    settle(at, false);
    cuts_.push_back(at);
    return true;
  }

  /// Takes back cuts that part something which grew later, and records the others.
  void finishCuts() {
    std::vector<std::size_t> kept;
    for (const std::size_t at : cuts_) {
      if (partsAt(at, voxelTopology(bitsAt(at))).second > 1)
        add(at);
      else
        kept.push_back(at);
    }
    for (const std::vector<std::size_t>& one : groupsOf(std::move(kept)))
      record(one, one.size(), false);
  }

  /// Whether a way no longer than loopVoxels joins two of the parts that a voxel touches.
  [[nodiscard]] bool hasShortLoop(std::size_t at, const VoxelTopology& topology) const {
    for (int part = 0; part + 1 < topology.object; ++part) {
      const VoxelBits start = topology.objectParts[static_cast<std::size_t>(part)];
      std::unordered_map<std::size_t, int> steps;
      std::vector<std::size_t> open;
      std::vector<std::size_t> goals;
      forNeighbours(g_, at, [&](std::size_t b, std::size_t next) {
        if ((state_.voxels[next] & kObject) == 0) return;
        if ((start >> b & 1) == 0) return goals.push_back(next);
        steps[next] = 1;
        open.push_back(next);
      });
      for (std::size_t n = 0; n < open.size(); ++n) {
        const int so = steps[open[n]];
        if (so + 1 > limits_.loopVoxels) break;
        bool reached = false;
        forNeighbours(g_, open[n], [&](std::size_t, std::size_t next) {
          if ((state_.voxels[next] & kObject) == 0 || !steps.emplace(next, so + 1).second) return;
          open.push_back(next);
          reached = reached || std::find(goals.begin(), goals.end(), next) != goals.end();
        });
        if (reached) return true;
      }
    }
    return false;
  }

  /// Moves phi to the other side at the voxels of a change, the first `needed` of which had to.
  void record(const std::vector<std::size_t>& voxels, std::size_t needed, bool filled) {
    HandleChange change;
    change.filled = filled;
    change.voxels = voxels.size();
    for (std::size_t n = 0; n < voxels.size(); ++n) {
      float& value = phi_.voxels[voxels[n]];
      const float depth = std::fabs(value);
      if (n < needed) {
        change.depth = std::max(change.depth, static_cast<double>(depth));
        change.placeLps += voxelCentre(g_, voxels[n]) / static_cast<double>(needed);
      }
      const float across = std::max(depth, 0.5F * level_);
      value = filled ? -across : across;
    }
    changes_.push_back(change);
  }

  Volume<float>& phi_;
  const Geometry& g_;
  const HandleLimits& limits_;
  const Volume<float>* uncertainty_;
  float level_, sign_ = 1.0F;
  std::vector<HandleChange>& changes_;
  Volume<std::uint8_t> state_;
  Volume<std::int32_t> labels_;  ///< of the parts, where they are needed
  DisjointSets joined_{0};       ///< of the labels
  std::vector<std::size_t> cuts_, fills_;
  Queue queue_, waiting_;
};

}  // namespace

std::vector<HandleChange> closeSmallHandles(Volume<float>& phi, const HandleLimits& limits,
                                            const Volume<float>* uncertainty,
                                            const Progress& progress) {
  std::vector<HandleChange> changes;
  constexpr int levels = 2;
  for (int n = 1; n <= levels; ++n) {
    const double level = limits.depth * n / levels;
    const Progress part = progress.sub((n - 1.0) / levels, static_cast<double>(n) / levels);
    Pass(phi, limits, uncertainty, level, changes).fill(part);
    Pass(phi, limits, uncertainty, level, changes).cut(part);
    part.report(1.0);
  }
  return changes;
}

}  // namespace angiomesh
