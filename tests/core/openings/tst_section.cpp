// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/openings/section.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_shapes.h"
#include "tests/core/refusal.h"

using namespace angiomesh;
using analytic::fieldOf;
using Eigen::Vector3d;

class TestSection : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // A tilted plane cuts a tube in an ellipse.
  void tubesAreCutInEllipses_data() {
    QTest::addColumn<double>("tilt");
    QTest::addColumn<bool>("mirrored");
    for (const double tilt : {0.0, 20.0, 45.0})
      for (const bool mirrored : {false, true})
        QTest::addRow("%g degrees%s", tilt, mirrored ? " mirrored" : "") << tilt << mirrored;
  }
  void tubesAreCutInEllipses() {
    QFETCH(double, tilt);
    QFETCH(bool, mirrored);
    const Geometry g = shapes::obliqueGeometry({40, 36, 30}, mirrored);
    const Vector3d centre = analytic::centreOf(g);
    const Vector3d axis = Vector3d(0.3, -0.5, 0.8).normalized();
    const double radius = 2.1;
    const SplineField field = fieldOf(shapes::sampled(
        g, [&](const Vector3d& p) { return analytic::tube(p, centre, axis, radius); }));
    const double angle = tilt * shapes::pi / 180.0;
    const Vector3d normal = std::cos(angle) * axis + std::sin(angle) * axis.unitOrthogonal();
    const Vector3d start = centre + 0.9 * normal.unitOrthogonal();
    const Section section = sectionOf(field, {start, 2.0 * normal});
    const double area = shapes::pi * radius * radius / std::cos(angle);
    QCOMPARE(section.loops.size(), std::size_t{1});
    QVERIFY(isNear(section.areaMm2 / area, 1.0, 1e-3));
    QVERIFY((section.centreLps - centre).norm() < 0.02);
    QVERIFY(std::abs(section.radiusMm - radius / std::cos(angle)) < 0.02);
    QVERIFY(std::abs(section.plane.normalLps.norm() - 1.0) < 1e-12);
    double turned = 0.0;
    const auto& loop = section.loops.front();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      QVERIFY(std::abs(section.height(loop[i])) < 1e-9);
      QVERIFY(std::abs(field.valueAt(loop[i])) < 1e-9);
      const Vector3d a = loop[i] - section.centreLps;
      const Vector3d b = loop[(i + 1) % loop.size()] - section.centreLps;
      turned += a.cross(b).dot(section.plane.normalLps);
    }
    // The inside to the right, seen from outside.
    QVERIFY(turned < 0.0);
    QVERIFY(section.covers(section.centreLps));
    QVERIFY(!section.covers(section.centreLps + 1.3 * section.radiusMm * normal.unitOrthogonal()));
  }

  void theSecondVesselInThePlaneIsLeftAlone() {
    const Geometry g = analytic::cube(40);
    const Vector3d one{11.3, 19.6, 20.0}, two{27.2, 19.9, 20.0}, axis = Vector3d::UnitZ();
    const SplineField field = fieldOf(shapes::sampled(g, [&](const Vector3d& p) {
      return std::min(analytic::tube(p, one, axis, 4.0), analytic::tube(p, two, axis, 6.0));
    }));
    for (const auto& [centre, radius] : {std::pair{one, 4.0}, std::pair{two, 6.0}}) {
      const Section section = sectionOf(field, {centre, axis});
      QVERIFY(std::abs(section.areaMm2 / (shapes::pi * radius * radius) - 1.0) < 1e-3);
      QVERIFY((section.centreLps - centre).norm() < 0.01);
    }
  }

  void aRingHasAnInnerOutline() {
    const Vector3d centre{19.4, 19.7, 19.2};
    const SplineField field = fieldOf(shapes::sampled(analytic::cube(40), [&](const Vector3d& p) {
      return analytic::torus(p, centre, 10.0, 4.0);
    }));
    const Section section =
        sectionOf(field, {centre + Vector3d(10.0, 0.0, 0.0), Vector3d::UnitZ()});
    QCOMPARE(section.loops.size(), std::size_t{2});
    QVERIFY(std::abs(section.areaMm2 / (shapes::pi * (196.0 - 36.0)) - 1.0) < 1e-3);
    QVERIFY((section.centreLps - centre).norm() < 0.01);
    QVERIFY(!section.covers(centre));
  }

  /// Chords alone would miss a two hundredth of the area.
  void areaAndCentreAreOfFourthOrder() {
    const Vector3d centre{15.3, 15.6, 15.4};
    const SplineField field = fieldOf(shapes::sampled(analytic::cube(32), [&](const Vector3d& p) {
      return analytic::tube(p, centre, Vector3d::UnitZ(), 5.0);
    }));
    for (const int finer : {1, 2}) {
      const Section section = sectionOf(field, {centre, Vector3d::UnitZ()}, {}, finer);
      QVERIFY(isNear(section.areaMm2 / (25.0 * shapes::pi), 1.0, 2e-4));
      QVERIFY((section.centreLps - centre).norm() < 1e-3);
    }
  }

  // Of a vessel thinner than the lattice's steps, across it, no two nodes in a row are inside.
  void aVesselBetweenTheNodesIsOnePiece() {
    const Vector3d centre{15.3, 15.6, 15.4}, n = Vector3d::UnitZ();
    const Vector3d u = n.unitOrthogonal(), v = n.cross(u);
    for (const double sign : {-1.0, 1.0}) {
      const Vector3d along = (u + sign * v).normalized(), across = n.cross(along);
      const SplineField field = fieldOf(shapes::sampled(analytic::cube(32), [&](const Vector3d& p) {
        const Vector3d d = p - centre;
        return std::pow(d.dot(along) / 8.0, 2) + std::pow(d.dot(across) / 0.5, 2) - 1.0;
      }));
      const Section section = sectionOf(field, {centre, n}, {}, 1);
      QCOMPARE(section.loops.size(), std::size_t{1});
      QVERIFY(isNear(section.areaMm2 / (shapes::pi * 8.0 * 0.5), 1.0, 0.1));
      QVERIFY((section.centreLps - centre).norm() < 0.1);
    }
  }

  // Nor do nodes across a square join vessels when there is a wall between them.
  void vesselsAcrossASquareStayApart() {
    const Vector3d centre{15.3, 15.6, 15.4}, n = Vector3d::UnitZ();
    const Vector3d u = n.unitOrthogonal(), v = n.cross(u);
    for (const double sign : {-1.0, 1.0}) {
      const Vector3d along = (u + sign * v).normalized(), across = n.cross(along);
      const SplineField field = fieldOf(shapes::sampled(analytic::cube(32), [&](const Vector3d& p) {
        const double s = (p - centre).dot(along), t = (p - centre).dot(across);
        return 0.36 - s * s + t * t + s * s * s * s / 16.0;
      }));
      const Section section = sectionOf(field, {centre + 0.72 * along, n}, {}, 1);
      QCOMPARE(section.loops.size(), std::size_t{1});
      for (const Vector3d& p : section.loops.front()) QVERIFY((p - centre).dot(along) > 0.4);
      QVERIFY(section.covers(centre + 2.0 * along) && !section.covers(centre - 2.0 * along));
    }
  }

  // The eight nodes around one form a ring about as thin as a step, with crossings of which some
  // lie outside: it is whole from wherever it is followed.
  void aRingOfEightNodesIsWhole() {
    const Vector3d n = Vector3d::UnitZ();
    const Vector3d u = n.unitOrthogonal(), v = n.cross(u);
    const Vector3d centre{15.3, 15.6, 15.4};
    const SplineField field = fieldOf(shapes::sampled(analytic::cube(32), [&](const Vector3d& p) {
      const double square = std::pow((p - centre).dot(u), 2) + std::pow((p - centre).dot(v), 2);
      return (square - 0.8 * 0.8) * (square - 1.6 * 1.6);
    }));
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        if (i == 0 && j == 0) continue;
        const Section section = sectionOf(field, {centre + i * u + j * v, n}, {}, 1);
        QCOMPARE(section.loops.size(), std::size_t{2});
        QCOMPARE(std::count(section.lattice.inside.begin(), section.lattice.inside.end(), 1), 8);
        QVERIFY((section.centreLps - centre).norm() < 0.05);
      }
  }

  void whatIsNoSectionIsRefused() {
    const Vector3d centre{15.5, 15.5, 15.5};
    const SplineField field = fieldOf(shapes::sampled(analytic::cube(32), [&](const Vector3d& p) {
      return analytic::tube(p, centre, Vector3d::UnitZ(), 5.0);
    }));
    const auto refused = [&](const CutPlane& plane, const char* why) {
      return messageOf([&] { sectionOf(field, plane); }).find(why) != std::string::npos;
    };
    QVERIFY(refused({{2.0, 2.0, 15.0}, Vector3d::UnitZ()}, "does not lie in a vessel"));
    QVERIFY(refused({{-20.0, 2.0, 15.0}, Vector3d::UnitZ()}, "does not lie in a vessel"));
    QVERIFY(refused({centre, Vector3d::UnitX()}, "reaches the border"));
    QVERIFY(refused({centre, Vector3d::Zero()}, "no direction"));
    QVERIFY(refused({centre, Vector3d::Constant(std::nan(""))}, "no direction"));
  }
};

QTEST_APPLESS_MAIN(TestSection)
#include "tst_section.moc"
