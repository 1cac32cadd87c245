// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/vesselness_step.h"
#include "core/pipeline/voxel_reason.h"
#include "tests/core/analytic.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

/// A tube along z of radius 3 voxels, brightness 200 on 20, and a grey one beside it.
Volume<float> tubes(double voxelMm) {
  Geometry g = cube(40);
  g.spacing.setConstant(voxelMm);
  return sampled(g, [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d x = p / voxelMm;
    const double a = tube(x, {12.0, 20.0, 20.0}, {0, 0, 1}, 3.0);
    const double b = tube(x, {30.0, 20.0, 20.0}, {0, 0, 1}, 2.0);
    return 20.0 + 180.0 * std::clamp(0.5 - a, 0.0, 1.0) + 90.0 * std::clamp(0.5 - b, 0.0, 1.0);
  });
}

struct Case {
  Parameters params;
  RunResult run;

  explicit Case(double voxelMm = 1.0) {
    params.vesselness.sigmaMaxMm = 4.0 * voxelMm;
    RunOptions options;
    options.until = Step::Evolve;
    run = Pipeline(makeSource(tubes(voxelMm), "tubes")).run(params, options);
  }

  [[nodiscard]] VoxelReason at(const Eigen::Vector3d& lps, const Volume<float>* kept = nullptr) {
    return reasonAt(lps, *run.preprocessed, *vessels(), *run.evolve, kept, params);
  }
  /// A run beyond the evolution gives the vesselness away.
  [[nodiscard]] std::shared_ptr<const VesselnessResult> vessels() const { return run.vesselness; }
};

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

}  // namespace

class TestVoxelReason : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The numbers are those that the run itself went by, also at the border of the volume.
  void theNumbersAreThoseOfTheRun_data() {
    QTest::addColumn<double>("voxelMm");
    for (const double voxelMm : {0.4, 1.0}) QTest::addRow("%g", voxelMm) << voxelMm;
  }
  void theNumbersAreThoseOfTheRun() {
    QFETCH(double, voxelMm);
    Case c(voxelMm);
    const Volume<float>& v = *c.run.vesselness->multiScale;
    const Volume<float> speed = speedVolume(v, c.run.evolve->thresholds);
    for (const Index3& at : {Index3{12, 20, 20}, Index3{16, 20, 20}, Index3{0, 39, 3},
                             Index3{30, 21, 39}, Index3{21, 5, 30}}) {
      const auto [i, j, k] = at;
      const VoxelReason reason = c.at(v.geometry.toPhysical(Eigen::Vector3d(i, j, k)));
      QVERIFY(reason.voxel == at);
      QCOMPARE(static_cast<float>(reason.vesselness()), v.at(i, j, k));
      QVERIFY(std::abs(reason.p - speed.at(i, j, k)) < 1e-6);
      QCOMPARE(static_cast<float>(reason.value), c.run.preprocessed->at(i, j, k));
      QCOMPARE(static_cast<float>(reason.phiMm), c.run.evolve->phi->at(i, j, k));
      QCOMPARE(reason.scales.size(), c.run.vesselness->scalesMm.size());
      for (const VoxelAtScale& scale : reason.scales)
        QVERIFY(std::abs(scale.vesselness) <= std::abs(reason.vesselness()));
      const double gamma = c.params.levelset.gamma;
      QCOMPARE(reason.curvatureTerm,
               (1.0 - gamma) * std::abs(c.params.levelset.d * reason.curvature));
      QCOMPARE(reason.speed, gamma * reason.p + reason.curvatureTerm);
    }
  }

  void aTubeIsKnownByItsEigenvalues() {
    Case c;
    const VoxelReason reason = c.at({12.0, 20.0, 20.0});
    const auto& l = reason.scales[reason.best].eigenvalues;
    QVERIFY(std::abs(l[0]) < 0.02 * std::abs(l[2]));
    QVERIFY(l[1] < 0.0 && l[2] < 0.0 && std::abs(l[1] / l[2] - 1.0) < 0.05);
    QVERIFY(reason.inside());
    QVERIFY2(has(reason.text(c.params), "Inside: its vesselness of"),
             reason.text(c.params).c_str());
    // On the wall of a tube of radius 3, 1 / r.
    QVERIFY(std::abs(c.at({15.0, 20.0, 20.0}).curvature - 1.0 / 3.0) < 0.08);
  }

  void brightnessGoesFromTheSurroundingsToTheLumen() {
    Case c;
    QVERIFY(std::abs(*c.at({12.0, 20.0, 20.0}).brightness() - 1.0) < 0.05);
    const VoxelReason beside = c.at({17.0, 20.0, 20.0});
    QVERIFY(!beside.inside());
    QVERIFY(std::abs(*beside.brightness()) < 0.05);
    QVERIFY(std::abs(*beside.lumen - 200.0) < 10.0 && std::abs(*beside.surroundings - 20.0) < 10.0);
    QVERIFY(!c.at({12.0, 2.0, 20.0}).lumen);
    QVERIFY(!c.at({12.0, 2.0, 20.0}).brightness());
  }

  void aPartThatIsLeftOutSaysSo() {
    Case c;
    Volume<float> nothing(c.run.evolve->phi->geometry);
    std::fill(nothing.voxels.begin(), nothing.voxels.end(), 1.0F);
    const VoxelReason leftOut = c.at({12.0, 20.0, 20.0}, &nothing);
    QVERIFY(!leftOut.inside());
    QVERIFY(has(leftOut.text(c.params), "left out"));
    QVERIFY(has(c.at({12.0, 2.0, 20.0}, &nothing).text(c.params), "Outside: it does not look"));
  }

  void theReasonsDiffer() {
    Parameters params;
    VoxelReason reason;
    reason.scales = {{1.0, {0.0, -9.0, -9.0}, 0.4}};
    reason.thresholds.b = 0.14;
    reason.value = 65.0;
    reason.surroundings = 20.0;
    reason.phiMm = 0.2;
    QVERIFY(
        has(reason.text(params), "Outside, though its vesselness of 0.4 is above b = 0.14: no"));
    reason.lumen = 120.0;
    QVERIFY(has(reason.text(params), "at 41 % of the way"));
    QVERIFY(has(reason.text(params), "lies at 45 %"));
    params.lumen.enabled = false;
    QVERIFY(has(reason.text(params), "came to rest before it"));
    reason.phiMm = -0.2;
    QVERIFY(has(reason.text(params), "Inside: its vesselness of 0.4"));
    QVERIFY(has(reason.text(params), "moves outwards"));
    reason.scales[0].vesselness = 0.1;
    QVERIFY(
        has(reason.text(params), "Inside, though its vesselness of 0.1 is below b = 0.14: the "));
    reason.scales[0].vesselness = -0.3;
    QVERIFY(has(reason.text(params), "does not look like a vessel"));
    reason.phiMm = 0.2;
    QVERIFY(has(reason.text(params), "Outside: it does not look like a vessel"));
    QVERIFY(has(reason.text(params), "moves inwards"));
  }

  void otherMethodsAndPlacesAreRefused() {
    Case c;
    QVERIFY_THROWS_EXCEPTION(InputError, (void)c.at({-5.0, 0.0, 0.0}));
    c.params.segmentation.method = SegmentationMethod::Threshold;
    QVERIFY_THROWS_EXCEPTION(InputError, (void)c.at({12.0, 20.0, 20.0}));
  }
};

QTEST_GUILESS_MAIN(TestVoxelReason)
#include "tst_voxel_reason.moc"
