// SPDX-License-Identifier: BSD-3-Clause
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "gui/dialog/series_dialog.h"
#include "gui/model/case_models.h"
#include "tests/io/dicom_writer.h"
#include "window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

void saveSecond(const fs::path& folder) {
  saveSecondSeries(folder, [](const Slice& slice) { return slice.k != 2; });
}

}  // namespace

class TestSeries : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aFolderOfSeveralSeriesAsksWhichOne() {
    const Folder folder;
    saveSeries(folder.path());
    saveSecond(folder.path());
    WindowCase c;
    c.window->open(QString::fromStdString(folder.path().string()));
    QTRY_COMPARE(c.seriesShown.size(), std::size_t{2});
    QVERIFY(!c.window->models().document.hasCase());

    c.seriesChosen = 0;
    c.window->open(QString::fromStdString(folder.path().string()));
    QTRY_VERIFY(c.window->models().document.hasCase());
    QCOMPARE(c.window->models().document.image()->at(1, 1, 1), float(storedValue(1, 1, 1)));
  }

  void aVolumeAmongLocalizersIsTakenWithAWord() {
    const Folder folder;
    saveSeries(folder.path());
    saveSecondSeries(folder.path(), [](const Slice& slice) { return slice.k < 2; });
    WindowCase c;
    QStringList said;
    QObject::connect(&c.models().log, &MessageLog::message, &c.models().log,
                     [&](Severity, const QString& text) { said << text; });
    c.window->open(QString::fromStdString(folder.path().string()));
    QTRY_VERIFY(c.models().document.hasCase());
    QVERIFY(c.seriesShown.empty());
    QVERIFY2(said.join('\n').contains("of 2 series all but one"), qPrintable(said.join('\n')));
  }

  void missingSlicesAreResampledOnlyWhenTheUserSaysSo() {
    const Folder folder;
    saveSecond(folder.path());
    WindowCase c;
    c.window->open(QString::fromStdString(folder.path().string()));
    QTRY_VERIFY(c.unevenReason.contains("1 slice is missing"));
    QVERIFY(!c.window->models().document.hasCase());
    c.resample = true;
    c.window->open(QString::fromStdString(folder.path().string()));
    QTRY_VERIFY(c.window->models().document.hasCase());
    QCOMPARE(c.window->models().document.image()->geometry.size[2], kSlices);
  }

  void theTableShowsWhatTheSeriesAre() {
    const Folder folder;
    saveSeries(folder.path());
    saveSecond(folder.path());
    saveSeries(
        folder.path(),
        [](Slice& slice) {
          slice.series = "1.2.3.4.3000003";
          slice.instance += ".7";
          slice.position += 0.4 * slice.k * oblique().col(1);
          return true;
        },
        EXS_LittleEndianExplicit, "c");
    const auto entries = describeImages(folder.path());
    SeriesDialog dialog(entries, makeInlineJobRunner);
    auto* table = dialog.findChild<QTableWidget*>("seriesTable");
    QCOMPARE(table->rowCount(), 3);
    QCOMPARE(table->item(0, 3)->text(), QString("9 × 7 × 6"));
    QCOMPARE(table->item(1, 1)->text(), QString("phase"));
    for (int row = 0; row < 3; ++row) {
      QVERIFY(!table->item(row, 0)->icon().isNull());
    }
    auto* note = dialog.findChild<QLabel*>("seriesNote");
    auto* open = dialog.findChild<QPushButton*>("seriesOpen");
    QCOMPARE(dialog.chosen(), std::optional<std::size_t>(0));
    table->selectRow(1);
    QVERIFY(note->text().contains("slice is missing"));
    QVERIFY(open->isEnabled());
    table->selectRow(2);
    QVERIFY(note->text().contains("gantry tilt"));
    QVERIFY(!open->isEnabled() && !dialog.chosen());
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestSeries>(argc, argv); }
#include "tst_series.moc"
