// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/levelset/flood.h"
#include "core/lumen/axis_smoothing.h"
#include "core/lumen/local_levels.h"
#include "core/lumen/lumen.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"
#include "tests/core/threads.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

// Brightness of a voxel whose centre lies at a signed distance from a wall.
double brightness(double distance) { return 100.0 * std::clamp(0.5 - distance, 0.0, 1.0); }

void addNoise(Volume<float>& image, double sigma) {
  for (std::size_t i = 0; i < image.voxels.size(); ++i)
    image.voxels[i] += static_cast<float>(sigma * randomNormal(7, i));
}

// What an evolution might find of a shape: a voxel too much, or too little.
Volume<std::uint8_t> roughly(const Volume<float>& distance, double wall) {
  Volume<std::uint8_t> found(distance.geometry);
  for (std::size_t i = 0; i < found.voxels.size(); ++i)
    found.voxels[i] = static_cast<double>(distance.voxels[i]) < wall ? 1 : 0;
  return found;
}

Volume<float> imageOf(const Volume<float>& distance, double noise) {
  Volume<float> image(distance.geometry);
  for (std::size_t i = 0; i < image.voxels.size(); ++i)
    image.voxels[i] = static_cast<float>(brightness(static_cast<double>(distance.voxels[i])));
  addNoise(image, noise);
  return image;
}

const Vector3d kAxis = Vector3d(0.3, 0.5, 1.0).normalized();
const Vector3d kCentre{15.6, 15.2, 15.7};

Volume<float> tubeDistance(double radius) {
  return analytic::sampled(analytic::cube(32), [radius](const Vector3d& p) {
    return analytic::tube(p, kCentre, kAxis, radius);
  });
}

// The share of the wrong voxels in those that are inside by either.
double disagreement(const Volume<float>& phi, const Volume<float>& distance) {
  std::size_t wrong = 0, all = 0;
  for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
    const bool a = phi.voxels[i] < 0.0F, b = distance.voxels[i] < 0.0F;
    wrong += a != b ? 1 : 0;
    all += a || b ? 1 : 0;
  }
  return static_cast<double>(wrong) / static_cast<double>(all);
}

}  // namespace

class TestLumen : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void measuresTheNoise() {
    Volume<float> image = tubeDistance(3.0);
    for (float& v : image.voxels) v = 0.0F;
    std::vector<std::uint32_t> all(image.voxels.size());
    std::iota(all.begin(), all.end(), 0U);
    QCOMPARE(noiseLevel(image, all), 0.0);
    addNoise(image, 12.0);
    QVERIFY(std::abs(noiseLevel(image, all) / 12.0 - 1.0) < 0.03);
    // A background that was set to 0 does not count.
    for (std::size_t i = 0; i < image.voxels.size() / 2; ++i) image.voxels[i] = 0.0F;
    QVERIFY(std::abs(noiseLevel(image, all) / 12.0 - 1.0) < 0.05);
    // Where nearly all is background, what is left is edges.
    for (std::size_t i = 0; i < image.voxels.size() / 16 * 15; ++i) image.voxels[i] = 0.0F;
    QCOMPARE(noiseLevel(image, all), 0.0);
  }

  void findsTheAxis() {
    const Volume<float> distance = tubeDistance(2.5);
    const CellBand band = bandAround(roughly(distance, 0.0), 2);
    const auto axes = vesselAxes(imageOf(distance, 5.0), band);
    double least = 1.0;
    for (std::size_t c = 0; c < band.size(); ++c) {
      const Index3 p = band.geometry.indexOf(band.voxel[c]);
      if (*std::min_element(p.begin(), p.end()) < 6 || *std::max_element(p.begin(), p.end()) > 25)
        continue;
      least = std::min(least, std::abs(axes[c].cast<double>().dot(kAxis)));
    }
    QVERIFY(isAbove(least, 0.9));
  }

  // Of each slice the band holds the first voxel. A value that is taken from beyond the slice
  // before is what the threads' buffers still hold of a larger, brighter image; as slices come in
  // no particular order it may well be the last to be written.
  void takesTheValuesOfEachSliceFromThatSlice() {
    setThreads(2);
    Volume<float> large(analytic::cube(40), 1e4F);
    Volume<std::uint8_t> any(large.geometry);
    any.voxels[0] = 1;
    const CellBand little = bandAround(any, 1);
    const Volume<float> distance = analytic::sampled(analytic::cube(32), [](const Vector3d& p) {
      return analytic::tube(p, Vector3d::Zero(), Vector3d::UnitZ(), 3.0);
    });
    const CellBand band = bandAround(roughly(distance, 0.0), 2);
    QCOMPARE(band.voxel.front(), 0U);
    const Volume<float> image = imageOf(distance, 0.0);
    // Many rounds, as a second thread may come too late to a few.
    for (int round = 0; round < 150; ++round) {
      static_cast<void>(vesselAxes(large, little));
      for (const auto& axis : vesselAxes(image, band)) QVERIFY(isAbove(std::abs(axis.z()), 0.999F));
    }
  }

  // A linear profile along the axis has no second derivative along it: it stays, and noise goes.
  void smoothsAlongTheAxisAlone() {
    const Volume<float> distance = tubeDistance(2.5);
    const CellBand band = bandAround(roughly(distance, 0.0), 3);
    const std::vector<Eigen::Vector3f> axes(band.size(), kAxis.cast<float>());
    const std::vector<float> along(band.size(), 3.0F), across(band.size(), 0.0F);
    const Volume<float> clean = imageOf(distance, 0.0), noisy = imageOf(distance, 20.0);
    const auto keptClean = smoothAlongAxes(clean, band, axes, along, across);
    const auto smoothed = smoothAlongAxes(noisy, band, axes, along, across);
    double moved = 0.0, before = 0.0, after = 0.0;
    for (std::size_t c = 0; c < band.size(); ++c) {
      const auto truth = static_cast<double>(clean.voxels[band.voxel[c]]);
      moved += std::pow(static_cast<double>(keptClean[c]) - truth, 2);
      before += std::pow(static_cast<double>(noisy.voxels[band.voxel[c]]) - truth, 2);
      after += std::pow(static_cast<double>(smoothed[c]) - truth, 2);
    }
    QVERIFY(after < 0.3 * before);
    QVERIFY(moved < 0.1 * before);
  }

  void isTheSameForAnyNumberOfThreads() {
    const Volume<float> distance = tubeDistance(2.5), image = imageOf(distance, 20.0);
    const auto [one, two] = onOneAndSeveralThreads(
        [&] { return refineLumen(image, roughly(distance, 0.7), {}, Polarity::Bright); });
    QVERIFY(one.voxels == two.voxels);
  }

  void placesTheWall_data() {
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("found");
    for (const double radius : {1.5, 3.0, 5.0})
      for (const double found : {-0.8, 1.2})
        QTest::addRow("radius %.1f, found %+.1f", radius, found) << radius << found;
  }
  void placesTheWall() {
    QFETCH(double, radius);
    QFETCH(double, found);
    const Volume<float> distance = tubeDistance(radius);
    LumenParams params;
    params.level = 0.5;
    // Dark vessels are bright ones upside down.
    for (const bool dark : {false, true}) {
      Volume<float> image = imageOf(distance, 8.0);
      // The brightness drifts by +-40 % from one side of the volume to the other.
      for (std::size_t i = 0; i < image.voxels.size(); ++i) {
        const double x = image.geometry.indexOf(i)[0] / 31.0;
        image.voxels[i] *= static_cast<float>((0.6 + 0.8 * x) * (dark ? -1.0 : 1.0));
      }
      const Volume<float> phi = refineLumen(image, roughly(distance, found), params,
                                            dark ? Polarity::Dark : Polarity::Bright);
      const double wrong = disagreement(phi, distance);
      QVERIFY(isBelow(wrong, 0.16 / radius));
    }
  }

  // Two tubes whose cores were found apart, with a gap of one voxel that is never quite dark.
  void keepsNeighboursApart() {
    const Volume<float> distance = analytic::sampled(analytic::cube(32), [](const Vector3d& p) {
      return std::min(analytic::tube(p, {12.6, 15.5, 15.5}, Vector3d::UnitZ(), 2.0),
                      analytic::tube(p, {17.6, 15.5, 15.5}, Vector3d::UnitZ(), 2.0));
    });
    Volume<std::uint8_t> found = roughly(distance, 0.6);
    for (std::size_t i = 0; i < found.voxels.size(); ++i)
      if (distance.voxels[i] < -1.0F) found.voxels[i] = 2;
    QCOMPARE(connectedComponents(found).sizes.size(), 1U);
    const Volume<float> phi =
        refineLumen(imageOf(distance, 6.0), found, LumenParams{}, Polarity::Bright);
    QCOMPARE(connectedComponents(insideMask(phi)).sizes.size(), 2U);
  }

  // Where two cores meet side by side in a voxel as bright as a wall, it stays outside and well off
  // the wall. Elsewhere phi is the wall's level less the share of brightness, just outside as well.
  void whereNeighboursMeetIsClearOfTheWall() {
    Volume<float> image(analytic::cube(32), 0.0F);
    Volume<std::uint8_t> found(image.geometry);
    const auto square = [](int i, int j) { return std::max(std::abs(i), std::abs(j)); };
    for (std::size_t n = 0; n < image.voxels.size(); ++n) {
      const auto [i, j, k] = image.geometry.indexOf(n);
      const int off = std::min(square(i - 12, j - 16), square(i - 18, j - 16));
      if (off <= 2) image.voxels[n] = 100.0F;
      if (i == 15 && j == 16) image.voxels[n] = 60.0F;
      if (off == 3 && j == 19) image.voxels[n] = 46.0F;
      if (off <= 3) found.voxels[n] = off <= 1 ? 2 : 1;
    }
    LumenParams params;
    params.level = 0.5;
    const Volume<float> phi = refineLumen(image, found, params, Polarity::Bright);
    QCOMPARE(connectedComponents(insideMask(phi)).sizes.size(), 2U);
    for (int k = 4; k < 28; ++k) {
      QCOMPARE(phi.at(15, 16, k), 0.1F);
      QVERIFY(isNear(static_cast<double>(phi.at(12, 19, k)), 0.04, 0.02));
      QVERIFY(phi.at(14, 16, k) < -0.4F && phi.at(16, 16, k) < -0.4F);
    }
  }

  // A mirrored scan has the mirrored wall and evidence, to its last voxel.
  void sidesAreAlike() {
    const Geometry g = analytic::cube(32);
    Volume<float> image(g);
    Volume<std::uint8_t> found(g), other(g);
    for (std::size_t i = 0; i < image.voxels.size(); ++i) {
      const double off =
          analytic::tube(voxelCentre(g, i), Vector3d::Zero(), Vector3d::Ones().normalized(), 3.0);
      image.voxels[i] = static_cast<float>(brightness(off) + 5.0 * randomNormal(7, i));
      found.voxels[i] = off < -1.0 ? 2 : off < 0.4 ? 1 : 0;
    }
    Volume<float> back = image;
    std::reverse(back.voxels.begin(), back.voxels.end());
    std::reverse_copy(found.voxels.begin(), found.voxels.end(), other.voxels.begin());
    WallEvidence one, two;
    const Volume<float> phi = refineLumen(image, found, {}, Polarity::Bright, {}, &one);
    Volume<float> mirrored = refineLumen(back, other, {}, Polarity::Bright, {}, &two);
    std::reverse(mirrored.voxels.begin(), mirrored.voxels.end());
    QVERIFY(isBelow(analytic::mostApart(phi, mirrored), 1e-4));
    std::reverse(two.lumen.begin(), two.lumen.end());
    std::reverse(two.around.begin(), two.around.end());
    QCOMPARE(one.lumen.size(), two.lumen.size());
    double most = 0.0;
    for (std::size_t c = 0; c < one.lumen.size(); ++c)
      most = std::max({most, std::fabs(static_cast<double>(one.lumen[c]) - two.lumen[c]),
                       std::fabs(static_cast<double>(one.around[c]) - two.around[c])});
    QVERIFY(isBelow(most, 1e-3));
  }

  // A thin vessel that fades for a stretch stays one.
  void bridgesAFadingStretch() {
    const Volume<float> distance = tubeDistance(1.5);
    Volume<float> image = imageOf(distance, 4.0);
    for (std::size_t i = 0; i < image.voxels.size(); ++i)
      if (std::abs(image.geometry.indexOf(i)[2] - 16) < 3) image.voxels[i] *= 0.3F;
    const Volume<float> phi =
        refineLumen(image, roughly(distance, 0.5), LumenParams{}, Polarity::Bright);
    QCOMPARE(connectedComponents(insideMask(phi)).sizes.size(), 1U);
  }

  void bandKnowsItsNeighbours() {
    Volume<std::uint8_t> set(analytic::oblique(14, 11, 9));
    for (const std::size_t i : {0U, 5U, 600U, 777U, 1300U}) set.voxels[i] = 1;
    const CellBand band = bandAround(set, 2);
    const Geometry& g = band.geometry;
    Volume<std::uint32_t> number(g, CellBand::none);
    for (std::uint32_t c = 0; c < band.size(); ++c) number.voxels[band.voxel[c]] = c;
    for (std::size_t i = 0; i < set.voxels.size(); ++i) {
      const Index3 p = g.indexOf(i);
      int steps = 99;
      for (std::size_t s = 0; s < set.voxels.size(); ++s) {
        if (set.voxels[s] == 0) continue;
        const Index3 q = g.indexOf(s);
        steps = std::min(
            steps, std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])}));
      }
      QCOMPARE(number.voxels[i] != CellBand::none, steps <= 2);
      if (steps > 2) continue;
      const std::uint32_t cell = number.voxels[i];
      QCOMPARE(int(band.layer[cell]), steps);
      for (std::size_t k = 0; k < CellBand::kOffsets.size(); ++k) {
        const Index3& d = CellBand::kOffsets[k];
        const Index3 q{p[0] + d[0], p[1] + d[1], p[2] + d[2]};
        const std::uint32_t expected =
            g.contains(q[0], q[1], q[2]) ? number.at(q[0], q[1], q[2]) : CellBand::none;
        QCOMPARE(band.neighbour(cell, k), expected);
      }
    }
  }

  void averagesLocally() {
    Volume<std::uint8_t> set(analytic::cube(40), 1);
    const CellBand band = bandAround(set, 1);
    std::vector<float> value(band.size()), weight(band.size(), 0.0F);
    for (std::size_t c = 0; c < band.size(); ++c) {
      const Index3 p = band.geometry.indexOf(band.voxel[c]);
      value[c] = static_cast<float>(p[0]);
      weight[c] = p[1] % 3 == 0 ? 1.0F : 0.0F;
    }
    const std::vector<float> mean = localMean(band, value, weight);
    const std::size_t middle = band.geometry.offset(20, 20, 20);
    QVERIFY(std::abs(mean[middle] - 20.0F) < 1.0F);
    QVERIFY(mean[band.geometry.offset(36, 20, 20)] > mean[band.geometry.offset(4, 20, 20)] + 10.0F);
    QCOMPARE(localMean(band, value, std::vector<float>(band.size(), 0.0F))[0], 0.0F);
  }

  // A faint vessel four voxels from a bright one keeps its own brightness, and what lies beside a
  // vessel has that of the nearest.
  void averagesAlongVesselsAlone() {
    Volume<std::uint8_t> set(analytic::cube(40));
    for (int i = 0; i < 40; ++i) set.at(i, 18, 20) = set.at(i, 22, 20) = 1;
    const CellBand band = bandAround(set, 1);
    std::vector<char> vessel(band.size());
    std::vector<float> value(band.size()), weight(band.size());
    for (std::size_t c = 0; c < band.size(); ++c) {
      vessel[c] = static_cast<char>(band.layer[c] == 0);
      const int j = band.geometry.indexOf(band.voxel[c])[1];
      value[c] = vessel[c] == 0 ? 0.0F : j == 18 ? 200.0F : 80.0F;
      weight[c] = vessel[c] == 0 ? 0.0F : 1.0F;
    }
    const std::vector<float> prior(band.size(), 140.0F);
    const std::vector<float> mean = meanAlong(band, vessel, value, weight, 100, prior);
    for (std::size_t c = 0; c < band.size(); ++c) {
      const int j = band.geometry.indexOf(band.voxel[c])[1];
      QVERIFY(std::abs(mean[c] - (j < 20 ? 200.0F : 80.0F)) < 3.0F);
    }
    const std::vector<float> nothing(band.size(), 0.0F);
    QCOMPARE(meanAlong(band, vessel, value, nothing, 100, prior)[0], 140.0F);
    QCOMPARE(meanAlong(band, vessel, value, weight, 0, prior), prior);
  }

  void floodsFromSeedsAndLargeParts() {
    Volume<float> v(analytic::cube(20), 0.0F);
    for (int i = 2; i < 17; ++i) v.at(i, 4, 4) = 0.2F;   // long
    for (int i = 2; i < 6; ++i) v.at(i, 10, 10) = 0.2F;  // short
    for (int i = 2; i < 6; ++i) v.at(i, 16, 16) = 0.5F;  // short, with a seed
    const Eigen::Vector3d seed = v.geometry.toPhysical({3.0, 16.0, 16.0});
    const Volume<std::uint8_t> found = floodVessels(v, 0.15, {seed}, 0.5, 10);
    QCOMPARE(int(found.at(16, 4, 4)), 1);
    QCOMPARE(int(found.at(3, 10, 10)), 0);
    QCOMPARE(int(found.at(5, 16, 16)), 2);
    const Volume<float> phi = floodStart(v, 0.15, found);
    QVERIFY(phi.at(9, 4, 4) < 0.0F && phi.at(9, 5, 4) > 0.0F && phi.at(3, 10, 10) > 0.0F);
  }

  void findsNothingInNothing() {
    const Volume<float> image(analytic::cube(8), 1.0F);
    const Volume<float> phi =
        refineLumen(image, Volume<std::uint8_t>(image.geometry), LumenParams{}, Polarity::Bright);
    for (const float f : phi.voxels) QVERIFY(f > 0.0F);
  }

  void canBeCancelled() {
    const Volume<float> distance = tubeDistance(2.5);
    const Progress progress;
    progress.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, refineLumen(imageOf(distance, 8.0), roughly(distance, 0.5),
                                                    LumenParams{}, Polarity::Bright, progress));
  }

  void axesAreAlike() {
    for (const bool fewAlongLast : {true, false}) {
      const Volume<float> distance = analytic::unlikeVessels(fewAlongLast);
      Volume<float> image = distance;
      for (float& value : image.voxels) value = 40.0F + 160.0F / (1.0F + std::exp(4.0F * value));
      for (std::size_t i = 0; i < image.voxels.size(); ++i)
        image.voxels[i] += static_cast<float>(5.0 * randomNormal(7, i));
      Volume<std::uint8_t> found(distance.geometry);
      for (std::size_t i = 0; i < found.voxels.size(); ++i)
        found.voxels[i] = distance.voxels[i] < -0.8F ? 2 : distance.voxels[i] < -0.2F ? 1 : 0;
      const auto refined = [](const Volume<float>& of, const Volume<std::uint8_t>& where) {
        return refineLumen(of, where, LumenParams{}, Polarity::Bright);
      };
      const Volume<float> phi = refined(image, found);
      const Volume<float> other = refined(analytic::turned(image), analytic::turned(found));
      const double most = analytic::mostApart(analytic::turned(phi), other);
      QVERIFY2(most < 0.02, qPrintable(QString::number(most)));
    }
  }
};

QTEST_GUILESS_MAIN(TestLumen)
#include "tst_lumen.moc"
