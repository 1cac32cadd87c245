// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <variant>

#include "core/base/random.h"
#include "core/phantom/curve_tube.h"
#include "core/phantom/rasterise.h"
#include "core/phantom/shape.h"
#include "core/phantom/wall_truth.h"
#include "tests/core/bars.h"
#include "tests/core/phantom_case.h"

using namespace angiomesh;
using analytic::paramsOf;
using Eigen::Vector3d;

namespace {

Vector3d randomPoint(std::uint64_t seed, std::uint64_t n) {
  return {randomNormal(seed, 3 * n), randomNormal(seed, 3 * n + 1), randomNormal(seed, 3 * n + 2)};
}

/// Points near the true wall: steps along the distance from random places of the volume.
std::vector<Vector3d> pointsNearTheWall(const PhantomParams& params, double reach) {
  const auto distance = phantomDistance(params);
  const Geometry g = phantomGeometry(params);
  std::vector<Vector3d> points;
  for (std::uint64_t n = 0; points.size() < 300 && n < 400000; ++n) {
    const Vector3d index(randomUniform(7, 3 * n) * g.size[0],
                         randomUniform(7, 3 * n + 1) * g.size[1],
                         randomUniform(7, 3 * n + 2) * g.size[2]);
    const Vector3d point = g.toPhysical(index);
    if (std::fabs(distance(point)) < reach) points.push_back(point);
  }
  return points;
}

}  // namespace

class TestWallTruth : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aTubesFootIsStraightBelow() {
    PhantomParams params = paramsOf(PhantomKind::Tube, 48, 5.0);
    params.spacingMm = {0.5, 0.5, 0.8};
    params.axis = {0.4, -0.2, 1.0};
    const WallTruth truth(params);
    const Vector3d axis = params.axis.normalized();
    const Geometry g = phantomGeometry(params);
    const Vector3d centre = g.toPhysical(Vector3d(23.5, 23.5, 23.5));
    for (std::uint64_t n = 0; n < 200; ++n) {
      const Vector3d way = randomPoint(1, n).cross(axis).normalized();
      const double depth = -1.0 + 2.0 * randomUniform(2, n);
      const Vector3d on = centre + (4.0 * randomUniform(3, n) - 2.0) * axis + 2.5 * way;
      const WallFoot foot = truth.footOf(on + depth * way);
      QVERIFY((foot.point - on).norm() < 1e-7);
      QVERIFY((foot.normal - way).norm() < 1e-6);
      QVERIFY(std::fabs(foot.signedDistanceMm - depth) < 1e-7);
      const WallCurvature curvature = truth.curvatureAt(foot);
      QVERIFY(std::fabs(curvature.largest - 1.0 / 2.5) < 1e-4);
      QVERIFY(std::fabs(curvature.least) < 1e-4);
      QVERIFY(std::fabs(truth.radiusAt(on) - 2.5) < 1e-9);
    }
    QVERIFY(truth.branchings().empty() && !truth.throat());
  }

  void aTorusBendsAsItDoes() {
    const PhantomParams params = paramsOf(PhantomKind::Torus, 64, 5.0);
    const WallTruth truth(params);
    const Vector3d centre = Vector3d::Constant(31.5);
    const double major = 16.0;
    for (const double turns : {0.0, 0.2, 0.5, 0.8}) {
      const double angle = 2.0 * M_PI * turns;
      const Vector3d on =
          centre + Vector3d(major + 5.0 * std::cos(angle), 0.0, 5.0 * std::sin(angle));
      const WallCurvature curvature = truth.curvatureAt(truth.footOf(on));
      const double around = std::cos(angle) / (major + 5.0 * std::cos(angle));
      QVERIFY(std::fabs(curvature.largest - 0.2) < 1e-4);
      QVERIFY(isNear(curvature.least, around, 1e-4));
    }
  }

  /// On every kind the foot lies on the wall, straight below the point, also where the function is
  /// no distance.
  void everyFootIsOnTheWall_data() {
    QTest::addColumn<int>("kind");
    for (std::size_t kind = 0; kind < phantomKindNames().size(); ++kind)
      QTest::newRow(phantomKindNames()[kind].c_str()) << static_cast<int>(kind);
  }
  void everyFootIsOnTheWall() {
    QFETCH(int, kind);
    PhantomParams params = paramsOf(static_cast<PhantomKind>(kind), 64, 3.0);
    params.axis = {0.2, 0.1, 1.0};
    const WallTruth truth(params);
    const auto distance = phantomDistance(params);
    const std::vector<Vector3d> points = pointsNearTheWall(params, 0.5);
    QVERIFY(points.size() > 50);
    std::size_t good = 0;
    for (const Vector3d& point : points) {
      const WallFoot foot = truth.footOf(point);
      QVERIFY(std::fabs(foot.normal.norm() - 1.0) < 1e-9);
      QCOMPARE(foot.signedDistanceMm < 0.0, distance(point) < 0.0);
      // No wall is nearer than the function says: its slope is at most 1.
      QVERIFY(std::fabs(foot.signedDistanceMm) > std::fabs(distance(point)) - 1e-4);
      const Vector3d way = point - foot.point;
      if (std::fabs(distance(foot.point)) < 1e-7 &&
          (way - way.dot(foot.normal) * foot.normal).norm() < 1e-6)
        ++good;
    }
    // Where walls meet in an edge, as the tree's do, nothing is straight below.
    QVERIFY2(static_cast<double>(good) >= 0.97 * static_cast<double>(points.size()),
             QByteArray::number(static_cast<double>(good)));
  }

  /// What is left out of a brick of voxels is farther off from all of it, wherever the grid lies.
  void theIndexOfAShapeHasItsDistances() {
    for (const PhantomKind kind : {PhantomKind::Tree, PhantomKind::CapsuleTree}) {
      PhantomParams params = paramsOf(kind, 64, 3.0);
      params.size = {64, 56, 72};
      params.spacingMm = {0.7, 0.9, 0.6};
      const Shape shape = makeShape(params);
      Geometry g = phantomGeometry(params);
      for (const double shift : {0.0, -8.0}) {
        g.origin = shift * g.spacing;
        const ShapeIndex index(shape, g);
        for (std::uint64_t n = 0; n < 20000; ++n) {
          Vector3d at;
          for (int a = 0; a < 3; ++a)
            at[a] = 84.0 * randomUniform(9, 3 * n + static_cast<std::uint64_t>(a)) - 10.0;
          // Near the corners of bricks.
          if (n % 2 == 0)
            for (double& x : at) x = 8.0 * std::round(x / 8.0) - 0.5 + 0.05 * (x - std::round(x));
          const Vector3d point = g.toPhysical(at);
          QCOMPARE(index.signedDistance(point), shape.signedDistance(point));
        }
      }
    }
  }

  void branchingsAreWhereVesselsMeet() {
    const auto count = [](PhantomKind kind) {
      return WallTruth(paramsOf(kind, 64, 4.0)).branchings().size();
    };
    for (const PhantomKind kind :
         {PhantomKind::Tube, PhantomKind::Torus, PhantomKind::Helix, PhantomKind::Kissing,
          PhantomKind::Stenosis, PhantomKind::Cone, PhantomKind::BentTube})
      QCOMPARE(count(kind), std::size_t{0});
    for (const PhantomKind kind :
         {PhantomKind::Bifurcation, PhantomKind::Aneurysm, PhantomKind::NeckAneurysm})
      QCOMPARE(count(kind), std::size_t{1});
    // At the trunk's end and at each branch's; the bridge goes from tip to tip.
    QCOMPARE(count(PhantomKind::CapsuleTree), std::size_t{3});
    const WallTruth fork(paramsOf(PhantomKind::Bifurcation, 64, 4.0));
    const Branching& place = fork.branchings().front();
    QVERIFY((place.point - Vector3d::Constant(31.5)).norm() < 1e-9);
    QCOMPARE(place.radiusMm, 4.0);
    QVERIFY(fork.nearBranching(place.point + Vector3d(6.9, 0, 0)));
    QVERIFY(!fork.nearBranching(place.point + Vector3d(7.1, 0, 0)));
  }

  /// The thickest of the vessels that meet, also of one that goes on: of that where it passes.
  void branchingsAreAsWideAsTheThickestVessel() {
    std::size_t passed = 0;
    for (const PhantomKind kind :
         {PhantomKind::Bifurcation, PhantomKind::Tree, PhantomKind::CapsuleTree,
          PhantomKind::VesselTree, PhantomKind::Aneurysm, PhantomKind::NeckAneurysm})
      for (const std::uint64_t seed : {1, 2, 3}) {
        PhantomParams params = paramsOf(kind, 128, 4.0);
        params.spacingMm = {0.5, 0.5, 0.5};
        params.randomSeed = seed;
        const std::vector<CentreLineSegment> lines = makeShape(params).centreLines;
        const WallTruth truth(params);
        for (const Branching& place : truth.branchings()) {
          double thickest = 0.0;
          for (const CentreLineSegment& s : lines) {
            const Vector3d way = s.to - s.from;
            const double t = (place.point - s.from).dot(way) / way.squaredNorm();
            if (t < -1e-6 || t > 1.0 + 1e-6 || (place.point - s.from - t * way).norm() > 1e-6)
              continue;
            thickest = std::max(thickest, s.radiusFromMm + t * (s.radiusToMm - s.radiusFromMm));
            if (t > 0.01 && t < 0.99) ++passed;
          }
          QVERIFY(isNear(place.radiusMm, thickest, 1e-6));
        }
      }
    QVERIFY(passed > 0);
  }

  /// It changes evenly along a line, and the nearest wall counts, not the nearest line.
  void radiiAreThoseOfTheNearestWall() {
    const Vector3d way = Vector3d(0.6, 0.0, 0.8), aside = way.unitOrthogonal();
    CentreLineSegment cone, ball;
    cone.from = {3.0, -2.0, 1.0};
    cone.to = cone.from + 10.0 * way;
    cone.radiusFromMm = 3.0;
    cone.radiusToMm = 1.0;
    for (const auto& [along, radius] :
         {std::pair{-4.0, 3.0}, std::pair{0.0, 3.0}, std::pair{2.5, 2.5}, std::pair{10.0, 1.0},
          std::pair{13.0, 1.0}})
      for (const double off : {0.0, 0.7, 6.0})
        QVERIFY(isNear(nearestVesselRadius({cone}, cone.from + along * way + off * aside), radius,
                       1e-12));
    // Lines without length are balls.
    ball.from = ball.to = cone.from + 8.0 * way + 9.0 * aside;
    ball.radiusFromMm = ball.radiusToMm = 6.0;
    const Vector3d between = cone.from + 8.0 * way + 3.0 * aside;
    for (const auto& lines : {std::vector{cone, ball}, std::vector{ball, cone}})
      QCOMPARE(nearestVesselRadius(lines, between), 6.0);
    QCOMPARE(nearestVesselRadius({}, between), 0.0);
  }

  void aVesselTreeIsWhatItSays() {
    for (const std::uint64_t seed : {1, 2, 3}) {
      PhantomParams params = paramsOf(PhantomKind::VesselTree, 128, 4.0);
      params.randomSeed = seed;
      const Phantom phantom = makePhantom(params);
      double thinnest = 1e9;
      double thickest = 0.0;
      for (const CentreLineSegment& s : phantom.centreLines) {
        thinnest = std::min({thinnest, s.radiusFromMm, s.radiusToMm});
        thickest = std::max({thickest, s.radiusFromMm, s.radiusToMm});
      }
      QVERIFY2(thinnest > 1.25 && thinnest < 1.6, QByteArray::number(thinnest));
      QVERIFY2(thickest > 6.0 && thickest < 8.0, QByteArray::number(thickest));
      QCOMPARE(connectedComponents(phantom.truth).sizes.size(), std::size_t{1});
      QVERIFY(WallTruth(params).branchings().size() >= 6);
    }
  }

  // Branches leave their parent for good and keep off all others: no two vessels touch but where
  // one leaves the other.
  void branchesOfAVesselTreeKeepApart() {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      PhantomParams params = paramsOf(PhantomKind::VesselTree, 128, 4.0);
      params.randomSeed = seed;
      const Shape shape = makeShape(params);
      const double gap = std::max(3.0, 1.5 * shape.blendMm);
      for (std::size_t n = 3; n < shape.solids.size(); ++n) {
        const CurveTube& tube = std::get<CurveTube>(shape.solids[n]);
        const Vector3d start = tube.centreAt(0.0);
        for (std::size_t other = 0; other < n; ++other) {
          // The parent is the one that the start lies deep in. It is left at 0.14 turns or more.
          const double depth = -signedDistance(shape.solids[other], start);
          const double beside = 1.2 * (depth + tube.radiusAt(0.0) + gap) / std::sin(0.28 * M_PI);
          for (double t = 0.0; t <= tube.length(); t += 0.0625) {
            const Vector3d p = tube.centreAt(t);
            if (depth > 0.0 && (p - start).norm() < beside) continue;
            const double clear = signedDistance(shape.solids[other], p) - tube.radiusAt(t);
            QVERIFY(isAbove(clear, gap - 1e-9));
          }
        }
      }
    }
  }

  void stenosesNarrowByWhatIsAsked() {
    for (const double percent : {50.0, 70.0, 90.0}) {
      PhantomParams params = paramsOf(PhantomKind::Stenosis, 64, 5.0);
      params.stenosisPercent = percent;
      const auto distance = phantomDistance(params);
      const double radius = 5.0 * (1.0 - 0.01 * percent);
      const Vector3d centre = Vector3d::Constant(31.5);
      QVERIFY(distance(centre + Vector3d(0.999 * radius, 0, 0)) < 0.0);
      QVERIFY(distance(centre + Vector3d(1.001 * radius, 0, 0)) > 0.0);
      QVERIFY(distance(centre + Vector3d(4.999, 0, 16.0)) < 0.0);
    }
  }

  /// A curved tube is the union of its balls.
  void aCurveTubeHoldsItsBalls() {
    const std::vector<Vector3d> points{{0, 0, 0}, {4, 1, 0}, {7, 5, 2}, {6, 9, 6}};
    const CurveTube tube(points, {2.0, 1.5, 1.6, 1.0});
    for (std::size_t n = 0; n < points.size(); ++n)
      QVERIFY((tube.centreAt(static_cast<double>(n)) - points[n]).norm() < 1e-12);
    constexpr int steps = 6000;
    for (std::uint64_t n = 0; n < 200; ++n) {
      const Vector3d point = Vector3d(4, 4, 3) + 4.0 * randomPoint(5, n);
      double least = 1e9;
      for (int i = 0; i <= steps; ++i) {
        const double t = tube.length() * i / steps;
        least = std::min(least, (point - tube.centreAt(t)).norm() - tube.radiusAt(t));
      }
      const double found = tube.signedDistance(point);
      QVERIFY2(found <= least + 1e-12 && found > least - 1e-5, QByteArray::number(found - least));
    }
    // A straight one of one radius is a capsule.
    const CurveTube straight({{0, 0, 0}, {3, 0, 0}, {9, 0, 0}}, {1.0, 1.0, 1.0});
    const RoundCone capsule({0, 0, 0}, {9, 0, 0}, 1.0, 1.0);
    for (std::uint64_t n = 0; n < 100; ++n) {
      const Vector3d point = Vector3d(4, 0, 0) + 4.0 * randomPoint(6, n);
      QVERIFY(std::fabs(straight.signedDistance(point) - capsule.signedDistance(point)) < 1e-9);
    }
  }
};

QTEST_GUILESS_MAIN(TestWallTruth)
#include "tst_wall_truth.moc"
