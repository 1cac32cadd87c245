// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/openings/cut_away.h"
#include "tests/core/analytic.h"
#include "tests/core/refusal.h"

using namespace angiomesh;
using Eigen::Vector3d;

class TestCutAway : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Where the nearest voxels are left, what lies within two voxels beyond a section counts as
  /// taken off, as far as two voxels beside its rim.
  void theSlabBeyondACutIsTwoVoxelsThick() {
    Geometry g = analytic::cube(24);
    g.spacing *= 0.5;
    const Vector3d centre = analytic::centreOf(g), normal = Vector3d(0.6, 0.0, 0.8);
    CutAway away;
    away.voxels = Volume<std::uint8_t>(g, CutAway::kLeft);
    away.sections.resize(1);
    away.sections[0].plane = {centre + Vector3d(0.08, 0.3, -0.06), normal};
    away.sections[0].centreLps = centre;
    away.sections[0].radiusMm = 0.7;
    const auto beyond = [&](double height, double aside) {
      const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
      for (int turn = 0; turn < 8; ++turn) {
        const double angle = 0.25 * M_PI * turn;
        const Vector3d way = std::cos(angle) * u + std::sin(angle) * v;
        const bool is = away.beyond(centre + height * normal + aside * way);
        if (is != away.beyond(centre + height * normal - aside * way)) return -1;
        if (is != away.beyond(centre + height * normal + aside * u)) return -1;
        if (turn == 7) return is ? 1 : 0;
      }
      return -1;
    };
    for (const double aside : {0.0, 0.6, 1.69}) {
      for (const double height : {1e-6, 0.4, 0.99}) QCOMPARE(beyond(height, aside), 1);
      for (const double height : {-0.99, -1e-6, 0.0, 1.01, 1.6}) QCOMPARE(beyond(height, aside), 0);
    }
    for (const double height : {1e-6, 0.4, 0.99}) QCOMPARE(beyond(height, 1.71), 0);
  }

  /// Whichever way they cross, and as near as they come: sections need a gap of one and a half
  /// voxels.
  void sectionsThatCrossOrTouchAreRefused() {
    const Geometry g = analytic::cube(40);
    const Vector3d centre = analytic::centreOf(g), axis = Vector3d::UnitZ();
    const Volume<float> phi = analytic::sampled(
        g, [&](const Vector3d& p) { return analytic::tube(p, centre, axis, 5.0); });
    const SplineField field = analytic::fieldOf(phi);
    const auto touch = [&](const CutPlane& one, const CutPlane& other) {
      return messageOf([&] {
               cutAway(field, phi, {one, other});
             }).find("touch") != std::string::npos;
    };
    for (const double degrees : {2.0, 10.0, 30.0, 55.0})
      for (const double turn : {0.3, 1.9, 4.4})
        for (const double up : {0.0, 0.8, 4.9}) {
          // The planes meet in a line across the tube, `up` off its axis.
          const double angle = degrees * M_PI / 180.0;
          const Vector3d aside(std::cos(turn), std::sin(turn), 0.0);
          const Vector3d on = centre + up * aside;
          const Vector3d tilted = std::cos(angle) * axis + std::sin(angle) * aside;
          const Vector3d inside = up * std::tan(angle) * axis;
          const CutPlane flat{centre, axis}, leaning{centre + inside, tilted};
          QVERIFY(std::fabs((on - leaning.pointLps).dot(tilted)) < 1e-9);
          QVERIFY(touch(flat, leaning) && touch(leaning, flat));
        }
    for (const auto& [apart, refused] : {std::pair{1.4, true}, std::pair{1.6, false}})
      QCOMPARE(touch({centre, axis}, {centre + apart * axis, -axis}), refused);
  }
};

QTEST_APPLESS_MAIN(TestCutAway)
#include "tst_cut_away.moc"
