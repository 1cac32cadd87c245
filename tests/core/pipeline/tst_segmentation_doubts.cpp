// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>

#include "core/base/random.h"
#include "core/pipeline/brighter_around.h"
#include "core/pipeline/segmentation_doubts.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"

using namespace angiomesh;
using namespace angiomesh::analytic;
using Eigen::Vector3d;

namespace {

const Geometry kGrid = cube(40);
const Vector3d kAxis = Vector3d(0.2, 0.3, 1.0).normalized();
const Vector3d kVessel(10.0, 12.0, 20.0), kMarrow(27.0, 26.0, 20.0);
constexpr double kRadius = 4.0;

/// A vessel of brightness 300 in tissue of 50; beside it a bone, its marrow 200 in a shell of 900.
double scan(const Vector3d& x) {
  if (tube(x, kVessel, kAxis, kRadius) < 0.0) return 300.0;
  const double bone = tube(x, kMarrow, kAxis, kRadius);
  return bone < 0.0 ? 200.0 : bone < 3.0 ? 900.0 : 50.0;
}

/// What bounds of the intensity leave of it to be found.
EvolveResult found(double boneRadius = kRadius) {
  EvolveResult result;
  result.phi = std::make_shared<const Volume<float>>(sampled(kGrid, [&](const Vector3d& x) {
    const double nearest =
        std::min(tube(x, kVessel, kAxis, kRadius), tube(x, kMarrow, kAxis, boneRadius));
    return std::clamp(nearest, -5.0, 5.0);
  }));
  result.wall = WallFacts{};
  return result;
}

std::vector<double> sharesOf(const Volume<float>& image, const Volume<float>& phi,
                             Polarity polarity) {
  const Components parts = connectedComponents(insideMask(phi));
  return brighterAround(image, phi, parts.labels, parts.sizes.size(), polarity);
}

bool isLeftOutBy(const std::string& words, const Vector3d& centre) {
  const std::size_t at = words.find("segmentation.drop = ");
  if (at == std::string::npos) return false;
  Vector3d p;
  return std::sscanf(words.c_str() + at, "segmentation.drop = %lf,%lf,%lf", &p[0], &p[1], &p[2]) ==
             3 &&
         tube(p, centre, kAxis, kRadius) < 0.0;
}

}  // namespace

class TestSegmentationDoubts : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void surroundingsAreTold() {
    const Volume<float> image = sampled(kGrid, scan);
    const EvolveResult result = found(1.2 * kRadius);  // the marrow comes first
    const std::vector<double> shares = sharesOf(image, *result.phi, Polarity::Bright);
    QCOMPARE(shares.size(), std::size_t{2});
    QVERIFY(isAbove(shares[0], 0.9));
    QCOMPARE(shares[1], 0.0);
    Volume<float> negative = image;
    for (float& value : negative.voxels) value = -value;
    QCOMPARE(sharesOf(negative, *result.phi, Polarity::Dark), shares);
    // The image may have another grid, turned and finer.
    Geometry fine = kGrid;
    fine.size = {80, 81, 79};
    fine.spacing = {0.5, 0.5, 0.5};
    fine.direction.col(0) *= -1.0;
    fine.origin = {39.0, 0.0, 0.0};
    const std::vector<double> other = sharesOf(sampled(fine, scan), *result.phi, Polarity::Bright);
    QVERIFY(other[0] > 0.9 && other[1] == 0.0);
  }

  /// An image of noise that ends amid the vessels goes on as it is at its border, on every side.
  void beyondTheImageItsNearestVoxelCounts() {
    const EvolveResult result = found();
    const auto noiseOf = [](const Index3& p) {
      return static_cast<float>(randomNormal(3, (p[2] * 97ULL + p[1]) * 89ULL + p[0]));
    };
    // The vessels reach beyond each of its six sides.
    const Index3 first{9, 11, 8}, last{28, 27, 31};
    Geometry part = kGrid;
    for (std::size_t a = 0; a < 3; ++a) {
      part.size[a] = last[a] - first[a] + 1;
      part.origin[static_cast<Eigen::Index>(a)] = first[a];
    }
    Volume<float> image(part), whole(kGrid);
    for (std::size_t i = 0; i < image.voxels.size(); ++i)
      image.voxels[i] = noiseOf(part.indexOf(i));
    for (std::size_t i = 0; i < whole.voxels.size(); ++i) {
      Index3 p = kGrid.indexOf(i);
      for (std::size_t a = 0; a < 3; ++a) p[a] = std::clamp(p[a], first[a], last[a]) - first[a];
      whole.voxels[i] = noiseOf(p);
    }
    const std::vector<double> shares = sharesOf(image, *result.phi, Polarity::Bright);
    QVERIFY(shares[0] > 0.2 && shares[0] < 0.8);
    QCOMPARE(shares, sharesOf(whole, *result.phi, Polarity::Bright));
  }

  /// Places between two vessels tell nothing, nor do so few as there are around a speck.
  void whatTellsNothingIsLeftOut() {
    // Two voxels off the wall of one begins the other, which is brighter.
    const Volume<float> phi = sampled(kGrid, [](const Vector3d& x) {
      return std::min(std::fabs(x.x() - 16.0), std::fabs(x.x() - 20.0)) - 1.7;
    });
    const Volume<float> image = sampled(kGrid, [](const Vector3d& x) {
      return x.x() < 14.5 || x.x() > 21.5 ? 50.0 : x.x() < 17.5 ? 300.0 : 900.0;
    });
    QCOMPARE(sharesOf(image, phi, Polarity::Bright), (std::vector<double>{0.0, 0.0}));
    const auto speck = [](double radius) {
      const Volume<float> ball = sampled(kGrid, [&](const Vector3d& x) {
        return analytic::ball(x, Vector3d(20.0, 20.0, 20.0), radius);
      });
      const Volume<float> hollow = sampled(kGrid, [&](const Vector3d& x) {
        return analytic::ball(x, Vector3d(20.0, 20.0, 20.0), radius) < 0.0 ? 100.0 : 900.0;
      });
      return sharesOf(hollow, ball, Polarity::Bright);
    };
    // As bright as the vessel is not brighter.
    QCOMPARE(sharesOf(Volume<float>(kGrid, 100.0F), *found().phi, Polarity::Bright),
             (std::vector<double>{0.0, 0.0}));
    QCOMPARE(speck(1.1), std::vector<double>{0.0});
    QCOMPARE(speck(3.3), std::vector<double>{1.0});
    QVERIFY(
        brighterAround(image, phi, Volume<std::int32_t>(kGrid, 0), 0, Polarity::Bright).empty());
  }

  void aVesselThatTouchesBoneIsNone() {
    const EvolveResult result = found(0.0);
    const auto beside = [](double half) {
      return [half](const Vector3d& x) {
        if (tube(x, kVessel, kAxis, kRadius) < 0.0) return 300.0;
        return x.x() - kVessel.x() - kAxis.x() / kAxis.z() * (x.z() - kVessel.z()) > half ? 900.0
                                                                                          : 50.0;
      };
    };
    const std::vector<double> shares =
        sharesOf(sampled(kGrid, beside(0.5)), *result.phi, Polarity::Bright);
    QVERIFY2(shares[0] > 0.3 && shares[0] < 0.5, qPrintable(QString::number(shares[0])));
    QVERIFY(segmentationDoubts(sampled(kGrid, beside(0.5)), result, {}, 1.0).empty());
  }

  void marrowIsNamedWithWhatLeavesItOut() {
    const Volume<float> image = sampled(kGrid, scan);
    const std::vector<std::string> doubts = segmentationDoubts(image, found(), {}, 1.0);
    QCOMPARE(doubts.size(), std::size_t{1});
    QVERIFY2(doubts[0].find("is no vessel") != std::string::npos &&
                 doubts[0].find("brighter") != std::string::npos,
             doubts[0].c_str());
    QVERIFY2(isLeftOutBy(doubts[0], kMarrow), doubts[0].c_str());
    Parameters dark;
    dark.vesselness.polarity = Polarity::Dark;
    Volume<float> negative = image;
    for (float& value : negative.voxels) value = -value;
    const std::vector<std::string> same = segmentationDoubts(negative, found(), dark, 1.0);
    QVERIFY(same.size() == 1 && same[0].find("darker") != std::string::npos);
    QVERIFY(segmentationDoubts(image, found(0.0), {}, 1.0).empty());
  }

  void manyHolesAreSaid() {
    const Volume<float> image = sampled(kGrid, scan);
    EvolveResult result = found(0.0);
    result.wall->filledHoles = 30;
    result.wall->cutHandles = 19;
    QVERIFY(segmentationDoubts(image, result, {}, 12.5).empty());
    result.wall->cutHandles = 20;
    const std::vector<std::string> doubts = segmentationDoubts(image, result, {}, 12.5);
    QCOMPARE(doubts.size(), std::size_t{1});
    QVERIFY(doubts[0].find("50 were closed") != std::string::npos);
    QVERIFY(doubts[0].find("vesselness.c, which is 12.5 here") != std::string::npos);
    result.wall.reset();
    QVERIFY(segmentationDoubts(image, result, {}, 12.5).empty());
  }
};

QTEST_GUILESS_MAIN(TestSegmentationDoubts)
#include "tst_segmentation_doubts.moc"
