// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/centreline/component_measure.h"
#include "core/distance/redistance.h"
#include "core/phantom/phantom.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

std::vector<ComponentMeasure> measured(const Volume<float>& phi) {
  const Components parts = connectedComponents(insideMask(phi));
  return measureComponents(phi, parts.labels, parts.sizes.size());
}

template <class F>
ComponentMeasure measuredOf(const Geometry& g, F f) {
  return measured(clamped(g, f)).front();
}

void compare(const ComponentMeasure& m, double length, double radius) {
  QVERIFY2(std::fabs(m.lengthMm / length - 1.0) < 0.05,
           qPrintable(QString("length %1 for %2").arg(m.lengthMm).arg(length)));
  QVERIFY2(std::fabs(m.meanRadiusMm / radius - 1.0) < 0.05,
           qPrintable(QString("radius %1 for %2").arg(m.meanRadiusMm).arg(radius)));
}

}  // namespace

class TestComponentMeasure : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void straightTubes_data() {
    QTest::addColumn<Eigen::Vector3d>("axis");
    QTest::addColumn<double>("radius");
    for (const double radius : {1.0, 1.5, 3.0, 8.0}) {
      QTest::addRow("axis-parallel, %g", radius) << Eigen::Vector3d(0, 0, 1) << radius;
      QTest::addRow("oblique, %g", radius) << Eigen::Vector3d(1, 2, 3.3) << radius;
      QTest::addRow("diagonal, %g", radius) << Eigen::Vector3d(1, 1, 0.05) << radius;
      QTest::addRow("steep, %g", radius) << Eigen::Vector3d(0.1, 0.23, 1) << radius;
    }
  }

  void straightTubes() {
    QFETCH(const Eigen::Vector3d, axis);
    QFETCH(const double, radius);
    const Geometry g = cube(64);
    const Eigen::Vector3d u = axis.normalized();
    const Eigen::Vector3d centre = centreOf(g) + Eigen::Vector3d(0.3, -0.2, 0.1);
    // Through the volume: as long as the line's part inside.
    compare(measuredOf(g, [&](const Eigen::Vector3d& x) { return tube(x, centre, u, radius); }),
            64.0 / u.cwiseAbs().maxCoeff(), radius);
    // With ball ends inside it.
    const Eigen::Vector3d half = 20.0 * u;
    compare(measuredOf(g,
                       [&](const Eigen::Vector3d& x) {
                         return capsule(x, centre - half, centre + half, radius);
                       }),
            40.0, radius);
  }

  void spacingAndDirectionCount() {
    const Geometry g = oblique(80, 70, 40);
    const Eigen::Vector3d u = g.direction * Eigen::Vector3d(1, 0.6, 0.8).normalized();
    const Eigen::Vector3d half = 10.0 * u;
    compare(measuredOf(g,
                       [&](const Eigen::Vector3d& x) {
                         return capsule(x, centreOf(g) - half, centreOf(g) + half, 1.5);
                       }),
            20.0, 1.5);
  }

  void ringsAreClosed() {
    for (const double radius : {1.5, 4.0}) {
      const Geometry g = cube(60);
      compare(measuredOf(
                  g, [&](const Eigen::Vector3d& x) { return torus(x, centreOf(g), 20.0, radius); }),
              2.0 * M_PI * 20.0, radius);
    }
  }

  void helixFollowsItsCentreLine() {
    for (const double radius : {2.0, 3.0}) {
      PhantomParams params;
      params.kind = PhantomKind::Helix;
      params.size = {64, 64, 64};
      params.radius = radius;
      double length = 0.0;
      for (const CentreLineSegment& s : makePhantom(params).centreLines)
        length += (s.to - s.from).norm();
      compare(measured(redistance(phantomField(params))).front(), length, radius);
    }
  }

  void branchesAddUp() {
    const Geometry g = cube(80);
    const Eigen::Vector3d joint = centreOf(g);
    for (const double radius : {1.5, 4.0}) {
      const std::vector<Eigen::Vector3d> ends{joint + Eigen::Vector3d(0, 2, -30),
                                              joint + Eigen::Vector3d(18, 0, 24),
                                              joint + Eigen::Vector3d(-20, 5, 20)};
      double length = 0.0;
      for (const Eigen::Vector3d& end : ends) length += (end - joint).norm();
      compare(measuredOf(g,
                         [&](const Eigen::Vector3d& x) {
                           double least = 1e9;
                           for (const Eigen::Vector3d& end : ends)
                             least = std::min(least, capsule(x, joint, end, radius));
                           return least;
                         }),
              length, radius);
    }
  }

  void roughWallsMakeNoBranches() {
    const Geometry g = cube(64);
    compare(measuredOf(g,
                       [&](const Eigen::Vector3d& x) {
                         const double wave =
                             std::sin(1.9 * x[0]) * std::sin(2.1 * x[1]) * std::sin(1.7 * x[2]);
                         return tube(x, centreOf(g), Eigen::Vector3d(1, 2, 3.3).normalized(), 5.0) +
                                wave;
                       }),
            64.0 * std::sqrt(1.0 + 4.0 + 3.3 * 3.3) / 3.3, 5.0);
  }

  void ballsAndSpecksHaveNoLength() {
    const Geometry g = cube(40);
    const ComponentMeasure m = measuredOf(g, [&](const Eigen::Vector3d& x) {
      return ball(x, {19.2, 20.1, 19.7}, 9.0);
    });
    QVERIFY(isBelow(m.lengthMm, 0.2 * 18.0));
    QVERIFY(std::fabs(m.meanRadiusMm - 9.0) < 0.9);
    Volume<float> speck(g, 1.0F);
    speck.at(5, 5, 5) = -0.5F;
    const ComponentMeasure one = measured(speck).front();
    QCOMPARE(one.lengthMm, 0.0);
    QVERIFY(std::fabs(4.0 / 3.0 * M_PI * std::pow(one.meanRadiusMm, 3) - 1.0) < 0.25);
  }

  void partsAreMeasuredByTheirLabels() {
    const Geometry g = cube(48);
    const Volume<float> phi = sampled(g, [](const Eigen::Vector3d& x) {
      return std::min(capsule(x, {10, 10, 8}, {10, 10, 40}, 4.0),
                      capsule(x, {34, 34, 8}, {34, 34, 40}, 2.0));
    });
    const auto both = measured(phi);
    QCOMPARE(both.size(), std::size_t{2});
    compare(both[0], 32.0, 4.0);
    compare(both[1], 32.0, 2.0);
    const Components parts = connectedComponents(insideMask(phi));
    QCOMPARE(measureComponents(phi, parts.labels, 1).size(), std::size_t{1});
  }
};

QTEST_GUILESS_MAIN(TestComponentMeasure)
#include "tst_component_measure.moc"
