// SPDX-License-Identifier: BSD-3-Clause
#include "core/distance/redistance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/field/spline_field.h"
#include "core/image/voxels.h"

namespace angiomesh {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr double kBeyond = 0.9;      // voxels of the band beyond the clamp, for their neighbours
constexpr double kLastStep = 3e-3;   // Newton's method squares it
constexpr double kTolerance = 1e-3;  // of a foot's offset, squared, over the distance
constexpr double kNearer = 1e-3;     // a neighbour's foot has to be, to be taken up

/// A point of the zero set.
struct Foot {
  Eigen::Vector3d point;   ///< continuous index
  Eigen::Vector3f normal;  ///< unit, outwards, in working-voxel space
  float bend = 0.0F;       ///< curvature in the direction last walked, per working voxel
};

/// A foot as a voxel keeps it, in a third of the space.
struct KeptFoot {
  /// From the voxel's centre, working voxels times ClosestPoints::offsetScale_: 1e-4 voxel at
  /// worst.
  std::array<std::int16_t, 3> offset, normal;
  std::int16_t bend;
};
constexpr float kLargest = 32767.0F;
constexpr float kNormalScale = kLargest, kBendScale = 16000.0F;  // |bend| <= 2

/// Feet by number, in chunks: growing neither moves nor doubles them.
class Feet {
 public:
  KeptFoot& operator[](std::size_t n) { return chunks_[n / kChunk][n % kChunk]; }
  const KeptFoot& operator[](std::size_t n) const { return chunks_[n / kChunk][n % kChunk]; }
  void add(const KeptFoot& foot) {
    if (size_ == chunks_.size() * kChunk) chunks_.emplace_back(kChunk);
    (*this)[size_++] = foot;
  }

 private:
  static constexpr std::size_t kChunk = std::size_t{1} << 18;
  std::vector<BigVector<KeptFoot>> chunks_;
  std::size_t size_ = 0;
};

/// The voxels near the zero set and, for each, the closest point found so far.
class ClosestPoints {
 public:
  ClosestPoints(const Volume<float>& phi, double bandVoxels)
      : geometry_(phi.geometry),
        field_(phi, SplineKind::InterpolatingBspline),
        reach_(bandVoxels + kBeyond) {
    for (int a = 0; a < 3; ++a) step_[a] = geometry_.spacing[a] / geometry_.voxelMm();
    offsetScale_ = kLargest / static_cast<float>(std::max(reach_, step_.maxCoeff()) + 1.0);
  }

  void findCrossings(const Volume<float>& phi, const Progress& progress);
  bool grow(const Progress& progress);
  void relax(const Progress& progress);

  [[nodiscard]] std::size_t count() const { return voxels_.size(); }
  /// The result; `this` is of no use afterwards.
  Volume<float> distances(const std::vector<bool>& inside, double bandVoxels);

 private:
  static constexpr std::int32_t kNone = -1;
  static constexpr std::int32_t kFresh = std::numeric_limits<std::int32_t>::max();

  [[nodiscard]] Eigen::Vector3d position(std::size_t voxel) const {
    const Index3 p = geometry_.indexOf(voxel);
    return {1.0 * p[0], 1.0 * p[1], 1.0 * p[2]};
  }
  [[nodiscard]] Eigen::Vector3f offset(std::size_t n) const {
    const auto& kept = feet_[n].offset;
    return Eigen::Vector3f(kept[0], kept[1], kept[2]) / offsetScale_;
  }
  [[nodiscard]] double distance(std::size_t n) const {
    return static_cast<double>(offset(n).norm());
  }
  [[nodiscard]] double distance(const Eigen::Vector3d& x, const Eigen::Vector3d& point) const {
    return step_.cwiseProduct(x - point).norm();
  }
  [[nodiscard]] KeptFoot kept(const Foot& foot, const Eigen::Vector3d& x) const;
  template <class F>
  void crossingsOfSlice(const Volume<float>& phi, int k, F found) const;
  bool bestOfNeighbours(std::size_t voxel, double within, Foot& foot) const;
  [[nodiscard]] bool toZero(Foot& foot) const;
  void approach(const Eigen::Vector3d& x, Foot& foot) const;

  Geometry geometry_;
  SplineField field_;
  double reach_;
  float offsetScale_ = 1.0F;
  Eigen::Vector3d step_;  ///< working voxels per voxel along each axis
  Volume<std::int32_t> slot_;
  BigVector<std::uint32_t> voxels_;
  Feet feet_;
  std::size_t frontier_ = 0;  ///< voxels_ before it have had their neighbours added
};

KeptFoot ClosestPoints::kept(const Foot& foot, const Eigen::Vector3d& x) const {
  KeptFoot k;
  const Eigen::Vector3f offset = step_.cwiseProduct(foot.point - x).cast<float>();
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    k.offset[a] = static_cast<std::int16_t>(
        std::lround(std::clamp(offset[axis] * offsetScale_, -kLargest, kLargest)));
    k.normal[a] = static_cast<std::int16_t>(std::lround(foot.normal[axis] * kNormalScale));
  }
  k.bend = static_cast<std::int16_t>(std::lround(foot.bend * kBendScale));
  return k;
}

/// Calls found(voxel, foot) for the voxels of a slice with a neighbour of the other sign, with the
/// nearest linear crossing on their grid edges.
template <class F>
void ClosestPoints::crossingsOfSlice(const Volume<float>& phi, int k, F found) const {
  const Index3& size = geometry_.size;
  const std::array<std::size_t, 3> stride{1, geometry_.offset(0, 1, 0), geometry_.offset(0, 0, 1)};
  for (int j = 0; j < size[1]; ++j)
    for (int i = 0; i < size[0]; ++i) {
      const std::size_t voxel = geometry_.offset(i, j, k);
      const Index3 p{i, j, k};
      const float value = phi.voxels[voxel];
      double best = std::numeric_limits<double>::max();
      Foot foot;
      for (std::size_t a = 0; a < 3; ++a)
        for (int side = -1; side <= 1; side += 2) {
          if (side < 0 ? p[a] == 0 : p[a] + 1 == size[a]) continue;
          const float other = phi.voxels[side < 0 ? voxel - stride[a] : voxel + stride[a]];
          if ((value < 0.0F) == (other < 0.0F)) continue;
          const auto axis = static_cast<Eigen::Index>(a);
          const double t = static_cast<double>(value) /
                           (static_cast<double>(value) - static_cast<double>(other));
          if (t * step_[axis] >= best) continue;
          best = t * step_[axis];
          foot.point = {1.0 * i, 1.0 * j, 1.0 * k};
          foot.point[axis] += side * t;
          foot.normal = Eigen::Vector3f::Zero();
          foot.normal[axis] = static_cast<float>(value < 0.0F ? side : -side);
        }
      if (best < std::numeric_limits<double>::max()) found(voxel, foot);
    }
}

void ClosestPoints::findCrossings(const Volume<float>& phi, const Progress& progress) {
  const auto slices = static_cast<std::size_t>(geometry_.size[2]);
  std::vector<std::vector<std::pair<std::uint32_t, KeptFoot>>> found(slices);
  parallelFor(0, slices, 1, [&](std::size_t k, std::size_t) {
    progress.check();
    crossingsOfSlice(phi, static_cast<int>(k), [&](std::size_t voxel, Foot foot) {
      const Foot start = foot;
      const Eigen::Vector3d x = position(voxel);
      if (toZero(foot) && distance(x, foot.point) <= distance(x, start.point) + 0.5)
        approach(x, foot);
      else
        foot = start;
      found[k].emplace_back(static_cast<std::uint32_t>(voxel), kept(foot, x));
    });
  });
  slot_ = Volume<std::int32_t>(geometry_, kNone);
  for (const auto& slice : found)
    for (const auto& [voxel, foot] : slice) {
      slot_.voxels[voxel] = static_cast<std::int32_t>(voxels_.size());
      voxels_.push_back(voxel);
      feet_.add(foot);
    }
}

/// The foot among those of a voxel's neighbours and its own that is nearest to it. False, and
/// `foot` as it was, if none is nearer than `within` or the nearest is its own.
bool ClosestPoints::bestOfNeighbours(std::size_t voxel, double within, Foot& foot) const {
  const Index3 p = geometry_.indexOf(voxel);
  const Eigen::Vector3f step = step_.cast<float>();
  auto least = static_cast<float>(within * within);
  std::int32_t best = kNone;
  Eigen::Vector3f to;
  forAround(geometry_, voxel, [&](std::size_t number, std::size_t next) {
    const std::int32_t slot = slot_.voxels[next];
    if (slot == kNone || slot == kFresh) return;
    const Index3& d = kSteps27[number];
    const Eigen::Vector3f away =
        offset(static_cast<std::size_t>(slot)) +
        step.cwiseProduct(Eigen::Vector3f(static_cast<float>(d[0]), static_cast<float>(d[1]),
                                          static_cast<float>(d[2])));
    const float square = away.squaredNorm();
    if (square < least) {
      least = square;
      best = slot;
      to = away;
    }
  });
  if (best == kNone || best == slot_.voxels[voxel]) return false;
  const KeptFoot& k = feet_[static_cast<std::size_t>(best)];
  foot.point = Eigen::Vector3d(p[0], p[1], p[2]) + to.cast<double>().cwiseQuotient(step_);
  for (std::size_t a = 0; a < 3; ++a)
    foot.normal[static_cast<Eigen::Index>(a)] = static_cast<float>(k.normal[a]) / kNormalScale;
  foot.bend = static_cast<float>(k.bend) / kBendScale;
  return true;
}

/// Adds the neighbours of the newest voxels, as far as they are within reach. False when none was
/// added.
bool ClosestPoints::grow(const Progress& progress) {
  std::vector<std::uint32_t> fresh;
  for (std::size_t n = frontier_; n < voxels_.size(); ++n)
    forNeighbours(geometry_, voxels_[n], [&](std::size_t, std::size_t next) {
      if (slot_.voxels[next] != kNone) return;
      slot_.voxels[next] = kFresh;
      fresh.push_back(static_cast<std::uint32_t>(next));
    });
  frontier_ = voxels_.size();
  std::vector<KeptFoot> found(fresh.size());
  std::vector<char> reached(fresh.size());
  parallelForEach(fresh.size(), kGrain, progress, [&](std::size_t n) {
    const Eigen::Vector3d x = position(fresh[n]);
    Foot foot;
    bestOfNeighbours(fresh[n], std::numeric_limits<double>::max(), foot);
    approach(x, foot);
    found[n] = kept(foot, x);
    reached[n] = static_cast<char>(distance(x, foot.point) <= reach_);
  });
  for (std::size_t n = 0; n < fresh.size(); ++n) {
    if (reached[n] == 0) {
      slot_.voxels[fresh[n]] = kNone;
      continue;
    }
    slot_.voxels[fresh[n]] = static_cast<std::int32_t>(voxels_.size());
    voxels_.push_back(fresh[n]);
    feet_.add(found[n]);
  }
  return voxels_.size() > frontier_;
}

/// Every voxel one of whose neighbours has a foot that is nearer starts again from there.
void ClosestPoints::relax(const Progress& progress) {
  std::vector<std::vector<std::pair<std::uint32_t, KeptFoot>>> found((count() + kGrain - 1) /
                                                                     kGrain);
  parallelFor(0, count(), kGrain, [&](std::size_t first, std::size_t last) {
    progress.check();
    for (std::size_t n = first; n < last; ++n) {
      Foot foot;
      if (!bestOfNeighbours(voxels_[n], std::max(distance(n) - kNearer, 0.0), foot)) continue;
      const Eigen::Vector3d x = position(voxels_[n]);
      approach(x, foot);
      found[first / kGrain].emplace_back(static_cast<std::uint32_t>(n), kept(foot, x));
    }
  });
  for (const auto& block : found)
    for (const auto& [n, foot] : block) feet_[n] = foot;
}

Volume<float> ClosestPoints::distances(const std::vector<bool>& inside, double bandVoxels) {
  slot_ = {};
  const double voxel = geometry_.voxelMm();
  const auto far = static_cast<float>(bandVoxels * voxel);
  Volume<float> out(geometry_, far);
  for (std::size_t i = 0; i < inside.size(); ++i)
    if (inside[i]) out.voxels[i] = -far;
  parallelForEach(count(), kGrain, [&](std::size_t n) {
    float& value = out.voxels[voxels_[n]];
    const auto d = static_cast<float>(distance(n) * voxel);
    // A voxel inside keeps its sign even where the surface runs through it.
    if (d < far) value = value < 0.0F ? -std::max(d, std::numeric_limits<float>::min()) : d;
  });
  return out;
}

/// Newton steps along the gradient in working-voxel space. False when they leave or stall.
bool ClosestPoints::toZero(Foot& foot) const {
  for (int n = 0; n < 20; ++n) {
    const SplineField::Jet jet = field_.atIndex(foot.point);
    const Eigen::Vector3d slope = jet.gradient.cwiseQuotient(step_);
    const double square = slope.squaredNorm();
    if (square < 1e-12) return false;
    Eigen::Vector3d move = -jet.value / square * slope;
    const double length = move.norm();
    if (length > 0.5) move *= 0.5 / length;
    foot.point += move.cwiseQuotient(step_);
    if (length < kLastStep) {
      foot.normal = (slope / std::sqrt(square)).cast<float>();
      return true;
    }
  }
  return false;
}

/// Walks from a point of the zero set to the one that is closest to x: steps within the tangent
/// plane, as long as the curvature found on the way suggests, halved when they do not shorten the
/// distance, each followed by a projection.
void ClosestPoints::approach(const Eigen::Vector3d& x, Foot& foot) const {
  double least = distance(x, foot.point);
  double part = 1.0;
  for (int n = 0; n < 10; ++n) {
    const Eigen::Vector3d normal = foot.normal.cast<double>();
    const Eigen::Vector3d away = step_.cwiseProduct(x - foot.point);
    const double height = away.dot(normal);
    Eigen::Vector3d along = away - height * normal;
    // The foot is off by `along` at most: the distance by about along^2 / 2 distance.
    const double square = along.squaredNorm();
    const double bend = static_cast<double>(foot.bend);
    along *= part / std::max(1.0 + bend * height, 0.25);
    const double length = along.norm();
    if (square < kTolerance * std::max(least, 0.02) || length < 1e-3) break;
    if (length > 1.0) along /= length;
    Foot next = foot;
    next.point += along.cwiseQuotient(step_);
    const bool found = toZero(next);
    const double d = distance(x, next.point);
    if (found) {
      const Eigen::Vector3d walked = step_.cwiseProduct(next.point - foot.point);
      const double turned = (next.normal - foot.normal).cast<double>().dot(walked);
      next.bend =
          static_cast<float>(std::clamp(turned / std::max(walked.squaredNorm(), 1e-12), -2.0, 2.0));
    }
    if (found && d < least) {
      foot = next;
      least = d;
    } else {
      part *= 0.4;
      if (found) foot.bend = next.bend;
    }
  }
}

}  // namespace

Volume<float> redistance(Volume<float> phi, double bandVoxels, const Progress& progress) {
  std::vector<bool> inside(phi.voxels.size());
  for (std::size_t i = 0; i < inside.size(); ++i) inside[i] = phi.voxels[i] < 0.0F;
  ClosestPoints closest(phi, bandVoxels);
  closest.findCrossings(phi, progress);
  phi = {};  // its signs are all that is needed from here on
  releaseFreedMemory();
  if (closest.count() == 0)
    throw NumericError("the level set has no surface", "redistancing",
                       "nothing, or everything, lies inside: check the seeds and levelset.b");
  progress.report(0.2);
  for (bool grown = true; grown;) grown = closest.grow(progress);
  progress.report(0.6);
  for (int n = 0; n < 2; ++n) closest.relax(progress);
  progress.report(0.9);
  return closest.distances(inside, bandVoxels);
}

}  // namespace angiomesh
