// SPDX-License-Identifier: BSD-3-Clause
#include <QCoreApplication>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/parameters/field.h"
#include "gui/model/case_models.h"
#include "gui/model/modality_habits.h"
#include "io/recipe/recipe_file.h"
#include "tests/gui/small_case.h"

using namespace angiomesh;
using angiomesh::test::twoTubes;

/// The presets that can be chosen, and which of them the parameters come from.
class TestPresets : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(settings_.isValid());
    QCoreApplication::setOrganizationName("AngiomeshTest");
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings_.path());
  }
  void init() { QSettings().clear(); }

  void presetsKeepPlaces() {
    CaseModels models(makeInlineJobRunner);
    QCOMPARE(models.presets.current(), QString("angiomesh"));
    models.document.addSeed({1.0, 2.0, 3.0});
    QCOMPARE(models.presets.current(), QString("angiomesh"));
    models.presets.apply("thesis");
    QCOMPARE(models.presets.current(), QString("thesis"));
    QCOMPARE(models.document.seeds().size(), std::size_t(1));
    models.document.setField("levelset.d", 0.3);
    QCOMPARE(models.presets.current(), QString());
    models.document.undoStack()->undo();
    QCOMPARE(models.presets.current(), QString("thesis"));
  }

  void theBaseIsWhatWasLeftLast() {
    CaseModels models(makeInlineJobRunner);
    models.presets.apply("brain-tof");
    models.document.setField("levelset.xi", 35.0);
    // Nearer to the default than to brain-tof, but it was changed from brain-tof.
    models.document.setField("segmentation.minLengthMm", 0.0);
    models.document.setField("vesselness.sigmaMaxMm", FieldValue());
    QCOMPARE(models.presets.base().name, std::string("brain-tof"));
    models.document.setField("levelset.xi", 20.0);
    QCOMPARE(models.presets.base().name, std::string("angiomesh"));
  }

  void aCaseBeginsFromTheNearest() {
    CaseModels models(makeInlineJobRunner);
    models.presets.apply("thesis");
    models.document.setField("levelset.xi", 35.0);
    models.files.take(twoTubes());  // it takes over what was set before there was any volume
    QCOMPARE(models.presets.current(), QString());
    QCOMPARE(models.presets.base().name, std::string("thesis"));
    models.files.take(twoTubes(36));
    QCOMPARE(models.presets.base().name, std::string("angiomesh"));
  }

  void ownOnesAreKept() {
    {
      CaseModels models(makeInlineJobRunner);
      QSignalSpy changed(&models.presets, &PresetShelf::changed);
      models.document.addSeed({1.0, 2.0, 3.0});
      models.document.setField("levelset.xi", 35.0);
      const Parameters used = models.document.parameters();
      QCOMPARE(models.presets.keep({"  Scanner\n B ", "coil  of 32 channels", used}), QString());
      QCOMPARE(changed.count(), 1);
      QCOMPARE(models.presets.current(), QString("Scanner B"));
      QCOMPARE(models.presets.keep({"A", "", Parameters()}), QString());
      QCOMPARE(models.presets.current(), QString("Scanner B"));
    }
    CaseModels models(makeInlineJobRunner);
    const std::size_t shipped = shippedPresets().size();
    QCOMPARE(models.presets.all().size(), shipped + 2);
    QCOMPARE(models.presets.all()[shipped].name, std::string("A"));
    const Preset* own = models.presets.find("Scanner B");
    QVERIFY(own && models.presets.isOwn("Scanner B"));
    QCOMPARE(own->about, std::string("coil of 32 channels"));
    QCOMPARE(own->params.thresholds.xi, 35.0);
    QVERIFY(own->params.seeds.points.empty());

    Preset again = *own;
    again.params.thresholds.xi = 40.0;
    QCOMPARE(models.presets.keep(again), QString());
    QCOMPARE(models.presets.all().size(), shipped + 2);
    QCOMPARE(models.presets.find("Scanner B")->params.thresholds.xi, 40.0);

    models.presets.apply("Scanner B");
    models.presets.forget("Scanner B");
    QVERIFY(!models.presets.find("Scanner B"));
    QCOMPARE(models.document.parameters().thresholds.xi, 40.0);
    QCOMPARE(models.presets.base().name, std::string("angiomesh"));
    QCOMPARE(CaseModels(makeInlineJobRunner).presets.all().size(), shipped + 1);
  }

  void namesOfTheProgramAreNotTaken() {
    CaseModels models(makeInlineJobRunner);
    const std::size_t shipped = models.presets.all().size();
    QVERIFY(models.presets.keep({"ct", "", Parameters()}).contains("ct"));
    QVERIFY(!models.presets.keep({" \n", "", Parameters()}).isEmpty());
    QVERIFY(!models.presets.keep({std::string(41, 'a'), "", Parameters()}).isEmpty());
    QCOMPARE(models.presets.keep({std::string(40, 'a'), "", Parameters()}), QString());
    QCOMPARE(models.presets.all().size(), shipped + 1);
  }

  void whatAnotherWindowOrVersionKeptStays() {
    CaseModels one(makeInlineJobRunner);
    CaseModels other(makeInlineJobRunner);
    QCOMPARE(one.presets.keep({"one", "", Parameters()}), QString());
    QCOMPARE(other.presets.keep({"other", "", Parameters()}), QString());
    // A version to come knows a field more.
    const QString later = QString::fromStdString(recipeText(recipeOf(Preset{"later", "", {}})))
                              .replace("\"parameters\": {", "\"parameters\": {\"new.key\": 1,");
    QSettings().setValue("presets/3/recipe", later);
    QSettings().setValue("presets/size", 3);
    CaseModels models(makeInlineJobRunner);
    QVERIFY(models.presets.find("one") && models.presets.find("other"));
    QVERIFY(!models.presets.find("later"));
    QCOMPARE(models.presets.keep({"third", "", Parameters()}), QString());
    QStringList kept;
    for (const QString& key : QSettings().allKeys())
      if (key.startsWith("presets/")) kept << QSettings().value(key).toString();
    QCOMPARE(kept.size(), 5);  // four, and how many
    QVERIFY(kept.contains(later));
  }

  void presetsAreRememberedByModality() {
    CaseModels models(makeInlineJobRunner);
    const auto begins = [&](const char* modality) {
      return models.presets.beginningFor(modality).name;
    };
    QCOMPARE(begins("MR"), std::string("angiomesh"));
    QCOMPARE(begins("CT"), std::string("ct"));
    QCOMPARE(begins(""), std::string("angiomesh"));
    rememberPreset("CT", "thesis");
    QCOMPARE(begins("CT"), std::string("thesis"));
    QCOMPARE(begins("MR"), std::string("angiomesh"));
    rememberPreset("C/T\n", "ct");
    QCOMPARE(begins("CT"), std::string("ct"));
    rememberPreset("MR", "of another version");
    QCOMPARE(begins("MR"), std::string("angiomesh"));
    QCOMPARE(models.presets.keep({"mine", "", preset("thesis")}), QString());
    rememberPreset("MR", "mine");
    QCOMPARE(begins("MR"), std::string("mine"));
  }

  void whatIsChosenIsRemembered() {
    CaseModels models(makeInlineJobRunner);
    models.files.take(twoTubes());
    models.presets.apply("peripheral-mra");
    models.files.take(twoTubes(36));
    QCOMPARE(models.presets.current(), QString("peripheral-mra"));
  }

 private:
  QTemporaryDir settings_;
};

QTEST_GUILESS_MAIN(TestPresets)
#include "tst_presets.moc"
