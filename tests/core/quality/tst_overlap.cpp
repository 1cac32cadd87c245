// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/quality/best_threshold.h"
#include "core/quality/overlap.h"
#include "tests/core/analytic.h"
#include "tests/core/threads.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

Geometry gridOf(const Index3& size, const Vector3d& spacing = Vector3d::Ones()) {
  Geometry g;
  g.size = size;
  g.spacing = spacing;
  return g;
}

/// A grid that is anisotropic, rotated and away from the origin.
Geometry obliqueGrid() {
  Geometry g = gridOf({30, 26, 22}, {0.5, 0.8, 1.2});
  g.origin = {-40.0, 13.0, 7.0};
  g.direction = (Eigen::AngleAxisd(0.5, Vector3d(1, 2, 3).normalized())).toRotationMatrix();
  return g;
}

Volume<std::uint8_t> boxMask(const Geometry& g, const Index3& first, const Index3& last) {
  Volume<std::uint8_t> mask(g);
  for (int k = first[2]; k < last[2]; ++k)
    for (int j = first[1]; j < last[1]; ++j)
      for (int i = first[0]; i < last[0]; ++i) mask.at(i, j, k) = 1;
  return mask;
}

Volume<float> ballField(const Geometry& g, const Vector3d& centreLps, double radius) {
  return analytic::sampled(g,
                           [&](const Vector3d& x) { return analytic::ball(x, centreLps, radius); });
}

bool near(double a, double b, double tolerance = 1e-9) { return std::fabs(a - b) < tolerance; }

}  // namespace

class TestOverlap : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { setThreads(0); }

  void equalMasksAgreeFully() {
    const auto mask = boxMask(obliqueGrid(), {5, 6, 7}, {15, 16, 12});
    const OverlapMeasures m = compareMasks(mask, mask);
    QVERIFY(near(m.overlap, 100.0) && near(m.sensitivity, 1.0) && near(m.precision, 1.0));
    QVERIFY(near(m.assdMm, 0.0) && near(m.hd95Mm, 0.0));
  }

  void aBoxShiftedByTwoVoxels() {
    const Geometry g = obliqueGrid();
    const auto truth = boxMask(g, {5, 5, 5}, {15, 15, 15});
    const auto result = boxMask(g, {7, 5, 5}, {17, 15, 15});
    const OverlapMeasures m = compareMasks(result, truth);
    QVERIFY(near(m.overlap, 80.0));
    QVERIFY(near(m.sensitivity, 0.8));
    QVERIFY(near(m.precision, 0.8));
    QVERIFY(near(m.hd95Mm, 1.0));  // two voxels of 0.5 mm
  }

  void sensitivityAndPrecisionAreNotMixedUp() {
    const Geometry g = gridOf({20, 20, 20});
    const OverlapMeasures m =
        compareMasks(boxMask(g, {5, 5, 5}, {15, 15, 15}), boxMask(g, {5, 5, 5}, {15, 15, 10}));
    QVERIFY(near(m.sensitivity, 1.0));
    QVERIFY(near(m.precision, 0.5));
    QVERIFY(near(m.overlap, 100.0 * 2.0 / 3.0));
  }

  void parallelSheetsAreTheirDistanceApart() {
    // Sheets one voxel thick across the volume: every distance is 7 slices of 1.2 mm.
    const Geometry g = obliqueGrid();
    const OverlapMeasures m =
        compareMasks(boxMask(g, {0, 0, 4}, {30, 26, 5}), boxMask(g, {0, 0, 11}, {30, 26, 12}));
    QVERIFY(near(m.overlap, 0.0));
    QVERIFY(near(m.assdMm, 7 * 1.2, 1e-6));
    QVERIFY(near(m.hd95Mm, 7 * 1.2, 1e-6));
  }

  void theBorderOfTheVolumeIsNoSurface() {
    // Half spaces have one flat surface each, though they touch five faces of the volume.
    const Geometry g = gridOf({16, 16, 16}, {1.0, 1.0, 0.5});
    const OverlapMeasures m =
        compareMasks(boxMask(g, {0, 0, 0}, {16, 16, 6}), boxMask(g, {0, 0, 0}, {16, 16, 9}));
    QVERIFY(near(m.assdMm, 1.5));
    QVERIFY(near(m.hd95Mm, 1.5));
  }

  void fewOutliersDoNotCountInThe95thPercentile() {
    const Geometry g = gridOf({40, 40, 40});
    const auto truth = boxMask(g, {5, 5, 5}, {15, 15, 15});
    auto result = truth;
    result.at(38, 38, 38) = 1;
    const OverlapMeasures m = compareMasks(result, truth);
    QVERIFY(near(m.hd95Mm, 0.0));
    const double outlier = std::sqrt(3.0) * 24.0;
    const double surface = 1000.0 - 512.0;
    QVERIFY(near(m.assdMm, outlier / (2.0 * surface + 1.0)));
  }

  void ballsOfDifferentRadii() {
    const Geometry g = gridOf({64, 64, 64}, {0.5, 0.5, 0.5});
    const Vector3d centre(15.8, 15.9, 16.1);
    const OverlapMeasures m = compareMasks(insideMask(ballField(g, centre, 12.0)),
                                           insideMask(ballField(g, centre, 10.0)));
    const double ratio = std::pow(10.0 / 12.0, 3);
    QVERIFY(near(m.sensitivity, 1.0));
    QVERIFY(near(m.precision, ratio, 0.005));
    QVERIFY(near(m.overlap, 100.0 * 2.0 * ratio / (1.0 + ratio), 0.3));
    QVERIFY(near(m.assdMm, 2.0, 0.1));
    QVERIFY(near(m.hd95Mm, 2.0, 0.4));
  }

  void emptyResultIsNotAnError() {
    const Geometry g = gridOf({8, 8, 8});
    const OverlapMeasures m =
        compareMasks(Volume<std::uint8_t>(g), boxMask(g, {2, 2, 2}, {5, 5, 5}));
    QVERIFY(near(m.overlap, 0.0) && near(m.sensitivity, 0.0) && near(m.precision, 0.0));
    QVERIFY(std::isnan(m.assdMm) && std::isnan(m.hd95Mm));
  }

  void ratiosAreSharesOfAllVoxels() {
    const Geometry g = gridOf({10, 10, 10});
    const VoxelRatios r =
        voxelRatios(boxMask(g, {0, 0, 0}, {10, 10, 3}), boxMask(g, {0, 0, 1}, {10, 10, 5}));
    QVERIFY(near(r.truePositive, 20.0) && near(r.falsePositive, 10.0));
    QVERIFY(near(r.trueNegative, 50.0) && near(r.falseNegative, 20.0));
    QVERIFY(near(r.overlap, 100.0 * 4.0 / 7.0));
  }

  void badInputIsRefused() {
    const Geometry g = gridOf({8, 8, 8});
    const auto box = boxMask(g, {2, 2, 2}, {5, 5, 5});
    QVERIFY_THROWS_EXCEPTION(InputError, compareMasks(box, Volume<std::uint8_t>(g)));
    const Volume<std::uint8_t> other(gridOf({8, 8, 9}), 1);
    QVERIFY_THROWS_EXCEPTION(InputError, compareMasks(box, other));
  }

  void measuresDoNotDependOnTheThreads() {
    const Geometry g = obliqueGrid();
    const Vector3d centre = g.toPhysical({15.0, 12.0, 11.0});
    const auto a = insideMask(ballField(g, centre, 6.0));
    const auto b = insideMask(ballField(g, centre + Vector3d(1.3, 0.4, -0.2), 5.0));
    const auto [one, two] = onOneAndSeveralThreads([&] { return compareMasks(a, b); });
    QCOMPARE(one.assdMm, two.assdMm);
    QCOMPARE(one.hd95Mm, two.hd95Mm);
  }

  void alignedGridsReproduceTheSignOfPhi() {
    const Geometry g = obliqueGrid();
    Volume<float> phi(g);
    for (std::size_t i = 0; i < phi.voxels.size(); ++i)
      phi.voxels[i] = static_cast<float>(static_cast<int>(i * 2654435761U % 7U) - 3) * 1e-30F;
    QVERIFY(maskOnGrid(phi, g).voxels == insideMask(phi).voxels);

    Geometry crop = g;  // starts at voxel (4, 3, 2) and is 5 voxels larger at the far end
    crop.origin = g.toPhysical({4.0, 3.0, 2.0}) + Vector3d::Constant(1e-6);
    crop.size = {31, 28, 25};
    const auto mask = maskOnGrid(phi, crop);
    for (int k = 0; k < crop.size[2]; ++k)
      for (int j = 0; j < crop.size[1]; ++j)
        for (int i = 0; i < crop.size[0]; ++i) {
          const bool inside = g.contains(i + 4, j + 3, k + 2) && phi.at(i + 4, j + 3, k + 2) < 0.0F;
          QCOMPARE(mask.at(i, j, k), static_cast<std::uint8_t>(inside ? 1 : 0));
        }
  }

  void noThresholdOfAnyGaussianIsBetterThanTheBestOne() {
    const Geometry g = gridOf({40, 40, 40});
    const Volume<float> phi = ballField(g, Vector3d(19.0, 20.0, 20.5), 9.0);
    const Volume<std::uint8_t> truth = insideMask(phi);
    Volume<float> image(g);
    for (std::size_t i = 0; i < image.voxels.size(); ++i)
      image.voxels[i] = truth.voxels[i] != 0 ? 80.0F : -20.0F;
    const BestThreshold clean = bestThreshold(image, truth);
    QCOMPARE(clean.overlap, 100.0);
    QCOMPARE(clean.sigmaVoxels, 0.0);
    QVERIFY(clean.threshold > -20.0 && clean.threshold <= 80.0);

    for (std::size_t i = 0; i < image.voxels.size(); ++i)
      image.voxels[i] += 40.0F * static_cast<float>(randomNormal(7, i));
    const auto overlapAbove = [&](double threshold) {
      Volume<std::uint8_t> mask(g);
      for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        mask.voxels[i] = image.voxels[i] > static_cast<float>(threshold) ? 1 : 0;
      return compareMasks(mask, truth).overlap;
    };
    const BestThreshold noisy = bestThreshold(image, truth);
    QVERIFY(noisy.sigmaVoxels > 0.0);
    for (double threshold = -60.0; threshold <= 120.0; threshold += 10.0)
      QVERIFY(overlapAbove(threshold) < noisy.overlap - 5.0);
    QVERIFY(noisy.overlap < 100.0);
    // In other units of brightness it is the same one, and half-way between dark and bright.
    QVERIFY(std::fabs(noisy.threshold - 30.0) < 10.0);
    for (float& value : image.voxels) value = 2.0F * value + 1000.0F;
    const BestThreshold other = bestThreshold(image, truth);
    QCOMPARE(other.sigmaVoxels, noisy.sigmaVoxels);
    QVERIFY(std::fabs(other.threshold - (2.0 * noisy.threshold + 1000.0)) < 0.5);
  }

  void aBallIsFoundOnAnotherGrid() {
    const Geometry fine = gridOf({60, 60, 60}, {0.4, 0.4, 0.4});
    const Vector3d centre(12.0, 11.5, 12.2);
    const Volume<float> phi = ballField(fine, centre, 7.0);
    Geometry grid = obliqueGrid();
    grid.origin = centre - grid.direction * grid.spacing.cwiseProduct(Vector3d(15, 13, 11));
    const auto mask = maskOnGrid(phi, grid);
    for (std::size_t n = 0; n < mask.voxels.size(); ++n) {
      const Index3 at = grid.indexOf(n);
      const double d = (grid.toPhysical(Vector3d(at[0], at[1], at[2])) - centre).norm() - 7.0;
      if (std::fabs(d) > 0.01) QCOMPARE(mask.voxels[n], static_cast<std::uint8_t>(d < 0.0 ? 1 : 0));
    }
  }
};

QTEST_GUILESS_MAIN(TestOverlap)
#include "tst_overlap.moc"
