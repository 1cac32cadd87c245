// SPDX-License-Identifier: BSD-3-Clause
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QToolButton>

#include "gui/dialog/preset_dialog.h"
#include "gui/panel/field_editor.h"
#include "tests/gui/window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

QToolButton* resetOf(WindowCase& c, const char* key) {
  return c.find<FieldEditor>(qPrintable(QStringLiteral("field:") + key))
      ->findChild<QToolButton*>("reset");
}

/// Fills the dialog in that "savePreset" opens. @returns whether it closed
bool save(WindowCase& c, const QString& name, const QString& about = {}) {
  c.window->findChild<QAction*>("savePreset")->trigger();
  auto* dialog = c.find<PresetDialog>("presetDialog");
  dialog->findChild<QLineEdit*>("presetName")->setText(name);
  dialog->findChild<QLineEdit*>("presetAbout")->setText(about);
  dialog->findChild<QPushButton*>("presetSave")->click();
  const bool closed = !dialog->isVisible();
  dialog->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  return closed;
}

}  // namespace

/// Presets in the window: chosen, changed, reset, saved, exported and imported.
class TestPresetsWindow : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(settings_.isValid());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings_.path());
  }
  void init() { QSettings().clear(); }

  void eachFieldKnowsItsPreset() {
    WindowCase c;
    c.models().live.setOn(false);
    QComboBox* chooser = c.find<QComboBox>("preset");
    chooser->setCurrentText("brain-tof");
    Q_EMIT chooser->textActivated("brain-tof");
    QCOMPARE(*c.models().document.parameters().vesselness.sigmaMaxMm, 3.0);
    QVERIFY(chooser->toolTip().contains("6 mm"));
    QToolButton* xi = resetOf(c, "levelset.xi");
    QToolButton* shortest = resetOf(c, "segmentation.minLengthMm");
    QToolButton* thickest = resetOf(c, "vesselness.sigmaMaxMm");
    for (const QToolButton* button : {xi, shortest, thickest}) QVERIFY(button->isHidden());

    c.models().document.setField("levelset.xi", 35.0);
    c.models().document.setField("segmentation.minLengthMm", 2.0);
    c.models().document.setField("vesselness.sigmaMaxMm", 1.5);
    QCOMPARE(chooser->currentIndex(), -1);
    QCOMPARE(chooser->placeholderText(), QString("brain-tof, changed"));
    for (const QToolButton* button : {xi, shortest, thickest}) QVERIFY(!button->isHidden());
    // As the form shows it: a diameter.
    QVERIFY2(thickest->toolTip().contains("6 mm") && thickest->toolTip().contains("brain-tof"),
             qPrintable(thickest->toolTip()));
    auto* more = c.find<QFrame>("step:surface")->findChild<QToolButton*>("more");
    const auto evolve = c.find<QFrame>("step:evolve")->findChild<QToolButton*>("more");
    QVERIFY(more->text() == "More" || evolve->text() == "More");

    for (QToolButton* button : {xi, shortest, thickest}) button->click();
    QCOMPARE(chooser->currentText(), QString("brain-tof"));
    QVERIFY(xi->isHidden());
    c.models().document.undoStack()->undo();
    QVERIFY(!thickest->isHidden());
  }

  void fieldsOutOfSightAreCounted() {
    WindowCase c;
    c.models().live.setOn(false);
    auto* more = c.find<QFrame>("step:evolve")->findChild<QToolButton*>("more");
    QCOMPARE(more->text(), QString("More"));
    c.models().document.setField("levelset.stepVoxels", 0.3);
    c.models().document.setField("levelset.checkEvery", std::int64_t(10));
    QCOMPARE(more->text(), QString("More (changed: 2)"));
    more->click();
    QCOMPARE(more->text(), QString("Less"));
    resetOf(c, "levelset.stepVoxels")->click();
    more->click();
    QCOMPARE(more->text(), QString("More (changed: 1)"));
  }

  void parametersBecomeAPreset() {
    WindowCase c;
    c.models().live.setOn(false);
    auto* saving = c.window->findChild<QAction*>("savePreset");
    QVERIFY(!saving->isEnabled());  // they are those of a preset
    c.models().document.setField("levelset.xi", 35.0);
    QVERIFY(saving->isEnabled());
    QVERIFY(!save(c, "ct"));
    QVERIFY(save(c, "Scanner B", "of the second floor"));
    QComboBox* chooser = c.find<QComboBox>("preset");
    QCOMPARE(chooser->currentText(), QString("Scanner B"));
    QCOMPARE(chooser->toolTip(), QString("of the second floor"));
    QCOMPARE(chooser->itemText(chooser->count() - 1), QString("Scanner B"));
    QVERIFY(chooser->itemText(chooser->count() - 2).isEmpty());  // a line between

    c.models().document.setField("levelset.xi", 36.0);
    saving->trigger();
    auto* dialog = c.find<PresetDialog>("presetDialog");
    QCOMPARE(dialog->findChild<QLineEdit*>("presetName")->text(), QString("Scanner B"));
    QVERIFY(!dialog->findChild<QLabel*>("presetNote")->text().isEmpty());
    dialog->findChild<QPushButton*>("presetSave")->click();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCOMPARE(c.models().presets.find("Scanner B")->params.thresholds.xi, 36.0);

    auto* removing = c.window->findChild<QAction*>("removePreset");
    removing->trigger();
    QVERIFY(c.answers.asked.contains("removePreset Scanner B"));
    QVERIFY(c.models().presets.find("Scanner B"));
    c.answers.replace = true;
    removing->trigger();
    QVERIFY(!c.models().presets.find("Scanner B"));
    QVERIFY(!removing->isEnabled());
    QCOMPARE(c.models().document.parameters().thresholds.xi, 36.0);
  }

  void presetsTravel() {
    const QString file = settings_.filePath("b.preset.json");
    {
      WindowCase c;
      c.models().live.setOn(false);
      c.models().document.setField("levelset.xi", 35.0);
      QVERIFY(save(c, "B/2", "it"));
      c.savePath = settings_.filePath("b");
      c.window->findChild<QAction*>("exportPreset")->trigger();
      QVERIFY(QFile::exists(file));
    }
    QSettings().clear();
    WindowCase c;
    c.models().live.setOn(false);
    c.openPath = file;
    auto* importing = c.window->findChild<QAction*>("importPreset");
    importing->trigger();
    QCOMPARE(c.models().presets.current(), QString("B/2"));
    QCOMPARE(c.models().document.parameters().thresholds.xi, 35.0);
    QCOMPARE(c.models().presets.find("B/2")->about, std::string("it"));

    // Again: nothing to ask. Of another content: only if the user wants it.
    importing->trigger();
    QVERIFY(c.answers.asked.isEmpty());
    write(file, read(file).replace("35", "45"));
    importing->trigger();
    QVERIFY(c.answers.asked.contains("replacePreset B/2"));
    QCOMPARE(c.models().presets.find("B/2")->params.thresholds.xi, 35.0);
    c.answers.replace = true;
    importing->trigger();
    QCOMPARE(c.models().document.parameters().thresholds.xi, 45.0);

    // A name of the program's is not taken from it.
    write(file, read(file).replace("B/2", "ct"));
    importing->trigger();
    QVERIFY(c.models().presets.isOwn("ct (imported)"));
    QVERIFY(c.models().presets.find("ct")->params == preset("ct"));

    write(file, "{ no");
    const std::size_t before = c.models().presets.all().size();
    importing->trigger();
    QCOMPARE(c.models().presets.all().size(), before);
    const QString log = c.find<QPlainTextEdit>("log")->toPlainText();
    QVERIFY2(log.contains("b.preset.json") && !log.contains(settings_.path()), qPrintable(log));
  }

 private:
  static QByteArray read(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  static void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
  }

  QTemporaryDir settings_;
};

QTEST_MAIN(TestPresetsWindow)
#include "tst_presets_window.moc"
