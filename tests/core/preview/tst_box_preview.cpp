// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "core/preview/box_preview.h"
#include "tests/core/analytic.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

RunResult runOf(const Volume<float>& image, const Parameters& params) {
  RunOptions options;
  options.until = Step::Evolve;
  return Pipeline(makeSource(image, "scan")).run(params, options);
}

PreviewGround groundOf(const RunResult& run, bool known = true) {
  return {run.preprocessed, run.vesselness, run.seeds->pointsLps,
          known ? run.evolve->phi : nullptr};
}

Volume<float> noisyTree() {
  PhantomParams params;
  params.size = {80, 80, 80};
  params.noiseSigma = 20.0;
  return makePhantom(params).image;
}

/// What two segmentations of a grid have in common, Dice.
double agreement(const Volume<float>& a, const Volume<float>& b) {
  std::size_t both = 0, all = 0;
  for (std::size_t i = 0; i < a.voxels.size(); ++i) {
    const bool inA = a.voxels[i] < 0.0F, inB = b.voxels[i] < 0.0F;
    both += inA && inB ? 2 : 0;
    all += (inA ? 1 : 0) + (inB ? 1 : 0);
  }
  return all > 0 ? static_cast<double>(both) / static_cast<double>(all) : 1.0;
}

/// Mean difference of two phi at their zero sets, voxels.
double wallsApart(const Volume<float>& a, const Volume<float>& b) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < a.voxels.size(); ++i)
    if (std::fabs(a.voxels[i]) < 1.0F && std::fabs(b.voxels[i]) < 2.0F) {
      sum += std::fabs(static_cast<double>(a.voxels[i]) - static_cast<double>(b.voxels[i]));
      ++count;
    }
  return count > 0 ? sum / count : 0.0;
}

}  // namespace

class TestBoxPreview : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void itIsWhatTheWholeVolumeWouldGive_data() {
    QTest::addColumn<double>("xi");
    QTest::addColumn<double>("gamma");
    QTest::addColumn<bool>("lumen");
    QTest::newRow("as it was") << 20.0 << 0.6 << true;
    QTest::newRow("other xi") << 12.0 << 0.6 << true;
    QTest::newRow("other gamma, level set alone") << 20.0 << 0.8 << false;
  }
  void itIsWhatTheWholeVolumeWouldGive() {
    QFETCH(double, xi);
    QFETCH(double, gamma);
    QFETCH(bool, lumen);
    const Volume<float> image = noisyTree();
    const RunResult before = runOf(image, Parameters());
    Parameters params;
    params.thresholds.xi = xi;
    params.levelset.gamma = gamma;
    params.lumen.enabled = lumen;
    const RunResult whole = runOf(image, params);
    const Geometry& grid = image.geometry;
    for (const Eigen::Vector3d& middle :
         {Eigen::Vector3d(40, 40, 40), Eigen::Vector3d(40, 30, 8)}) {
      const VoxelBox box = boxAround(grid, grid.toPhysical(middle), {32, 32, 32});
      const EvolveResult part = previewInBox(groundOf(before), box, params, {}, {});
      const Volume<float> same = cropped(*whole.evolve->phi, box);
      QVERIFY(part.phi->geometry == same.geometry);
      QCOMPARE(part.thresholds.b, whole.evolve->thresholds.b);
      const double dice = agreement(*part.phi, same), apart = wallsApart(*part.phi, same);
      const QString what = QString("Dice %1, walls %2 voxels apart").arg(dice).arg(apart);
      qInfo("%s", qPrintable(what));
      QVERIFY2(dice > (lumen ? 0.99 : 0.96) && apart < 0.02, qPrintable(what));
    }
  }

  /// A thin vessel that runs through a corner of the box is too small there to be found by itself.
  void vesselsThatPassThroughAreKept() {
    const Volume<float> image = sampled(cube(60), [](const Eigen::Vector3d& x) {
      const double vessel = tube(x, {30.0, 30.0, 30.0}, {0, 0, 1}, 2.0);
      return 20.0 + 180.0 * std::clamp(0.5 - vessel, 0.0, 1.0);
    });
    Parameters params;
    params.vesselness.sigmaMaxMm = 3.0;
    params.levelset.floodLeastVoxels = 2000;
    const RunResult run = runOf(image, params);
    const VoxelBox box = boxAround(image.geometry, {30.0, 30.0, 30.0}, {9, 9, 9});
    PreviewGround ground = groundOf(run);
    ground.seedsLps.clear();
    const auto inside = [](const EvolveResult& result) {
      return std::count_if(result.phi->voxels.begin(), result.phi->voxels.end(),
                           [](float phi) { return phi < 0.0F; });
    };
    const auto found = inside(previewInBox(ground, box, params, {}, {}));
    QVERIFY(std::fabs(static_cast<double>(found) - 9.0 * 12.6) < 20.0);
    ground.known.reset();
    QCOMPARE(inside(previewInBox(ground, box, params, {}, {})), std::ptrdiff_t{0});
  }

  void whereNothingIsItIsEmpty() {
    const Volume<float> image = noisyTree();
    const RunResult run = runOf(image, Parameters());
    const VoxelBox box = boxAround(image.geometry, {2.0, 2.0, 2.0}, {6, 6, 6});
    const EvolveResult part = previewInBox(groundOf(run), box, Parameters(), {}, {});
    QVERIFY(*std::min_element(part.phi->voxels.begin(), part.phi->voxels.end()) > 0.0F);
    QVERIFY(part.phi->geometry.size == (Index3{6, 6, 6}));
  }

  void itCanBeCancelled() {
    const Volume<float> image = noisyTree();
    const RunResult run = runOf(image, Parameters());
    Progress progress;
    progress.cancel();
    const VoxelBox box = boxAround(image.geometry, {40.0, 40.0, 40.0}, {32, 32, 32});
    QVERIFY_THROWS_EXCEPTION(Cancelled,
                             previewInBox(groundOf(run), box, Parameters(), {}, progress));
  }
};

QTEST_GUILESS_MAIN(TestBoxPreview)
#include "tst_box_preview.moc"
