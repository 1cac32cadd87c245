// SPDX-License-Identifier: BSD-3-Clause
#include "core/distance/mask_distance.h"

#include <Eigen/Geometry>

#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/quality/zero_set_measure.h"
#include "tests/core/bars.h"
#include "tests/core/phantom_case.h"
#include "tests/core/threads.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

bool sameSide(const Volume<float>& phi, const Volume<std::uint8_t>& mask) {
  for (std::size_t i = 0; i < phi.voxels.size(); ++i)
    if ((phi.voxels[i] < 0.0F) != (mask.voxels[i] != 0)) return false;
  return true;
}

double zeroSetVolume(const Volume<float>& phi) {
  return measureZeroSet(SplineField(phi, SplineKind::InterpolatingBspline)).volumeMm3;
}

PhantomParams oblique(PhantomParams params) {
  params.axis = {1.0, 2.0, 3.0};
  params.offset = {0.3, 0.2, 0.0};
  return params;
}

}  // namespace

class TestMaskDistance : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void phantomsKeepTheirVolume_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("radius");
    QTest::addColumn<bool>("tilted");
    QTest::addColumn<double>("spacingZ");
    const auto row = [](const char* name, PhantomKind kind, double radius, bool tilted,
                        double spacingZ = 1.0) {
      QTest::newRow(name) << static_cast<int>(kind) << radius << tilted << spacingZ;
    };
    row("tube 1.5", PhantomKind::Tube, 1.5, false);
    row("tube 1.5 oblique", PhantomKind::Tube, 1.5, true);
    row("tube 2", PhantomKind::Tube, 2.0, true);
    row("tube 3", PhantomKind::Tube, 3.0, true);
    row("tube 5", PhantomKind::Tube, 5.0, true);
    row("tube 3, thick slices", PhantomKind::Tube, 3.0, true, 2.5);
    row("torus", PhantomKind::Torus, 3.0, true);
    row("kissing", PhantomKind::Kissing, 3.0, false);
    row("capsule tree", PhantomKind::CapsuleTree, 3.0, false);
    row("tree", PhantomKind::Tree, 3.0, false);
  }
  void phantomsKeepTheirVolume() {
    QFETCH(int, kind);
    QFETCH(double, radius);
    QFETCH(bool, tilted);
    QFETCH(double, spacingZ);
    PhantomParams params = paramsOf(static_cast<PhantomKind>(kind), 64, radius);
    if (tilted) params = oblique(params);
    params.spacingMm = {1.0, 1.0, spacingZ};
    const Phantom phantom = makePhantom(params);
    const MaskDistance made = distanceOfMask(phantom.truth);
    const double volume = zeroSetVolume(made.phi);
    QVERIFY(sameSide(made.phi, phantom.truth));
    QVERIFY(made.largestShiftVoxels < 0.5);
    QVERIFY(isNear(volume / made.maskVolumeMm3, 1.0, 0.01));
  }

  void stairsAreSmoothed() {
    // On the grid's edges the stairs of a mask miss the true wall by 0.29 voxel (uniform, +-1/2).
    const PhantomParams params = oblique(paramsOf(PhantomKind::Tube, 48, 5.0));
    const auto wall = phantomDistance(params);
    const Volume<float> phi = distanceOfMask(makePhantom(params).truth).phi;
    const Geometry& g = phi.geometry;
    double sum = 0.0, count = 0.0;
    for (int k = 4; k < 44; ++k)
      for (int j = 4; j < 44; ++j)
        for (int i = 4; i < 44; ++i) {
          const double u = static_cast<double>(phi.at(i, j, k));
          const double v = static_cast<double>(phi.at(i + 1, j, k));
          if ((u < 0.0) == (v < 0.0)) continue;
          const double d = wall(g.toPhysical(Eigen::Vector3d(i + u / (u - v), j, k)));
          sum += d * d;
          count += 1.0;
        }
    QVERIFY(isBelow(std::sqrt(sum / count), 0.12));
  }

  void thinLinesStay() {
    // Straight along an axis, across faces and across corners; one single voxel.
    Geometry g;
    g.size = {40, 40, 40};
    g.spacing = {0.5, 0.5, 1.5};
    Volume<std::uint8_t> mask(g);
    for (int n = 5; n < 35; ++n) {
      mask.at(n, 5, 5) = 1;
      mask.at(n, n, 30) = 1;
      mask.at(n, 40 - n, n) = 1;
    }
    mask.at(20, 10, 8) = 7;
    const MaskDistance made = distanceOfMask(mask);
    QVERIFY(sameSide(made.phi, mask));
    QVERIFY(std::fabs(zeroSetVolume(made.phi) / made.maskVolumeMm3 - 1.0) < 0.1);
    // Half-way between two voxels of a line across faces the wall has not closed.
    const SplineField field(made.phi, SplineKind::InterpolatingBspline);
    for (int n = 8; n < 32; ++n) QVERIFY(field.atIndex({n + 0.5, n + 0.5, 30.0}).value < 0.0);
  }

  void vesselsReachTheBorder() {
    const PhantomParams params = oblique(paramsOf(PhantomKind::Tube, 32, 3.0));
    const Phantom phantom = makePhantom(params);
    const Volume<float> phi = distanceOfMask(phantom.truth).phi;
    const Geometry& g = phi.geometry;
    const auto wall = phantomDistance(params);
    int inside = 0;
    for (int j = 0; j < 32; ++j)
      for (int i = 0; i < 32; ++i) {
        if (phantom.truth.at(i, j, 0) == 0) continue;
        ++inside;
        // No flare and no narrowing: the distance is right in the outermost layer too.
        const double d = wall(g.toPhysical(Eigen::Vector3d(i, j, 0)));
        QVERIFY(std::fabs(static_cast<double>(phi.at(i, j, 0)) - d) < 0.6);
      }
    QVERIFY(inside > 20);
  }

  void resultIsADistanceInMm() {
    PhantomParams params = oblique(paramsOf(PhantomKind::Tube, 48, 5.0));
    params.spacingMm = {0.4, 0.4, 0.4};
    const Volume<float> phi = distanceOfMask(makePhantom(params).truth).phi;
    const auto wall = phantomDistance(params);
    const Geometry& g = phi.geometry;
    for (int k = 6; k < 42; k += 3)
      for (int j = 6; j < 42; j += 3)
        for (int i = 6; i < 42; i += 3) {
          const double d = wall(g.toPhysical(Eigen::Vector3d(i, j, k)));
          if (std::fabs(d) < 1.6)
            QVERIFY(std::fabs(static_cast<double>(phi.at(i, j, k)) - d) < 0.2);
        }
    const auto range = valueRange(phi);
    QVERIFY(range[1] <= 2.0F && range[0] >= -2.01F);
  }

  void theGridsPlaceInSpaceDoesNotMatter() {
    const Phantom phantom = makePhantom(oblique(paramsOf(PhantomKind::Tube, 32, 3.0)));
    Volume<std::uint8_t> moved = phantom.truth;
    moved.geometry.origin = {5.0, -70.0, 12.0};
    moved.geometry.direction =
        Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    moved.geometry.direction.col(0) *= -1.0;
    QCOMPARE(distanceOfMask(moved).phi.voxels, distanceOfMask(phantom.truth).phi.voxels);
  }

  void threadsDoNotMatter() {
    const Phantom phantom = makePhantom(paramsOf(PhantomKind::CapsuleTree, 48, 3.0));
    const auto [one, three] =
        onOneAndSeveralThreads([&] { return distanceOfMask(phantom.truth).phi; }, 3);
    setThreads(0);
    QCOMPARE(one.voxels, three.voxels);
  }

  void emptyAndFullMasksAreRefused() {
    Geometry g;
    g.size = {8, 8, 8};
    QVERIFY_THROWS_EXCEPTION(InputError, distanceOfMask(Volume<std::uint8_t>(g)).phi);
    QVERIFY_THROWS_EXCEPTION(InputError, distanceOfMask(Volume<std::uint8_t>(g, 1)).phi);
    const Phantom phantom = makePhantom(paramsOf(PhantomKind::Tube, 32, 3.0));
    const Progress progress;
    progress.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, distanceOfMask(phantom.truth, progress).phi);
  }

  void axesAreAlike() {
    for (const bool fewAlongLast : {true, false}) {
      const Volume<std::uint8_t> mask = insideMask(unlikeVessels(fewAlongLast));
      const MaskDistance one = distanceOfMask(mask), other = distanceOfMask(turned(mask));
      const double most = mostApart(turned(one.phi), other.phi);
      QVERIFY2(most < 0.01, qPrintable(QString::number(most)));
      QVERIFY(std::fabs(one.maskVolumeMm3 - other.maskVolumeMm3) < 1e-9);
    }
  }
};

QTEST_APPLESS_MAIN(TestMaskDistance)
#include "tst_mask_distance.moc"
