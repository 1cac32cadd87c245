// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/clutter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/phantom/rasterise.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr std::uint64_t kClutterStream = 0x636c7574;  // apart from the noise of the same seed
constexpr double kLeastSide = 40.0;                   // mm and voxels
constexpr double kShellMm = 3.0, kPlateMm = 2.0, kBoneMm = 3.0;
constexpr double kBoneRadiusMm = 12.0;
constexpr double kBlobRadiiMm[] = {7.5, 2.5, 2.5};
constexpr double kBlobIntensities[] = {200.0, 255.0, 230.0};
constexpr double kClearance = 3.0, kVeinClearance = 1.5, kVeinGap = 2.0;  // voxels
constexpr double kSlabLevels[] = {0.0, 20.0, 8.0, 28.0};
constexpr int kDirections = 16;  // around a vessel, where the bone and the vein may lie

struct Body {
  ClutterPiece piece;
  Vector3d low, high;  ///< holds all of it, mm
  double clearance = 0.0;
  std::function<double(const Vector3d&)> distance;  ///< exact, negative inside, mm
};

/// A box around `centre` with edges rounded by `round`.
double roundedBox(const Vector3d& fromCentre, const Vector3d& half, double round) {
  const Vector3d q = fromCentre.cwiseAbs() - half + Vector3d::Constant(round);
  const Vector3d outside = q.cwiseMax(0.0);
  return outside.norm() + std::min(q.maxCoeff(), 0.0) - round;
}

/// The vessels' surroundings and where the pieces go.
class Placement {
 public:
  Placement(const PhantomParams& params, const Shape& shape, const Geometry& g,
            const Progress& progress)
      : shape_(shape),
        g_(g),
        field_(sampleField(shape, g, progress)),
        random_(randomBits(params.randomSeed, kClutterStream)),
        unit_(g.voxelMm()) {
    low_ = -0.5 * g.spacing;
    high_ = low_ + g.spacing.cwiseProduct(Vector3d(g.size[0], g.size[1], g.size[2]));
  }

  [[nodiscard]] double toVessels(const Vector3d& p) const {
    return interpolateLinear(field_, p.cwiseQuotient(g_.spacing));
  }

  std::vector<Body> all() {
    addShell();
    addVein();
    addBone();
    for (std::size_t i = 0; i < std::size(kBlobRadiiMm); ++i)
      addBlob(kBlobRadiiMm[i], kBlobIntensities[i]);
    addPlate();
    return std::move(solids_);
  }

 private:
  double uniform() { return randomUniform(random_, counter_++); }

  void add(const char* kind, int label, double intensity, double clearance, int segment,
           const Vector3d& from, const Vector3d& to, double margin,
           std::function<double(const Vector3d&)> distance) {
    Body solid;
    solid.piece = {kind, static_cast<std::uint8_t>(label), intensity, from, to, segment};
    solid.low = from.cwiseMin(to) - Vector3d::Constant(margin);
    solid.high = from.cwiseMax(to) + Vector3d::Constant(margin);
    solid.clearance = clearance;
    solid.distance = std::move(distance);
    solids_.push_back(std::move(solid));
  }

  void addShell() {
    const Vector3d centre = 0.5 * (low_ + high_);
    const Vector3d half = 0.5 * (high_ - low_) - 2.0 * g_.spacing;
    const double round = 0.4 * half.minCoeff();
    add("shell", 1, 230.0, kClearance * unit_, -1, centre - half, centre + half, 0.0,
        [=](const Vector3d& p) {
          const double d = roundedBox(p - centre, half, round);
          return std::max(d, -d - kShellMm);
        });
  }

  /// To all that is bright, and to the border.
  [[nodiscard]] double room(const Vector3d& p) const {
    double least = toVessels(p);
    for (const Body& s : solids_) least = std::min(least, s.distance(p));
    return std::min({least, (p - low_).minCoeff(), (high_ - p).minCoeff()});
  }

  /// Where there is most room, with some luck.
  Vector3d roomiest(double enough) {
    Vector3d best = 0.5 * (low_ + high_);
    double most = -1.0;
    constexpr int samples = 3000;
    for (int i = 0; i < samples; ++i) {
      Vector3d p;
      for (int a = 0; a < 3; ++a) p[a] = low_[a] + uniform() * (high_[a] - low_[a]);
      const double score = std::min(room(p), enough) + 0.02 * enough * uniform();
      if (score > most) {
        most = score;
        best = p;
      }
    }
    return best;
  }

  void addBlob(double radius, double intensity) {
    const double clear = kClearance * unit_;
    const Vector3d centre = roomiest(radius + clear + unit_);
    const Vector3d half = Vector3d::Constant(radius);
    add("blob", 3, intensity, clear, -1, centre - half, centre + half, 0.0,
        [=](const Vector3d& p) { return (p - centre).norm() - radius; });
  }

  void addPlate() {
    const double wide = 0.125 * (high_ - low_).minCoeff();
    const double clear = kClearance * unit_;
    const Vector3d centre = roomiest(wide + clear);
    Vector3d normal(uniform() - 0.5, uniform() - 0.5, uniform() + 0.5);
    normal /= normal.norm();
    Vector3d first(normal[2], 0.0, -normal[0]);
    first /= first.norm();
    const Vector3d second(normal[1] * first[2] - normal[2] * first[1],
                          normal[2] * first[0] - normal[0] * first[2],
                          normal[0] * first[1] - normal[1] * first[0]);
    const Vector3d half(wide, wide, 0.5 * kPlateMm);
    const Vector3d extent =
        wide * (first.cwiseAbs() + second.cwiseAbs()) + 0.5 * kPlateMm * normal.cwiseAbs();
    add("plate", 2, 180.0, clear, -1, centre - extent, centre + extent, 0.0,
        [=](const Vector3d& p) {
          const Vector3d d = p - centre;
          return roundedBox({d.dot(first), d.dot(second), d.dot(normal)}, half, 0.0);
        });
  }

  struct Beside {
    int segment = -1;
    Vector3d outwards = Vector3d::UnitX();
    double score = -std::numeric_limits<double>::max();
  };

  /// The segment and the direction away from it with the highest score.
  template <class Score>
  [[nodiscard]] Beside bestBeside(const Score& score) const {
    Beside best;
    for (std::size_t n = 0; n < shape_.centreLines.size(); ++n) {
      const CentreLineSegment& s = shape_.centreLines[n];
      const double length = (s.to - s.from).norm();
      if (length < unit_) continue;
      const Vector3d along = (s.to - s.from) / length;
      const auto [side, other] = acrossOf(along);
      for (int d = 0; d < kDirections; ++d) {
        const double turns = static_cast<double>(d) / kDirections;
        const Vector3d outwards = portableCosTurns(turns) * side + portableSinTurns(turns) * other;
        const double value = score(s, length, outwards);
        if (value > best.score) best = {static_cast<int>(n), outwards, value};
      }
    }
    return best;
  }

  /// Along the middle of the segment, which the vein accompanies, from `from` to `to`.
  struct Companion {
    Vector3d from, to;
  };
  [[nodiscard]] Companion companion(const CentreLineSegment& s, const Vector3d& outwards) const {
    const double apart = s.radiusFromMm + s.radiusToMm + kVeinGap * unit_;
    const Vector3d step = s.to - s.from;
    return {s.from + 0.1 * step + apart * outwards, s.to - 0.1 * step + apart * outwards};
  }

  void addVein() {
    const Beside best =
        bestBeside([&](const CentreLineSegment& s, double length, const Vector3d& outwards) {
          const double radius = 0.5 * (s.radiusFromMm + s.radiusToMm);
          const auto [from, to] = companion(s, outwards);
          double free = 0.0;
          constexpr int samples = 10;
          for (int i = 0; i <= samples; ++i)
            if (room(from + (to - from) * i / samples) > radius + 0.8 * kVeinGap * unit_)
              free += 1.0;
          return free / (samples + 1) * length * std::min(radius, 3.0 * unit_);
        });
    if (best.segment < 0) return;
    const CentreLineSegment& s = shape_.centreLines[static_cast<std::size_t>(best.segment)];
    const auto [from, to] = companion(s, best.outwards);
    const double radius = 0.5 * (s.radiusFromMm + s.radiusToMm);
    const RoundCone cone(from, to, radius, radius);
    vein_ = best.segment;
    add("vein", 5, 200.0, kVeinClearance * unit_, best.segment, from, to, radius,
        [=](const Vector3d& p) { return cone.signedDistance(p); });
  }

  void addBone() {
    const auto centreOf = [](const CentreLineSegment& s, const Vector3d& outwards) -> Vector3d {
      return 0.5 * (s.from + s.to) +
             (0.5 * (s.radiusFromMm + s.radiusToMm) + kBoneRadiusMm) * outwards;
    };
    const Beside best =
        bestBeside([&](const CentreLineSegment& s, double length, const Vector3d& outwards) {
          if (vein_ >= 0 && &s == &shape_.centreLines[static_cast<std::size_t>(vein_)])
            return -std::numeric_limits<double>::max();
          return std::min(room(centreOf(s, outwards)), kBoneRadiusMm) +
                 0.2 * std::min(length, kBoneRadiusMm) +
                 std::min(0.5 * (s.radiusFromMm + s.radiusToMm), 3.0 * unit_);
        });
    const int segment = best.segment >= 0 ? best.segment : vein_;
    if (segment < 0) return;
    const Vector3d outwards = best.segment >= 0 ? best.outwards : Vector3d::UnitX();
    const Vector3d centre =
        centreOf(shape_.centreLines[static_cast<std::size_t>(segment)], outwards);
    const Vector3d half = Vector3d::Constant(kBoneRadiusMm);
    add("bone", 4, 400.0, 0.0, segment, centre - half, centre + half, 0.0, [=](const Vector3d& p) {
      const Vector3d d = p - centre;
      const double r = d.norm();
      const double shell = std::max(r - kBoneRadiusMm, kBoneRadiusMm - kBoneMm - r);
      return std::max(shell, d.dot(outwards) + 0.5 * kBoneRadiusMm);  // 60 degrees about the touch
    });
  }

  const Shape& shape_;
  Geometry g_;
  Volume<float> field_;
  std::uint64_t random_;
  std::uint64_t counter_ = 0;
  double unit_;
  Vector3d low_, high_;
  int vein_ = -1;
  std::vector<Body> solids_;
};

/// What of the solid is drawn: it keeps clear of the vessels.
bool drawn(const Body& solid, const Placement& placement, const Vector3d& p) {
  return solid.distance(p) < 0.0 && placement.toVessels(p) > solid.clearance;
}

void draw(Phantom& phantom, Volume<float>& bright, Volume<std::uint8_t>& taken, const Body& solid,
          const Placement& placement, const Progress& progress) {
  const Geometry& g = phantom.image.geometry;
  const Vector3d quarter = 0.25 * g.spacing;
  const double reach = quarter.norm() * (1.0 + 1e-9);
  Index3 first;
  Index3 last;
  for (int a = 0; a < 3; ++a) {
    first[a] = std::max(0, static_cast<int>(std::floor(solid.low[a] / g.spacing[a])));
    last[a] = std::min(g.size[a] - 1, static_cast<int>(std::ceil(solid.high[a] / g.spacing[a])));
    if (first[a] > last[a]) return;
  }
  const auto slices = static_cast<std::size_t>(last[2] - first[2] + 1);
  parallelForEach(slices, 1, progress, [&](std::size_t slice) {
    const int k = first[2] + static_cast<int>(slice);
    for (int j = first[1]; j <= last[1]; ++j)
      for (int i = first[0]; i <= last[0]; ++i) {
        const Vector3d centre = g.spacing.cwiseProduct(Vector3d(i, j, k));
        if (solid.distance(centre) > reach) continue;
        int count = 0;
        for (int corner = 0; corner < 8; ++corner) {
          const Vector3d sign((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0,
                              (corner & 4) != 0 ? 1.0 : -1.0);
          if (drawn(solid, placement, centre + sign.cwiseProduct(quarter))) ++count;
        }
        std::uint8_t& used = taken.at(i, j, k);
        count = std::min(count, 8 - used);
        if (count == 0) continue;
        used = static_cast<std::uint8_t>(used + count);
        bright.at(i, j, k) += static_cast<float>(solid.piece.intensity * count / 8.0);
        if (count >= 4 && phantom.truth.at(i, j, k) == 0)
          phantom.clutter.at(i, j, k) = solid.piece.label;
      }
  });
}

void addSlabs(Phantom& phantom) {
  const Geometry& g = phantom.image.geometry;
  const auto slice = static_cast<std::size_t>(g.size[0]) * static_cast<std::size_t>(g.size[1]);
  const int slabs = static_cast<int>(std::size(kSlabLevels));
  for (int n = 0; n < slabs; ++n) {
    const int first = g.size[2] * n / slabs;
    const int last = g.size[2] * (n + 1) / slabs;
    const double level = kSlabLevels[n];
    for (std::size_t i = static_cast<std::size_t>(first) * slice;
         i < static_cast<std::size_t>(last) * slice; ++i)
      phantom.image.voxels[i] += static_cast<float>(level);
    ClutterPiece piece;
    piece.kind = "slab";
    piece.intensity = level;
    piece.from = {-0.5 * g.spacing[0], -0.5 * g.spacing[1], (first - 0.5) * g.spacing[2]};
    piece.to = {(g.size[0] - 0.5) * g.spacing[0], (g.size[1] - 0.5) * g.spacing[1],
                (last - 0.5) * g.spacing[2]};
    phantom.pieces.push_back(std::move(piece));
  }
}

}  // namespace

void addClutter(Phantom& phantom, const PhantomParams& params, const Shape& shape,
                const Progress& progress) {
  progress.phase("phantom: clutter");
  const Geometry& g = phantom.image.geometry;
  const double shortest =
      g.spacing.cwiseProduct(Vector3d(g.size[0], g.size[1], g.size[2])).minCoeff();
  if (shortest < kLeastSide || shortest < kLeastSide * g.voxelMm())
    throw InputError("the volume is too small for clutter", "phantom size",
                     "give at least 40 mm and 40 voxels of the smallest spacing in each direction");
  Placement placement(params, shape, g, progress.sub(0.0, 0.5));
  Volume<std::uint8_t> taken = countSubvoxels(shape, g, progress.sub(0.5, 0.7));
  phantom.clutter = Volume<std::uint8_t>(g);
  Volume<float> bright(g);
  for (const Body& solid : placement.all()) {
    draw(phantom, bright, taken, solid, placement, progress);
    phantom.pieces.push_back(solid.piece);
  }
  blurVoxels(bright, params.psf, progress);
  for (std::size_t i = 0; i < bright.voxels.size(); ++i)
    phantom.image.voxels[i] += bright.voxels[i];
  addSlabs(phantom);
  progress.report(1.0);
}

}  // namespace angiomesh
