// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/levelset/comparison_methods.h"
#include "core/parameters/field.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "core/quality/overlap.h"
#include "tests/core/analytic.h"
#include "tests/core/threads.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

using Method = SegmentationMethod;

Phantom noisyTube(double noise) {
  PhantomParams params;
  params.psf.kind = PointSpread::Kind::Subvoxels;
  params.kind = PhantomKind::Tube;
  params.size = {40, 40, 40};
  params.radius = 5.0;
  params.noiseSigma = noise;
  params.axis = {0.0, 1.0, 2.0};
  return makePhantom(params);
}

Volume<float> turnedDark(const Volume<float>& image) {
  Volume<float> dark = image;
  for (float& value : dark.voxels) value = 300.0F - value;
  return dark;
}

std::vector<Eigen::Vector3d> middle(const Geometry& g) { return {centreOf(g)}; }

double overlapOf(const Volume<float>& phi, const Phantom& phantom) {
  return compareMasks(insideMask(phi), phantom.truth).overlap;
}

ComparisonResult segmented(const Volume<float>& image, Method method,
                           Polarity polarity = Polarity::Bright,
                           const ComparisonParams& params = {}) {
  return segmentByComparison(image, method, middle(image.geometry), 1.5, params, polarity);
}

}  // namespace

class TestComparisonMethods : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tubesAreFound_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<double>("noise");
    QTest::addColumn<bool>("dark");
    QTest::addColumn<double>("least");
    for (const bool dark : {false, true}) {
      const char* tone = dark ? ", dark" : ", bright";
      const auto row = [&](const char* name, Method method, double noise, double least) {
        QTest::addRow("%s, noise %g%s", name, noise, tone)
            << static_cast<int>(method) << noise << dark << least;
      };
      row("contour", Method::GeodesicActiveContour, 0.0, 95.0);
      row("contour", Method::GeodesicActiveContour, 20.0, 95.0);
      row("region", Method::ConfidenceConnected, 20.0, 92.0);
      row("threshold", Method::Threshold, 0.0, 99.0);
      row("threshold", Method::Threshold, 20.0, 98.0);
    }
  }

  void tubesAreFound() {
    QFETCH(const int, method);
    QFETCH(const double, noise);
    QFETCH(const bool, dark);
    QFETCH(const double, least);
    const Phantom phantom = noisyTube(noise);
    const ComparisonResult result =
        segmented(dark ? turnedDark(phantom.image) : phantom.image, static_cast<Method>(method),
                  dark ? Polarity::Dark : Polarity::Bright);
    const double overlap = overlapOf(result.phi, phantom);
    QVERIFY2(overlap >= least, qPrintable(QString::number(overlap)));
  }

  void theBoundsThatWereUsedAreTold() {
    const Phantom phantom = noisyTube(10.0);
    const ComparisonResult otsu = segmented(phantom.image, Method::Threshold);
    QVERIFY(otsu.lower && *otsu.lower > 60.0 && *otsu.lower < 195.0 && !otsu.upper);
    const ComparisonResult dark =
        segmented(turnedDark(phantom.image), Method::Threshold, Polarity::Dark);
    QVERIFY(dark.upper && !dark.lower);
    ComparisonParams params;
    params.thresholdLower = 100.0;
    params.thresholdUpper = 1000.0;
    const ComparisonResult given =
        segmented(phantom.image, Method::Threshold, Polarity::Bright, params);
    QCOMPARE(*given.lower, 100.0);
    QCOMPARE(*given.upper, 1000.0);
    const ComparisonResult region = segmented(phantom.image, Method::ConfidenceConnected);
    QVERIFY(*region.lower < 250.0 && *region.upper > 250.0);
    QVERIFY(!segmented(phantom.image, Method::GeodesicActiveContour).lower);
  }

  void aThresholdKeepsThePartsOfItsSeeds() {
    const Geometry g = cube(30);
    const Volume<float> two = sampled(g, [](const Eigen::Vector3d& x) {
      return std::min(ball(x, {8, 14.5, 14.5}, 4.0), ball(x, {22, 14.5, 14.5}, 4.0)) < 0.0 ? 200.0
                                                                                           : 0.0;
    });
    ComparisonParams params;
    params.thresholdSigmaVoxels = 0.0;
    const std::vector<Eigen::Vector3d> seeds{{8, 14, 14}};
    const auto parts = [&] {
      const ComparisonResult found =
          segmentByComparison(two, Method::Threshold, seeds, 1.0, params, Polarity::Bright);
      return connectedComponents(insideMask(found.phi)).sizes.size();
    };
    QCOMPARE(parts(), std::size_t{1});
    params.thresholdFromSeeds = false;
    QCOMPARE(parts(), std::size_t{2});
  }

  // A seed beside a part keeps it, on any side; one two voxels away does not.
  void seedsKeepThePartsBesideThem() {
    Volume<float> image(cube(9), 0.0F);
    image.at(4, 4, 4) = 200.0F;
    ComparisonParams params;
    params.thresholdSigmaVoxels = 0.0;
    params.thresholdLower = 100.0;
    const auto keeps = [&](double i, double j, double k) {
      try {
        const ComparisonResult found = segmentByComparison(
            image, Method::Threshold, {{4.0 + i, 4.0 + j, 4.0 + k}}, 1.0, params, Polarity::Bright);
        return found.phi.at(4, 4, 4) < 0.0F;
      } catch (const NumericError&) {
        return false;
      }
    };
    for (int n = 0; n < 27; ++n) QVERIFY(keeps(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
    for (const double far : {-2.0, 2.0})
      QVERIFY(!keeps(far, 0.0, 0.0) && !keeps(0.0, far, 0.0) && !keeps(0.0, 0.0, far));
  }

  void theThreadsDoNotMatter() {
    const Phantom phantom = noisyTube(30.0);
    for (const Method method :
         {Method::GeodesicActiveContour, Method::ConfidenceConnected, Method::Threshold}) {
      const auto [one, three] =
          onOneAndSeveralThreads([&] { return segmented(phantom.image, method); }, 3);
      setThreads(0);
      QVERIFY(one.phi.voxels == three.phi.voxels);
    }
  }

  void badInputIsRefused() {
    const Phantom phantom = noisyTube(10.0);
    const Volume<float>& image = phantom.image;
    for (const Method method :
         {Method::GeodesicActiveContour, Method::ConfidenceConnected, Method::Threshold}) {
      QVERIFY_THROWS_EXCEPTION(InputError,
                               segmentByComparison(image, method, {}, 1.0, {}, Polarity::Bright));
      const Progress cancelled;
      cancelled.cancel();
      QVERIFY_THROWS_EXCEPTION(Cancelled,
                               segmentByComparison(image, method, middle(image.geometry), 1.0, {},
                                                   Polarity::Bright, {}, cancelled));
    }
    QVERIFY_THROWS_EXCEPTION(InputError, segmented(image, Method::LevelSet));
    ComparisonParams params;
    params.thresholdLower = 1e5;
    QVERIFY_THROWS_EXCEPTION(NumericError,
                             segmented(image, Method::Threshold, Polarity::Bright, params));
    params.thresholdLower = -1e5;
    QVERIFY_THROWS_EXCEPTION(NumericError,
                             segmented(image, Method::Threshold, Polarity::Bright, params));
    Parameters all;
    QVERIFY_THROWS_EXCEPTION(InputError, setFieldFromText(all, "segmentation.method", "snake"));
    all.comparison.thresholdLower = 2.0;
    all.comparison.thresholdUpper = 1.0;
    QVERIFY_THROWS_EXCEPTION(InputError, validate(all));
  }

  void aContourCanBeStopped() {
    const Phantom phantom = noisyTube(10.0);
    int asked = 0;
    const auto stop = [&asked] { return ++asked >= 7; };
    const ComparisonResult result =
        segmentByComparison(phantom.image, Method::GeodesicActiveContour,
                            middle(phantom.image.geometry), 1.5, {}, Polarity::Bright, stop);
    QCOMPARE(result.iterations, 7);
    QCOMPARE(result.stopReason, StopReason::Stopped);
  }

  void thePipelineRunsThem() {
    const Phantom phantom = noisyTube(10.0);
    Pipeline pipeline(makeSource(phantom.image, "tube"));
    Parameters params;
    params.vesselness.sigmaMaxMm = 5.0;
    const std::string ours = pipeline.key(Step::Evolve, params);
    RunOptions options;
    options.until = Step::Evolve;
    for (const Method method :
         {Method::GeodesicActiveContour, Method::ConfidenceConnected, Method::Threshold}) {
      params.segmentation.method = method;
      QVERIFY(pipeline.key(Step::Evolve, params) != ours);
      const RunResult run = pipeline.run(params, options);
      QVERIFY(overlapOf(*run.evolve->phi, phantom) > 90.0);
      const auto range = valueRange(*run.evolve->phi);
      QVERIFY(range[0] >= -5.0F && range[0] < -3.5F);
      QCOMPARE(range[1], 5.0F);
    }
  }
};

QTEST_GUILESS_MAIN(TestComparisonMethods)
#include "tst_comparison_methods.moc"
