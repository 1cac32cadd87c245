// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/phantom/rasterise.h"
#include "core/phantom/shape.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/segmentation_mask.h"
#include "core/preprocess/preprocess.h"
#include "core/quality/overlap.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

struct SyntheticCt {
  Volume<float> hu;
  Volume<std::uint8_t> vessels;
};

Shape solid(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
  Shape shape;
  shape.solids.push_back(RoundCone(from, to, radius, radius));
  return shape;
}

/// A vessel of radius 4 that touches a shell of bone and one of radius 2 away from it, in soft
/// tissue beside fat and air; noise of 20 HU.
SyntheticCt syntheticCt() {
  const Geometry g = cube(64);
  Shape vessels = solid({32, 54, -20}, {32, 54, 90}, 4.0);
  vessels.solids.push_back(RoundCone({8, -20, 14}, {8, 90, 20}, 2.0, 2.0));
  const Eigen::Vector3d centre(34, 30, 32);
  const Eigen::Vector3d beside = centre + Eigen::Vector3d(0, 0, 1e-3);
  const Volume<std::uint8_t> vessel = countSubvoxels(vessels, g);
  const Volume<std::uint8_t> outer = countSubvoxels(solid(centre, beside, 20.0), g);
  const Volume<std::uint8_t> inner = countSubvoxels(solid(centre, beside, 15.0), g);
  SyntheticCt ct{Volume<float>(g), Volume<std::uint8_t>(g)};
  for (std::size_t n = 0; n < ct.hu.voxels.size(); ++n) {
    const double lumen = vessel.voxels[n] / 8.0;
    const double bone = std::min((outer.voxels[n] - inner.voxels[n]) / 8.0, 1.0 - lumen);
    const int x = g.indexOf(n)[0];
    const double ground = x >= 60 ? -1000.0 : x >= 57 ? -100.0 : 50.0;
    ct.hu.voxels[n] = static_cast<float>(350.0 * lumen + 1200.0 * bone +
                                         ground * (1.0 - lumen - bone) + 20.0 * randomNormal(3, n));
    ct.vessels.voxels[n] = vessel.voxels[n] >= 4 ? 1 : 0;
  }
  return ct;
}

/// Inside voxels with no voxel of the truth within two steps.
std::size_t farFromTruth(const Volume<std::uint8_t>& mask, const Volume<std::uint8_t>& truth) {
  const Geometry& g = mask.geometry;
  std::size_t count = 0;
  for (std::size_t n = 0; n < mask.voxels.size(); ++n) {
    if (mask.voxels[n] == 0) continue;
    const Index3 p = g.indexOf(n);
    bool near = false;
    for (int k = -2; k <= 2; ++k)
      for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i)
          near = near || (g.contains(p[0] + i, p[1] + j, p[2] + k) &&
                          truth.at(p[0] + i, p[1] + j, p[2] + k) != 0);
    count += near ? 0 : 1;
  }
  return count;
}

}  // namespace

class TestCtPreset : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void boneIsNoVessel() {
    const SyntheticCt ct = syntheticCt();
    Pipeline pipeline(makeSource(ct.hu, "ct"));
    RunOptions options;
    options.until = Step::Evolve;
    const RunResult run = pipeline.run(preset("ct"), options);
    const Volume<std::uint8_t> mask = segmentationMask(run, ct.vessels.geometry);
    QCOMPARE(farFromTruth(mask, ct.vessels), std::size_t{0});
    QCOMPARE(connectedComponents(mask).sizes.size(), std::size_t{2});
    const double overlap = compareMasks(mask, ct.vessels).overlap;
    QVERIFY(isAbove(overlap, 96.0));
  }

  void whatIsAboveTheBoundIsFilledWithItsRim() {
    Volume<float> image(cube(9), 50.0F);
    image.at(4, 4, 4) = 1200.0F;
    image.at(4, 5, 4) = 300.0F;
    image.at(4, 6, 4) = 320.0F;
    image.at(0, 0, 0) = -1000.0F;
    image.at(8, 8, 8) = 500.0F;
    const Volume<float> out = clampIntensities(image, 0.0, 500.0, 1);
    QCOMPARE(out.at(4, 4, 4), 50.0F);
    QCOMPARE(out.at(4, 5, 4), 50.0F);
    QCOMPARE(out.at(4, 6, 4), 320.0F);
    QCOMPARE(out.at(0, 0, 0), 0.0F);
    QCOMPARE(out.at(8, 8, 8), 500.0F);
    QCOMPARE(clampIntensities(image, 0.0, 500.0, 0).at(4, 5, 4), 300.0F);
    QCOMPARE(clampIntensities(image, 0.0, 500.0, 2).at(4, 6, 4), 50.0F);
    QCOMPARE(clampIntensities(image, 0.0, {}, 1).at(4, 4, 4), 1200.0F);
    QCOMPARE(clampIntensities(image, {}, 500.0, 1).at(0, 0, 0), -1000.0F);
  }

  void theRimStaysInsideTheVolume() {
    Volume<float> image(cube(6), 50.0F);
    image.at(5, 2, 0) = 900.0F;
    image.at(0, 3, 0) = 300.0F;
    const Volume<float> out = clampIntensities(image, {}, 500.0, 1);
    QCOMPARE(out.at(0, 3, 0), 300.0F);
    QCOMPARE(out.at(5, 2, 0), 50.0F);
  }

  void boundsThatLeaveNothingAreRefused() {
    const Volume<float> image(cube(6), 50.0F);
    QVERIFY_THROWS_EXCEPTION(InputError, clampIntensities(image, 100.0, 500.0, 1));
    QVERIFY_THROWS_EXCEPTION(InputError, clampIntensities(image, {}, 10.0, 1));
    Parameters params = preset("ct");
    params.preprocess.clampUpper = -5.0;
    QVERIFY_THROWS_EXCEPTION(InputError, validate(params));
  }
};

QTEST_GUILESS_MAIN(TestCtPreset)
#include "tst_ct_preset.moc"
