// SPDX-License-Identifier: BSD-3-Clause
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QMenu>
#include <QSignalSpy>

#include "core/base/formatted.h"
#include "core/image/voxels.h"
#include "gui/model/result_text.h"
#include "tests/gui/port_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

std::size_t parts(const Volume<float>& phi) {
  return connectedComponents(insideMask(phi)).sizes.size();
}

/// Two tubes, segmented, with the crosshair in one of them.
struct CorrectCase : WindowCase {
  explicit CorrectCase(const std::filesystem::path& recovery = {})
      : WindowCase(makeInlineJobRunner, recovery) {
    models().files.take(twoTubes());
    models().live.setOn(false);
    models().runs.run(Step::Evolve);
    state().setVolumeView(VolumeView::None);
    window->views().setCrosshair(insideOf(models(), 0.5));
    QCoreApplication::processEvents();
  }

  CaseCorrections& corrections() { return models().corrections; }
  const Volume<float>& phi() { return *models().results.segmentation()->phi; }
  SliceView* axial() { return window->views().slice(2); }
  QPoint inAxial(const Eigen::Vector3d& lps) { return axial()->positionOf(lps).toPoint(); }
  Eigen::Vector3d here() { return window->views().crosshair(); }
  Eigen::Vector3d along(double share) { return insideOf(models(), share); }
  QListWidget* list() { return find<QListWidget>("correctionList"); }

  /// Takes a piece out of the middle of the tube around the crosshair.
  void breakTube() {
    corrections().setToEdge(false);
    corrections().setRadius(4.0);
    corrections().paint(false, {here()});
  }
};

}  // namespace

class TestCorrectionsWindow : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theBrushPaintsInASlice() {
    CorrectCase c;
    const auto evolved = c.models().results.evolveResult();
    QVERIFY(c.models().results.segmentation() == evolved);
    QCOMPARE(parts(c.phi()), std::size_t{2});
    const QImage before = c.axial()->picture(1);
    trigger(c, "toolErase");
    c.corrections().setToEdge(false);
    c.corrections().setRadius(1.0);
    const Eigen::Vector3d middle = c.here();
    const QPoint from = c.inAxial(middle + Eigen::Vector3d(-4.0, 0.0, 0.0));
    const QPoint to = c.inAxial(middle + Eigen::Vector3d(4.0, 0.0, 0.0));
    sendMouse(*c.axial(), QEvent::MouseMove, from, Qt::NoButton, Qt::NoButton);
    QVERIFY(c.axial()->picture(1) != before);  // the brush is seen
    drag(*c.axial(), Qt::LeftButton, from, to);
    const auto& texts = c.models().document.parameters().segmentation.corrections;
    QCOMPARE(texts.size(), std::size_t{1});
    const Correction made = parseCorrection(texts[0]);
    QVERIFY(made.kind == CorrectionKind::Erase && made.radiusMm == 1.0);
    QVERIFY(made.placesLps.size() > 3);
    QVERIFY((made.placesLps.front() - c.axial()->lpsAt(from)).norm() < 0.01);
    QVERIFY((made.placesLps.back() - c.axial()->lpsAt(to)).norm() < 0.01);
    // It is there at once, and nothing before it was made anew.
    QVERIFY(c.models().results.segmentation() != evolved);
    QVERIFY(c.models().results.evolveResult() == evolved);
    QVERIFY(c.corrections().outcome(0) && c.corrections().outcome(0)->removed > 20);
    const Geometry& g = c.phi().geometry;
    const Index3 p = nearestVoxel(g, middle);
    QVERIFY(c.phi().at(p[0], p[1], p[2]) > 0.0F);
    QVERIFY(c.models().results.fresh(Step::Correct));
    QCOMPARE(c.models().results.segmentationName(), QString("1.1"));
    QCOMPARE(c.list()->count(), 1);
    QVERIFY2(c.list()->item(0)->text().startsWith("1. Erase, "),
             qPrintable(c.list()->item(0)->text()));
  }

  void undoAndRedoGiveTheSameBits() {
    CorrectCase c;
    const auto evolved = c.models().results.segmentation();
    c.breakTube();
    const auto broken = c.models().results.segmentation();
    QCOMPARE(parts(*broken->phi), std::size_t{3});
    c.corrections().paint(true, {c.along(0.1)});
    const auto both = c.models().results.segmentation();
    QVERIFY(both != broken);
    QTest::keyClick(c.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(c.models().results.segmentation()->phi->voxels == broken->phi->voxels);
    QCOMPARE(c.models().results.segmentationName(), QString("1.1"));
    QTest::keyClick(c.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(c.models().results.segmentation() == evolved);
    QCOMPARE(c.models().results.segmentationName(), QString("1"));
    c.models().document.undoStack()->redo();
    c.models().document.undoStack()->redo();
    QVERIFY(c.models().results.segmentation()->phi->voxels == both->phi->voxels);
    QCOMPARE(c.models().results.segmentationName(), QString("1.2"));
  }

  void twoClicksJoinAndSeparate() {
    CorrectCase c;
    c.breakTube();
    QCOMPARE(parts(c.phi()), std::size_t{3});
    trigger(c, "toolJoin");
    const Eigen::Vector3d one = c.along(0.1), other = c.along(0.9);
    const auto clickAt = [&](const Eigen::Vector3d& place) {
      c.window->views().setCrosshair(place);
      const QPoint at = c.inAxial(place);
      drag(*c.axial(), Qt::LeftButton, at, at);
    };
    clickAt(one);
    QVERIFY(c.corrections().picked());
    QCOMPARE(c.corrections().all().size(), std::size_t{1});
    clickAt(other);
    QVERIFY(!c.corrections().picked());
    QCOMPARE(c.corrections().all().size(), std::size_t{2});
    QCOMPARE(parts(c.phi()), std::size_t{2});
    trigger(c, "toolSeparate");
    clickAt(one);
    clickAt(other);
    QCOMPARE(parts(c.phi()), std::size_t{3});
    // Another tool forgets what was begun.
    clickAt(one);
    QVERIFY(c.corrections().picked());
    trigger(c, "toolNavigate");
    QVERIFY(!c.corrections().picked());
  }

  void whatCannotBeMadeIsTakenBack() {
    CorrectCase c;
    QSignalSpy said(&c.models().log, &MessageLog::message);
    trigger(c, "openLoop");
    QCoreApplication::processEvents();
    QVERIFY(c.corrections().all().empty());
    QVERIFY(c.models().results.segmentation() == c.models().results.evolveResult());
    bool told = false;
    for (const auto& each : said)
      told |= each[1].toString().startsWith("Open loop: there is no loop");
    QVERIFY(told);
    QVERIFY(!c.models().document.undoStack()->canUndo());
  }

  void oneOfThemCanBeRemoved() {
    CorrectCase c;
    c.breakTube();
    c.corrections().paint(true, {c.along(0.1)});
    QCOMPARE(c.list()->count(), 2);
    c.list()->setCurrentRow(0);
    c.click(c.find<QPushButton>("removeCorrection"));
    QCOMPARE(c.list()->count(), 1);
    QCOMPARE(parts(c.phi()), std::size_t{2});
    QVERIFY(parseCorrection(c.corrections().all()[0]).kind == CorrectionKind::Add);
  }

  void aRunMeshesWhatIsCorrected() {
    CorrectCase c;
    c.click(c.find<QPushButton>("run"));
    QVERIFY(c.models().results.meshFits());
    const auto mesh = c.models().results.mesh(MeshKind::Exported);
    c.breakTube();
    QVERIFY(!c.models().results.meshFits());
    QVERIFY(surfaceText(c.models().results, c.models().runs, MeshKind::Exported)
                .text.startsWith("Result 1.1, no mesh yet"));
    c.click(c.find<QPushButton>("run"));
    QVERIFY(c.models().results.meshFits());
    QCOMPARE(c.models().results.components().size(), std::size_t{3});
    QVERIFY(c.models().results.mesh(MeshKind::Exported) != mesh);
    QCOMPARE(c.models().results.meshRun()->segmentation()->corrections.size(), std::size_t{1});
    // Back at once, with its mesh.
    QTest::keyClick(c.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(c.models().results.meshFits());
    QVERIFY(c.models().results.mesh(MeshKind::Exported) == mesh);
  }

  void theyAreMadeAgainAfterAnotherRun() {
    CorrectCase c;
    c.breakTube();
    const auto before = c.models().results.segmentation();
    c.models().document.setField("levelset.xi", 35.0);
    QVERIFY(!c.corrections().ready());
    QVERIFY(!c.find<QAction>("toolAdd")->isEnabled());
    c.models().runs.run(Step::Evolve);
    QVERIFY(c.corrections().ready());
    QVERIFY(c.models().results.segmentation() != before);
    QCOMPARE(parts(c.phi()), std::size_t{3});
    QCOMPARE(c.models().results.segmentationName(), QString("2.1"));
  }

  void theMenuOfAPlaceCorrects() {
    CorrectCase c;
    c.corrections().setToEdge(false);
    c.corrections().setRadius(4.0);
    QTest::mouseClick(c.axial(), Qt::RightButton, Qt::NoModifier, c.inAxial(c.here()));
    auto* menu = c.window->findChild<QMenu*>("correctHere");
    QVERIFY(menu && menu->isEnabled());
    const auto entry = [&](const char* name) {
      for (QAction* action : menu->actions())
        if (action->objectName() == name) return action;
      return static_cast<QAction*>(nullptr);
    };
    for (const char* name :
         {"addHere", "eraseHere", "toolJoin", "toolSeparate", "cutOffHere", "fillHole", "openLoop"})
      QVERIFY2(entry(name), name);
    entry("eraseHere")->trigger();
    QCOMPARE(parts(c.phi()), std::size_t{3});
    entry("cutOffHere")->trigger();
    c.window->findChild<QMenu*>("portMenu")->close();
  }

  void theBrushChangesItsSize() {
    CorrectCase c;
    const double before = c.corrections().radiusMm();
    QCOMPARE(before, 1.5);  // three voxels
    trigger(c, "brushLarger");
    QVERIFY(c.corrections().radiusMm() > before);
    QCOMPARE(c.find<QDoubleSpinBox>("brushRadius")->value(), 1.88);
    trigger(c, "brushSmaller");
    QVERIFY(std::fabs(c.corrections().radiusMm() - before) < 1e-9);
    QVERIFY(c.corrections().toEdge());
    trigger(c, "brushToEdge");
    QVERIFY(!c.corrections().toEdge());
    QVERIFY(!c.find<QCheckBox>("toEdge")->isChecked());
  }
};

int main(int argc, char** argv) { return runWindowTests<TestCorrectionsWindow>(argc, argv); }

#include "tst_corrections_window.moc"
