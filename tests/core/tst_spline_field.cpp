// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/base/random.h"
#include "core/surface/spline_field.h"
#include "tests/core/analytic.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

class TestSplineField : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void interpolatingKindsTakeTheVoxelValues() {
    Volume<float> noise(oblique(14, 12, 11));
    for (std::size_t i = 0; i < noise.voxels.size(); ++i)
      noise.voxels[i] = static_cast<float>(randomNormal(3, i));
    for (const SplineKind kind : {SplineKind::InterpolatingBspline, SplineKind::CatmullRom}) {
      const SplineField field(noise, kind);
      for (std::size_t i = 0; i < noise.voxels.size(); ++i) {
        const Index3 p = noise.geometry.indexOf(i);
        const double value = field.atIndex({1.0 * p[0], 1.0 * p[1], 1.0 * p[2]}).value;
        QVERIFY(std::fabs(value - noise.voxels[i]) < 1e-5);
      }
    }
  }

  void reproducesALinearFieldAndItsGradient() {
    const Eigen::Vector3d slope(0.3, -1.1, 0.7);
    const auto volume =
        sampled(oblique(14, 12, 11), [&](const Eigen::Vector3d& x) { return slope.dot(x) + 2.0; });
    for (const SplineKind kind : {SplineKind::Bspline, SplineKind::CatmullRom}) {
      const SplineField field(volume, kind);
      const Eigen::Vector3d x = volume.geometry.toPhysical({5.3, 6.7, 4.2});
      QVERIFY(std::fabs(field.at(x).value - slope.dot(x) - 2.0) < 1e-4);
      QVERIFY((field.at(x).gradient - slope).norm() < 1e-4);
    }
  }

  void gradientIsTheDerivativeOfTheValue() {
    const auto volume = sampled(oblique(14, 12, 11), [](const Eigen::Vector3d& x) {
      return std::sin(x[0]) * std::cos(0.7 * x[1]) + x[2] * x[2] * 0.1;
    });
    for (const SplineKind kind :
         {SplineKind::InterpolatingBspline, SplineKind::Bspline, SplineKind::CatmullRom}) {
      const SplineField field(volume, kind);
      const Eigen::Vector3d x = volume.geometry.toPhysical({6.31, 5.72, 4.44});
      const double h = 1e-5;
      for (int a = 0; a < 3; ++a) {
        Eigen::Vector3d up = x;
        Eigen::Vector3d down = x;
        up[a] += h;
        down[a] -= h;
        const double difference = (field.at(up).value - field.at(down).value) / (2.0 * h);
        QVERIFY(std::fabs(difference - field.at(x).gradient[a]) < 1e-5);
      }
    }
  }

  void projectsOntoASphere() {
    const Geometry g = oblique(14, 12, 11);
    const Eigen::Vector3d centre = g.toPhysical({6.5, 5.5, 5.0});
    const double radius = 1.9;
    const auto phi = sampled(g, [&](const Eigen::Vector3d& x) { return ball(x, centre, radius); });
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    for (std::uint64_t i = 0; i < 50; ++i) {
      Eigen::Vector3d direction(randomNormal(1, 3 * i), randomNormal(1, 3 * i + 1),
                                randomNormal(1, 3 * i + 2));
      Eigen::Vector3d x = centre + (radius + 0.3) * direction.normalized();
      QVERIFY(field.projectToZero(x));
      QVERIFY(std::fabs(field.at(x).value) < 1e-5);
      QVERIFY(std::fabs((x - centre).norm() - radius) < 0.02);
    }
    Eigen::Vector3d far = g.toPhysical({0.0, 0.0, 0.0});
    QVERIFY(!field.projectToZero(far, 1.0));
  }
};

QTEST_GUILESS_MAIN(TestSplineField)
#include "tst_spline_field.moc"
