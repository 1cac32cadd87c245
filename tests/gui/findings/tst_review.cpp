// SPDX-License-Identifier: BSD-3-Clause
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

#include "gui/findings/case_review.h"
#include "tests/gui/window_case.h"

using namespace angiomesh;
using angiomesh::test::WindowCase;

namespace {

/// A tube with a tight stenosis, and a small ball beside it.
Source stenosisAndIsland() {
  PhantomParams params;
  params.psf.kind = PointSpread::Kind::Subvoxels;
  params.kind = PhantomKind::Stenosis;
  params.size = {48, 48, 64};
  params.radius = 5.0;
  params.stenosisPercent = 60.0;
  params.noiseSigma = 3.0;
  Volume<float> image = makePhantom(params).image;
  const Geometry& g = image.geometry;
  for (std::size_t i = 0; i < image.voxels.size(); ++i) {
    const Index3 p = g.indexOf(i);
    const double away = Eigen::Vector3d(p[0] - 40, p[1] - 40, p[2] - 32).norm();
    if (away < 2.4) image.voxels[i] = 250.0F;
  }
  return makeSource(std::move(image), "stenosis");
}

struct Reviewed : WindowCase {
  explicit Reviewed(const JobRunnerFactory& makeRunner = makeInlineJobRunner)
      : WindowCase(makeRunner) {
    find<QDockWidget>("reviewDock")->show();
    find<QDockWidget>("reviewDock")->raise();
  }
  void segment() {
    models().files.take(stenosisAndIsland());
    models().runs.run(Step::Evolve);
  }
  QPushButton* button(const char* name) { return find<QPushButton>(name); }
  QTableWidget* places() { return find<QTableWidget>("doubtfulPlaces"); }
  QTableWidget* remarks() { return find<QTableWidget>("remarks"); }
  QString count() { return find<QLabel>("reviewCount")->text(); }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    window->activateWindow();
    QTest::keyClick(window->views().slice(2), key, modifiers);
  }
};

}  // namespace

/// Verdict, scores, remarks and the list of doubtful places.
class TestReview : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void thereIsNothingToReviewBeforeASegmentation() {
    Reviewed c;
    QVERIFY(!c.button("reviewAccept")->isEnabled());
    QVERIFY(!c.button("reviewFind")->isEnabled());
    c.models().files.take(stenosisAndIsland());
    QVERIFY(!c.button("reviewAccept")->isEnabled());
    c.key(Qt::Key_N);
    QCOMPARE(c.places()->rowCount(), 0);
    c.models().runs.run(Step::Evolve);
    QVERIFY(c.button("reviewAccept")->isEnabled());
    QVERIFY(c.button("remarkAdd")->isEnabled());
  }

  void aKeyStepsThroughTheDoubtfulPlaces() {
    Reviewed c;
    c.segment();
    c.key(Qt::Key_N);
    QCOMPARE(c.places()->rowCount(), 2);
    QVERIFY2(c.places()->item(0, 0)->text().contains("Neck"),
             qPrintable(c.places()->item(0, 0)->text()));
    QVERIFY(c.places()->item(1, 0)->text().contains("Island"));
    QCOMPARE(c.count(), QString("1 of 2 doubtful places seen"));
    QCOMPARE(c.places()->currentRow(), 0);
    const auto off = [&](const Eigen::Vector3d& place) {
      return (c.window->views().crosshair() - place).norm();
    };
    QVERIFY(off({23.5, 23.5, 31.5}) < 2.5);
    c.key(Qt::Key_N);
    QVERIFY(off({40.0, 40.0, 32.0}) < 2.0);
    QCOMPARE(c.count(), QString("2 of 2 doubtful places seen"));
    c.key(Qt::Key_N);
    QCOMPARE(c.places()->currentRow(), 0);
    c.key(Qt::Key_N, Qt::ShiftModifier);
    QCOMPARE(c.places()->currentRow(), 1);
    // What was seen is work: it can be undone, and parameters stay as they are.
    QVERIFY(c.models().document.modified());
    QVERIFY(c.models().results.fresh(Step::Evolve));
    c.models().document.undoStack()->undo();
    QCOMPARE(c.count(), QString("0 of 2 doubtful places seen"));
    // Of another segmentation they are not known.
    c.models().document.setField("levelset.xi", 22.0);
    c.models().runs.run(Step::Evolve);
    QCOMPARE(c.places()->rowCount(), 0);
    QCOMPARE(c.count(), QString("Doubtful places"));
  }

  void aVerdictBelongsToItsResult() {
    Reviewed c;
    c.segment();
    QTest::mouseClick(c.button("reviewAccept"), Qt::LeftButton);
    QCOMPARE(c.window->review().review().verdict, Verdict::Accepted);
    for (int n = 0; n < 4; ++n) QTest::keyClick(c.find<QComboBox>("reviewScore"), Qt::Key_Down);
    QCOMPARE(c.window->review().review().score, 4);
    QVERIFY(!c.find<QLabel>("reviewStale")->isVisible());
    c.models().document.setField("levelset.xi", 22.0);
    c.models().runs.run(Step::Evolve);
    QVERIFY(c.find<QLabel>("reviewStale")->isVisible());
    QTest::mouseClick(c.button("reviewReject"), Qt::LeftButton);
    QVERIFY(!c.find<QLabel>("reviewStale")->isVisible());
    QVERIFY(!c.button("reviewAccept")->isChecked());
    // A second click takes it back.
    QTest::mouseClick(c.button("reviewReject"), Qt::LeftButton);
    QCOMPARE(c.window->review().review().verdict, Verdict::None);
    for (int n = 0; n < 2; ++n) c.models().document.undoStack()->undo();
    QVERIFY(c.button("reviewAccept")->isChecked());
  }

  void remarksAreKeptWithTheCase() {
    Reviewed c;
    c.segment();
    c.window->views().setCrosshair({20.0, 21.0, 22.0});
    QTest::mouseClick(c.button("remarkAdd"), Qt::LeftButton);
    auto* editor = c.remarks()->findChild<QLineEdit*>();
    QVERIFY(editor);
    QTest::keyClicks(editor, "next to bone");
    // Results that arrive meanwhile do not take away what was typed.
    Q_EMIT c.models().results.resultsChanged();
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(c.window->review().review().remarks.front().text, std::string("next to bone"));
    auto* score = qobject_cast<QComboBox*>(c.remarks()->cellWidget(0, 0));
    for (int n = 0; n < 2; ++n) QTest::keyClick(score, Qt::Key_Down);
    const std::vector<ReviewRemark> expected{{{20.0, 21.0, 22.0}, 2, "next to bone"}};
    QVERIFY(c.window->review().review().remarks == expected);
    QCOMPARE(c.remarks()->item(0, 1)->text(), QString("L 20.0 P 21.0 S 22.0 mm"));
    c.window->views().setCrosshair({1.0, 1.0, 1.0});
    QTest::mouseClick(c.button("remarkAdd"), Qt::LeftButton);
    QCOMPARE(c.remarks()->rowCount(), 2);
    // Back to the first one by a click.
    QTest::mouseClick(c.remarks()->viewport(), Qt::LeftButton, Qt::NoModifier,
                      c.remarks()->visualItemRect(c.remarks()->item(0, 1)).center());
    QVERIFY((c.window->views().crosshair() - Eigen::Vector3d(20, 21, 22)).norm() < 1e-9);
    c.remarks()->setCurrentCell(1, 2);
    QTest::mouseClick(c.button("remarkRemove"), Qt::LeftButton);
    QVERIFY(c.window->review().review().remarks == expected);
    c.models().document.undoStack()->undo();
    QCOMPARE(c.remarks()->rowCount(), 2);
    c.models().document.undoStack()->redo();
    // Through the file.
    const QTemporaryDir folder;
    c.answers.savePath = folder.filePath("a.angiomesh");
    c.find<QAction>("saveCase")->trigger();
    std::vector<std::string> warnings;
    const CaseReading saved = readCase(folder.filePath("a.angiomesh").toStdString());
    QVERIFY(saved.document.notes.review.remarks == expected);
  }

  void theReportOfAMeshHasIt() {
    Reviewed c;
    c.models().files.take(test::twoTubes());
    c.models().runs.run();
    QTest::mouseClick(c.button("reviewAccept"), Qt::LeftButton);
    c.savePath = c.folder.filePath("a.ply");
    c.find<QAction>("export")->trigger();
    c.click(c.find<QPushButton>("exportGo"));
    QFile report(c.folder.filePath("a.report.json"));
    QVERIFY(report.open(QIODevice::ReadOnly));
    const QJsonObject review =
        QJsonDocument::fromJson(report.readAll()).object().value("review").toObject();
    QCOMPARE(review.value("verdict").toString(), QString("accepted"));
  }

  void placesOfAResultThatIsGoneAreNotShown() {
    Reviewed c(makeThreadedJobRunner);
    c.models().files.take(stenosisAndIsland());
    QTRY_VERIFY(c.models().document.hasCase());
    c.models().runs.run(Step::Evolve);
    QTRY_VERIFY_WITH_TIMEOUT(!c.models().busy(), test::kPatienceMs);
    c.window->review().find();
    QVERIFY(c.window->review().finding());
    QCOMPARE(c.count(), QString("Looking for doubtful places…"));
    c.models().files.take(test::twoTubes());
    QTRY_VERIFY_WITH_TIMEOUT(!c.window->review().finding(), test::kPatienceMs);
    QVERIFY(!c.window->review().found());
    QCOMPARE(c.places()->rowCount(), 0);
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestReview>(argc, argv); }
#include "tst_review.moc"
