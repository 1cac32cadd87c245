// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>
#include <functional>

#include "core/levelset/evolution.h"
#include "core/levelset/front_speed.h"
#include "tests/core/analytic.h"

using namespace angiomesh;
using namespace angiomesh::analytic;
using Eigen::Vector3d;

namespace {

constexpr double kB = 0.1;

Thresholds simpleThresholds() {
  Thresholds t;
  t.b = kB;
  t.a = 2.0 * kB;
  return t;
}

// The vesselness of which eq. 3.21 makes p, between -1 and 1.
float vesselnessOf(double p) { return static_cast<float>(kB * (1.0 + p)); }

struct Weights {
  double gamma, d, p;
};

/// Compares phi_t with -F for the voxels beside the front, well inside the grid; the largest
/// difference, relative to F. `kappa(x, phi)` in 1 / working voxel.
double largestError(const Volume<float>& phi, const Weights& w,
                    const std::function<double(const Vector3d&, double)>& kappa) {
  const Geometry& g = phi.geometry;
  const Volume<float> vesselness(g, vesselnessOf(w.p));
  const FrontSpeed speed(vesselness, simpleThresholds(), w.gamma, w.d, true);
  double worst = 0.0;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
    const Index3 at = g.indexOf(i);
    bool inner = std::fabs(phi.voxels[i]) <= 0.5F;
    for (std::size_t a = 0; a < 3; ++a) inner = inner && at[a] > 1 && at[a] + 2 < g.size[a];
    if (!inner) continue;
    ++seen;
    const Vector3d x = g.toPhysical({1.0 * at[0], 1.0 * at[1], 1.0 * at[2]});
    const double speedThere =
        w.gamma * w.p + (1.0 - w.gamma) * std::fabs(w.d * kappa(x, phi.voxels[i]));
    worst = std::max(worst, std::fabs(-speed.change(phi, i) / speedThere - 1.0));
  }
  return seen > 300 ? worst : 1e9;
}

// Where the front of a field crosses the row of voxels through (j, k), first voxel inside, in
// voxels.
double crossing(const Volume<float>& phi, int j, int k) {
  for (int i = 0; i + 1 < phi.geometry.size[0]; ++i) {
    const double a = phi.at(i, j, k), b = phi.at(i + 1, j, k);
    if (a < 0.0 && b >= 0.0) return i + a / (a - b);
  }
  return -1.0;
}

// A plane across x at `at` voxels, inside below it.
LevelSetEvolution planeFront(double at, double p, const LevelSetParams& params) {
  const Geometry g = cube(24);
  return {std::make_shared<const Volume<float>>(g, vesselnessOf(p)), simpleThresholds(),
          sampled(g, [&](const Vector3d& x) { return x.x() - at; }), params};
}

}  // namespace

class TestFrontSpeed : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // phi_t = -(gamma p + (1 - gamma) |d kappa|) |grad phi|, with either term alone and both.
  void theSpeedIsThatOfEquation320_data() {
    QTest::addColumn<double>("gamma");
    QTest::addColumn<double>("d");
    QTest::addColumn<double>("p");
    QTest::newRow("expanding") << 0.3 << 0.0 << 1.0;
    QTest::newRow("half as fast") << 0.6 << 0.0 << 0.5;
    QTest::newRow("shrinking") << 0.3 << 0.0 << -0.7;
    QTest::newRow("bent") << 0.3 << 5.0 << 0.0;
    QTest::newRow("bent, d negative") << 0.6 << -5.0 << 0.0;
    QTest::newRow("both") << 0.4 << 4.0 << 0.8;
    QTest::newRow("the default weights") << 0.7 << 0.2 << 1.0;
  }
  void theSpeedIsThatOfEquation320() {
    QFETCH(double, gamma);
    QFETCH(double, d);
    QFETCH(double, p);
    const Weights w{gamma, d, p};
    for (const Geometry& g : {cube(48), oblique(90, 74, 44)}) {
      const double unit = g.voxelMm();
      const double radius = 18.0;  // working voxels
      const Vector3d c = centreOf(g) + Vector3d(0.21, -0.13, 0.07);
      const auto phi =
          sampled(g, [&](const Vector3d& x) { return ball(x, c, radius * unit) / unit; });
      const double error =
          largestError(phi, w, [&](const Vector3d&, double off) { return 2.0 / (radius + off); });
      QVERIFY2(error < 0.05, qPrintable(QString::number(error)));
    }
    Geometry g = cube(68);
    g.size[2] = 26;
    const double ring = 22.0, radius = 8.0;
    const Vector3d c = centreOf(g) + Vector3d(0.21, -0.13, 0.07);
    const auto phi = sampled(g, [&](const Vector3d& x) { return torus(x, c, ring, radius); });
    const double error = largestError(phi, w, [&](const Vector3d& x, double off) {
      const double from = std::hypot(x.x() - c.x(), x.y() - c.y());
      return 1.0 / (radius + off) + (from - ring) / (radius + off) / from;
    });
    QVERIFY2(error < 0.05, qPrintable(QString::number(error)));
  }

  // A plane has no curvature, and its steps are exact: half a voxel while it is fast, and what its
  // speed makes in one unit of time where that is less.
  void aPlaneMovesByTheWholeStep() {
    LevelSetParams params;
    for (const double step : {0.5, 0.3})
      for (const double p : {1.0, -1.0}) {
        params.stepVoxels = step;
        LevelSetEvolution front = planeFront(11.3, p, params);
        front.step(10);
        const double moved = crossing(front.phi(), 12, 11) - 11.3;
        QVERIFY2(std::fabs(moved - 10.0 * step * p) < 1e-3, qPrintable(QString::number(moved)));
      }
    params.stepVoxels = 0.5;
    params.gamma = 0.5;
    LevelSetEvolution slow = planeFront(11.3, 0.2, params);
    slow.step(10);
    QVERIFY(std::fabs(crossing(slow.phi(), 12, 11) - 11.3 - 10 * 0.5 * 0.2) < 1e-3);
  }

  // Where p is 0 a ball grows by its curvature alone: r' = (1 - gamma) d 2 / r.
  void aBallGrowsByItsCurvature() {
    const Geometry g = cube(40);
    LevelSetParams params;
    params.gamma = 0.2;
    params.d = 1.0;
    const double radius = 8.0;
    LevelSetEvolution front(
        std::make_shared<const Volume<float>>(g, vesselnessOf(0.0)), simpleThresholds(),
        sampled(g, [&](const Vector3d& x) { return ball(x, centreOf(g), radius); }), params);
    const auto equivalentRadius = [&] {
      return std::cbrt(static_cast<double>(front.insideVoxels()) * 3.0 / 4.0 / M_PI);
    };
    QVERIFY(std::fabs(equivalentRadius() - radius) < 0.1);
    front.step(30);
    // The speed stays below the largest step, so each iteration is one unit of time. The layers
    // hold city-block distances, whose curvature comes out larger than the front's.
    const double expected = std::sqrt(radius * radius + 2.0 * 0.8 * 2.0 * 30) - radius;
    const double grown = equivalentRadius() - radius;
    QVERIFY2(grown > 0.8 * expected && grown < 1.8 * expected,
             qPrintable(QString("%1, not %2").arg(grown).arg(expected)));
  }
};

QTEST_GUILESS_MAIN(TestFrontSpeed)
#include "tst_front_speed.moc"
