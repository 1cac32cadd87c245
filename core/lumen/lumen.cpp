// SPDX-License-Identifier: BSD-3-Clause
#include "core/lumen/lumen.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <set>
#include <utility>

#include "core/base/large_pages.h"
#include "core/base/parallel.h"
#include "core/distance/cell_band.h"
#include "core/lumen/axis_smoothing.h"
#include "core/lumen/local_levels.h"

namespace angiomesh {
namespace {

constexpr std::size_t kGrain = 8192;
/// Voxels beside the wall are not full: what they tell about the lumen's brightness counts less.
constexpr float kWallShare = 0.02F;
constexpr float kAlong = 0.6F;  // cosine: two parts lie end to end
constexpr float kFull = 0.75F;  // of the contrast: as bright as the lumen
constexpr std::uint32_t kLeastCore = 30;
constexpr float kFaintest = -0.33F;  // below the wall's level, of the contrast: no vessel any more
constexpr float kFar = 0.75F;        // |phi| away from the wall, working voxels

/// Labels 1.. of the 26-connected parts of `set`, in the band's order.
std::vector<std::uint32_t> partsOf(const CellBand& band, const std::vector<char>& set) {
  std::vector<std::uint32_t> label(band.size(), 0), open;
  std::uint32_t count = 0;
  for (std::uint32_t c = 0; c < band.size(); ++c) {
    if (set[c] == 0 || label[c] != 0) continue;
    label[c] = ++count;
    open.assign(1, c);
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < 26; ++k)
        if (const std::uint32_t n = band.neighbour(at, k);
            n != CellBand::none && set[n] != 0 && label[n] == 0) {
          label[n] = count;
          open.push_back(n);
        }
    }
  }
  return label;
}

/// Cells by brightness; of equal ones the first in memory comes first.
using Ranked = std::pair<float, std::uint32_t>;
struct ComesLater {
  bool operator()(const Ranked& a, const Ranked& b) const {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  }
};
using BrightestFirst = std::priority_queue<Ranked, std::vector<Ranked>, ComesLater>;

class Refiner {
 public:
  Refiner(const Volume<float>& image, const Volume<std::uint8_t>& found, const LumenParams& params,
          Polarity polarity, const Progress& progress)
      : image_(image),
        params_(params),
        sign_(polarity == Polarity::Bright ? 1.0F : -1.0F),
        band_(bandAround(found, std::max(1, static_cast<int>(std::lround(params.reachVoxels))),
                         progress)),
        outermost_(*std::max_element(band_.layer.begin(), band_.layer.end())) {
    core_.resize(band_.size());
    for (std::size_t c = 0; c < band_.size(); ++c)
      core_[c] = static_cast<char>(found.voxels[band_.voxel[c]] > 1);
  }

  Volume<float> run(const Progress& progress, WallEvidence* evidence) {
    axes_ = vesselAxes(image_, band_, progress);
    value_.resize(band_.size());
    for (std::size_t c = 0; c < band_.size(); ++c)
      value_[c] = sign_ * image_.voxels[band_.voxel[c]];
    firstLevels();
    progress.report(0.4);
    smooth(progress);
    progress.report(0.8);
    averageAround();
    for (int round = 0; round < 2; ++round) lumenAgain();
    grow();
    bridge();
    axes_ = {};  // room for what follows
    part_ = joined_ = {};
    releaseFreedMemory();
    fillCavities();
    Volume<float> phi = result();
    if (evidence != nullptr) tell(*evidence);
    progress.report(1.0);
    return phi;
  }

 private:
  [[nodiscard]] float share(std::size_t c) const {
    const float contrast = lumen_[c] - around_[c];
    return contrast > 0.0F ? (value_[c] - around_[c]) / contrast : 0.0F;
  }
  [[nodiscard]] float excess(std::size_t c) const {
    return share(c) - static_cast<float>(params_.level);
  }

  /// Over the band's outermost layer.
  void averageAround() {
    std::vector<float> outer(band_.size());
    for (std::size_t c = 0; c < band_.size(); ++c)
      outer[c] = band_.layer[c] == outermost_ ? 1.0F : 0.0F;
    around_ = localMean(band_, value_, outer);
  }

  /// Along what was found and, beyond it, what has a weight.
  void averageLumen(const std::vector<float>& weight) {
    std::vector<char> vessel(band_.size());
    for (std::size_t c = 0; c < band_.size(); ++c)
      vessel[c] = static_cast<char>(band_.layer[c] == 0 || weight[c] > 0.0F);
    lumen_ = meanAlong(band_, vessel, value_, weight, params_.meanSteps,
                       localMean(band_, value_, weight));
  }

  /// From where vessels were found: its inner voxels, or all of them where it is thin.
  void firstLevels() {
    std::vector<float> inner(band_.size(), 0.0F);
    for (std::size_t c = 0; c < band_.size(); ++c) {
      if (band_.layer[c] != 0) continue;
      inner[c] = 1.0F;
      for (std::size_t k = 0; k < 6; ++k) {
        const std::uint32_t n = band_.neighbour(c, k);
        if (n != CellBand::none && band_.layer[n] != 0) inner[c] = kWallShare;
      }
    }
    averageLumen(inner);
    averageAround();
  }

  /// From the smoothed image: the more a voxel looks full, the more it tells about the lumen.
  void lumenAgain() {
    std::vector<float> inner(band_.size(), 0.0F);
    for (std::size_t c = 0; c < band_.size(); ++c) {
      if (band_.layer[c] > 1 || !(excess(c) > 0.0F)) continue;
      const float s = std::min(share(c), 1.5F);
      inner[c] = s * s * s * s;
      for (std::size_t k = 0; k < 6; ++k) {
        const std::uint32_t n = band_.neighbour(c, k);
        if (n == CellBand::none || excess(n) > 0.0F) continue;
        inner[c] *= kWallShare;
        break;
      }
    }
    averageLumen(inner);
  }

  /// Beside the vessels, where neither they nor what else the volume holds is taken for noise.
  [[nodiscard]] double noiseBeside() const {
    std::vector<std::uint32_t> voxels;
    for (std::size_t c = 0; c < band_.size(); ++c)
      if (band_.layer[c] == outermost_) voxels.push_back(band_.voxel[c]);
    return noiseLevel(image_, voxels);
  }

  void smooth(const Progress& progress) {
    const double noise = noiseBeside();
    if (noise == 0.0) return;
    std::vector<float> along(band_.size()), across(band_.size());
    for (std::size_t c = 0; c < band_.size(); ++c) {
      const double contrast = static_cast<double>(lumen_[c] - around_[c]);
      const double ratio = contrast > noise ? noise / contrast : 1.0;
      along[c] = static_cast<float>(params_.along * ratio * ratio);
      across[c] = static_cast<float>(params_.across * ratio * ratio);
    }
    value_ = {};  // before its successor is made
    value_ = smoothAlongAxes(image_, band_, axes_, along, across, progress);
    for (float& v : value_) v *= sign_;
  }

  /// Grows the cores of what was found, brightest voxels first, over all that is bright enough.
  /// Where two of them meet, the voxel between them joins them if they lie along the vessel or it
  /// is as bright as the lumen, else it stays outside.
  void grow() {
    labelCores();
    joined_ = eachItself(part_);
    inside_.assign(band_.size(), 0);
    between_.assign(band_.size(), 0);
    BrightestFirst open;
    std::vector<char> queued(band_.size(), 0);
    const auto push = [&](std::uint32_t c) {
      if (queued[c] != 0 || !(excess(c) > 0.0F)) return;
      queued[c] = 1;
      open.emplace(excess(c), c);
    };
    const auto growAll = [&] {
      for (std::uint32_t c = 0; c < band_.size(); ++c)
        if (part_[c] != 0) push(c);
      while (!open.empty()) {
        const std::uint32_t c = open.top().second;
        open.pop();
        if (part_[c] == 0 && !settle(c)) {
          between_[c] = 1;
          continue;
        }
        inside_[c] = 1;
        for (std::size_t k = 0; k < 26; ++k)
          if (const std::uint32_t n = band_.neighbour(c, k); n != CellBand::none) push(n);
      }
    };
    growAll();
    // What is too thin or faint for a core of its own, and stands apart.
    std::vector<char> rest(band_.size(), 0);
    for (std::size_t c = 0; c < band_.size(); ++c)
      rest[c] = static_cast<char>(band_.layer[c] == 0 && queued[c] == 0 && excess(c) > 0.0F);
    const std::vector<std::uint32_t> more = partsOf(band_, rest);
    const auto most = static_cast<std::uint32_t>(joined_.size()) - 1;
    for (std::size_t c = 0; c < band_.size(); ++c)
      if (more[c] != 0) part_[c] = most + more[c];
    const std::vector<std::uint32_t> all = eachItself(part_);
    joined_.insert(joined_.end(), all.begin() + most + 1, all.end());
    growAll();
  }

  /// Numbers the cores; specks are none.
  void labelCores() {
    part_ = partsOf(band_, core_);
    std::vector<std::uint32_t> size(labelsOf(part_), 0);
    for (const std::uint32_t p : part_) ++size[p];
    for (std::size_t c = 0; c < band_.size(); ++c)
      if (size[part_[c]] < kLeastCore) part_[c] = 0;
  }

  /// The number of labels, 0 included.
  static std::size_t labelsOf(const std::vector<std::uint32_t>& parts) {
    return *std::max_element(parts.begin(), parts.end()) + std::size_t{1};
  }

  /// All labels in order: no part has been joined.
  static std::vector<std::uint32_t> eachItself(const std::vector<std::uint32_t>& parts) {
    std::vector<std::uint32_t> all(labelsOf(parts));
    std::iota(all.begin(), all.end(), 0U);
    return all;
  }

  std::uint32_t root(std::uint32_t part) {
    while (joined_[part] != part) part = joined_[part] = joined_[joined_[part]];
    return part;
  }

  /// Gives a voxel the part of its neighbours. False where they belong to parts that must not join.
  bool settle(std::uint32_t c) {
    std::uint32_t part = 0;
    Eigen::Vector3f towards = Eigen::Vector3f::Zero();
    for (std::size_t k = 0; k < 26; ++k) {
      const std::uint32_t n = band_.neighbour(c, k);
      if (n == CellBand::none || part_[n] == 0 || !(inside_[n] != 0 || excess(n) > 0.0F)) continue;
      const std::uint32_t other = root(part_[n]);
      const Index3& d = CellBand::kOffsets[k];
      const Eigen::Vector3f here =
          Eigen::Vector3f(static_cast<float>(d[0]), static_cast<float>(d[1]),
                          static_cast<float>(d[2]))
              .normalized();
      if (part == 0) {
        part = other;
        towards = here;
      } else if (other != part) {
        const Eigen::Vector3f between = here - towards;
        if (share(c) < kFull && std::fabs(between.dot(axes_[c])) < kAlong * between.norm()) {
          apart_.insert(std::minmax(part, other));
          return false;
        }
        joined_[std::max(part, other)] = std::min(part, other);
        part = std::min(part, other);
      }
    }
    if (part == 0) return false;
    part_[c] = part;
    return true;
  }

  /// Joins the parts of what was found as one and fell apart because a thin vessel fades below the
  /// wall's level for a stretch: over the brightest voxels between them, along the vessel.
  void bridge() {
    BrightestFirst open;
    std::vector<std::uint32_t> from(band_.size(), CellBand::none);
    const std::vector<std::uint32_t> grownAs = separate();
    const auto spread = [&](std::uint32_t c) {
      for (std::size_t k = 0; k < 26; ++k) {
        const std::uint32_t n = band_.neighbour(c, k);
        if (n == CellBand::none || inside_[n] != 0 || from[n] != CellBand::none) continue;
        if (band_.layer[n] != 0 || !(excess(n) > kFaintest)) continue;
        from[n] = c;
        part_[n] = part_[c];
        open.emplace(excess(n), n);
      }
    };
    for (std::uint32_t c = 0; c < band_.size(); ++c)
      if (inside_[c] != 0) spread(c);
    while (!open.empty()) {
      const std::uint32_t c = open.top().second;
      open.pop();
      if (inside_[c] != 0) continue;
      for (std::size_t k = 0; k < 26; ++k) {
        const std::uint32_t n = band_.neighbour(c, k);
        if (n == CellBand::none || (inside_[n] == 0 && from[n] == CellBand::none)) continue;
        const std::uint32_t mine = root(part_[c]), other = root(part_[n]);
        if (mine == other) continue;
        const std::uint32_t a = originOf(from, c), b = originOf(from, n);
        const std::pair<std::uint32_t, std::uint32_t> both = std::minmax(grownAs[a], grownAs[b]);
        if (apart_.count(both) != 0) continue;
        if (!liesAlong(c, a, b)) {
          // A way round would lie along the vessel, somewhere.
          if (both.first != both.second) apart_.insert(both);
          continue;
        }
        joined_[std::max(mine, other)] = std::min(mine, other);
        for (std::uint32_t at : {c, n})
          for (; inside_[at] == 0; at = from[at]) inside_[at] = 1;
      }
      spread(c);
    }
  }

  /// Labels the 26-connected parts of what is inside anew. Returns the parts of grow() by cell.
  std::vector<std::uint32_t> separate() {
    for (std::uint32_t& p : part_) p = root(p);
    std::set<std::pair<std::uint32_t, std::uint32_t>> apart;
    for (const auto& [a, b] : apart_) apart.insert(std::minmax(root(a), root(b)));
    apart_ = std::move(apart);
    std::vector<std::uint32_t> grownAs = std::move(part_);
    part_ = partsOf(band_, inside_);
    joined_ = eachItself(part_);
    return grownAs;
  }

  [[nodiscard]] std::uint32_t originOf(const std::vector<std::uint32_t>& from,
                                       std::uint32_t c) const {
    while (inside_[c] == 0) c = from[c];
    return c;
  }

  /// Whether the way from one cell to another runs along the vessel's axis at `c`.
  [[nodiscard]] bool liesAlong(std::uint32_t c, std::uint32_t from, std::uint32_t to) const {
    const Index3 a = band_.geometry.indexOf(band_.voxel[from]);
    const Index3 b = band_.geometry.indexOf(band_.voxel[to]);
    const Eigen::Vector3f way(static_cast<float>(b[0] - a[0]), static_cast<float>(b[1] - a[1]),
                              static_cast<float>(b[2] - a[2]));
    return std::fabs(way.dot(axes_[c])) >= kAlong * way.norm();
  }

  /// What is dark but enclosed is inside.
  void fillCavities() {
    std::vector<char> outside(band_.size(), 0);
    std::vector<std::uint32_t> open;
    const auto reach = [&](std::uint32_t c) {
      if (inside_[c] != 0 || outside[c] != 0) return;
      outside[c] = 1;
      open.push_back(c);
    };
    for (std::uint32_t c = 0; c < band_.size(); ++c) {
      bool border = band_.layer[c] == outermost_;
      for (std::size_t k = 0; k < 6; ++k)
        border = border || band_.neighbour(c, k) == CellBand::none;
      if (border) reach(c);
    }
    while (!open.empty()) {
      const std::uint32_t c = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < 6; ++k)
        if (band_.neighbour(c, k) != CellBand::none) reach(band_.neighbour(c, k));
    }
    for (std::size_t c = 0; c < band_.size(); ++c)
      if (outside[c] == 0) inside_[c] = 1;
  }

  /// The lumen's brightness from the image itself, without regard to which voxels are brighter than
  /// others: weights that follow the brightness take noise for lumen.
  void tell(WallEvidence& evidence) {
    std::vector<float> inner(band_.size(), 0.0F);
    for (std::size_t c = 0; c < band_.size(); ++c) {
      if (inside_[c] == 0) continue;
      inner[c] = 1.0F;
      for (std::size_t k = 0; k < 6; ++k)
        if (const std::uint32_t n = band_.neighbour(c, k); n != CellBand::none && inside_[n] == 0) {
          const float s = std::clamp(share(c), 0.0F, 1.0F);
          inner[c] = kWallShare * s * s * s * s;
          break;
        }
    }
    for (std::size_t c = 0; c < band_.size(); ++c)
      value_[c] = sign_ * image_.voxels[band_.voxel[c]];
    averageLumen(inner);
    evidence.noise = noiseBeside();
    evidence.value = value_;
    evidence.lumen = lumen_;
    evidence.around = around_;
    evidence.meanSteps = params_.meanSteps;
    evidence.band = std::move(band_);
  }

  [[nodiscard]] Volume<float> result() const {
    Volume<float> phi(image_.geometry, kFar);
    constexpr float hair = 1e-3F, gap = 0.1F;
    const auto wall = static_cast<float>(std::max(params_.level, 0.5));
    for (std::size_t c = 0; c < band_.size(); ++c) {
      const float x = std::clamp(wall - share(c), -kFar, kFar);
      const float least = between_[c] != 0 ? gap : hair;
      phi.voxels[band_.voxel[c]] = inside_[c] != 0 ? std::min(x, -hair) : std::max(x, least);
    }
    return phi;
  }

  const Volume<float>& image_;
  LumenParams params_;
  float sign_;
  CellBand band_;
  std::uint8_t outermost_;
  std::vector<float> value_;           ///< the image, brighter inside
  std::vector<float> lumen_, around_;  ///< local brightness
  std::vector<Eigen::Vector3f> axes_;
  std::vector<std::uint32_t> part_, joined_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> apart_;  ///< parts that met side by side
  std::vector<char> core_, inside_, between_;
};

}  // namespace

Volume<float> refineLumen(const Volume<float>& image, const Volume<std::uint8_t>& found,
                          const LumenParams& params, Polarity polarity, const Progress& progress,
                          WallEvidence* evidence) {
  if (std::all_of(found.voxels.begin(), found.voxels.end(), [](std::uint8_t f) { return f == 0; }))
    return Volume<float>(image.geometry, kFar);
  return Refiner(image, found, params, polarity, progress).run(progress, evidence);
}

}  // namespace angiomesh
