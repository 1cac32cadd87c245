// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/preprocess/curvature_flow.h"
#include "core/preprocess/preprocess.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

double variance(const Volume<float>& image) {
  double sum = 0.0;
  double square = 0.0;
  for (const float v : image.voxels) {
    sum += static_cast<double>(v);
    square += static_cast<double>(v) * static_cast<double>(v);
  }
  const auto n = static_cast<double>(image.voxels.size());
  return square / n - sum / n * (sum / n);
}

}  // namespace

class TestPreprocess : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cropKeepsTheVoxelsOfTheBoxInPlace() {
    const Geometry g = oblique(20, 18, 16);
    const auto image =
        sampled(g, [](const Eigen::Vector3d& x) { return x[0] + 10.0 * x[1] - 3.0 * x[2]; });
    const Eigen::Vector3d a = centreOf(g) - Eigen::Vector3d(1.5, 1.5, 1.5);
    const Eigen::Vector3d b = centreOf(g) + Eigen::Vector3d(1.5, 1.5, 1.5);
    // The corners may come in any order.
    const auto crop = cropToBox(image, {b[0], a[1], b[2], a[0], b[1], a[2]});
    QVERIFY(crop.voxels.size() < image.voxels.size());
    for (std::size_t i = 0; i < crop.voxels.size(); ++i) {
      const Index3 p = crop.geometry.indexOf(i);
      const Eigen::Vector3d x = voxelCentre(crop.geometry, p);
      QVERIFY(std::fabs(crop.voxels[i] - (x[0] + 10.0 * x[1] - 3.0 * x[2])) < 1e-3);
    }
    QVERIFY_THROWS_EXCEPTION(InputError, cropToBox(image, {900, 900, 900, 901, 901, 901}));
  }

  /// Whatever the box cuts off the rows of an oblique grid, every centre in it is kept, and no
  /// layer that holds none.
  void cropHoldsAllVoxelsOfTheBoxAndNoMore() {
    const Geometry g = oblique(20, 18, 16);
    const Volume<float> image(g, 1.0F);
    for (std::uint64_t n = 0; n < 60; ++n) {
      std::array<double, 6> box{};
      Eigen::Vector3d least, most;
      for (int a = 0; a < 3; ++a) {
        const auto at = static_cast<std::uint64_t>(a);
        const double half = 0.5 + 2.5 * randomUniform(3, 6 * n + at);
        const double middle = centreOf(g)[a] + 5.0 * (randomUniform(3, 6 * n + 3 + at) - 0.5);
        box[at] = least[a] = middle - half;
        box[at + 3] = most[a] = middle + half;
      }
      Index3 low = g.size, high{-1, -1, -1};
      for (std::size_t i = 0; i < image.voxels.size(); ++i) {
        const Eigen::Vector3d x = voxelCentre(g, i);
        if ((x.array() < least.array()).any() || (x.array() > most.array()).any()) continue;
        const Index3 p = g.indexOf(i);
        for (std::size_t a = 0; a < 3; ++a) {
          low[a] = std::min(low[a], p[a]);
          high[a] = std::max(high[a], p[a]);
        }
      }
      if (high[0] - low[0] < 1 || high[1] - low[1] < 1 || high[2] - low[2] < 1) {
        QVERIFY_THROWS_EXCEPTION(InputError, cropToBox(image, box));
        continue;
      }
      const Geometry cropped = cropToBox(image, box).geometry;
      for (std::size_t a = 0; a < 3; ++a) QCOMPARE(cropped.size[a], high[a] - low[a] + 1);
      QVERIFY((cropped.origin - voxelCentre(g, low)).norm() < 1e-9);
    }
  }

  void resamplingMakesCubicVoxelsAndKeepsTheField() {
    const Geometry g = oblique(24, 20, 12);
    QVERIFY(!wantsIsotropic(cube(5)));
    QVERIFY(wantsIsotropic(g));
    const auto field = [](const Eigen::Vector3d& x) { return 3.0 * x[0] - x[1] + 0.5 * x[2]; };
    const auto out = resampleIsotropic(sampled(g, field));
    QVERIFY(out.geometry.spacing.isApproxToConstant(0.4));
    QVERIFY((out.geometry.origin - g.origin).norm() < 1e-12);
    double worst = 0.0;
    for (std::size_t i = 0; i < out.voxels.size(); ++i) {
      const Index3 p = out.geometry.indexOf(i);
      worst = std::max(worst, std::fabs(out.voxels[i] - field(voxelCentre(out.geometry, p))));
    }
    QVERIFY(isBelow(worst, 1e-3));
  }

  void sigmoidKeepsRangeAndOrder() {
    Volume<float> image(cube(5));
    for (std::size_t i = 0; i < image.voxels.size(); ++i) image.voxels[i] = static_cast<float>(i);
    const auto out = sigmoid(image, 60.0, 62.0);
    QVERIFY(std::is_sorted(out.voxels.begin(), out.voxels.end()));
    QVERIFY(std::fabs(out.voxels[62] - 62.0F) <
            1e-3F);  // the level maps to the middle of the range
    QVERIFY(out.voxels.front() >= 0.0F && out.voxels.back() <= 124.0F);
    // At one window above the level 1 / (1 + e^-6) of the range is reached.
    QVERIFY(std::fabs(out.voxels[122] - 124.0 / (1.0 + std::exp(-6.0))) < 1e-2);
  }

  void curvatureFlowSmoothsNoiseAndKeepsAPlane() {
    Volume<float> noise(cube(16));
    for (std::size_t i = 0; i < noise.voxels.size(); ++i)
      noise.voxels[i] = static_cast<float>(randomNormal(2, i));
    PreprocessParams params;
    params.curvatureFlowEnabled = true;
    QVERIFY(variance(preprocess(noise, params)) < 0.7 * variance(noise));
    const auto plane =
        sampled(cube(12), [](const Eigen::Vector3d& x) { return 2.0 * x[0] + x[1]; });
    const auto out = preprocess(plane, params);
    QVERIFY(std::fabs(out.at(6, 6, 6) - plane.at(6, 6, 6)) < 1e-3F);
    const Progress progress;
    progress.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, preprocess(noise, params, progress));
  }

  /// Its step is in voxels: in mm, thin vessels of small voxels would go, and large ones stay
  /// noisy.
  void curvatureFlowDoesTheSameForVoxelsOfAnySize() {
    const auto vessel = [](double voxelMm) {
      Geometry g = cube(20);
      g.spacing.setConstant(voxelMm);
      return sampled(g, [&](const Eigen::Vector3d& x) {
        const double r = std::hypot(x[0] / voxelMm - 9.7, x[1] / voxelMm - 9.4);
        return 100.0 * std::exp(-r * r / 4.0);
      });
    };
    PreprocessParams params;
    params.curvatureFlowEnabled = true;
    const Volume<float> one = preprocess(vessel(1.0), params);
    QVERIFY(one.at(10, 9, 10) > 60.0F);
    for (const double voxelMm : {0.25, 0.3, 3.0}) {
      const Volume<float> other = preprocess(vessel(voxelMm), params);
      for (std::size_t i = 0; i < one.voxels.size(); ++i)
        QVERIFY(std::fabs(other.voxels[i] - one.voxels[i]) < 1e-2F);
    }
    // Thick slices keep their shape: along the vessel, in which nothing changes, nothing happens.
    Volume<float> thick = vessel(1.0);
    thick.geometry.spacing[2] = 3.0;
    const Volume<float> flown = preprocess(thick, params);
    QVERIFY(std::fabs(flown.at(10, 9, 10) - one.at(10, 9, 10)) < 1e-2F);
  }

  void unusableVolumesAreRefused() {
    Volume<float> image(cube(4), 1.0F);
    QVERIFY_THROWS_EXCEPTION(InputError, checkUsable(image, "x"));
    image.voxels[3] = 2.0F;
    checkUsable(image, "x");
    image.voxels[5] = std::nanf("");
    QVERIFY_THROWS_EXCEPTION(InputError, checkUsable(image, "x"));
    Geometry flat = cube(4);
    flat.size[2] = 1;
    QVERIFY_THROWS_EXCEPTION(InputError, checkUsable(Volume<float>(flat, 1.0F), "x"));
  }

  void componentsAreLabelledLargestFirst() {
    Volume<std::uint8_t> mask(cube(10));
    mask.at(1, 1, 1) = mask.at(2, 2, 2) = 1;  // touch at a corner
    for (int i = 5; i < 9; ++i) mask.at(i, 7, 7) = 1;
    const Components all = connectedComponents(mask);
    QCOMPARE(all.sizes, (std::vector<std::size_t>{4, 2}));
    QCOMPARE(all.labels.at(5, 7, 7), 1);
    QCOMPARE(all.labels.at(2, 2, 2), 2);
    QCOMPARE(connectedComponents(mask, false).sizes.size(), std::size_t{3});
  }

  void percentilesInterpolateBetweenRanks() {
    Geometry g = cube(1);
    g.size = {5, 1, 1};
    Volume<float> image(g);
    image.voxels = {40.0F, 0.0F, 10.0F, 30.0F, 20.0F};
    const auto p = percentiles(image, {0.0, 0.5, 0.625, 1.0});
    QVERIFY(p[0] == 0.0 && p[1] == 20.0 && std::fabs(p[2] - 25.0) < 1e-9 && p[3] == 40.0);
  }

  void percentilesAreThoseOfTheSortedVoxels_data() {
    QTest::addColumn<float>("scale");
    QTest::addColumn<bool>("whole");
    QTest::newRow("whole numbers") << 900.0F << true;
    QTest::newRow("around nought") << 1.0F << false;
    QTest::newRow("tiny") << 1e-41F << false;
    QTest::newRow("huge") << 3e38F << false;
  }
  void percentilesAreThoseOfTheSortedVoxels() {
    QFETCH(float, scale);
    QFETCH(bool, whole);
    Geometry g = cube(1);
    g.size = {211, 173, 67};  // some blocks, and the last of them not full
    Volume<float> image(g);
    std::mt19937 random(7);
    for (float& voxel : image.voxels) {
      voxel = (static_cast<float>(random() >> 8) / 8388608.0F - 1.0F) * scale;
      if (whole) voxel = std::round(voxel);
    }
    std::vector<double> sorted(image.voxels.begin(), image.voxels.end());
    std::sort(sorted.begin(), sorted.end());
    // In no order, some twice, and ranks side by side.
    const std::vector<double> fractions{0.998, 0.01, 0.5, 0.5, 0.0, 1.0, 0.123456, 0.5000001};
    const std::vector<double> found = percentiles(image, fractions);
    for (std::size_t n = 0; n < fractions.size(); ++n) {
      const double rank = fractions[n] * static_cast<double>(sorted.size() - 1);
      const auto low = static_cast<std::size_t>(rank);
      const double above = sorted[std::min(low + 1, sorted.size() - 1)];
      QCOMPARE(found[n], sorted[low] + (rank - std::floor(rank)) * (above - sorted[low]));
    }
    QCOMPARE(static_cast<double>(valueRange(image)[0]), sorted.front());
    QCOMPARE(static_cast<double>(valueRange(image)[1]), sorted.back());
  }

  void axesAreAlike_data() {
    QTest::addColumn<bool>("fewAlongLast");
    QTest::newRow("few slices") << true;
    QTest::newRow("many slices") << false;
  }
  void axesAreAlike() {
    QFETCH(bool, fewAlongLast);
    const Volume<float> image = unlikeVessels(fewAlongLast), other = turned(image);
    QVERIFY(mostApart(turned(curvatureFlow(image, 5, 0.0625)), curvatureFlow(other, 5, 0.0625)) <
            1e-5);
    QVERIFY(mostApart(turned(resampleIsotropic(image)), resampleIsotropic(other)) < 1e-5);
    const auto clampedImage = clampIntensities(image, -1.0, 0.5, 1);
    QVERIFY(mostApart(turned(clampedImage), clampIntensities(other, -1.0, 0.5, 1)) == 0.0);
    const Index3 low{3, 5, 2}, high{20, 31, 15};
    QVERIFY(mostApart(turned(cropped(image, {low, high})),
                      cropped(other, {turned(low), turned(high)})) < 1e-6);
    const auto parts = connectedComponents(insideMask(image)),
               partsOther = connectedComponents(insideMask(other));
    QVERIFY(mostApart(turned(parts.labels), partsOther.labels) == 0.0);
    QCOMPARE(shareOfBorder(insideMask(other)), shareOfBorder(insideMask(image)));
  }
};

QTEST_GUILESS_MAIN(TestPreprocess)
#include "tst_preprocess.moc"
