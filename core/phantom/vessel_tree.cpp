// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/vessel_tree.h"

#include <algorithm>
#include <cmath>

#include "core/base/exact_math.h"
#include "core/base/random.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr std::uint64_t kStream = 0x76657373;  // apart from the noise of the same seed
constexpr int kDraws = 120;                    // of a branch, until one finds room
constexpr int kSteps = 8;                      // of the centre lines, for each piece of a spline
constexpr double kLeastLean = 0.14;            // turns, of a branch against its parent
constexpr double kGoldenTurns = 0.381966011250105;

/// A vessel with the numbers of its centre lines.
struct Vessel {
  CurveTube tube;
  std::vector<int> lines;  ///< of each of the kSteps per piece; -1 outside the volume
};

/// Where and how a branch leaves its parent.
struct Take {
  std::size_t parent = 0;
  double t = 0.0, turns = 0.0;  ///< along the parent and around it
  double length = 0.0, radiusFrom = 0.0, radiusTo = 0.0;
};

class TreeBuilder {
 public:
  TreeBuilder(Shape& shape, const ShapeFrame& frame, std::uint64_t randomSeed)
      : shape_(shape), f_(frame), random_(randomBits(randomSeed, kStream)) {}

  void build() {
    shape_.blendMm = 0.4 * f_.radius;
    addMain();
    addAneurysm();
    const double r = f_.radius;
    const double start = uniform();
    constexpr double places[] = {1.25, 1.875, 2.5, 3.125, 3.625};
    constexpr double radii[][2] = {
        {0.9, 0.62}, {0.75, 0.5}, {0.62, 0.42}, {0.55, 0.36}, {0.5, 0.325}};
    for (std::size_t i = 0; i < std::size(places); ++i)
      addBranch({0, places[i], start + kGoldenTurns * static_cast<double>(i), 0.62 * f_.halfSide,
                 radii[i][0] * r, radii[i][1] * r});
    const std::size_t branches = vessels_.size();
    for (std::size_t v = 1; v < branches; ++v)
      for (const double t : {1.25, 2.125}) {
        const double radius = 0.72 * vessels_[v].tube.radiusAt(t);
        if (radius < 0.36 * r) continue;
        addBranch({v, t, uniform(), 0.38 * f_.halfSide, radius, std::max(0.7 * radius, 0.325 * r)});
      }
  }

 private:
  double uniform() { return randomUniform(random_, counter_++); }
  double between(double low, double high) { return low + (high - low) * uniform(); }

  /// A direction across `axis`, of length 1.
  static Vector3d across(const Vector3d& axis, double turns) {
    const auto [u, v] = acrossOf(axis);
    return portableCosTurns(turns) * u + portableSinTurns(turns) * v;
  }

  void add(CurveTube tube, int parent) {
    Vessel vessel{std::move(tube), {}};
    const int steps = static_cast<int>(vessel.tube.length()) * kSteps;
    int last = parent;
    for (int i = 0; i < steps; ++i) {
      const double from = static_cast<double>(i) / kSteps;
      const double to = static_cast<double>(i + 1) / kSteps;
      last = addCentreLine(shape_, f_, {vessel.tube.centreAt(from), vessel.tube.centreAt(to)},
                           {vessel.tube.radiusAt(from), vessel.tube.radiusAt(to)}, last);
      vessel.lines.push_back(last);
    }
    shape_.solids.emplace_back(vessel.tube);
    vessels_.push_back(std::move(vessel));
  }

  void addMain() {
    const auto leave = clipToVolume(f_, f_.centre, f_.at(0, 0, -f_.through));
    const double exit = (leave ? (*leave)[1] : 1.0) * f_.through;
    const double half = f_.halfSide;
    const double wave = 0.2 * half;
    std::vector<Vector3d> points{f_.at(0, 0, -exit - 10.0 * f_.unit - 2.0 * f_.radius)};
    double turns = uniform();
    for (const double level : {-0.5, -0.08, 0.34}) {
      turns += between(0.3, 0.6);
      const double aside = wave * between(0.5, 1.0);
      points.push_back(
          f_.at(aside * portableCosTurns(turns), aside * portableSinTurns(turns), level * half));
    }
    turns += between(0.3, 0.6);
    points.push_back(
        f_.at(wave * portableCosTurns(turns), wave * portableSinTurns(turns), 0.72 * half));
    std::vector<double> radii;
    for (const double share : {1.55, 1.5, 1.25, 1.0, 0.8}) radii.push_back(share * f_.radius);
    add(CurveTube(points, radii), -1);
  }

  void addAneurysm() {
    const CurveTube& main = vessels_.front().tube;
    constexpr double t = 1.625;
    const Vector3d from = main.centreAt(t);
    const double radius = main.radiusAt(t);
    const double sac = 1.3 * radius;
    for (int draw = 0; draw < kDraws; ++draw) {
      const Vector3d aside = across(main.tangentAt(t), uniform());
      const Vector3d centre = from + (1.3 * radius + 0.9 * sac) * aside;
      if (draw + 1 < kDraws && !inside(centre, sac)) continue;
      shape_.solids.emplace_back(RoundCone(from, centre, 0.6 * radius, 0.6 * radius));
      shape_.solids.emplace_back(RoundCone(centre, centre, sac, sac));
      shape_.centreLines.push_back({from, centre, 0.6 * radius, sac, lineAt(0, t)});
      return;
    }
  }

  /// The centre line that ends at a vessel's parameter, a multiple of 1 / kSteps.
  [[nodiscard]] int lineAt(std::size_t vessel, double t) const {
    const auto step = static_cast<std::size_t>(std::lround(t * kSteps));
    return vessels_[vessel].lines[step - 1];
  }

  /// Whether a ball lies well inside the volume.
  [[nodiscard]] bool inside(const Vector3d& centre, double radius) const {
    const double room = radius + 4.0 * f_.unit;
    for (int a = 0; a < 3; ++a)
      if (centre[a] < f_.low[a] + room || centre[a] > f_.high[a] - room) return false;
    return true;
  }

  [[nodiscard]] bool fits(const CurveTube& tube, const Take& take) const {
    const CurveTube& parent = vessels_[take.parent].tube;
    const double gap = std::max(3.0 * f_.unit, 1.5 * shape_.blendMm);
    // So far a vessel that leaves at the least angle stays beside its parent.
    const double joined =
        1.2 * (parent.radiusAt(take.t) + take.radiusFrom + gap) / portableSinTurns(kLeastLean);
    const Vector3d start = tube.centreAt(0.0);
    const int steps = static_cast<int>(tube.length()) * 2 * kSteps;
    for (int i = 0; i <= steps; ++i) {
      const double t = 0.5 * i / kSteps;
      const Vector3d centre = tube.centreAt(t);
      const double radius = tube.radiusAt(t);
      if (!inside(centre, radius)) return false;
      const bool near = (centre - start).norm() < joined;
      for (std::size_t n = 0; n < shape_.solids.size(); ++n) {
        if (near && n == solidOf(take.parent)) continue;
        if (signedDistance(shape_.solids[n], centre) < radius + gap) return false;
      }
    }
    return true;
  }

  /// The main vessel's solid is followed by the two of the aneurysm.
  [[nodiscard]] static std::size_t solidOf(std::size_t vessel) {
    return vessel == 0 ? 0 : vessel + 2;
  }

  void addBranch(const Take& take) {
    const CurveTube& parent = vessels_[take.parent].tube;
    const Vector3d from = parent.centreAt(take.t);
    const Vector3d tangent = parent.tangentAt(take.t);
    for (int draw = 0; draw < kDraws; ++draw) {
      const double shorter = 1.0 - 0.55 * draw / kDraws;
      const double astray = 0.5 * draw / kDraws;
      const Vector3d aside = across(tangent, take.turns + astray * between(-1.0, 1.0));
      const double lean = between(kLeastLean, 0.21);
      Vector3d way = portableCosTurns(lean) * tangent + portableSinTurns(lean) * aside;
      std::vector<Vector3d> points{from};
      const double step = shorter * take.length / 3.0;
      for (int i = 0; i < 3; ++i) {
        points.push_back(points.back() + (step + (i == 0 ? parent.radiusAt(take.t) : 0.0)) * way);
        const Vector3d bend = across(way, uniform());
        const double angle = between(0.03, 0.09);
        way = portableCosTurns(angle) * way + portableSinTurns(angle) * bend;
      }
      std::vector<double> radii;
      for (int i = 0; i <= 3; ++i)
        radii.push_back(take.radiusFrom + (take.radiusTo - take.radiusFrom) * i / 3.0);
      CurveTube tube(points, radii);
      if (!fits(tube, take)) continue;
      add(std::move(tube), lineAt(take.parent, take.t));
      return;
    }
  }

  Shape& shape_;
  const ShapeFrame& f_;
  std::uint64_t random_;
  std::uint64_t counter_ = 0;
  std::vector<Vessel> vessels_;
};

}  // namespace

void buildVesselTree(Shape& shape, const ShapeFrame& frame, std::uint64_t randomSeed) {
  requireRoom(frame, 7.0 * frame.radius, "vessel tree");
  TreeBuilder(shape, frame, randomSeed).build();
}

}  // namespace angiomesh
