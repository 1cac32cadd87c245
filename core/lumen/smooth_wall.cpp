// SPDX-License-Identifier: BSD-3-Clause
#include "core/lumen/smooth_wall.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/field/wall_field.h"
#include "core/image/voxels.h"
#include "core/lumen/local_levels.h"
#include "core/lumen/local_quadric.h"
#include "core/lumen/wall_cells.h"
#include "core/topology/voxel_topology.h"

namespace angiomesh {
namespace {

using Eigen::Vector3f;

constexpr std::size_t kGrain = 256;
// Working voxels from the wall: where phi is made anew, where it is fitted (the corners of all
// cells of the grid that the wall crosses), and where the image tells about the wall.
constexpr double kReach = 2.3, kNear = 1.0, kTelling = 1.3;
constexpr double kFarthest = 0.9;     // that a value may change
constexpr double kLargestStep = 0.7;  // in one fit
constexpr double kFirstReach = 0.75;  // of the window: the first fit only has to be smooth
constexpr double kStretch = 2.0;
// See LocalQuadric: in voxel^2 for each voxel that a square voxel of wall is uncertain by. The more
// noise there is in the image, the more do the directions found before count.
constexpr double kSteadiness = 8.0;
constexpr double kLeastUncertainty = 0.04;  // of aliasing, where there is no noise
constexpr double kSmallestWindow = 2.5, kLargestWindow = 14.0;
// Where a window this much narrower finds another place, by so many standard deviations, the wall
// bends more than a quadric does, as at a neck: there the narrow one counts.
constexpr double kPart = 0.6;
constexpr double kSurelySame = 2.0, kSurelyOther = 4.0;
// The standard deviation of a place found in a window of radius w: so much of the uncertainty of a
// square voxel, over w; not below that of aliasing.
constexpr double kWindowNoise = 1.33, kLeastDeviation = 0.03;
// Share of the lumen's brightness from which on a voxel tells what that is: the more the less it
// depends on where the wall lies.
constexpr float kFull = 0.8F;
constexpr int kRounds = 2;
// Of a mask, working voxels: the standard deviation of half a voxel to either side is both the
// wall's uncertainty and the point spread of a voxel that is full or empty by half of its volume.
constexpr float kOfMask = 0.2887F;
constexpr float kHeld = 0.05F;  // |phi| of a voxel that is kept on its side, working voxels

class WallFitter {
 public:
  WallFitter(Volume<float> phi, WallEvidence* evidence, const SmoothWallParams& params,
             const Progress& progress)
      : phi_(std::move(phi)),
        evidence_(evidence),
        params_(params),
        voxelMm_(static_cast<float>(phi_.geometry.voxelMm())),
        cells_(phi_, kReach),
        bends_(cells_.size()),
        offset_(cells_.size(), 0.0F),
        uncertainty_(cells_.size(), kOfMask) {
    start_.resize(cells_.size());
    for (std::size_t n = 0; n < cells_.size(); ++n)
      start_[n] = phi_.voxels[cells_[n].voxel] / voxelMm_;
    // Not wallField(): bending a wall as rough as voxels are would draw it inwards.
    cells_.place(SplineField(phi_, SplineKind::InterpolatingBspline), progress);
    frames_ = vesselFrames(phi_, cells_, kNear, kStretch, progress);
    if (evidence_ != nullptr) findEvidence();
  }

  SmoothWall run(const Progress& progress) {
    SmoothWall out;
    fit(kFirstReach * params_.reach, {}, progress);
    progress.report(0.3);
    if (evidence_ == nullptr) profile_.spread = static_cast<double>(kOfMask);
    for (int round = 0; round < kRounds; ++round) {
      cells_.place(wallField(phi_, SplineKind::InterpolatingBspline), progress);
      if (evidence_ != nullptr) {
        if (round == 0) out.spreadVoxels = spread();
        if (out.spreadVoxels > 0.0) profile_.spread = out.spreadVoxels;
        levelLumen();
      }
      const std::vector<Reading> readings = residuals();
      if (evidence_ != nullptr) doubt(readings);
      fit(params_.reach, readings, progress);
      progress.report(0.3 * (round + 2));
    }
    out.heldVoxels = keepTopology();
    out.phi = std::move(phi_);
    return out;
  }

 private:
  /// What a cell's voxel says about the wall: how far outside its foot it lies, and how much that
  /// is worth.
  struct Reading {
    float outwards = 0.0F, weight = 0.0F;
  };

  /// The share of the lumen's brightness over the surroundings' at a cell's voxel.
  [[nodiscard]] double seenAt(std::size_t n) const {
    if (evidence_ == nullptr) return start_[n] < 0.0F ? 1.0 : 0.0;
    const std::size_t e = number_[n];
    return static_cast<double>((evidence_->value[e] - evidence_->around[e]) / contrastAt(e));
  }

  void findEvidence() {
    number_.assign(cells_.size(), kNoEvidence);
    std::size_t e = 0;
    for (std::size_t n = 0; n < cells_.size(); ++n) {
      const std::vector<std::uint32_t>& voxels = evidence_->band.voxel;
      while (e < voxels.size() && voxels[e] < cells_[n].voxel) ++e;
      if (e == voxels.size()) break;
      if (voxels[e] == cells_[n].voxel) number_[n] = static_cast<std::uint32_t>(e);
    }
    weigh();
  }

  void weigh() {
    for (std::size_t n = 0; n < cells_.size(); ++n) {
      if (number_[n] == kNoEvidence) continue;
      const float contrast = contrastAt(number_[n]);
      if (contrast > 0.0F)
        uncertainty_[n] =
            static_cast<float>(wallUncertainty(evidence_->noise / static_cast<double>(contrast)));
      else
        number_[n] = kNoEvidence;
    }
  }

  [[nodiscard]] float contrastAt(std::size_t e) const {
    return evidence_->lumen[e] - evidence_->around[e];
  }

  /// The lumen's brightness anew, from how full the profile says that voxels are: those of a thin
  /// vessel are not.
  void levelLumen() {
    const CellBand& band = evidence_->band;
    std::vector<float> value = evidence_->value, weight(band.size(), 0.0F);
    std::vector<char> vessel(band.size(), 0);
    std::size_t n = 0;
    for (std::size_t e = 0; e < band.size(); ++e) {
      while (n < cells_.size() && cells_[n].voxel < band.voxel[e]) ++n;
      const bool near = n < cells_.size() && cells_[n].voxel == band.voxel[e];
      float full = phi_.voxels[band.voxel[e]] < 0.0F ? 1.0F : 0.0F;
      if (near)
        full = static_cast<float>(WallProfile::share(
            profile_.argument(static_cast<double>(cells_[n].distance), bends_[n])));
      if (full < kFull) continue;
      value[e] = evidence_->around[e] + (value[e] - evidence_->around[e]) / full;
      const float depth = (full - kFull) / (1.0F - kFull);
      weight[e] = depth * depth;
      vessel[e] = 1;
    }
    evidence_->lumen =
        meanAlong(band, vessel, value, weight, evidence_->meanSteps, evidence_->lumen);
    weigh();
  }

  /// The point spread, 0 where the walls do not tell.
  [[nodiscard]] double spread() const {
    if (params_.spreadVoxels) return *params_.spreadVoxels;
    std::vector<float> radius(cells_.size());
    for (std::size_t n = 0; n < cells_.size(); ++n) radius[n] = frames_[n].radius;
    return measureSpread(cells_, *evidence_, number_, radius, bends_);
  }

  [[nodiscard]] std::vector<Reading> residuals() const {
    std::vector<Reading> list(cells_.size());
    parallelForEach(cells_.size(), kGrain, [&](std::size_t n) {
      const WallCell& cell = cells_[n];
      const auto d = static_cast<double>(cell.distance);
      if (std::fabs(d) > kTelling || (evidence_ != nullptr && number_[n] == kNoEvidence)) return;
      // Around the axis of a vessel the model does not hold.
      if (frames_[n].radius > 0.0F && d < -0.8 * static_cast<double>(frames_[n].radius)) return;
      const double seen = seenAt(n);
      const double x = profile_.argument(d, bends_[n]);
      const double slope = profile_.slope(x);
      const double more = std::clamp(seen - WallProfile::share(x), -1.0, 1.0);
      list[n] = {static_cast<float>(more / slope), static_cast<float>(slope * slope)};
    });
    return list;
  }

  /// Where voxels around a place differ from the profile by more than noise does, as in a lumen
  /// that is not evenly bright or where neighbouring voxels share their noise, the wall is as
  /// uncertain as that.
  void doubt(const std::vector<Reading>& readings) {
    constexpr float reach = 3.5F;
    constexpr int enough = 12;
    parallelForEach(cells_.size(), kGrain, [&](std::size_t n) {
      if (frames_[n].radius == 0.0F) return;
      double sum = 0.0;
      int count = 0;
      cells_.forBox(cells_[n].foot, Vector3f::Constant(reach), [&](std::size_t m) {
        const Reading& r = readings[m];
        if (r.weight == 0.0F) return;
        sum += static_cast<double>(r.outwards * r.outwards * r.weight);
        ++count;
      });
      if (count < enough) return;
      const auto seen = static_cast<float>(wallUncertainty(std::sqrt(sum / count)));
      uncertainty_[n] = std::max(uncertainty_[n], seen);
    });
  }

  [[nodiscard]] double uncertaintyAt(std::size_t n) const {
    return std::max(static_cast<double>(uncertainty_[n]), kLeastUncertainty);
  }

  [[nodiscard]] double windowOf(std::size_t n, double reach) const {
    const double radius = std::max(static_cast<double>(frames_[n].radius), 0.7);
    return std::clamp(reach * std::sqrt(std::sqrt(uncertaintyAt(n) * radius)), kSmallestWindow,
                      kLargestWindow);
  }

  /// Moves the wall to the quadrics fitted to the wall, or to what `readings` say if there are any.
  void fit(double reach, const std::vector<Reading>& readings, const Progress& progress) {
    std::vector<char> found(cells_.size(), 0);
    parallelForEach(cells_.size(), kGrain, progress, [&](std::size_t n) {
      if (frames_[n].radius > 0.0F) found[n] = static_cast<char>(fitAt(n, reach, readings));
    });
    parallelForEach(cells_.size(), kGrain, [&](std::size_t n) {
      if (found[n] == 0) takeOver(n, found);
    });
    for (std::size_t n = 0; n < cells_.size(); ++n) {
      const auto bound = static_cast<float>(kFarthest);
      const float value =
          std::clamp(cells_[n].distance - offset_[n], start_[n] - bound, start_[n] + bound);
      phi_.voxels[cells_[n].voxel] = value * voxelMm_;
    }
  }

  bool fitAt(std::size_t n, double reach, const std::vector<Reading>& readings) {
    const WallCell& cell = cells_[n];
    const VesselFrame& frame = frames_[n];
    const bool inImage = !readings.empty();
    const auto window = static_cast<float>(windowOf(n, reach));
    const float part =
        inImage ? static_cast<float>(std::max(kPart, kSmallestWindow / static_cast<double>(window)))
                : 0.0F;
    const auto margin = static_cast<float>(inImage ? kTelling : kNear);
    LocalQuadric wide(static_cast<double>(window)), narrow(static_cast<double>(window * part));
    cells_.forBox(cell.foot, frame.half(window) + Vector3f::Constant(margin), [&](std::size_t m) {
      const WallCell& other = cells_[m];
      if (inImage ? readings[m].weight == 0.0F : frames_[m].radius == 0.0F) return;
      const Vector3f way = other.foot - cell.foot;
      const float square = frame.square(way) / (window * window);
      if (square >= 1.0F || !onOneWall(cell, other)) return;
      const float weight = inImage ? readings[m].weight : 1.0F;
      const float target = inImage ? -readings[m].outwards : 0.0F;
      wide.add({way / window, other.normal, weight * kernel(square), target});
      if (square < part * part)
        narrow.add(
            {way / (window * part), other.normal, weight * kernel(square / (part * part)), target});
    });
    const double steadiness = kSteadiness * uncertaintyAt(n);
    LocalQuadric::Fit fit = wide.solve(steadiness);
    if (!fit.found || fit.weight < 0.5) return false;
    if (const LocalQuadric::Fit close = narrow.solve(steadiness);
        close.found && close.weight >= 0.5) {
      const double deviation =
          std::max(kWindowNoise * static_cast<double>(uncertainty_[n]), kLeastDeviation) /
          (static_cast<double>(window * part) * std::sqrt(static_cast<double>(frame.stretch)));
      const double doubt = std::fabs(fit.offset - close.offset) / deviation;
      const double share =
          std::clamp((doubt - kSurelySame) / (kSurelyOther - kSurelySame), 0.0, 1.0);
      fit.offset += share * (close.offset - fit.offset);
      fit.mean += share * (close.mean - fit.mean);
      fit.gauss += share * (close.gauss - fit.gauss);
    }
    offset_[n] = static_cast<float>(std::clamp(fit.offset, -kLargestStep, kLargestStep));
    bends_[n].mean = static_cast<float>(std::clamp(fit.mean, -1.5, 1.5));
    bends_[n].gauss = static_cast<float>(std::clamp(fit.gauss, -1.0, 1.0));
    return true;
  }

  static float kernel(float square) {
    const float t = 1.0F - square;
    return t * t * t;
  }

  /// Offset and curvature of the fitted cells around the foot.
  void takeOver(std::size_t n, const std::vector<char>& found) {
    constexpr float window = 1.9F;
    const WallCell& cell = cells_[n];
    float offset = 0.0F, weights = 0.0F;
    WallBend bend;
    cells_.forBox(
        cell.foot, Vector3f::Constant(window + static_cast<float>(kNear)), [&](std::size_t m) {
          const WallCell& other = cells_[m];
          const float t = 1.0F - (other.foot - cell.foot).squaredNorm() / (window * window);
          if (found[m] == 0 || t <= 0.0F || other.normal.dot(cell.normal) < 0.2F) return;
          const float w = t * t;
          offset += w * offset_[m];
          bend.mean += w * bends_[m].mean;
          bend.gauss += w * bends_[m].gauss;
          weights += w;
        });
    offset_[n] = weights > 0.0F ? offset / weights : 0.0F;
    if (weights > 0.0F) bends_[n] = {bend.mean / weights, bend.gauss / weights};
  }

  [[nodiscard]] VoxelBits around(std::uint32_t voxel) const {
    VoxelBits object = 0;
    forNeighbours(phi_.geometry, voxel, [&](std::size_t n, std::size_t next) {
      if (phi_.voxels[next] < 0.0F) object |= VoxelBits{1} << n;
    });
    return object;
  }

  /// Voxels change sides one after the other, in the order of memory, where that is no change of
  /// topology; the others stay, close to the wall.
  std::size_t keepTopology() {
    struct Change {
      std::uint32_t voxel;
      float value;
    };
    std::vector<Change> waiting;
    const float held = kHeld * voxelMm_;
    for (std::size_t n = 0; n < cells_.size(); ++n) {
      float& value = phi_.voxels[cells_[n].voxel];
      if ((value < 0.0F) == (start_[n] < 0.0F)) continue;
      waiting.push_back({cells_[n].voxel, value});
      value = start_[n] < 0.0F ? -held : held;
    }
    for (std::size_t before = waiting.size() + 1; waiting.size() < before;) {
      before = waiting.size();
      std::erase_if(waiting, [&](const Change& change) {
        if (!voxelTopology(around(change.voxel)).simple()) return false;
        phi_.voxels[change.voxel] = change.value;
        return true;
      });
    }
    return waiting.size();
  }

  Volume<float> phi_;
  WallEvidence* evidence_;
  SmoothWallParams params_;
  float voxelMm_;
  WallCells cells_;
  std::vector<VesselFrame> frames_;
  std::vector<WallBend> bends_;
  std::vector<float> offset_, uncertainty_, start_;
  std::vector<std::uint32_t> number_;
  WallProfile profile_;
};

}  // namespace

SmoothWall smoothWall(Volume<float> phi, WallEvidence* evidence, const SmoothWallParams& params,
                      const Progress& progress) {
  return WallFitter(std::move(phi), evidence, params, progress).run(progress);
}

}  // namespace angiomesh
