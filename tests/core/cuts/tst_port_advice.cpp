// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <array>
#include <set>

#include "core/cuts/port_advice.h"
#include "core/openings/port_colour.h"
#include "tests/core/analytic.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

constexpr double kRadius = 3.0;

/// A tube along x, cut at x = `at`; what lies beyond is taken.
CutAway cutAt(double at) {
  Geometry g = analytic::cube(24);
  g.size = {60, 24, 24};
  const Volume<float> phi = analytic::clamped(g, [](const Vector3d& p) {
    return analytic::tube(p, {0, 11.6, 11.4}, Vector3d::UnitX(), kRadius);
  });
  return cutAway(analytic::fieldOf(phi), phi, {{{at, 11.6, 11.4}, Vector3d::UnitX()}}, {"cut"});
}

/// A branch along the tube from x = `from` to `to`, in steps of at most `step`.
SkeletonBranch branchOf(double from, double to, double step) {
  SkeletonBranch branch;
  branch.to = 1;
  const int count = std::max(1, static_cast<int>(std::ceil(std::fabs(to - from) / step)));
  for (int i = 0; i <= count; ++i)
    branch.points.push_back({{from + (to - from) * i / count, 11.6, 11.4}, kRadius, kRadius});
  return branch;
}

Skeleton skeletonOf(const SkeletonBranch& branch, NodeKind first, NodeKind last) {
  Skeleton skeleton;
  skeleton.nodes.resize(2);
  skeleton.nodes[0].kind = first;
  skeleton.nodes[1].kind = last;
  skeleton.branches = {branch};
  return skeleton;
}

}  // namespace

class TestPortAdvice : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Whichever way the branch runs, and in whichever of its steps the cut lies.
  void branchingsThatAreNearAreNamed_data() {
    QTest::addColumn<double>("junction");
    QTest::addColumn<double>("tip");
    QTest::addColumn<double>("step");
    QTest::addColumn<QString>("said");
    // 40 - 20 = 20 mm are 3.3 diameters.
    for (const double step : {1.0, 7.0, 100.0}) {
      QTest::addRow("near, steps of %g", step) << 20.0 << 55.0 << step << "lies 3.3 of";
      QTest::addRow("first step, steps of %g", step) << 39.5 << 55.0 << step << "lies 0.1 of";
      QTest::addRow("last step, steps of %g", step) << 20.0 << 40.3 << step << "lies 3.3 of";
      QTest::addRow("far, steps of %g", step) << 9.0 << 55.0 << step << "";
    }
  }
  void branchingsThatAreNearAreNamed() {
    QFETCH(double, junction);
    QFETCH(double, tip);
    QFETCH(double, step);
    QFETCH(QString, said);
    const CutAway away = cutAt(40.0);
    for (const bool turned : {false, true}) {
      const Skeleton skeleton =
          turned ? skeletonOf(branchOf(tip, junction, step), NodeKind::Tip, NodeKind::Junction)
                 : skeletonOf(branchOf(junction, tip, step), NodeKind::Junction, NodeKind::Tip);
      const std::vector<PortAdvice> advice = portAdvice(skeleton, away);
      QCOMPARE(advice.size(), std::size_t{said.isEmpty() ? 0U : 1U});
      if (said.isEmpty()) continue;
      QCOMPARE(advice[0].cut, std::size_t{0});
      QVERIFY2(QString::fromStdString(advice[0].words).startsWith(said), advice[0].words.c_str());
    }
  }

  void noBranchingNoAdvice() {
    const CutAway away = cutAt(40.0);
    for (const NodeKind kind : {NodeKind::Tip, NodeKind::Border})
      QVERIFY(portAdvice(skeletonOf(branchOf(20.0, 55.0, 1.0), kind, NodeKind::Junction), away)
                  .empty());
    // Of a branch that ends before it.
    QVERIFY(
        portAdvice(skeletonOf(branchOf(20.0, 39.0, 1.0), NodeKind::Junction, NodeKind::Tip), away)
            .empty());
  }

  void aSectionThroughTwoVesselsIsNamed() {
    Skeleton skeleton = skeletonOf(branchOf(20.0, 55.0, 1.0), NodeKind::Junction, NodeKind::Tip);
    skeleton.branches.push_back(branchOf(25.0, 45.0, 1.0));
    const std::vector<PortAdvice> advice = portAdvice(skeleton, cutAt(40.0));
    QCOMPARE(advice.size(), std::size_t{1});
    QVERIFY2(advice[0].words.find("passes 2 vessels") == 0, advice[0].words.c_str());
  }

  /// One after the other and all of the first eight.
  void portsHaveColoursOfTheirOwn() {
    std::set<std::array<double, 3>> seen;
    for (std::size_t n = 0; n < 8; ++n) {
      const std::array<double, 3> colour = portColour(n);
      for (const double part : colour) QVERIFY(part >= 0.0 && part <= 1.0);
      for (const std::array<double, 3>& other : seen) {
        double apart = 0.0;
        for (std::size_t c = 0; c < 3; ++c) apart += std::fabs(colour[c] - other[c]);
        QVERIFY(apart > 0.25);
      }
      QVERIFY(seen.insert(colour).second);
      QVERIFY(portColour(n + 8) == colour);
    }
  }
};

QTEST_APPLESS_MAIN(TestPortAdvice)
#include "tst_port_advice.moc"
