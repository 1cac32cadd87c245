// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <array>
#include <cmath>

#include "core/base/random.h"
#include "core/centreline/lumen_probe.h"
#include "core/centreline/vessel_at.h"
#include "core/distance/redistance.h"
#include "core/phantom/phantom.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"

using namespace angiomesh;
using namespace angiomesh::analytic;
using Eigen::Vector3d;

namespace {

template <class F>
SplineField fieldOf(const Geometry& g, F f) {
  return analytic::fieldOf(clamped(g, f));
}

struct Random {
  std::uint64_t count = 0;
  double uniform() { return randomUniform(7, count++); }
};

double degreesBetweenLines(const Vector3d& a, const Vector3d& b) {
  const double degrees = degreesBetween(a, b);
  return std::min(degrees, 180.0 - degrees);
}

/// The greatest errors of vesselAt() over many points.
struct Worst {
  double degrees = 0.0, centreVoxels = 0.0, radius = 0.0;
  int missing = 0;

  void add(const std::optional<LocalVessel>& v, const Vector3d& axis, const Vector3d& centreLps,
           double radiusMm, double voxelMm) {
    if (!v) {
      ++missing;
      return;
    }
    degrees = std::max(degrees, degreesBetweenLines(v->axisLps, axis));
    centreVoxels = std::max(centreVoxels, (v->centreLps - centreLps).norm() / voxelMm);
    radius = std::max(radius, std::fabs(v->radiusMm / radiusMm - 1.0));
  }

  void verify(double mostDegrees, double mostCentre, double mostRadius) const {
    const QString text = QString("axis %1 degrees, centre %2 voxel, radius %3 %, missing %4")
                             .arg(degrees)
                             .arg(centreVoxels)
                             .arg(100.0 * radius)
                             .arg(missing);
    QVERIFY2(
        missing == 0 && degrees < mostDegrees && centreVoxels < mostCentre && radius < mostRadius,
        qPrintable(text));
  }
};

Vector3d acrossOf(const Vector3d& u, Random& random) {
  const Vector3d d(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
  return (d - d.dot(u) * u).normalized();
}

/// Distance-like, then redistanced and clamped as by the pipeline.
SplineField phantomPhi(const PhantomParams& params) {
  return analytic::fieldOf(redistance(phantomField(params)));
}

}  // namespace

class TestVesselAt : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Into the box of the voxels' centres, at each of its faces, edges and corners.
  void pointsBeyondTheVolumeAreMovedToItsFaces() {
    const Geometry g = oblique(24, 22, 18);
    const SplineField field =
        fieldOf(g, [&](const Vector3d& x) { return ball(x, centreOf(g), 3); });
    const LumenProbe probe(field);
    const Vector3d last(23.0, 21.0, 17.0);
    for (int n = 0; n < 27; ++n) {
      Vector3d index, nearest;
      int beyond = n;
      for (int a = 0; a < 3; ++a, beyond /= 3) {
        nearest[a] = std::array{0.0, 0.4 * last[a], last[a]}[static_cast<std::size_t>(beyond % 3)];
        index[a] = nearest[a] + 3.5 * (beyond % 3 - 1);
        if (beyond % 3 == 1) index[a] = nearest[a];
      }
      QVERIFY((probe.intoVolume(g.toPhysical(index)) - g.toPhysical(nearest)).norm() < 1e-9);
    }
  }

  void straightTubes_data() {
    QTest::addColumn<Vector3d>("axis");
    QTest::addColumn<double>("radius");
    for (const double radius : {1.0, 1.2, 2.0, 4.0, 8.0, 20.0}) {
      QTest::addRow("along the grid, %g", radius) << Vector3d(0, 0, 1) << radius;
      QTest::addRow("oblique, %g", radius) << Vector3d(1, 2, 3.3) << radius;
      QTest::addRow("diagonal, %g", radius) << Vector3d(1, 1, 0.05) << radius;
    }
  }

  void straightTubes() {
    QFETCH(const Vector3d, axis);
    QFETCH(const double, radius);
    const Geometry g = cube(72);
    const Vector3d u = axis.normalized();
    const Vector3d centre = centreOf(g) + Vector3d(0.3, -0.2, 0.1);
    const SplineField phi =
        fieldOf(g, [&](const Vector3d& x) { return tube(x, centre, u, radius); });
    Random random;
    Worst worst;
    for (int n = 0; n < 100; ++n) {
      const Vector3d on = centre + (10.0 * random.uniform() - 5.0) * u;
      const Vector3d aside = (radius + 1.9) * random.uniform() * acrossOf(u, random);
      worst.add(vesselAt(phi, on + aside), u, on, radius, 1.0);
    }
    worst.verify(2.0, 0.1, 0.03);
  }

  void curvedTubes() {
    for (const double radius : {1.2, 2.0, 4.0, 6.5}) {
      const double ring = 4.0 * radius;
      const Geometry g = cube(static_cast<int>(2.0 * (ring + radius) + 12.0));
      const SplineField phi =
          fieldOf(g, [&](const Vector3d& x) { return torus(x, centreOf(g), ring, radius); });
      Random random;
      Worst worst;
      for (int n = 0; n < 100; ++n) {
        const double t = 2.0 * M_PI * random.uniform();
        const Vector3d tangent(-std::sin(t), std::cos(t), 0.0);
        const Vector3d on = centreOf(g) + ring * Vector3d(std::cos(t), std::sin(t), 0.0);
        const Vector3d aside = (radius + 1.5) * random.uniform() * acrossOf(tangent, random);
        worst.add(vesselAt(phi, on + aside), tangent, on, radius, 1.0);
      }
      worst.verify(1.5, 0.05, 0.03);
    }
  }

  void spacingAndDirectionCount() {
    Geometry g = oblique(80, 70, 40);
    for (const double mirror : {1.0, -1.0}) {
      g.direction.col(1) *= mirror;
      const Vector3d u = g.direction * Vector3d(1, 0.6, 0.8).normalized();
      const SplineField phi =
          fieldOf(g, [&](const Vector3d& x) { return tube(x, centreOf(g), u, 2.0); });
      Random random;
      Worst worst;
      for (int n = 0; n < 50; ++n) {
        const Vector3d on = centreOf(g) + (random.uniform() - 0.5) * u;
        worst.add(vesselAt(phi, on + 2.5 * random.uniform() * acrossOf(u, random)), u, on, 2.0,
                  g.voxelMm());
      }
      worst.verify(2.0, 0.1, 0.03);
    }
  }

  void roughWalls() {
    const Geometry g = cube(64);
    const Vector3d u = Vector3d(1, 2, 3.3).normalized();
    for (const double radius : {3.0, 8.0}) {
      const SplineField phi = fieldOf(g, [&](const Vector3d& x) {
        return tube(x, centreOf(g), u, radius) +
               0.5 * std::sin(1.9 * x[0]) * std::sin(2.1 * x[1]) * std::sin(1.7 * x[2]);
      });
      Random random;
      Worst worst;
      for (int n = 0; n < 100; ++n) {
        const Vector3d on = centreOf(g) + (10.0 * random.uniform() - 5.0) * u;
        worst.add(vesselAt(phi, on + radius * random.uniform() * acrossOf(u, random)), u, on,
                  radius, 1.0);
      }
      worst.verify(2.5, 0.25, 0.05);
    }
  }

  void ovalVesselsKeepTheirArea() {
    const Geometry g = cube(64);
    const SplineField phi = fieldOf(g, [&](const Vector3d& x) {
      const Vector3d d = x - centreOf(g);
      return 4.0 * (std::hypot(d[0] / 12.0, d[1] / 4.0) - 1.0);
    });
    Random random;
    Worst worst;
    for (int n = 0; n < 50; ++n)
      worst.add(vesselAt(phi, centreOf(g) + Vector3d(9.0 * random.uniform(), random.uniform(), 0)),
                Vector3d::UnitZ(), centreOf(g), std::sqrt(48.0), 1.0);
    worst.verify(1.0, 0.1, 0.03);
  }

  void neighboursAreNotMixed() {
    PhantomParams params;
    params.kind = PhantomKind::Kissing;
    params.size = {64, 64, 64};
    params.radius = 4.0;
    params.gap = 0.8;
    params.offset = {0.5, 0.5, 0.0};  // voxels lie in the gap
    const SplineField phi = phantomPhi(params);
    const Vector3d middle(32.0, 32.0, 31.5);
    Random random;
    Worst worst;
    for (int n = 0; n < 100; ++n) {
      const double side = n % 2 == 0 ? 1.0 : -1.0;
      const Vector3d on = middle + Vector3d(0, 0, 8.0 * random.uniform() - 4.0);
      // Anywhere in a tube, and on the wall that faces the other one.
      const double aside = n < 50 ? 0.45 : 0.45 + 7.5 * random.uniform();
      int across = 0;
      const auto at = [&](double mm) {
        Vector3d p = on;
        p[across] += side * mm;
        return p;
      };
      if (phi.valueAt(at(4.4)) >= 0.0) across = 1;
      worst.add(vesselAt(phi, at(aside)), Vector3d::UnitZ(), at(4.4), 4.0, 1.0);
    }
    worst.verify(3.0, 0.2, 0.03);
  }

  void branchesHaveTheirOwnAxes() {
    PhantomParams params;
    params.kind = PhantomKind::Bifurcation;
    params.size = {80, 80, 80};
    params.radius = 5.0;
    const SplineField phi = phantomPhi(params);
    for (const CentreLineSegment& s : makePhantom(params).centreLines) {
      const Vector3d u = (s.to - s.from).normalized();
      // From two radii off the joint on, where the blend has ended.
      const bool isParent = s.parent < 0;
      const double length = (s.to - s.from).norm();
      for (double at = 12.0; at < length - 4.0; at += 2.0) {
        const Vector3d on = isParent ? Vector3d(s.to - at * u) : Vector3d(s.from + at * u);
        Worst worst;
        worst.add(vesselAt(phi, on), u, on, s.radiusToMm, 1.0);
        worst.verify(3.0, 0.3, 0.04);
      }
    }
    // In the joint: within a radius of it, along the parent.
    const auto joint = vesselAt(phi, Vector3d::Constant(39.5));
    QVERIFY(joint);
    QVERIFY(degreesBetweenLines(joint->axisLps, Vector3d::UnitZ()) < 15.0);
    QVERIFY((joint->centreLps - Vector3d::Constant(39.5)).norm() < 2.5);
    QVERIFY(joint->radiusMm > 4.5 && joint->radiusMm < 8.0);
  }

  void tipsBelongToTheirVessel() {
    const Geometry g = cube(64);
    const Vector3d u = Vector3d(1, 2, 3.3).normalized();
    const Vector3d from = centreOf(g) - 20.0 * u;
    const Vector3d to = centreOf(g) + 20.0 * u;
    const SplineField phi = fieldOf(g, [&](const Vector3d& x) {
      const double t = std::clamp((x - from).dot(u), 0.0, 40.0);
      return (x - from - t * u).norm() - 4.0;
    });
    for (const double past : {-4.0, 0.0, 3.5, 4.0, 5.0}) {
      const auto v = vesselAt(phi, to + past * u);
      QVERIFY(v);
      const double off = (v->centreLps - to - std::min(past, 0.0) * u).norm();
      QVERIFY(isBelow(off, 2.1));
      QVERIFY(isBelow(degreesBetweenLines(v->axisLps, u), 5.0));
      QVERIFY(v->radiusMm > 3.2 && v->radiusMm < 4.2);
    }
  }

  void whereTheVolumeEnds() {
    const Geometry g = cube(48);
    const Vector3d u = Vector3d(1, 2, 3.3).normalized();
    const SplineField phi =
        fieldOf(g, [&](const Vector3d& x) { return tube(x, centreOf(g), u, 4.0); });
    const double leaves = 23.5 / u[2];
    Worst worst;
    for (const double at : {-leaves, -leaves + 1.0, leaves - 2.0, leaves})
      worst.add(vesselAt(phi, centreOf(g) + at * u), u, centreOf(g) + at * u, 4.0, 1.0);
    worst.verify(2.0, 0.5, 0.05);
  }

  void nothingFarFromVessels() {
    const Geometry g = cube(48);
    const SplineField phi =
        fieldOf(g, [&](const Vector3d& x) { return tube(x, centreOf(g), Vector3d::UnitZ(), 4.0); });
    QVERIFY(!vesselAt(phi, centreOf(g) + Vector3d(6.5, 0, 0)));
    QVERIFY(vesselAt(phi, centreOf(g) + Vector3d(5.5, 0, 0)));
    QVERIFY(!vesselAt(phi, centreOf(g) + Vector3d(5.5, 0, 0), 1.0));
    QVERIFY(!vesselAt(phi, centreOf(g) + Vector3d(0, 0, 60)));
  }
};

QTEST_GUILESS_MAIN(TestVesselAt)
#include "tst_vessel_at.moc"
