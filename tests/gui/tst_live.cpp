// SPDX-License-Identifier: BSD-3-Clause
#include <QCheckBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>

#include "core/image/voxel_box.h"
#include "core/parameters/field.h"
#include "tests/gui/port_case.h"
#include "tests/gui/window_case.h"

using namespace angiomesh;
using angiomesh::test::insideOf;
using angiomesh::test::kPatienceMs;
using angiomesh::test::slowTree;
using angiomesh::test::twoTubes;
using angiomesh::test::WindowCase;

namespace {

/// A window in which a scan is segmented, with the crosshair in a vessel.
struct LiveCase : WindowCase {
  explicit LiveCase(Source source = twoTubes(),
                    const JobRunnerFactory& makeRunner = makeInlineJobRunner)
      : WindowCase(makeRunner) {
    models().files.take(std::move(source));
    for (int waited = 0; !models().document.hasCase() && waited < kPatienceMs; waited += 10)
      QTest::qWait(10);
    models().runs.run(Step::Evolve);
    for (int waited = 0; models().runs.running() && waited < kPatienceMs; waited += 10)
      QTest::qWait(10);
    window->views().setCrosshair(insideOf(models(), 0.5));
    find<QSpinBox>("liveSide")->setValue(24);
  }

  LivePreview& live() { return models().live; }
  QString status() { return find<QLabel>("liveStatus")->text(); }
  QImage axial() { return window->views().slice(2)->picture(1); }
  QSlider* slider(const char* field) {
    return find<QSlider>("slider", QStringLiteral("field:") + field);
  }
};

/// Pixels as green as the outlines of a preview.
int green(const QImage& picture) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QRgb p = picture.pixel(x, y);
      count += qGreen(p) > qRed(p) + 60 && qGreen(p) > qBlue(p) + 40 ? 1 : 0;
    }
  return count;
}

/// How much of two segmentations is common, Dice.
double agreement(const Volume<float>& a, const Volume<float>& b) {
  double both = 0.0, all = 0.0;
  for (std::size_t i = 0; i < a.voxels.size(); ++i) {
    both += a.voxels[i] < 0.0F && b.voxels[i] < 0.0F ? 2.0 : 0.0;
    all += (a.voxels[i] < 0.0F ? 1.0 : 0.0) + (b.voxels[i] < 0.0F ? 1.0 : 0.0);
  }
  return all > 0.0 ? both / all : 1.0;
}

}  // namespace

class TestLive : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aSliderIsTriedAroundTheCrosshair() {
    LiveCase c;
    QVERIFY(!c.live().phi());
    QVERIFY2(c.status().contains("slider"), qPrintable(c.status()));
    const QImage before = c.axial();
    const auto result = c.models().results.evolveResult();
    const std::string vesselness = c.models().results.report(Step::Vesselness).key;
    QSignalSpy runs(&c.models().runs, &RunModel::ended);
    QTest::keyClick(c.slider("levelset.xi"), Qt::Key_PageUp);
    const auto phi = c.live().phi();
    QVERIFY(phi);
    QCOMPARE(phi->geometry.size, (Index3{24, 24, 24}));
    QVERIFY(phi->geometry.holds(c.window->views().crosshair()));
    QVERIFY(c.axial() != before);
    QCOMPARE(green(before), 0);
    QVERIFY2(green(c.axial()) > 100, qPrintable(QString::number(green(c.axial()))));
    // Nothing of the case is computed anew.
    QCOMPARE(c.models().results.evolveResult(), result);
    QCOMPARE(c.models().results.report(Step::Vesselness).key, vesselness);
    QCOMPARE(runs.size(), 0);
    QVERIFY(c.models().runs.state(Step::Evolve) == StepState::Stale);
    // The box goes where the crosshair goes.
    c.window->views().setCrosshair(insideOf(c.models(), 0.9));
    QVERIFY(c.live().phi() != phi);
    QVERIFY(c.live().phi()->geometry.holds(c.window->views().crosshair()));
    QTest::keyClick(c.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!c.live().phi());
    c.window->views().setCrosshair(insideOf(c.models(), 0.5));
    QCOMPARE(c.axial(), before);
  }

  void itIsWhatARunGives() {
    LiveCase c;
    c.models().document.setField("levelset.xi", 35.0);
    const auto tried = c.live().phi();
    QVERIFY(tried);
    c.models().runs.run(Step::Evolve);
    QVERIFY(!c.live().phi());
    const Volume<float>& whole = *c.models().results.evolveResult()->phi;
    const Eigen::Vector3d first = whole.geometry.toIndex(tried->geometry.origin);
    const Index3 low{static_cast<int>(std::lround(first[0])),
                     static_cast<int>(std::lround(first[1])),
                     static_cast<int>(std::lround(first[2]))};
    const Index3 high{low[0] + 23, low[1] + 23, low[2] + 23};
    QVERIFY(agreement(*tried, cropped(whole, {low, high})) > 0.98);
  }

  void itIsOffWhereItCannotBe() {
    LiveCase c;
    c.models().document.setField("levelset.xi", 35.0);
    QVERIFY(c.live().phi());
    c.click(c.find<QCheckBox>("live"));
    QVERIFY(!c.live().on() && !c.live().phi() && c.status().isEmpty());
    c.click(c.find<QCheckBox>("live"));
    QVERIFY(c.live().phi());
    // While nobody tunes.
    c.find<QDockWidget>("pipelineDock")->hide();
    QVERIFY(!c.live().phi());
    c.find<QDockWidget>("pipelineDock")->show();
    QVERIFY(c.live().phi());
    // Once a step before the evolution is stale.
    c.models().document.setField("vesselness.sigmaMaxMm", 3.0);
    QVERIFY(!c.live().phi());
    QVERIFY2(c.status().contains("run anew"), qPrintable(c.status()));
    c.models().document.undoStack()->undo();
    QVERIFY(c.live().phi());
    c.models().document.setField("segmentation.method", std::string("threshold"));
    QVERIFY(!c.live().phi());
    // Of the next scan nothing is known yet.
    c.models().files.take(slowTree());
    QVERIFY(!c.live().phi());
    QVERIFY2(c.status().contains("run once"), qPrintable(c.status()));
  }

  void theLastOfManyMovesIsShown() {
    LiveCase c(slowTree(), makeThreadedJobRunner);
    for (int i = 1; i <= 40; ++i) {
      c.models().document.setField("levelset.xi", 20.0 + 0.25 * i, i > 1);
      QTest::qWait(5);
    }
    QTRY_VERIFY_WITH_TIMEOUT(!c.live().working(), kPatienceMs);
    QVERIFY2(c.status().startsWith("in "), qPrintable(c.status()));
    PreviewGround ground{
        c.models().results.layer(Layer::Preprocessed), c.models().results.vesselnessResult(),
        c.models().results.seedsResult()->pointsLps, c.models().results.evolveResult()->phi};
    const VoxelBox box =
        boxAround(ground.image->geometry, c.window->views().crosshair(), {24, 24, 24});
    const EvolveResult last = previewInBox(ground, box, c.models().document.parameters(), {}, {});
    QCOMPARE(c.live().phi()->voxels, last.phi->voxels);
  }

  void aRunTakesItsPlace() {
    LiveCase c(slowTree(), makeThreadedJobRunner);
    c.models().document.setField("levelset.xi", 30.0);
    QTRY_VERIFY_WITH_TIMEOUT(c.live().phi() && !c.live().working(), kPatienceMs);
    c.models().runs.run(Step::Evolve);
    QVERIFY(!c.live().phi());
    QTRY_VERIFY_WITH_TIMEOUT(!c.models().runs.running(), kPatienceMs);
    QVERIFY(!c.live().phi() && !c.live().working());
    QVERIFY2(c.status().contains("slider"), qPrintable(c.status()));
  }

  void everySliderGoesToBothEnds_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("two tubes") << 0;
    QTest::newRow("tree") << 1;
    QTest::newRow("noisy tree") << 2;
  }
  void everySliderGoesToBothEnds() {
    QFETCH(int, kind);
    PhantomParams tree;
    tree.psf.kind = PointSpread::Kind::Subvoxels;
    tree.size = {32, 32, 32};
    tree.radiusMax = 3.0;
    tree.noiseSigma = kind == 1 ? 10.0 : 50.0;
    LiveCase c(kind == 0 ? twoTubes(26) : makeSource(makePhantom(tree).image, "tree"));
    c.find<QSpinBox>("liveSide")->setValue(16);
    int moved = 0;
    for (const Field& field : parameterFields()) {
      QSlider* slider = c.slider(field.key.c_str());
      if (!slider || field.step != Step::Evolve || !slider->isEnabled()) continue;
      for (const int end : {slider->minimum(), slider->maximum()}) {
        slider->setValue(end);
        QVERIFY(!c.live().working());
        ++moved;
      }
      while (c.models().document.undoStack()->canUndo()) c.models().document.undoStack()->undo();
    }
    QVERIFY(moved > 8);
    QVERIFY(!c.live().phi());
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestLive>(argc, argv); }
#include "tst_live.moc"
