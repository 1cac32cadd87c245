// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/cuts/end_cuts.h"
#include "core/distance/redistance.h"
#include "core/phantom/phantom.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"
#include "tests/core/phantom_case.h"

using namespace angiomesh;
using namespace angiomesh::analytic;
using Eigen::Vector3d;

namespace {

struct Case {
  SplineField phi;
  Skeleton skeleton;
};

template <class F>
Case caseOf(const Geometry& g, F f) {
  const Volume<float> phi = clamped(g, f);
  return {fieldOf(phi), skeletonOf(phi)};
}

}  // namespace

class TestEndCuts : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void bothEndsOfACapsule() {
    const Geometry g = cube(64);
    const Vector3d u = Vector3d(1, 2, 3.3).normalized();
    const Vector3d from = centreOf(g) - 20.0 * u;
    const Vector3d to = centreOf(g) + 20.0 * u;
    const Case c = caseOf(g, [&](const Vector3d& x) { return capsule(x, from, to, 3.0); });
    const EndCuts ends = proposeEndCuts(c.skeleton, c.phi, 2.0);
    QCOMPARE(ends.cuts.size(), std::size_t{2});
    QVERIFY(ends.uncut.empty());
    for (const ProposedCut& cut : ends.cuts) {
      const double side = (cut.pointLps - centreOf(g)).dot(u) > 0.0 ? 1.0 : -1.0;
      QVERIFY(degreesBetween(cut.outwardNormalLps, side * u) < 1.0);
      const Vector3d wanted = centreOf(g) + side * 14.0 * u;
      QVERIFY(isBelow((cut.pointLps - wanted).norm(), 1.1));
      QVERIFY((cut.pointLps - wanted - (cut.pointLps - wanted).dot(u) * u).norm() < 0.1);
      QVERIFY(std::fabs(cut.radiusMm - 3.0) < 0.05);
      QCOMPARE(cut.branch, 0);
    }
    QCOMPARE(proposeEndCuts(c.skeleton, c.phi, 0.0).cuts.size(), std::size_t{2});
    // Beyond the middle of it the two would change places.
    const EndCuts deep = proposeEndCuts(c.skeleton, c.phi, 6.5);
    QVERIFY(deep.cuts.empty());
    QCOMPARE(deep.uncut.size(), std::size_t{2});
    QVERIFY(deep.uncut[0].reason.find("too short") != std::string::npos);
    QVERIFY(proposeEndCuts(c.skeleton, c.phi, 50.0).cuts.empty());
  }

  void shortBranchesHaveNone() {
    const Geometry g = cube(64);
    const Vector3d centre = centreOf(g);
    for (const double length : {9.0, 24.0}) {
      const Case c = caseOf(g, [&](const Vector3d& x) {
        return std::min(tube(x, centre, Vector3d::UnitZ(), 4.0),
                        capsule(x, centre, centre + Vector3d(length, 0, 0), 2.0));
      });
      QCOMPARE(c.skeleton.branches.size(), std::size_t{3});
      const EndCuts ends = proposeEndCuts(c.skeleton, c.phi, 2.5);
      QCOMPARE(ends.cuts.size(), std::size_t{length > 20.0 ? 1U : 0U});
      QCOMPARE(ends.uncut.size(), 1 - ends.cuts.size());
      for (const ProposedCut& cut : ends.cuts) {
        QVERIFY(degreesBetween(cut.outwardNormalLps, Vector3d::UnitX()) < 1.0);
        QVERIFY(std::fabs(cut.radiusMm - 2.0) < 0.05);
      }
      for (const UncutTip& tip : ends.uncut)
        QVERIFY2(tip.reason.find("junction") != std::string::npos, tip.reason.c_str());
    }
  }

  void openEndsAndRingsHaveNone() {
    const PhantomParams params = paramsOf(PhantomKind::Bifurcation, 80);
    const Volume<float> phi = redistance(phantomField(params));
    const EndCuts open =
        proposeEndCuts(skeletonOf(phi), SplineField(phi, SplineKind::InterpolatingBspline), 2.0);
    QVERIFY(open.cuts.empty() && open.uncut.empty());
    const Geometry g = cube(60);
    const Case ring =
        caseOf(g, [&](const Vector3d& x) { return torus(x, centreOf(g), 20.0, 4.0); });
    QVERIFY(proposeEndCuts(ring.skeleton, ring.phi, 2.0).cuts.empty());
  }

  void tipsOfATree() {
    const PhantomParams params = paramsOf(PhantomKind::Tree, 96);
    const Volume<float> phi = redistance(phantomField(params));
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    const Skeleton s = skeletonOf(phi);
    const EndCuts ends = proposeEndCuts(s, field, 2.0);
    std::size_t tips = 0;
    for (const SkeletonNode& node : s.nodes) tips += node.kind == NodeKind::Tip ? 1 : 0;
    QCOMPARE(ends.cuts.size() + ends.uncut.size(), tips);
    QVERIFY(2 * ends.cuts.size() > tips);
    for (const UncutTip& tip : ends.uncut) QVERIFY(!tip.reason.empty());
    // Along the true lines, and pointing to where the vessel ends.
    const std::vector<CentreLineSegment> lines = makePhantom(params).centreLines;
    int askew = 0;
    for (const ProposedCut& cut : ends.cuts) {
      double nearest = 1e9;
      double degrees = 0.0;
      for (const CentreLineSegment& l : lines) {
        const double off = capsule(cut.pointLps, l.from, l.to, 0.0);
        if (off >= nearest) continue;
        nearest = off;
        degrees = degreesBetween(cut.outwardNormalLps, l.to - l.from);
      }
      QVERIFY(isBelow(nearest, 0.6));
      if (std::min(degrees, 180.0 - degrees) > 6.0) ++askew;
    }
    QVERIFY2(askew <= 1, qPrintable(QString::number(askew)));
  }

  void distancesHaveToMakeSense() {
    const Skeleton none;
    const SplineField phi(Volume<float>(cube(4), 1.0F), SplineKind::InterpolatingBspline);
    QVERIFY_THROWS_EXCEPTION(InputError, proposeEndCuts(none, phi, -1.0));
    QVERIFY_THROWS_EXCEPTION(InputError,
                             proposeEndCuts(none, phi, std::numeric_limits<double>::quiet_NaN()));
    QVERIFY(proposeEndCuts(none, phi, 2.0).cuts.empty());
  }
};

QTEST_GUILESS_MAIN(TestEndCuts)
#include "tst_end_cuts.moc"
