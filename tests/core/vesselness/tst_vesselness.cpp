// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/phantom/phantom.h"
#include "core/vesselness/gauss_kernel.h"
#include "core/vesselness/hessian_slices.h"
#include "core/vesselness/row_kernels.h"
#include "core/vesselness/speed.h"
#include "core/vesselness/thickest.h"
#include "core/vesselness/vesselness.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

Volume<float> brightTube(const Geometry& g, const Eigen::Vector3d& axis, double radius) {
  // A Gaussian profile of the tube's width: smooth, so that sampling does not matter.
  return sampled(g, [&](const Eigen::Vector3d& x) {
    const double d = tube(x, centreOf(g), axis.normalized(), 0.0);
    return 100.0 * std::exp(-0.5 * d * d / (radius * radius));
  });
}

Volume<float> noisyCube() {
  Volume<float> image(cube(24));
  for (std::size_t i = 0; i < image.voxels.size(); ++i)
    image.voxels[i] = static_cast<float>(randomNormal(5, i) * 20.0 + (i % 97 == 0 ? 200.0 : 0.0));
  return image;
}

std::array<Volume<float>, 6> scaledHessian(const Volume<float>& image, double sigmaMm) {
  std::array<Volume<float>, 6> out;
  for (auto& component : out) component = Volume<float>(image.geometry);
  const std::size_t slice = image.geometry.offset(0, 0, 1);
  forEachHessianSlice(
      image, sigmaMm,
      [&](int k, const HessianSlice& h) {
        for (std::size_t c = 0; c < 6; ++c)
          std::copy_n(h[c], slice, out[c].voxels.begin() + static_cast<std::ptrdiff_t>(slice) * k);
      },
      {});
  return out;
}

}  // namespace

class TestVesselness : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void kernelHasUnitSumAndTheGivenVariance() {
    for (const double variance : {0.25, 1.0, 4.0, 16.0, 36.0}) {
      const std::vector<float> half = discreteGaussian(variance, 1e-6);
      double sum = half[0];
      double second = 0.0;
      for (std::size_t n = 1; n < half.size(); ++n) {
        sum += 2.0 * half[n];
        second += 2.0 * half[n] * static_cast<double>(n * n);
      }
      QVERIFY(std::fabs(sum - 1.0) < 1e-5);
      QVERIFY(std::fabs(second / variance - 1.0) < 1e-3);
    }
    QVERIFY(discreteGaussian(1e4).size() <= 31);
  }

  void eigenvaluesAgreeWithAReferenceSolver() {
    for (std::uint64_t n = 0; n < 2000; ++n) {
      std::array<double, 6> h{};
      for (std::uint64_t c = 0; c < 6; ++c) h[c] = randomNormal(11, 6 * n + c);
      if (n % 5 == 0) h[3] = h[4] = h[5] = 0.0;
      if (n % 7 == 0) h[1] = h[0];
      Eigen::Matrix3d m;
      m << h[0], h[3], h[4], h[3], h[1], h[5], h[4], h[5], h[2];
      const Eigen::Vector3d expected =
          Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m).eigenvalues();
      std::array<double, 3> l = symmetricEigenvalues(h);
      QVERIFY(std::fabs(l[0]) <= std::fabs(l[1]) && std::fabs(l[1]) <= std::fabs(l[2]));
      std::sort(l.begin(), l.end());
      for (int a = 0; a < 3; ++a)
        QVERIFY(std::fabs(l[static_cast<std::size_t>(a)] - expected[a]) < 1e-6);
    }
  }

  /// The Hessian of a sampled Gaussian blob is the closed form of the differenced wider blob.
  void hessianOfABlobIsTheDifferencedWiderBlob() {
    const Geometry g = oblique(41, 37, 25);
    const double blob = 1.8;
    const double sigma = 1.2;
    const Eigen::Vector3d c = centreOf(g);
    const auto image = sampled(g, [&](const Eigen::Vector3d& x) {
      return 1000.0 * std::exp(-0.5 * (x - c).squaredNorm() / (blob * blob));
    });
    const double wide = std::sqrt(blob * blob + sigma * sigma);
    const auto smooth = [&](const Eigen::Vector3d& d) {
      return 1000.0 * std::pow(blob / wide, 3) * std::exp(-0.5 * d.squaredNorm() / (wide * wide));
    };
    const auto hessian = scaledHessian(image, sigma);
    // As the differences do, S between voxels is interpolated linearly.
    const auto between = [&](const Eigen::Vector3d& d) {
      const Eigen::Vector3d index = d.cwiseQuotient(g.spacing);
      double sum = 0.0;
      for (int corner = 0; corner < 8; ++corner) {
        Eigen::Vector3d at;
        double weight = 1.0;
        for (int a = 0; a < 3; ++a) {
          const double low = std::floor(index[a] + 1e-12);
          const double t = index[a] - low;
          at[a] = low + (corner >> a & 1);
          weight *= (corner >> a & 1) != 0 ? t : 1.0 - t;
        }
        sum += weight * smooth(g.spacing.cwiseProduct(at));
      }
      return sum;
    };
    const int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    double worst = 0.0;
    double largest = 0.0;
    for (const Index3& p :
         {Index3{20, 18, 12}, Index3{23, 18, 12}, Index3{22, 20, 13}, Index3{17, 21, 11}}) {
      const Eigen::Vector3d d =
          g.spacing.cwiseProduct(Eigen::Vector3d(p[0] - 20.0, p[1] - 18.0, p[2] - 12.0));
      for (int component = 0; component < 6; ++component) {
        const Eigen::Vector3d a = sigma * Eigen::Vector3d::Unit(pairs[component][0]);
        const Eigen::Vector3d b = sigma * Eigen::Vector3d::Unit(pairs[component][1]);
        const double expected = component < 3 ? between(d + a) - 2.0 * between(d) + between(d - a)
                                              : 0.25 * (between(d + a + b) - between(d + a - b) -
                                                        between(d - a + b) + between(d - a - b));
        const double got =
            static_cast<double>(hessian[static_cast<std::size_t>(component)].at(p[0], p[1], p[2]));
        worst = std::max(worst, std::fabs(got - expected));
        largest = std::max(largest, std::fabs(expected));
      }
    }
    // The kernel leaves out up to 1 % of its tails, and with them some of its variance.
    QVERIFY2(worst < 0.06 * largest, qPrintable(QString("%1 of %2").arg(worst).arg(largest)));
  }

  void anIdealTubePeaksOnItsAxisAtSigmaEqualsItsRadius() {
    const Geometry g = cube(41);
    for (const Eigen::Vector3d& axis :
         {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(1, 2, 3)}) {
      const double radius = 3.0;
      const auto image = sampled(g, [&](const Eigen::Vector3d& x) {
        return tube(x, centreOf(g), axis.normalized(), radius) < 0.0 ? 100.0 : 0.0;
      });
      VesselnessParams params;
      double best = 0.0;
      double bestSigma = 0.0;
      for (const double sigma : {1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0}) {
        const auto v = vesselnessAtScale(image, sigma, params, 25.0);
        const float centre = v.at(20, 20, 20);
        if (sigma == radius)
          for (int i = 14; i <= 26; ++i) QVERIFY(v.at(i, 20, 20) <= centre + 1e-5F);
        if (static_cast<double>(centre) > best) {
          best = static_cast<double>(centre);
          bestSigma = sigma;
        }
      }
      QVERIFY2(bestSigma >= 2.0 && bestSigma <= 3.5, qPrintable(QString::number(bestSigma)));
      QVERIFY(best > 0.3);
    }
  }

  void polarityAndMeasureDoWhatTheySay() {
    const Geometry g = cube(31);
    auto image = brightTube(g, {0, 0, 1}, 2.0);
    VesselnessParams params;
    params.sigmaMaxMm = 3.0;
    params.cFraction = 0.25;
    const auto bright = vesselness(image, params);
    QVERIFY(bright.at(15, 15, 15) > 0.5F);
    const auto lowest = std::min_element(bright.voxels.begin(), bright.voxels.end());
    QVERIFY(*lowest < -0.01F);
    params.measure = VesselMeasure::Frangi;
    const auto frangi = vesselness(image, params);
    QVERIFY(*std::min_element(frangi.voxels.begin(), frangi.voxels.end()) >= 0.0F);
    params.measure = VesselMeasure::Modified;
    for (float& value : image.voxels) value = 50.0F - value;
    params.polarity = Polarity::Dark;
    const auto dark = vesselness(image, params);
    for (std::size_t i = 0; i < dark.voxels.size(); ++i)
      QVERIFY(std::fabs(dark.voxels[i] - bright.voxels[i]) < 2e-3F);
  }

  void rotatingTheGridRotatesTheResult() {
    const Volume<float> image = noisyCube();
    Volume<float> turned(image.geometry);
    const int n = image.geometry.size[0];
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) turned.at(j, k, i) = image.at(i, j, k);
    VesselnessParams params;
    params.sigmaMaxMm = 3.0;
    const auto a = vesselness(image, params);
    const auto b = vesselness(turned, params);
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) QVERIFY(std::fabs(a.at(i, j, k) - b.at(j, k, i)) < 2e-4F);
  }

  void sameBitsForAnyNumberOfThreads() {
    const Volume<float> image = noisyCube();
    setThreads(1);
    const auto one = vesselness(image, {});
    setThreads(2);
    QVERIFY(one.voxels == vesselness(image, {}).voxels);
  }

  void scalesFollowTheEquations() {
    const Geometry g = cube(8);
    VesselnessParams params;
    auto scales = scalesMm(params, g);
    QCOMPARE(scales.size(), std::size_t{6});  // ceil(log_1.5 6) + 1
    QVERIFY(std::fabs(scales.front() - 1.0) < 1e-12 && std::fabs(scales.back() - 6.0) < 1e-9);
    for (std::size_t i = 2; i < scales.size(); ++i)
      QVERIFY(std::fabs(scales[i] / scales[i - 1] - scales[1] / scales[0]) < 1e-9);
    params.scaleRule = ScaleRule::Difference;
    QCOMPARE(scalesMm(params, g).size(), std::size_t{4});  // ceil(log_1.5 5)
    params.sigmaMaxMm = 1.5;
    QCOMPARE(scalesMm(params, g).size(), std::size_t{2});
    params.sigmaMaxMm = 1.0;
    QCOMPARE(scalesMm(params, g).size(), std::size_t{1});
    params.sigmaMaxMm = 0.5;
    QVERIFY_THROWS_EXCEPTION(InputError, scalesMm(params, g));
  }

  void thresholdsAndSpeedFollowTheEquations() {
    Volume<float> v(cube(4), 0.0F);
    v.voxels[0] = 0.1F;
    v.voxels[1] = 0.3F;
    v.voxels[2] = -0.9F;
    const Thresholds t = thresholds(v, {3.0, {}, ThresholdRule::Average}, 6.0);
    QVERIFY(std::fabs(t.vAverage - 0.2) < 1e-6);
    QVERIFY(std::fabs(t.b - 0.1) < 1e-6);
    QVERIFY(!t.clamped);
    QVERIFY(thresholds(v, {300.0, {}, ThresholdRule::Average}, 6.0).clamped);
    QCOMPARE(thresholds(v, {3.0, 0.4, ThresholdRule::Average}, 6.0).b, 0.4);
    QVERIFY(std::fabs(thresholds(v, {}, 6.0).b - 0.14) < 1e-12);
    QCOMPARE(vesselSpeed(2.0 * t.a, t), 1.0);
    QVERIFY(std::fabs(vesselSpeed(t.b, t)) < 1e-12);
    QVERIFY(std::fabs(vesselSpeed(1.5 * t.b, t) - 0.5) < 1e-12);
    QVERIFY(std::fabs(vesselSpeed(0.5 * t.b, t) + 0.5) < 1e-12);
    QCOMPARE(vesselSpeed(-0.1, t), -1.0);
    QVERIFY_THROWS_EXCEPTION(NumericError, thresholds(Volume<float>(cube(3), 0.0F), {}, 6.0));
  }

  void theLargestScaleFollowsTheThickestVessel() {
    const auto tube = [](double radius, double noise, const Eigen::Vector3d& spacing) {
      PhantomParams params;
      params.psf.kind = PointSpread::Kind::Subvoxels;
      params.kind = PhantomKind::Tube;
      params.spacingMm = spacing;
      params.size = {100, 100, static_cast<int>(48 * spacing[0] / spacing[2])};
      params.radius = radius;
      params.noiseSigma = noise;
      return makePhantom(params).image;
    };
    for (const double noise : {0.0, 20.0, 60.0}) {
      const Volume<float> thick = tube(20.0, noise, {0.5, 0.5, 0.5});
      const double radius = thickestRadiusMm(thick, Polarity::Bright) / 0.5;
      QVERIFY2(radius > 15.5 && radius < 20.5, std::to_string(radius).c_str());
      const auto sigma = withScalesFromImage({}, thick).sigmaMaxMm;
      QVERIFY(sigma && std::fabs(*sigma - 0.25 * radius) < 1e-9);
      Volume<float> dark = thick;
      for (float& value : dark.voxels) value = -value;
      QCOMPARE(thickestRadiusMm(dark, Polarity::Dark), thickestRadiusMm(thick, Polarity::Bright));
      const double flat = thickestRadiusMm(tube(20.0, noise, {0.5, 0.5, 1.5}), Polarity::Bright);
      QVERIFY2(flat > 0.5 * 15.5 && flat < 0.5 * 20.5, std::to_string(flat).c_str());
      const auto usual = withScalesFromImage({}, tube(8.0, noise, {0.5, 0.5, 0.5})).sigmaMaxMm;
      QVERIFY(usual && *usual == 3.0);
    }
    VesselnessParams given;
    given.sigmaMaxMm = 2.5;
    QCOMPARE(*withScalesFromImage(given, tube(20.0, 0.0, {0.5, 0.5, 0.5})).sigmaMaxMm, 2.5);
    const Volume<float> even(cube(20), 7.0F);
    QCOMPARE(thickestRadiusMm(even, Polarity::Bright), 0.0);
  }

  // Of four blocks along each axis the first three: blocks outside are the last ones, and the
  // largest ball in the box, which goes on beyond the volume, touches its sides.
  void aBoxInACornerIsAsThickAsItsSides() {
    for (const double voxel : {0.5, 1.0, 2.0}) {
      Geometry g = cube(16);
      g.spacing.setConstant(voxel);
      Volume<float> image(g, 0.0F);
      for (int k = 0; k < 12; ++k)
        for (int j = 0; j < 12; ++j)
          for (int i = 0; i < 12; ++i) image.at(i, j, k) = 100.0F;
      QVERIFY(isNear(thickestRadiusMm(image, Polarity::Bright), 10.0 * voxel, 1e-6));
    }
  }

  void cancelIsPassedOn() {
    const Progress progress;
    progress.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, vesselness(noisyCube(), {}, progress));
  }

  // The fast form of the measure against eq. 3.22 by its letter, on Hessians of all kinds.
  void measuresRowsAsTheEquationSays() {
    constexpr int width = 1000;  // no multiple of a block
    const double c = 40.0;
    std::array<std::vector<float>, 6> h;
    std::array<const float*, 6> rows{};
    for (std::size_t k = 0; k < 6; ++k) {
      for (std::uint64_t i = 0; i < width; ++i)
        h[k].push_back(
            static_cast<float>((k < 3 ? 60.0 : 20.0) * randomNormal(k, i) - (k < 2 ? 80.0 : 0.0)));
      rows[k] = h[k].data();
    }
    MeasureRow measure;
    measure.scale = static_cast<float>(1.0 / c);
    std::vector<float> v(width, 0.0F);
    mergeMeasure(rows, measure, width, v.data());
    std::size_t kinds[3] = {0, 0, 0};
    for (std::size_t i = 0; i < width; ++i) {
      const auto l = symmetricEigenvalues({h[0][i], h[1][i], h[2][i], h[3][i], h[4][i], h[5][i]});
      double expected = 0.0;
      if (l[2] > 0.0) {
        expected = std::exp(-l[2] * l[2] / (0.5 * c * c)) - 1.0;
      } else if (l[1] < 0.0) {
        const double ra = l[1] / l[2], rb = l[0] / std::sqrt(l[1] * l[2]);
        const double s2 = l[0] * l[0] + l[1] * l[1] + l[2] * l[2];
        expected = (1.0 - std::exp(-2.0 * ra * ra)) * std::exp(-2.0 * rb * rb) *
                   (1.0 - std::exp(-0.5 * s2 / (c * c)));
      }
      ++kinds[expected > 0.0 ? 0 : expected < 0.0 ? 1 : 2];
      // Where two eigenvalues are all but of one size, either order may be taken.
      if (std::abs(std::abs(l[1]) - std::abs(l[2])) < 1e-3 * std::abs(l[2])) continue;
      QVERIFY2(std::abs(static_cast<double>(v[i]) - expected) < 1e-4,
               qPrintable(QString("%1: %2, not %3").arg(i).arg(v[i]).arg(expected)));
    }
    QVERIFY(kinds[0] > 100 && kinds[1] > 50 && kinds[2] > 50);
    // Only what is larger is written over.
    std::vector<float> other(width, 2.0F);
    mergeMeasure(rows, measure, width, other.data());
    QVERIFY(other == std::vector<float>(width, 2.0F));
  }

  void axesAreAlike_data() {
    QTest::addColumn<bool>("fewAlongLast");
    QTest::newRow("few slices") << true;
    QTest::newRow("many slices") << false;
  }
  void axesAreAlike() {
    QFETCH(bool, fewAlongLast);
    Volume<float> image = unlikeVessels(fewAlongLast);
    for (float& value : image.voxels) value = 100.0F / (1.0F + std::exp(3.0F * value));
    const Volume<float> other = turned(image);
    const auto smooth = [](const Volume<float>& of) {
      Volume<float> to(of.geometry);
      const std::size_t slice = of.geometry.offset(0, 0, 1);
      forEachSmoothSlice(of, 1.1,
                         [&](int k, const float* values) {
                           std::copy_n(values, slice,
                                       to.voxels.data() + static_cast<std::size_t>(k) * slice);
                         },
                         {});
      return to;
    };
    QVERIFY(mostApart(turned(smooth(image)), smooth(other)) < 1e-4);
    VesselnessParams params;
    const Volume<float> v = vesselness(image, params);
    QVERIFY(*std::max_element(v.voxels.begin(), v.voxels.end()) > 0.3F);
    // The kernels along the first axis sum in another order.
    QVERIFY2(mostApart(turned(v), vesselness(other, params)) < 2e-3,
             qPrintable(QString::number(mostApart(turned(v), vesselness(other, params)))));
    QVERIFY(std::fabs(thickestRadiusMm(image, Polarity::Bright) -
                      thickestRadiusMm(other, Polarity::Bright)) < 1e-6);
    QCOMPARE(contrastC(params, image), contrastC(params, other));
  }
};

QTEST_GUILESS_MAIN(TestVesselness)
#include "tst_vesselness.moc"
