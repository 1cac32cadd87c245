// SPDX-License-Identifier: BSD-3-Clause
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QPushButton>

#include "gui/job/display_facts.h"
#include "gui/model/modality_habits.h"
#include "tests/gui/window_case.h"
#include "tests/io/dicom_writer.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

constexpr double kIntercept = -1024.0;

/// A series in HU, or of another modality; its files state windows, or none.
struct Series {
  explicit Series(const char* modality, bool windows = true) {
    saveSeries(folder.path(), [&](Slice& slice) {
      slice.rescaled = true;
      slice.intercept = kIntercept;
      slice.edit = [modality, windows](DcmDataset& data) {
        putText(data, DCM_Modality, modality);
        if (windows) return;
        delete data.remove(DCM_WindowCenter);
        delete data.remove(DCM_WindowWidth);
      };
      return true;
    });
  }
  const Folder folder;
};

void open(WindowCase& c, const Series& series) {
  c.window->open(QString::fromStdString(series.folder.path().string()));
  QTRY_VERIFY(c.models().document.hasCase() && !c.models().files.loading());
}

SliceView* axial(WindowCase& c) { return c.window->views().slice(2); }

WindowLevel shown(WindowCase& c) { return {axial(c)->windowWidth(), axial(c)->windowLevel()}; }

void key(WindowCase& c, Qt::Key key) { QTest::keyClick(axial(c), key); }

QAction* action(WindowCase& c, const char* name) {
  return c.window->findChild<QAction*>(QLatin1String(name));
}

constexpr WindowLevel kFile{599.0, 299.5};  // 600 / 300, less the half and the one of PS3.3

}  // namespace

class TestWindowPresets : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void keysChooseWindowsOfCt() {
    const Series series("CT");
    WindowCase c;
    open(c, series);
    QCOMPARE(shown(c), kFile);
    QVERIFY(action(c, "windowFile")->isChecked());
    key(c, Qt::Key_3);
    QCOMPARE(shown(c), WindowLevel(600.0, 200.0));
    QVERIFY(action(c, "windowCta")->isChecked() && !action(c, "windowFile")->isChecked());
    key(c, Qt::Key_4);
    QCOMPARE(shown(c), WindowLevel(400.0, 40.0));
    key(c, Qt::Key_5);
    QCOMPARE(shown(c), WindowLevel(80.0, 40.0));
    key(c, Qt::Key_6);
    QCOMPARE(shown(c), WindowLevel(1500.0, 300.0));
    QCOMPARE(c.window->views().slice(0)->windowWidth(), 1500.0);
    key(c, Qt::Key_1);
    QCOMPARE(shown(c), kFile);
    key(c, Qt::Key_1);  // again: nothing changes
    QCOMPARE(shown(c), kFile);
    QVERIFY(action(c, "windowFile")->isChecked());
  }

  void allWindowsOfTheFileAreOffered() {
    const Folder folder;
    saveSeries(folder.path(), [](Slice& slice) {
      slice.rescaled = true;
      slice.intercept = kIntercept;
      slice.edit = [](DcmDataset& data) {
        putText(data, DCM_Modality, "CT");
        putText(data, DCM_WindowCenter, "300\\40\\-600");
        putText(data, DCM_WindowWidth, "600\\401\\1501");
        putText(data, DCM_WindowCenterWidthExplanation, "FIRST\\SOFT & THIN\\LUNG");
      };
      return true;
    });
    WindowCase c;
    QVERIFY(!c.find<QMenu>("otherWindows")->menuAction()->isEnabled());
    c.window->open(QString::fromStdString(folder.path().string()));
    QTRY_VERIFY(c.models().document.hasCase() && !c.models().files.loading());
    QCOMPARE(shown(c), kFile);
    auto* others = c.find<QMenu>("otherWindows");
    QVERIFY(others->menuAction()->isEnabled());
    QCOMPARE(others->actions().size(), 2);
    QCOMPARE(others->actions()[0]->text(), QString("SOFT && THIN (400 / 39.5)"));
    others->actions()[1]->trigger();
    QCOMPARE(shown(c), WindowLevel(1500.0, -600.5));
    QVERIFY(others->actions()[1]->isChecked() && !others->actions()[0]->isChecked());
    QVERIFY(!action(c, "windowFile")->isChecked());
    c.state().setLayer(Layer::Vesselness);
    QVERIFY(!others->menuAction()->isEnabled());
  }

  void percentilesLeaveFewVoxelsOut() {
    const Series series("MR", false);
    WindowCase c;
    open(c, series);
    const std::vector<double> ends = percentiles(*c.models().document.image(), {0.01, 0.998});
    const WindowLevel expected(ends[1] - ends[0], 0.5 * (ends[0] + ends[1]));
    QCOMPARE(shown(c), expected);
    c.drag(axial(c), {100, 100}, {160, 130});
    QVERIFY(shown(c) != expected);
    key(c, Qt::Key_2);
    QCOMPARE(shown(c), expected);
  }

  void windowsThatMakeNoSenseAreNotOffered() {
    const Series series("MR", false);
    WindowCase c;
    QVERIFY(!action(c, "windowPercentiles")->isEnabled());
    QVERIFY(!action(c, "setWindow")->isEnabled());
    open(c, series);
    QVERIFY(!action(c, "windowFile")->isEnabled());
    QVERIFY(action(c, "windowPercentiles")->isEnabled());
    const WindowLevel before = shown(c);
    for (const Qt::Key which : {Qt::Key_1, Qt::Key_3, Qt::Key_4, Qt::Key_5, Qt::Key_6}) {
      key(c, which);
      QCOMPARE(shown(c), before);
    }
    // A file that tells no modality is judged by its values.
    DisplayFacts facts;
    facts.values = {-1000.0, 2000.0};
    QVERIFY(presetWindow(WindowPreset::Bone, facts).has_value());
    facts.values = {0.0, 1.0};
    QVERIFY(!presetWindow(WindowPreset::Brain, facts).has_value());
    c.state().setLayer(Layer::Vesselness);
    QVERIFY(!action(c, "windowPercentiles")->isEnabled());
  }

  void menusOfSlicesOfferThem() {
    const Series series("CT");
    WindowCase c;
    open(c, series);
    QTest::mouseClick(axial(c), Qt::RightButton, {}, axial(c)->rect().center());
    auto* menu = c.find<QMenu>("portMenu");
    QVERIFY(menu && menu->actions().contains(action(c, "windowMenu")));
    QMenu* windows = action(c, "windowMenu")->menu();
    QVERIFY(windows->actions().contains(action(c, "windowBrain")));
    QTest::keyClick(menu, Qt::Key_Up);
    QTest::keyClick(menu, Qt::Key_Right);
    QTRY_VERIFY(windows->isVisible());
    QTest::mouseClick(windows, Qt::LeftButton, {},
                      windows->actionGeometry(action(c, "windowBrain")).center());
    QCOMPARE(shown(c), WindowLevel(80.0, 40.0));
  }

  void numbersAreEntered() {
    const Series series("CT");
    WindowCase c;
    open(c, series);
    key(c, Qt::Key_W);
    auto* dialog = c.find<QDialog>("windowDialog");
    QVERIFY(dialog && QTest::qWaitForWindowExposed(dialog));
    QApplication::setActiveWindow(dialog);
    auto* window = dialog->findChild<QDoubleSpinBox*>("windowWidth");
    auto* level = dialog->findChild<QDoubleSpinBox*>("windowLevel");
    QTest::keyClicks(window, "350");
    QCOMPARE(shown(c), kFile);  // not while it is being typed
    QTest::keyClick(window, Qt::Key_Tab);
    QCOMPARE(shown(c), WindowLevel(350.0, kFile.second));
    QTest::keyClicks(level, "-25");
    QTest::keyClick(level, Qt::Key_Return);
    QCOMPARE(shown(c), WindowLevel(350.0, -25.0));
    QTRY_VERIFY(!c.find<QDialog>("windowDialog"));
    // It follows what happens elsewhere.
    QApplication::setActiveWindow(c.window.get());
    key(c, Qt::Key_W);
    dialog = c.find<QDialog>("windowDialog");
    QVERIFY(dialog);
    key(c, Qt::Key_5);
    QCOMPARE(dialog->findChild<QDoubleSpinBox*>("windowWidth")->value(), 80.0);
  }

  void nothingLeavesTheRangeOfTheLayer() {
    const Series series("CT");
    WindowCase c;
    open(c, series);
    const WindowLimits limits = c.state().windowLimits();
    const auto values = valueRange(*c.models().document.image());
    QCOMPARE(limits.least, static_cast<double>(values[0]));
    QCOMPARE(limits.greatest, static_cast<double>(values[1]));
    const double range = limits.greatest - limits.least;
    for (int i = 0; i < 60; ++i) c.drag(axial(c), {10, 10}, {260, 10});
    QCOMPARE(axial(c)->windowWidth(), 4.0 * range);
    QCOMPARE(c.state().windowLevel(), shown(c));
    for (int i = 0; i < 60; ++i) c.drag(axial(c), {260, 10}, {10, 260});
    QVERIFY(axial(c)->windowWidth() > 0.0 && axial(c)->windowWidth() < 0.001 * range);
    QCOMPARE(axial(c)->windowLevel(), limits.greatest + range);
    c.state().setWindowLevel(1e30, -1e30);
    QCOMPARE(shown(c), WindowLevel(4.0 * range, limits.least - range));
    key(c, Qt::Key_W);
    auto* dialog = c.find<QDialog>("windowDialog");
    auto* window = dialog->findChild<QDoubleSpinBox*>("windowWidth");
    window->selectAll();
    QTest::keyClicks(window, "0");
    QTest::keyClick(window, Qt::Key_Tab);
    QVERIFY(shown(c).first > 0.0);
    // Nor does what a case says.
    CaseView view;
    view.windowLevels["source"] = {1e30, 1e30};
    c.state().take(view);
    QCOMPARE(shown(c), WindowLevel(4.0 * range, limits.greatest + range));
  }

  void numbersAreRememberedOfCt() {
    const Series series("CT"), other("MR");
    {
      WindowCase c;
      open(c, series);
      key(c, Qt::Key_3);
    }
    {
      WindowCase c;
      open(c, series);
      QCOMPARE(shown(c), WindowLevel(600.0, 200.0));
      c.drag(axial(c), {100, 100}, {140, 120});
    }
    WindowCase c;
    open(c, series);
    QVERIFY(shown(c).first > 600.0 && shown(c).second > 200.0);
    QVERIFY(shown(c).first < 1200.0);
    open(c, other);
    QTRY_COMPARE(shown(c), kFile);  // another modality, other habits
    open(c, series);
    QTRY_VERIFY(shown(c).first > 600.0);
    QTest::keyClick(axial(c), Qt::Key_W, Qt::ControlModifier);
    QCOMPARE(shown(c), kFile);
    open(c, other);
    open(c, series);
    QCOMPARE(shown(c), kFile);  // "reset" forgot it
  }

  void onlyThePresetIsRememberedOfMr() {
    const Series series("MR");
    WindowLevel percentiles;
    {
      WindowCase c;
      open(c, series);
      c.drag(axial(c), {100, 100}, {140, 120});
      QVERIFY(shown(c) != kFile);
    }
    {
      WindowCase c;
      open(c, series);
      QCOMPARE(shown(c), kFile);
      key(c, Qt::Key_2);
      percentiles = shown(c);
      QVERIFY(percentiles != kFile);
      c.drag(axial(c), {100, 100}, {140, 120});
    }
    WindowCase c;
    open(c, series);
    QCOMPARE(shown(c), percentiles);
  }

  void whatWasWrittenElsewhereIsNoWindow() {
    DisplayFacts facts;
    facts.modality = "CT";
    facts.values = {-1000.0, 2000.0};
    for (const char* words : {"", "600", "a b", "600 200 40", "-5 40", "nan 40", "600 inf"}) {
      QSettings().setValue("modality/CT/window", words);
      QVERIFY2(!windowFor(facts), words);
    }
    QSettings().setValue("modality/CT/window", "1e9 40");
    QCOMPARE(windowFor(facts)->first, 12000.0);
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestWindowPresets>(argc, argv); }
#include "tst_window_presets.moc"
