// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/field/cell_bounds.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

constexpr SplineKind kKinds[] = {SplineKind::InterpolatingBspline, SplineKind::Bspline,
                                 SplineKind::CatmullRom};

// A field of noise on a grid that is neither isotropic nor upright.
Volume<float> slantedNoise() {
  Volume<float> phi = shapes::noise({8, 8, 8}, 21);
  phi.geometry = shapes::obliqueGeometry({8, 8, 8}, true);
  return phi;
}

Vector3d between(const Vector3d& low, const Vector3d& high, std::uint64_t i) {
  Vector3d at = low;
  for (int a = 0; a < 3; ++a)
    at[a] += randomUniform(5, 3 * i + static_cast<std::uint64_t>(a)) * (high[a] - low[a]);
  return at;
}

double spectralNorm(const Eigen::Matrix3d& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(symmetric)
      .eigenvalues()
      .cwiseAbs()
      .maxCoeff();
}

}  // namespace

class TestCellBounds : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void noHessianExceedsItsBound() {
    const Volume<float> phi = slantedNoise();
    const Index3 cell{2, 3, 4};
    for (const SplineKind kind : kKinds) {
      const SplineField field(phi, kind);
      const double whole = hessianBound(field, cell);
      for (std::uint64_t n = 0; n < 40; ++n) {
        const Vector3d first(2.0, 3.0, 4.0);
        const Vector3d low = between(first, first + Vector3d::Constant(0.7), n);
        const Vector3d high = low + Vector3d::Constant(0.3);
        const double boxed = hessianBound(field, cell, low, high);
        QVERIFY(boxed <= whole * (1.0 + 1e-9));
        double most = 0.0;
        for (std::uint64_t k = 0; k < 20; ++k)
          most = std::max(
              most,
              spectralNorm(field.secondAt(phi.geometry.toPhysical(between(low, high, 100 * n + k)))
                               .hessian));
        QVERIFY2(most <= boxed * (1.0 + 1e-6),
                 qPrintable(QString("%1 above %2").arg(most).arg(boxed)));
        // Loose by the Frobenius norm and the hull, no more.
        QVERIFY(boxed < 8.0 * most);
      }
    }
  }

  /// Where the second derivatives are constant the bound is their Frobenius norm.
  void theBoundOfAQuadraticIsItsBend() {
    Eigen::Matrix3d bend;
    bend << 0.3, -0.1, 0.2, -0.1, 0.5, 0.05, 0.2, 0.05, -0.4;
    const Geometry g = shapes::obliqueGeometry({30, 30, 30}, true);
    const Vector3d centre = analytic::centreOf(g);
    const auto phi = shapes::sampled(
        g, [&](const Vector3d& x) { return 0.5 * (x - centre).dot(bend * (x - centre)) - 1.0; });
    for (const SplineKind kind : kKinds) {
      const SplineField field(phi, kind);
      const Index3 cell{14, 15, 14};
      QVERIFY(std::fabs(hessianBound(field, cell) / bend.norm() - 1.0) < 2e-3);
      const Vector3d low(14.1, 15.2, 14.4), high(14.6, 15.9, 14.7);
      QVERIFY(std::fabs(hessianBound(field, cell, low, high) / bend.norm() - 1.0) < 5e-3);
    }
  }

  void boundsOfTheSlopeHoldAndClose() {
    for (const Volume<float>& phi : {shapes::noise({8, 8, 8}, 21), slantedNoise()})
      for (const SplineKind kind : kKinds) {
        const SplineField field(phi, kind);
        for (std::uint64_t i = 0; i < 40; ++i) {
          const Vector3d way = Vector3d(randomNormal(1, 3 * i), randomNormal(1, 3 * i + 1),
                                        randomNormal(1, 3 * i + 2))
                                   .normalized();
          const Vector3d low(2.0 + randomUniform(2, 3 * i), 3.0 + 0.5 * randomUniform(2, 3 * i + 1),
                             4.0 + 0.2 * randomUniform(2, 3 * i + 2));
          const Index3 cell{2, 3, 4};
          double wide = 0.0;
          for (const double side : {0.4, 0.05}) {
            const Vector3d high =
                (low + Vector3d::Constant(side)).cwiseMin(Vector3d(3.0, 4.0, 5.0));
            const auto bounds = slopeBounds(field, cell, low, high, way);
            for (std::uint64_t k = 0; k < 20; ++k) {
              const Vector3d at = between(low, high, 100 * i + k);
              const double slope = field.at(phi.geometry.toPhysical(at)).gradient.dot(way);
              QVERIFY(slope > bounds[0] - 1e-5 && slope < bounds[1] + 1e-5);
            }
            if (side > 0.1)
              wide = bounds[1] - bounds[0];
            else
              QVERIFY(bounds[1] - bounds[0] < 0.5 * wide + 1e-9);
          }
        }
      }
  }
};

QTEST_GUILESS_MAIN(TestCellBounds)
#include "tst_cell_bounds.moc"
