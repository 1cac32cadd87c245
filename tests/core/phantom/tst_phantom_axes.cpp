// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/image/voxels.h"
#include "core/phantom/phantom.h"
#include "core/phantom/shape.h"
#include "core/phantom/wall_truth.h"
#include "tests/core/bars.h"
#include "tests/core/phantom_case.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

/// Another size and spacing along each axis.
PhantomParams unevenParams(PhantomKind kind, const char* psf) {
  PhantomParams params = analytic::paramsOf(kind, 40, 4.0);
  params.size = {52, 34, 40};
  params.spacingMm = {0.8, 1.4, 1.1};
  params.axis = {0.4, -0.7, 1.0};
  params.offset = {0.3, -0.2, 0.1};
  params.psf = pointSpreadFromText(psf);
  return params;
}

/// What lies along axis a goes to axis a + turns.
Vector3d turned(const Vector3d& v, int turns) {
  Vector3d result;
  for (int a = 0; a < 3; ++a) result[(a + turns) % 3] = v[a];
  return result;
}

PhantomParams turned(PhantomParams params, int turns) {
  const Index3 size = params.size;
  for (int a = 0; a < 3; ++a)
    params.size[static_cast<std::size_t>((a + turns) % 3)] = size[static_cast<std::size_t>(a)];
  params.spacingMm = turned(params.spacingMm, turns);
  params.axis = turned(params.axis, turns);
  params.offset = turned(params.offset, turns);
  return params;
}

}  // namespace

class TestPhantomAxes : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The three axes of a grid are alike: what is made on a grid that is turned by a quarter is the
  /// image turned.
  void aTurnedGridHasTheTurnedImage_data() {
    QTest::addColumn<PhantomKind>("kind");
    QTest::addColumn<QByteArray>("psf");
    for (const PhantomKind kind : {PhantomKind::Tube, PhantomKind::Torus})
      for (const char* psf : {"gaussian:0", "gaussian:0.5", "gaussian:1.5", "mr:1.5", "subvoxels"})
        QTest::addRow("%s, %s", phantomKindNames()[static_cast<std::size_t>(kind)].c_str(), psf)
            << kind << QByteArray(psf);
  }
  void aTurnedGridHasTheTurnedImage() {
    QFETCH(PhantomKind, kind);
    QFETCH(QByteArray, psf);
    PhantomParams params = unevenParams(kind, psf.constData());
    params.fadePercent = kind == PhantomKind::Tube ? 60.0 : 100.0;
    const Phantom phantom = makePhantom(params);
    const Geometry& g = phantom.image.geometry;
    QVERIFY(*std::max_element(phantom.image.voxels.begin(), phantom.image.voxels.end()) > 200.0F);
    for (const int turns : {1, 2}) {
      const Phantom other = makePhantom(turned(params, turns));
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < phantom.image.voxels.size(); ++i) {
        const Index3 p = g.indexOf(i);
        Index3 q;
        for (std::size_t a = 0; a < 3; ++a) q[(a + static_cast<std::size_t>(turns)) % 3] = p[a];
        if (std::fabs(phantom.image.voxels[i] - other.image.at(q[0], q[1], q[2])) > 1.5F) ++wrong;
      }
      // Rounding may put a subvoxel or a cell at the wall on the other side.
      QVERIFY2(wrong < 10, QByteArray::number(static_cast<double>(wrong)));
    }
  }

  /// A blur leaves a body's sum and middle, and adds the same variance along each axis.
  void aBlurIsRoundInMillimetresAlongEachAxis() {
    for (const double sigma : {0.5, 1.0, 1.5})
      for (const int turns : {0, 1, 2}) {
        PhantomParams params = turned(unevenParams(PhantomKind::Torus, "gaussian"), turns);
        params.axis = {0.0, 0.0, 1.0};
        params.radius = 3.0;
        params.psf.sigma = sigma;
        const Phantom phantom = makePhantom(params);
        const Geometry& g = phantom.image.geometry;
        const double minor = 3.0 * 0.8, major = 0.25 * 52.0 * 0.8;
        double sum = 0.0;
        Vector3d first = Vector3d::Zero(), second = Vector3d::Zero();
        for (std::size_t i = 0; i < phantom.image.voxels.size(); ++i) {
          const auto value = static_cast<double>(phantom.image.voxels[i]);
          const Vector3d p = voxelCentre(g, i);
          sum += value;
          first += value * p;
          second += value * p.cwiseAbs2();
        }
        const double volume = 2.0 * M_PI * M_PI * major * minor * minor;
        QVERIFY(isNear(sum * g.voxelVolumeMm3() / (255.0 * volume), 1.0, 2e-3));
        const Vector3d middle = first / sum;
        const Vector3d size(g.size[0], g.size[1], g.size[2]);
        const Vector3d expected =
            0.5 * (size - Vector3d::Ones()).cwiseProduct(g.spacing) + 0.8 * params.offset;
        QVERIFY(isBelow((middle - expected).norm(), 0.005));
        const Vector3d variance = second / sum - middle.cwiseAbs2();
        for (int a = 0; a < 3; ++a) {
          const double own =
              a == 2 ? 0.25 * minor * minor : 0.5 * (major * major + 0.75 * minor * minor);
          const double blur = 0.64 * sigma * sigma + g.spacing[a] * g.spacing[a] / 12.0;
          QVERIFY(isNear((variance[a] - own) / blur, 1.0, 0.05));
        }
      }
  }

  void aTurnedGridHasTheTurnedWall() {
    const PhantomParams params = unevenParams(PhantomKind::Torus, "gaussian");
    const WallTruth truth(params);
    const Geometry g = phantomGeometry(params);
    const Vector3d extent = g.toPhysical(Vector3d(g.size[0] - 1, g.size[1] - 1, g.size[2] - 1));
    for (const int turns : {1, 2}) {
      const WallTruth other(turned(params, turns));
      int near = 0;
      for (int n = 0; n < 1728; ++n) {
        const Vector3d share(n % 12 / 11.0, n / 12 % 12 / 11.0, n / 144 / 11.0);
        const Vector3d point = extent.cwiseProduct(share);
        const WallFoot foot = truth.footOf(point);
        // Far off two feet may be as near.
        if (std::fabs(foot.signedDistanceMm) > 2.0) continue;
        ++near;
        const WallFoot there = other.footOf(turned(point, turns));
        QVERIFY(isNear(there.signedDistanceMm, foot.signedDistanceMm, 1e-6));
        QVERIFY(isBelow((there.point - turned(foot.point, turns)).norm(), 1e-4));
      }
      QVERIFY(near > 20);
    }
  }
};

QTEST_GUILESS_MAIN(TestPhantomAxes)
#include "tst_phantom_axes.moc"
