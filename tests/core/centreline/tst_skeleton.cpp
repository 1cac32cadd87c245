// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/centreline/skeleton.h"
#include "core/distance/redistance.h"
#include "core/phantom/phantom.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"
#include "tests/core/phantom_case.h"
#include "tests/core/threads.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using namespace angiomesh::analytic;
using Eigen::Vector3d;

namespace {

double toLines(const Vector3d& x, const std::vector<CentreLineSegment>& lines) {
  double least = 1e9;
  for (const CentreLineSegment& s : lines) least = std::min(least, capsule(x, s.from, s.to, 0.0));
  return least;
}

/// How far the points of a skeleton are from a centre line and their radii from a radius.
template <class Distance>
void verifyLine(const Skeleton& skeleton, Distance distance, double radiusMm, double mostOff,
                double mostRadiusOff) {
  double off = 0.0;
  double radiusOff = 0.0;
  for (const SkeletonBranch& branch : skeleton.branches)
    for (const SkeletonPoint& p : branch.points) {
      off = std::max(off, distance(p.pointLps));
      radiusOff = std::max(radiusOff, std::fabs(p.radiusMm - radiusMm));
    }
  QVERIFY2(off < mostOff && radiusOff < mostRadiusOff,
           qPrintable(QString("off by %1, radius by %2").arg(off).arg(radiusOff)));
}

std::vector<NodeKind> kindsOf(const Skeleton& skeleton) {
  std::vector<NodeKind> kinds;
  for (const SkeletonNode& node : skeleton.nodes) kinds.push_back(node.kind);
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

/// Against the centre lines of a phantom of 1 mm voxels.
struct Comparison {
  double mean = 0.0, most = 0.0, nearShare = 0.0;  ///< of the skeleton's points; near: within 0.5
  double recall = 0.0;                             ///< of the true lines, within 1
  double length = 0.0, trueLength = 0.0;
};

Comparison compared(const Skeleton& skeleton, const std::vector<CentreLineSegment>& truth) {
  Comparison result;
  std::vector<CentreLineSegment> mine;
  double count = 0.0;
  for (const SkeletonBranch& branch : skeleton.branches) {
    result.length += branch.lengthMm;
    for (std::size_t i = 0; i < branch.points.size(); ++i) {
      const double off = toLines(branch.points[i].pointLps, truth);
      result.mean += off;
      result.most = std::max(result.most, off);
      if (off < 0.5) result.nearShare += 1.0;
      count += 1.0;
      if (i > 0)
        mine.push_back({branch.points[i - 1].pointLps, branch.points[i].pointLps, 0.0, 0.0, -1});
    }
  }
  result.mean /= count;
  result.nearShare /= count;
  double all = 0.0;
  for (const CentreLineSegment& s : truth) {
    const double length = (s.to - s.from).norm();
    result.trueLength += length;
    for (double at = 0.0; at < length; at += 0.5) {
      all += 1.0;
      if (toLines(s.from + at / length * (s.to - s.from), mine) < 1.0) result.recall += 1.0;
    }
  }
  result.recall /= all;
  return result;
}

QString textOf(const Comparison& c) {
  return QString("mean %1, most %2, near %3, recall %4, length %5 for %6")
      .arg(c.mean)
      .arg(c.most)
      .arg(c.nearShare)
      .arg(c.recall)
      .arg(c.length)
      .arg(c.trueLength);
}

}  // namespace

class TestSkeleton : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void capsules_data() {
    QTest::addColumn<Vector3d>("axis");
    QTest::addColumn<double>("radius");
    for (const double radius : {1.0, 1.5, 3.0, 8.0}) {
      QTest::addRow("along the grid, %g", radius) << Vector3d(0, 0, 1) << radius;
      QTest::addRow("oblique, %g", radius) << Vector3d(1, 2, 3.3) << radius;
      QTest::addRow("diagonal, %g", radius) << Vector3d(1, 1, 0.05) << radius;
    }
  }

  void capsules() {
    QFETCH(const Vector3d, axis);
    QFETCH(const double, radius);
    const Geometry g = cube(64);
    const Vector3d centre = centreOf(g) + Vector3d(0.3, -0.2, 0.1);
    const Vector3d from = centre - 20.0 * axis.normalized();
    const Vector3d to = centre + 20.0 * axis.normalized();
    const Skeleton s =
        skeletonOf(clamped(g, [&](const Vector3d& x) { return capsule(x, from, to, radius); }));
    QCOMPARE(s.branches.size(), std::size_t{1});
    QCOMPARE(kindsOf(s), (std::vector{NodeKind::Tip, NodeKind::Tip}));
    const SkeletonBranch& branch = s.branches.front();
    QVERIFY(isNear(branch.lengthMm, 40.0, 0.5));
    QVERIFY(std::fabs(branch.meanRadiusMm / radius - 1.0) < 0.03);
    QVERIFY(branch.minRadiusMm <= branch.meanRadiusMm && branch.meanRadiusMm <= branch.maxRadiusMm);
    verifyLine(
        s, [&](const Vector3d& x) { return capsule(x, from, to, 0.0); }, radius, 0.3, 0.1);
  }

  void tubesThroughTheVolume() {
    const Geometry g = cube(64);
    const Vector3d centre = centreOf(g) + Vector3d(0.3, -0.2, 0.1);
    for (const Vector3d& axis : {Vector3d(0, 0, 1), Vector3d(1, 2, 3.3)})
      for (const double radius : {1.0, 1.5, 3.0, 8.0}) {
        const Vector3d u = axis.normalized();
        const Skeleton s =
            skeletonOf(clamped(g, [&](const Vector3d& x) { return tube(x, centre, u, radius); }));
        QCOMPARE(s.branches.size(), std::size_t{1});
        QCOMPARE(kindsOf(s), (std::vector{NodeKind::Border, NodeKind::Border}));
        QVERIFY(std::fabs(s.branches.front().lengthMm - 63.0 / u.cwiseAbs().maxCoeff()) < 0.3);
        verifyLine(
            s, [&](const Vector3d& x) { return tube(x, centre, u, 0.0); }, radius, 0.2, 0.1);
      }
  }

  void spacingAndDirectionCount() {
    Geometry g = oblique(80, 70, 40);
    for (const double mirror : {1.0, -1.0}) {
      g.direction.col(1) *= mirror;
      const Vector3d u = g.direction * Vector3d(1, 0.6, 0.8).normalized();
      const Vector3d from = centreOf(g) - 10.0 * u;
      const Vector3d to = centreOf(g) + 10.0 * u;
      const Skeleton s =
          skeletonOf(clamped(g, [&](const Vector3d& x) { return capsule(x, from, to, 1.5); }));
      QCOMPARE(s.branches.size(), std::size_t{1});
      QVERIFY(std::fabs(s.branches.front().lengthMm - 20.0) < 0.3);
      verifyLine(
          s, [&](const Vector3d& x) { return capsule(x, from, to, 0.0); }, 1.5, 0.1, 0.03);
    }
  }

  /// Where the border slices a vessel lengthwise, one line leads into the opening, whichever face
  /// it is.
  void slicedVesselsAreAlikeAtEachFace() {
    for (int face = 0; face < 6; ++face) {
      const Geometry g = cube(48);
      Vector3d inwards = Vector3d::Zero(), one = Vector3d::Zero(), other = Vector3d::Zero();
      inwards[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
      one[(face / 2 + 1) % 3] = other[(face / 2 + 2) % 3] = 1.0;
      // A vessel that turns about an axis across the face, which slices it over most of the turn,
      // and ends inside.
      const Vector3d middle = centreOf(g) - 24.3 * inwards - 1.5 * one - 3.5 * other;
      const Skeleton s = skeletonOf(clamped(g, [&](const Vector3d& x) {
        const Vector3d d = x - middle, p(d.dot(one), d.dot(other), d.dot(inwards));
        const double around = std::clamp(std::atan2(p.y(), p.x()), -0.9, 2.2);
        const Vector3d turn(9.0 * std::cos(around), 9.0 * std::sin(around), 0.0);
        const Vector3d end(9.0 * std::cos(2.2), 9.0 * std::sin(2.2), 0.0);
        const Vector3d tip = end + 32.0 * Vector3d(-0.3, -0.2, 0.93).normalized();
        return std::min((p - turn).norm() - 4.0, capsule(p, end, tip, 4.0));
      }));
      QCOMPARE(s.branches.size(), std::size_t{1});
      QCOMPARE(kindsOf(s), (std::vector{NodeKind::Tip, NodeKind::Border}));
    }
  }

  /// However close to each other branches leave, all hang together.
  void aVesselOfOnePieceHasLinesOfOnePiece() {
    for (const double apart : {0.0, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0}) {
      const Geometry g = cube(56);
      const Vector3d one = centreOf(g) + Vector3d(0.2, 0.1, 0.5 * apart);
      const Vector3d other = centreOf(g) + Vector3d(0.2, 0.1, -0.5 * apart);
      const Skeleton s = skeletonOf(clamped(g, [&](const Vector3d& x) {
        return std::min({tube(x, one, Vector3d::UnitZ(), 4.0),
                         capsule(x, one, one + Vector3d(22, 0, 3), 2.0),
                         capsule(x, other, other - Vector3d(22, 3, 0), 2.0)});
      }));
      QCOMPARE(s.nodes.size(), s.branches.size() + 1);
      const std::vector<NodeKind> kinds = kindsOf(s);
      QCOMPARE(std::count(kinds.begin(), kinds.end(), NodeKind::Tip), 2);
      QCOMPARE(std::count(kinds.begin(), kinds.end(), NodeKind::Border), 2);
      double length = 0.0;
      for (const SkeletonBranch& branch : s.branches) length += branch.lengthMm;
      QVERIFY(isNear(length, 55.0 + 22.2 + 22.2, 4.0));
    }
  }

  void ringsAreClosed() {
    for (const double radius : {1.5, 4.0}) {
      const Geometry g = cube(60);
      const Skeleton s = skeletonOf(
          clamped(g, [&](const Vector3d& x) { return torus(x, centreOf(g), 20.0, radius); }));
      QCOMPARE(s.branches.size(), std::size_t{1});
      QCOMPARE(kindsOf(s), std::vector{NodeKind::Ring});
      const SkeletonBranch& ring = s.branches.front();
      QCOMPARE(ring.from, ring.to);
      QCOMPARE(ring.points.front().pointLps, ring.points.back().pointLps);
      QVERIFY(std::fabs(ring.lengthMm - 2.0 * M_PI * 20.0) < 1.0);
      verifyLine(
          s, [&](const Vector3d& x) { return torus(x, centreOf(g), 20.0, 0.0); }, radius, 0.15,
          0.05);
    }
  }

  void bifurcation() {
    const PhantomParams params = paramsOf(PhantomKind::Bifurcation, 96);
    const Skeleton s = skeletonOf(redistance(phantomField(params)));
    QCOMPARE(s.branches.size(), std::size_t{3});
    QCOMPARE(kindsOf(s), (std::vector{NodeKind::Junction, NodeKind::Border, NodeKind::Border,
                                      NodeKind::Border}));
    for (const SkeletonNode& node : s.nodes)
      if (node.kind == NodeKind::Junction)
        QVERIFY((node.pointLps - Vector3d::Constant(47.5)).norm() < 0.5);
    const double daughter = 4.0 / std::cbrt(2.0);
    for (const SkeletonBranch& branch : s.branches) {
      const bool isParent = branch.meanRadiusMm > 3.7;
      QVERIFY(std::fabs(branch.meanRadiusMm / (isParent ? 4.0 : daughter) - 1.0) < 0.01);
      const double length = isParent ? 47.5 : 47.5 / std::cos(35.0 / 180.0 * M_PI);
      QVERIFY(isNear(branch.lengthMm, length, 0.7));
    }
    const Comparison c = compared(s, makePhantom(params).centreLines);
    QVERIFY2(c.most < 0.3 && c.recall == 1.0, qPrintable(textOf(c)));
  }

  /// Voxel paths of the two run side by side in the trunk for long before they meet.
  void sideBranchesStartWhereTheyLeave() {
    const Geometry g = cube(64);
    const Vector3d centre = centreOf(g);
    for (const double slope : {0.0, 0.7}) {
      const Vector3d end = centre + 22.0 * Vector3d(1, 0, slope).normalized();
      const Skeleton s = skeletonOf(clamped(g, [&](const Vector3d& x) {
        return std::min(tube(x, centre, Vector3d::UnitZ(), 4.0), capsule(x, centre, end, 2.0));
      }));
      QCOMPARE(s.branches.size(), std::size_t{3});
      for (const SkeletonNode& node : s.nodes)
        if (node.kind == NodeKind::Junction) QVERIFY(isBelow((node.pointLps - centre).norm(), 1.0));
      for (const SkeletonBranch& branch : s.branches)
        QVERIFY(std::fabs(branch.meanRadiusMm - (branch.lengthMm > 25.0 ? 4.0 : 2.0)) < 0.05);
    }
  }

  void kissingTubesStayApart() {
    PhantomParams params = paramsOf(PhantomKind::Kissing, 96);
    params.offset = {0.5, 0.5, 0.0};
    const Volume<float> phi = redistance(phantomField(params));
    const Skeleton s = skeletonOf(phi);
    QCOMPARE(s.branches.size(), std::size_t{2});
    QVERIFY(s.branches[0].component != s.branches[1].component);
    const Comparison c = compared(s, makePhantom(params).centreLines);
    QVERIFY2(c.most < 0.3 && c.recall == 1.0, qPrintable(textOf(c)));
    // On the wall that faces the other tube, its branch may be nearer.
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    for (int b = 0; b < 2; ++b) {
      const auto& points = s.branches[static_cast<std::size_t>(b)].points;
      const auto& others = s.branches[static_cast<std::size_t>(1 - b)].points;
      const Vector3d middle = points[points.size() / 2].pointLps;
      const Vector3d towards = (others[others.size() / 2].pointLps - middle).normalized();
      for (const double aside : {0.0, 2.0, 3.9, 4.2}) {
        const auto place = placeOnSkeleton(s, field, middle + aside * towards);
        QVERIFY(place);
        QCOMPARE(place->branch, b);
        QVERIFY(std::abs(place->point - static_cast<int>(points.size() / 2)) <= 2);
      }
    }
    QVERIFY(!placeOnSkeleton(s, field, Vector3d::Zero()));
  }

  void phantoms_data() {
    QTest::addColumn<PhantomKind>("kind");
    QTest::addColumn<int>("branches");
    QTest::addColumn<double>("recall");
    QTest::addRow("helix") << PhantomKind::Helix << 1 << 0.99;
    QTest::addRow("stenosis") << PhantomKind::Stenosis << 1 << 0.99;
    // Where a sac is joined depends on a short line that hardly has a direction.
    QTest::addRow("aneurysm") << PhantomKind::Aneurysm << 3 << 0.95;
    QTest::addRow("capsule tree, with a bridge") << PhantomKind::CapsuleTree << 6 << 0.98;
    QTest::addRow("tree") << PhantomKind::Tree << 0 << 0.98;
  }

  void phantoms() {
    QFETCH(const PhantomKind, kind);
    QFETCH(const int, branches);
    QFETCH(const double, recall);
    const PhantomParams params = paramsOf(kind, 96);
    const Skeleton s = skeletonOf(redistance(phantomField(params)));
    if (branches > 0) QCOMPARE(static_cast<int>(s.branches.size()), branches);
    const Comparison c = compared(s, makePhantom(params).centreLines);
    const QString text = textOf(c);
    QVERIFY2(c.mean < 0.15 && c.nearShare > 0.93 && c.most < 3.0, qPrintable(text));
    QVERIFY2(c.recall > recall, qPrintable(text));
    QVERIFY2(std::fabs(c.length / c.trueLength - 1.0) < 0.03, qPrintable(text));
  }

  void roughWallsMakeNoBranches() {
    const Geometry g = cube(64);
    const Vector3d u = Vector3d(1, 2, 3.3).normalized();
    const Skeleton s = skeletonOf(clamped(g, [&](const Vector3d& x) {
      return tube(x, centreOf(g), u, 5.0) +
             std::sin(1.9 * x[0]) * std::sin(2.1 * x[1]) * std::sin(1.7 * x[2]);
    }));
    QCOMPARE(s.branches.size(), std::size_t{1});
    verifyLine(
        s, [&](const Vector3d& x) { return tube(x, centreOf(g), u, 0.0); }, 5.0, 0.5, 0.4);
  }

  void nothingOfBallsAndSpecks() {
    Volume<float> phi = clamped(cube(40), [](const Vector3d& x) {
      return ball(x, {19.2, 20.1, 19.7}, 9.0);
    });
    phi.at(2, 2, 2) = -0.5F;
    const Skeleton s = skeletonOf(phi);
    double length = 0.0;
    for (const SkeletonBranch& branch : s.branches) length += branch.lengthMm;
    QVERIFY(isBelow(length, 2.0));
    QVERIFY(skeletonOf(Volume<float>(cube(8), 1.0F)).branches.empty());
  }

  void threadsDoNotCount() {
    const Volume<float> phi = redistance(phantomField(paramsOf(PhantomKind::CapsuleTree, 64, 3.0)));
    const auto [one, three] = onOneAndSeveralThreads([&] { return skeletonOf(phi); }, 3);
    setThreads(0);
    QCOMPARE(one.branches.size(), three.branches.size());
    for (std::size_t b = 0; b < one.branches.size(); ++b) {
      QCOMPARE(one.branches[b].points.size(), three.branches[b].points.size());
      for (std::size_t n = 0; n < one.branches[b].points.size(); ++n) {
        const SkeletonPoint& p = one.branches[b].points[n];
        const SkeletonPoint& q = three.branches[b].points[n];
        QVERIFY(p.pointLps == q.pointLps && p.radiusMm == q.radiusMm);
      }
    }
  }

  void axesAreAlike() {
    for (const bool fewAlongLast : {true, false}) {
      const Volume<float> phi = unlikeVessels(fewAlongLast);
      const Skeleton one = skeletonOf(phi), other = skeletonOf(turned(phi));
      QCOMPARE(one.branches.size(), std::size_t{3});
      QCOMPARE(other.branches.size(), one.branches.size());
      const auto lengths = [](const Skeleton& skeleton) {
        std::vector<double> all;
        for (const SkeletonBranch& branch : skeleton.branches) all.push_back(branch.lengthMm);
        std::sort(all.begin(), all.end());
        return all;
      };
      for (std::size_t i = 0; i < 3; ++i)
        QVERIFY2(std::fabs(lengths(one)[i] - lengths(other)[i]) < 0.4,
                 qPrintable(QString("%1 %2").arg(lengths(one)[i]).arg(lengths(other)[i])));
    }
  }
};

QTEST_GUILESS_MAIN(TestSkeleton)
#include "tst_skeleton.moc"
