// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/base/random.h"
#include "core/field/spline_field.h"
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

  void hessianIsTheDerivativeOfTheGradient() {
    const auto volume = sampled(oblique(14, 12, 11), [](const Eigen::Vector3d& x) {
      return std::sin(x[0]) * std::cos(0.7 * x[1]) + x[2] * x[2] * 0.1;
    });
    for (const SplineKind kind :
         {SplineKind::InterpolatingBspline, SplineKind::Bspline, SplineKind::CatmullRom}) {
      const SplineField field(volume, kind);
      for (const Eigen::Vector3d& index :
           {Eigen::Vector3d(6.31, 5.72, 4.44), Eigen::Vector3d(0.2, 10.7, 9.6)}) {
        const Eigen::Vector3d x = volume.geometry.toPhysical(index);
        const SplineField::SecondJet jet = field.secondAt(x);
        QVERIFY(std::fabs(jet.value - field.at(x).value) < 1e-12);
        QVERIFY(std::fabs(jet.value - field.valueAt(x)) < 1e-12);
        QVERIFY((jet.gradient - field.at(x).gradient).norm() < 1e-12);
        QVERIFY((jet.hessian - jet.hessian.transpose()).norm() < 1e-12);
        const double h = 1e-5;
        for (int a = 0; a < 3; ++a) {
          const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(a);
          const Eigen::Vector3d difference =
              (field.at(x + step).gradient - field.at(x - step).gradient) / (2.0 * h);
          QVERIFY((difference - jet.hessian.col(a)).norm() < 1e-5);
        }
      }
    }
  }

  /// Away from the border, where the spline has natural ends, cubics and below are reproduced.
  void interpolatingBsplineReproducesAQuadraticInside() {
    Eigen::Matrix3d bend;
    bend << 0.3, -0.1, 0.2, -0.1, 0.5, 0.05, 0.2, 0.05, -0.4;
    const Geometry g = oblique(32, 30, 30);
    const Eigen::Vector3d centre = centreOf(g);
    const auto volume = sampled(g, [&](const Eigen::Vector3d& x) {
      return 0.5 * (x - centre).dot(bend * (x - centre)) - 1.0;
    });
    const SplineField field(volume, SplineKind::InterpolatingBspline);
    const Eigen::Vector3d x = g.toPhysical({15.3, 14.6, 15.2});
    const SplineField::SecondJet jet = field.secondAt(x);
    QVERIFY(std::fabs(jet.value - 0.5 * (x - centre).dot(bend * (x - centre)) + 1.0) < 1e-4);
    QVERIFY((jet.gradient - bend * (x - centre)).norm() < 1e-4);
    QVERIFY((jet.hessian - bend).norm() < 1e-3);
  }

  void valuesLieWithinTheBounds() {
    Volume<float> noise(oblique(9, 8, 7));
    for (std::size_t i = 0; i < noise.voxels.size(); ++i)
      noise.voxels[i] = static_cast<float>(randomNormal(3, i));
    for (const SplineKind kind :
         {SplineKind::InterpolatingBspline, SplineKind::Bspline, SplineKind::CatmullRom}) {
      const SplineField field(noise, kind);
      for (std::uint64_t i = 0; i < 2000; ++i) {
        const Eigen::Vector3d x(8 * randomUniform(1, 3 * i), 7 * randomUniform(1, 3 * i + 1),
                                6 * randomUniform(1, 3 * i + 2));
        const Index3 cell{static_cast<int>(x[0]), static_cast<int>(x[1]), static_cast<int>(x[2])};
        const double value = field.atIndex(x).value;
        for (const auto& [low, high] : {field.bounds(cell, {cell[0] + 1, cell[1] + 1, cell[2] + 1}),
                                        field.bounds({0, 0, 0}, {8, 7, 6})})
          QVERIFY(low <= value + 1e-6 && value - 1e-6 <= high);
      }
      for (std::size_t i = 0; i < noise.voxels.size(); ++i) {
        const Index3 p = noise.geometry.indexOf(i);
        const double value = field.atIndex({1.0 * p[0], 1.0 * p[1], 1.0 * p[2]}).value;
        QVERIFY(std::fabs(field.atVoxel(p[0], p[1], p[2]) - value) < 1e-6);
      }
    }
  }

  void curvaturesOfBallTubeAndTorus() {
    const Geometry g = cube(48);
    const Eigen::Vector3d c = centreOf(g) + Eigen::Vector3d(0.21, -0.13, 0.37);
    const Eigen::Vector3d axis = Eigen::Vector3d(0.4, 0.3, 0.87).normalized();
    const double r = 8.0;
    const double ring = 13.0;
    struct Body {
      Volume<float> phi;
      bool torus;
      double second;
    };
    const Body bodies[] = {
        {sampled(g, [&](const Eigen::Vector3d& x) { return ball(x, c, r); }), false, 1.0 / r},
        {sampled(g, [&](const Eigen::Vector3d& x) { return tube(x, c, axis, r); }), false, 0.0},
        {sampled(g, [&](const Eigen::Vector3d& x) { return torus(x, c, ring, r); }), true, 0.0}};
    for (const Body& body : bodies) {
      const SplineField field(body.phi, SplineKind::InterpolatingBspline);
      int found = 0;
      for (std::uint64_t i = 0; i < 300; ++i) {
        Eigen::Vector3d x = c + 18.0 * Eigen::Vector3d(randomUniform(1, 3 * i) - 0.5,
                                                       randomUniform(1, 3 * i + 1) - 0.5,
                                                       randomUniform(1, 3 * i + 2) - 0.5);
        if (!field.projectToZero(x, 4.0)) continue;
        ++found;
        const PrincipalCurvatures k = principalCurvatures(field.secondAt(x));
        // Along the torus: cos of the angle to the plane of the ring, over the distance to its
        // axis.
        const double rho = std::hypot(x[0] - c[0], x[1] - c[1]);
        const double second = body.torus ? (rho - ring) / r / rho : body.second;
        QVERIFY(std::fabs(k.k1 - std::max(1.0 / r, second)) < 0.03 / r);
        QVERIFY(std::fabs(k.k2 - std::min(1.0 / r, second)) < 0.03 / r);
      }
      QVERIFY(found > 50);
    }
  }

  void curvatureWithoutGradientIsZero() {
    SplineField::SecondJet jet{0.0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()};
    QCOMPARE(principalCurvatures(jet).maximal(), 0.0);
    const SplineField flat(Volume<float>(cube(5)), SplineKind::InterpolatingBspline);
    QCOMPARE(principalCurvatures(flat.secondAt({2.0, 2.0, 2.0})).maximal(), 0.0);
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
