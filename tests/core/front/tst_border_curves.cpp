// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/front/border_curves.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

constexpr double kEdge = 2.5;

/// The rims of a field whose edges are to be `kEdge` long wherever nothing else limits them.
struct Rims {
  Geometry grid;
  BorderCurves curves;

  template <class Distance>
  Rims(const Geometry& g, const Distance& distance) : grid(g) {
    const SplineField field = analytic::fieldOf(analytic::sampled(g, distance));
    SizingParams sizing = SizingParams::printed();
    sizing.edgeMinMm = sizing.edgeMaxMm = kEdge;
    const GuidanceField size(field, sizing);
    curves = borderCurves(field, size, EndPlanes(g), {}, false);
  }

  [[nodiscard]] std::vector<Vector3d> points(std::size_t rim) const {
    std::vector<Vector3d> list;
    for (const std::uint32_t v : curves.rims[rim]) list.push_back(curves.points[v].point);
    return list;
  }
  [[nodiscard]] std::vector<double> edges(std::size_t rim) const {
    const std::vector<Vector3d> list = points(rim);
    std::vector<double> lengths;
    for (std::size_t i = 0; i < list.size(); ++i)
      lengths.push_back((list[(i + 1) % list.size()] - list[i]).norm());
    return lengths;
  }
};

Geometry gridOf(int nx, int ny, int nz) {
  Geometry g;
  g.size = {nx, ny, nz};
  return g;
}

double circle(const Vector3d& p, double x, double y, double radius) {
  return std::hypot(p.x() - x, p.y() - y) - radius;
}

}  // namespace

class TestBorderCurves : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Wherever the trace of a rim begins and ends, and however near the other border is.
  void aRoundRimIsDividedEvenly_data() {
    QTest::addColumn<int>("length");
    for (const int length : {2, 12}) QTest::addRow("%d", length) << length;
  }
  void aRoundRimIsDividedEvenly() {
    QFETCH(int, length);
    constexpr double radius = 6.0;
    const Rims rims(gridOf(24, 24, length),
                    [](const Vector3d& p) { return circle(p, 11.3, 11.6, radius); });
    QCOMPARE(rims.curves.rims.size(), std::size_t{2});
    for (std::size_t n = 0; n < 2; ++n) {
      const std::vector<double> edges = rims.edges(n);
      QCOMPARE(edges.size(), static_cast<std::size_t>(std::lround(2.0 * M_PI * radius / kEdge)));
      const auto [least, most] = std::minmax_element(edges.begin(), edges.end());
      QVERIFY(isBelow(*most / *least, 1.02));
      for (const Vector3d& p : rims.points(n)) {
        QVERIFY(std::fabs(circle(p, 11.3, 11.6, radius)) < 0.01);
        QVERIFY(p.z() == 0.0 || p.z() == length - 1.0);
      }
    }
  }

  /// No edge is so long that it could cross the other vessel's rim, and both have the same.
  void rimsThatAllButTouchHaveShortEdgesThere() {
    constexpr double radius = 6.0, gap = 0.5;
    const std::array<double, 2> x{20.0 - radius - 0.5 * gap, 20.0 + radius + 0.5 * gap};
    const Rims rims(gridOf(41, 24, 12), [&](const Vector3d& p) {
      return std::min(circle(p, x[0], 11.6, radius), circle(p, x[1], 11.6, radius));
    });
    QCOMPARE(rims.curves.rims.size(), std::size_t{4});
    for (std::size_t n = 0; n < 4; ++n) {
      const std::vector<Vector3d> points = rims.points(n);
      const double other = points[0].x() < 20.0 ? x[1] : x[0];
      const std::vector<double> edges = rims.edges(n);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double away = std::max(circle(points[i], other, 11.6, radius),
                                     circle(points[(i + 1) % points.size()], other, 11.6, radius));
        // The spline rounds the ridge between the vessels, which are farther apart for it.
        QVERIFY(isBelow(edges[i], 1.6 * (away + 0.25)));
        QVERIFY(isBelow(edges[i], 1.1 * kEdge));
      }
      QVERIFY(*std::min_element(edges.begin(), edges.end()) < 0.6 * kEdge);
      QVERIFY(*std::max_element(edges.begin(), edges.end()) > 0.8 * kEdge);
      QCOMPARE(edges.size(), rims.edges(0).size());
    }
  }

  /// The two sides of a slit are near each other, though they are one rim.
  void theSidesOfASlitSeeEachOther() {
    constexpr double half = 0.7;
    const Rims rims(gridOf(30, 20, 12), [](const Vector3d& p) {
      return std::hypot(p.x() - std::clamp(p.x(), 7.3, 21.8), p.y() - 9.7) - half;
    });
    QCOMPARE(rims.curves.rims.size(), std::size_t{2});
    for (std::size_t n = 0; n < 2; ++n) {
      const std::vector<double> edges = rims.edges(n);
      const auto [least, most] = std::minmax_element(edges.begin(), edges.end());
      QVERIFY(isBelow(*most, 1.7 * 2.0 * half) && isAbove(*least, half));
    }
  }
};

QTEST_APPLESS_MAIN(TestBorderCurves)
#include "tst_border_curves.moc"
