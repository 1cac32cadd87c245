// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/phantom/phantom.h"
#include "core/pipeline/doubtful_places.h"
#include "tests/core/analytic.h"
#include "tests/core/phantom_case.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

Volume<float> clampedField(const PhantomParams& params) {
  Volume<float> phi = phantomField(params);
  const auto most = static_cast<float>(5.0 * phi.geometry.voxelMm());
  for (float& value : phi.voxels) value = std::clamp(value, -most, most);
  return phi;
}

Volume<float> tubeWithBall(const Geometry& g, const Eigen::Vector3d& centre, double radius) {
  return clamped(g, [&](const Eigen::Vector3d& x) {
    return std::min(tube(x, centreOf(g) - Eigen::Vector3d(6, 0, 0), {0, 0, 1}, 4.0),
                    ball(x, centre, radius));
  });
}

std::vector<DoubtfulPlace> placesOf(const Volume<float>& phi) {
  return doubtfulPlaces(phi, nullptr, {});
}

}  // namespace

class TestDoubtfulPlaces : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aPlainTubeLeavesNoDoubt() {
    QCOMPARE(placesOf(clampedField(paramsOf(PhantomKind::Tube, 48, 4.0))).size(), std::size_t{0});
    QCOMPARE(placesOf(clampedField(paramsOf(PhantomKind::Bifurcation, 64, 4.0))).size(),
             std::size_t{0});
  }

  void aStenosisIsANeckWhereItIsTight() {
    PhantomParams params = paramsOf(PhantomKind::Stenosis, 64, 5.0);
    params.stenosisPercent = 60.0;
    const Volume<float> phi = clampedField(params);
    const auto places = placesOf(phi);
    QCOMPARE(places.size(), std::size_t{1});
    QCOMPARE(places[0].kind, DoubtKind::Neck);
    QVERIFY((places[0].pointLps - centreOf(phi.geometry)).norm() < 1.5);
    QVERIFY2(places[0].text.find("4") != std::string::npos, places[0].text.c_str());
    params.stenosisPercent = 30.0;
    QCOMPARE(placesOf(clampedField(params)).size(), std::size_t{0});
  }

  void aVesselThatGetsThinnerIsNoNeck() {
    const Geometry g = cube(64);
    QCOMPARE(placesOf(clamped(g,
                              [&](const Eigen::Vector3d& x) {
                                return std::min(capsule(x, {32, 32, 8}, {32, 32, 32}, 5.0),
                                                capsule(x, {32, 32, 32}, {32, 32, 56}, 2.0));
                              }))
                 .size(),
             std::size_t{0});
  }

  void aHoleThroughAVesselIsNamed() {
    const Geometry g = cube(40);
    Volume<float> phi = clamped(g, [&](const Eigen::Vector3d& x) {
      return tube(x, centreOf(g), {0, 0, 1}, 4.3);
    });
    for (int i = 0; i < 40; ++i) phi.at(i, 20, 20) = std::max(phi.at(i, 20, 20), 0.3F);
    const auto places = placesOf(phi);
    QVERIFY(!places.empty());
    QCOMPARE(places[0].kind, DoubtKind::Hole);
    QVERIFY((places[0].pointLps - Eigen::Vector3d(20, 20, 20)).norm() < 5.0);
  }

  void islandsAreNamedSmallestFirstAndNotWithoutEnd() {
    const Geometry g = cube(48);
    const Eigen::Vector3d centre(38.0, 24.0, 24.0);
    const auto one = placesOf(tubeWithBall(g, centre, 1.9));
    QCOMPARE(one.size(), std::size_t{1});
    QCOMPARE(one[0].kind, DoubtKind::Island);
    QVERIFY((one[0].pointLps - centre).norm() < 1.0);
    // One of 3 % of the largest part is none.
    QCOMPARE(placesOf(tubeWithBall(g, centre, 3.0)).size(), std::size_t{0});
    Volume<float> phi = tubeWithBall(g, centre, 1.9);
    for (int n = 0; n < 20; ++n) {
      phi.at(44, 3 + 2 * n, 4) = -0.4F;
      if (n < 5) phi.at(45, 3 + 2 * n, 4) = -0.4F;
    }
    const auto many = placesOf(phi);
    QCOMPARE(many.size(), kMostDoubts);
    for (const DoubtfulPlace& place : many) QCOMPARE(place.pointLps[2], 4.0);
    QVERIFY(many.front().weight >= many.back().weight);
  }

  void vesselnessOutsideIsAMissedVessel() {
    const Geometry g = cube(40);
    const Volume<float> phi = clamped(g, [&](const Eigen::Vector3d& x) {
      return tube(x, {10, 20, 20}, {0, 0, 1}, 4.0);
    });
    Thresholds thresholds;
    thresholds.b = 0.1;
    // Inside and at the wall it is as it should be; beside it runs a second, weaker vessel.
    Volume<float> v = sampled(g, [&](const Eigen::Vector3d& x) {
      const double inside = tube(x, {10, 20, 20}, {0, 0, 1}, 4.9);
      const double other = tube(x, {30, 20, 20}, {0, 0, 1}, 1.5);
      return inside < 0.0 ? 0.5 : other < 0.0 ? 0.07 - 1e-3 * std::fabs(x[2] - 20.0) : 0.0;
    });
    VesselnessResult result;
    result.multiScale = std::make_shared<const Volume<float>>(v);
    const auto places = doubtfulPlaces(phi, &result, thresholds);
    QCOMPARE(places.size(), std::size_t{1});
    QCOMPARE(places[0].kind, DoubtKind::Missed);
    QVERIFY((places[0].pointLps - Eigen::Vector3d(30, 20, 20)).norm() < 1.6);
    thresholds.b = 0.2;  // it is too weak then
    QCOMPARE(doubtfulPlaces(phi, &result, thresholds).size(), std::size_t{0});
    QCOMPARE(placesOf(phi).size(), std::size_t{0});
  }

  void canBeCancelled() {
    const Progress progress;
    progress.cancel();
    QVERIFY_THROWS_EXCEPTION(
        Cancelled,
        doubtfulPlaces(clampedField(paramsOf(PhantomKind::Tube, 32, 4.0)), nullptr, {}, progress));
  }
};

QTEST_GUILESS_MAIN(TestDoubtfulPlaces)
#include "tst_doubtful_places.moc"
