// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/distance/redistance.h"
#include "core/field/spline_field.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

using Shape = std::function<double(const Eigen::Vector3d&)>;

/// How far the zero set lies from that of `shape` (a distance), and how far |grad phi| from 1, both
/// at their worst, in working voxels.
struct Deviation {
  double zeroSet = 0.0, gradient = 0.0, value = 0.0;
};

Deviation deviationOf(const Volume<float>& phi, const Shape& shape, double gradientReach) {
  const Geometry& g = phi.geometry;
  const double unit = g.voxelMm();
  const SplineField field(phi, SplineKind::InterpolatingBspline);
  Deviation error;
  for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
    const Index3 p = g.indexOf(i);
    bool inner = true;
    for (int a = 0; a < 3; ++a) inner = inner && p[a] >= 6 && p[a] < g.size[a] - 6;
    const Eigen::Vector3d x = voxelCentre(g, p);
    const double exact = shape(x) / unit;
    if (!inner || std::fabs(exact) > 3.0) continue;
    if (std::fabs(exact) < 1.0) {
      Eigen::Vector3d foot = x;
      if (field.projectToZero(foot))
        error.zeroSet = std::max(error.zeroSet, std::fabs(shape(foot)) / unit);
    }
    if (std::fabs(exact) < gradientReach) {
      error.gradient = std::max(error.gradient, std::fabs(field.at(x).gradient.norm() - 1.0));
      error.value = std::max(error.value, std::fabs(phi.voxels[i] / unit - exact));
    }
  }
  return error;
}

}  // namespace

class TestRedistance : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void distortedFieldsBecomeDistances_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<bool>("anisotropic");
    for (const bool anisotropic : {false, true}) {
      QTest::addRow("ball %d", anisotropic) << 0 << anisotropic;
      QTest::addRow("tube %d", anisotropic) << 1 << anisotropic;
      QTest::addRow("torus %d", anisotropic) << 2 << anisotropic;
    }
  }

  // On the grid with coarse z, the clamp of the default band would lie within two z voxels of the
  // surface.
  void distortedFieldsBecomeDistances() {
    QFETCH(int, shape);
    QFETCH(bool, anisotropic);
    const Geometry g = anisotropic ? oblique(80, 66, 40) : cube(40);
    const double unit = anisotropic ? 0.8 : 1.0;  // a few voxels per radius along z as well
    const Eigen::Vector3d c = centreOf(g) + unit * Eigen::Vector3d(0.21, -0.37, 0.11);
    const Shape exact = [&](const Eigen::Vector3d& x) {
      if (shape == 0) return ball(x, c, 9.0 * unit);
      if (shape == 1) return tube(x, c, Eigen::Vector3d(1, 2, 3).normalized(), 6.0 * unit);
      return torus(x, c, 11.0 * unit, 5.5 * unit);
    };
    const auto distorted = sampled(g, [&](const Eigen::Vector3d& x) {
      const double d = exact(x) / unit;
      return d * (2.0 + 0.5 * std::sin(0.2 * (x[0] + x[1]) / unit)) * (1.0 + 0.03 * d);
    });
    const Deviation error =
        deviationOf(redistance(distorted, anisotropic ? 12.0 : 5.0), exact, 3.0);
    QVERIFY(isBelow(error.zeroSet, 0.01));
    QVERIFY(isBelow(error.gradient, 0.05));
    QVERIFY(isBelow(error.value, 0.01));
  }

  void thinTubesKeepTheirRadius() {
    const Geometry g = cube(32);
    for (const double radius : {1.0, 1.5, 2.0, 3.0}) {
      const Shape exact = [&](const Eigen::Vector3d& x) {
        return tube(x, centreOf(g), Eigen::Vector3d(1, 2, 3).normalized(), radius);
      };
      const auto phi = redistance(sampled(g, exact));
      const SplineField field(phi, SplineKind::InterpolatingBspline);
      double sum = 0.0;
      int count = 0;
      for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
        const Index3 p = g.indexOf(i);
        Eigen::Vector3d x(p[0], p[1], p[2]);
        if (std::fabs(exact(x)) > 0.6 || (x - centreOf(g)).norm() > 12.0 || !field.projectToZero(x))
          continue;
        sum += exact(x);
        ++count;
      }
      // A tube of one voxel has its axis, where the distance has a crease, inside the spline's
      // support.
      QVERIFY2(std::fabs(sum / count) < (radius > 1.0 ? 0.02 : 0.03),
               qPrintable(QString("%1: %2").arg(radius).arg(sum / count)));
    }
  }

  void signsStayAndValuesAreClamped() {
    const Geometry g = cube(24);
    const auto phi = sampled(g, [&](const Eigen::Vector3d& x) {
      return std::sin(0.7 * x[0]) + std::cos(0.5 * x[1]) - 0.9 * std::sin(0.4 * x[2]);
    });
    const auto d = redistance(phi, 3.0);
    for (std::size_t i = 0; i < d.voxels.size(); ++i) {
      QCOMPARE(d.voxels[i] < 0.0F, phi.voxels[i] < 0.0F);
      QVERIFY(std::fabs(d.voxels[i]) <= 3.0F);
    }
    QVERIFY_THROWS_EXCEPTION(NumericError, redistance(Volume<float>(g, 1.0F)));
  }

  void sameBitsForAnyNumberOfThreads() {
    const Geometry g = cube(24);
    const auto phi =
        sampled(g, [&](const Eigen::Vector3d& x) { return ball(x, centreOf(g), 7.3); });
    setThreads(1);
    const auto one = redistance(phi);
    setThreads(2);
    QVERIFY(one.voxels == redistance(phi).voxels);
  }

  void axesAreAlike() {
    for (const bool fewAlongLast : {true, false}) {
      Volume<float> phi = unlikeVessels(fewAlongLast);
      for (float& value : phi.voxels) value *= 1.0F + 0.3F * std::fabs(value);
      const double most = mostApart(turned(redistance(phi)), redistance(turned(phi)));
      QVERIFY2(most < 0.01, qPrintable(QString::number(most)));
    }
  }
};

QTEST_GUILESS_MAIN(TestRedistance)
#include "tst_redistance.moc"
