// SPDX-License-Identifier: BSD-3-Clause
#include <QProcess>
#include <QTest>
#include <nlohmann/json.hpp>

#include "core/phantom/phantom.h"
#include "core/pipeline/report.h"
#include "io/recipe/command_line.h"
#include "io/recipe/methods_text.h"
#include "io/recipe/recipe_file.h"
#include "tests/core/random_parameters.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

Source tube(double originMm = 0.0) {
  PhantomParams params;
  params.kind = PhantomKind::Tube;
  params.size = {24, 24, 24};
  params.spacingMm = {0.5, 0.5, 0.5};
  params.radius = 2.0;
  Phantom phantom = makePhantom(params);
  phantom.image.geometry.origin.array() += originMm;
  return makeSource(std::move(phantom.image), "Mustermann^Erika");
}

/// The words that a shell makes of a line.
QStringList wordsOf(const std::string& line) {
  QProcess shell;
  shell.start("sh", {"-c", "for w in " + QString::fromStdString(line) +
                               "; do printf '%s\\n' \"$w\"; done"});
  if (!shell.waitForFinished()) return {};
  return QString::fromUtf8(shell.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts);
}

/// `text` with one value of it replaced.
std::string with(const std::string& text, const std::string& pointer, const nlohmann::json& value) {
  nlohmann::json json = nlohmann::json::parse(text);
  json[nlohmann::json::json_pointer(pointer)] = value;
  return json.dump();
}

}  // namespace

class TestRecipe : public QObject {
  Q_OBJECT

 private:
  Source source_ = tube();
  std::string text_ = recipeText(recipeOf(preset("angiomesh"), source_));

  static QString messageFor(const std::string& text) {
    return messageOf([&] { (void)recipeFromText(text, preset("angiomesh"), "it.json"); });
  }

 private Q_SLOTS:
  void everyFieldComesBack() {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Recipe recipe = recipeOf(randomParameters(seed), source_);
      const Recipe back = recipeFromText(recipeText(recipe), preset("thesis"), "it.json");
      for (const Field& field : parameterFields())
        QVERIFY2(field.get(back.params) == field.get(recipe.params), field.key.c_str());
      QCOMPARE(back.program, std::string(versionText()));
      QVERIFY(back.source && back.source->hash == source_.hash);
      QVERIFY(back.source->size == source_.image->geometry.size);
      QVERIFY(back.source->spacingMm == source_.image->geometry.spacing);
      QCOMPARE(recipeHash(back), recipeHash(recipe));
    }
  }

  void everythingIsInTheHash() {
    const Recipe recipe = recipeOf(preset("angiomesh"), source_);
    for (const Field& field : parameterFields()) {
      Recipe other = recipe;
      for (std::uint64_t seed = 1; field.get(other.params) == field.get(recipe.params); ++seed)
        field.put(other.params, randomValue(field, seed));
      QVERIFY2(recipeHash(other) != recipeHash(recipe), field.key.c_str());
    }
    QVERIFY(recipeHash(recipeOf(recipe.params, tube(1.0))) != recipeHash(recipe));
  }

  void aFileOfParametersAloneIsARecipe() {
    const Folder folder;
    save(folder / "p.json", R"({"seeds": {"least": 0.25}})");
    const Recipe recipe = readRecipe(folder / "p.json", preset("thesis"));
    QCOMPARE(recipe.params.seeds.least, 0.25);
    QCOMPARE(recipe.params.smooth.method, SmoothMethod::Taubin);
    QVERIFY(recipe.program.empty() && !recipe.source);
    QVERIFY(recipeWarnings(recipe, source_).empty());
  }

  void aPresetIsARecipeForAnyVolume() {
    const Folder folder;
    Preset legs{"Legs, \"1.5 T\"", "of our scanner", preset("peripheral-mra")};
    legs.params.thresholds.xi = 31.0;
    save(folder / "legs.preset.json", recipeText(recipeOf(legs)));
    const Recipe recipe = readRecipe(folder / "legs.preset.json", preset("thesis"));
    QVERIFY(recipe.params == legs.params);
    QVERIFY(!recipe.source && recipeWarnings(recipe, source_).empty());
    const Preset back = presetOf(recipe, folder / "legs.preset.json");
    QCOMPARE(back.name, legs.name);
    QCOMPARE(back.about, legs.about);
    QVERIFY(back.params == legs.params);
  }

  void aPresetIsMadeOfAnyRecipe() {
    for (const char* file : {"/a/legs.json", "legs.recipe.json", "legs.preset.json"}) {
      Parameters params = preset("ct");
      params.seeds.points = {1.0, 2.0, 3.0};
      params.preprocess.roi = {0.0, 0.0, 0.0, 1.0, 1.0, 1.0};
      params.thresholds.xi = 31.0;
      const Preset made = presetOf(recipeOf(params, source_), file);
      QCOMPARE(made.name, std::string("legs"));
      Parameters expected = preset("ct");
      expected.thresholds.xi = 31.0;
      QVERIFY(made.params == expected);
    }
    QCOMPARE(presetOf(Recipe(), ".json").name, std::string(".json"));
  }

  void badNamesOfPresetsAreRefused() {
    const std::string text = recipeText(recipeOf(Preset{"legs", "", {}}));
    const auto with = [&](const std::string& what, const std::string& by) {
      std::string bad = text;
      return bad.replace(bad.find(what), what.size(), by);
    };
    QVERIFY(messageFor(with("\"legs\"", "\"\"")).contains("preset.name is empty"));
    QVERIFY(messageFor(with("\"legs\"", "7")).contains("preset.name is no text"));
    QVERIFY(messageFor(with("\"about\"", "\"abut\"")).contains("preset.about is missing"));
  }

  void nothingTellsWhoseItIs() {
    QVERIFY(text_.find("Mustermann") == std::string::npos);
    QVERIFY(text_.find('/') == std::string::npos);
  }

  void badRecipesAreRefusedByName_data() {
    QTest::addColumn<QString>("pointer");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* pointer, const char* value, const char* says) {
      QTest::addRow("%s %s", pointer, value) << pointer << value << says;
    };
    row("/schema", "2", "newer Angiomesh (schema 2)");
    row("/schema", "0", "schema is not 1");
    row("/schema", "\"1\"", "schema is not 1");
    row("/schema", "null", "schema is not 1");
    row("/program", "2", "program is no text");
    row("/patient", "\"x\"", "patient is not known");
    row("/parameters", "[]", "parameters is no object");
    row("/parameters/seeds/points", "[1,2]", "seeds.points");
    row("/parameters/seeds/least", "\"much\"", "seeds.least");
    row("/parameters/seeds/none", "1", "there is no parameter 'seeds.none'");
    row("/parameters/ports/cuts", "[\"1,2,inlet\"]", "is no cut");
    row("/source", "1", "source is no object");
    row("/source/path", "\"x\"", "source.path is not known");
    row("/source/hash", "\"0123\"", "source.hash is no hash");
    row("/source/hash", "\"0123456789abcdeX\"", "source.hash is no hash");
    row("/source/size", "[1,2]", "source.size is no list of three numbers");
    row("/source/size/1", "1.5", "source.size[1] is no count");
    row("/source/size/1", "-3", "source.size[1] is no count");
    row("/source/spacingMm/2", "0", "source.spacingMm[2] is not above 0");
    row("/source/spacingMm/2", "\"1\"", "source.spacingMm[2] is no number");
  }

  void badRecipesAreRefusedByName() {
    QFETCH(QString, pointer);
    QFETCH(QString, value);
    QFETCH(QString, says);
    const QString message =
        messageFor(with(text_, pointer.toStdString(), nlohmann::json::parse(value.toStdString())));
    QVERIFY2(message.contains(says), qPrintable(message));
    // What a parameter says names itself; the file is named for the rest.
    QVERIFY2(pointer.startsWith("/parameters/") || message.contains("it.json"),
             qPrintable(message));
  }

  void whatIsCutShortIsRefused() {
    for (std::size_t n = 0; n < text_.size() - 2; ++n)
      QVERIFY2(!messageFor(text_.substr(0, n)).isEmpty(), std::to_string(n).c_str());
    for (const char* key : {"schema", "program", "parameters"}) {
      nlohmann::json json = nlohmann::json::parse(text_);
      json.erase(key);
      QVERIFY2(!messageFor(json.dump()).isEmpty(), key);
    }
    QVERIFY(!messageFor(std::string(100000, '[')).isEmpty());
  }

  void anotherVolumeIsAWarning() {
    Recipe recipe = recipeOf(preset("angiomesh"), source_);
    QVERIFY(recipeWarnings(recipe, source_).empty());
    const std::vector<std::string> other = recipeWarnings(recipe, tube(1.0));
    QCOMPARE(other.size(), std::size_t{1});
    QVERIFY(other.front().find("24 x 24 x 24 voxels of 0.5 x 0.5 x 0.5 mm") != std::string::npos);
    recipe.program = "0.0.1";
    const std::vector<std::string> both = recipeWarnings(recipe, tube(1.0));
    QVERIFY(both.size() == 2 && both.front().find("version 0.0.1") != std::string::npos);
  }

  void placesOutsideAnotherVolumeAreNamed_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("inside");
    QTest::addColumn<QString>("outside");
    const auto row = [](const char* key, const char* in, const char* out) {
      QTest::newRow(key) << key << in << out;
    };
    row("seeds.points", "1,2,3,2,3,4", "1,2,3,1,2,-40");
    row("segmentation.drop", "1,2,3", "1,2,30");
    row("ports.cuts", "1,2,3,inlet", "1,2,3,inlet;1,-20,3,outlet");
    row("ports.names", "border_1=a;1,2,3=b", "90,2,3=b");
  }

  void placesOutsideAnotherVolumeAreNamed() {
    QFETCH(QString, key);
    QFETCH(QString, inside);
    QFETCH(QString, outside);
    Recipe recipe = recipeOf(preset("angiomesh"), source_);
    const Source other = tube(1.0);
    setFieldFromText(recipe.params, key.toStdString(), inside.toStdString());
    QCOMPARE(recipeWarnings(recipe, other).size(), std::size_t{1});
    setFieldFromText(recipe.params, key.toStdString(), outside.toStdString());
    const QString message = messageOf([&] { (void)recipeWarnings(recipe, other); });
    QVERIFY2(message.contains("--set " + key + "=none"), qPrintable(message));
    // Of its own volume the steps themselves say what is wrong.
    QVERIFY(recipeWarnings(recipe, source_).empty());
  }

  void theNearestPresetLeavesLeastToSay() {
    for (const std::string& name : presetNames()) {
      Parameters params = preset(name);
      setFieldFromText(params, "seeds.points", "1,2,3");
      QCOMPARE(nearestPreset(params).name, name);
      QVERIFY(nearestPreset(params).others.empty());
      params.levelset.gamma = 0.61;
      QCOMPARE(nearestPreset(params).others.size(), std::size_t{1});
    }
    QCOMPARE(commandLine(preset("angiomesh")), std::string("angiomesh-cli run SCAN -o OUT"));
    QCOMPARE(commandLine(preset("ct")), std::string("angiomesh-cli run SCAN -o OUT --preset ct"));
  }

  void aShellTakesTheLineApartAsItWasMeant() {
    Parameters params = preset("ct");
    setFieldFromText(params, "seeds.points", "-1,2.5,3,4,5,1e-7");
    setFieldFromText(params, "ports.cuts", "1, 2, 3, inlet;-1,2,3,0,0,1,out-2");
    setFieldFromText(params, "ports.names", "border_1=left");
    setFieldFromText(params, "preprocess.roi", "-10,-10,-10,10,10,10");
    setFieldFromText(params, "preprocess.clamp.upper", "600.5");
    QCOMPARE(wordsOf(commandLine(params)), QStringList({"angiomesh-cli",
                                                        "run",
                                                        "SCAN",
                                                        "-o",
                                                        "OUT",
                                                        "--preset",
                                                        "ct",
                                                        "--set",
                                                        "preprocess.clamp.upper=600.5",
                                                        "--roi",
                                                        "-10,-10,-10,10,10,10",
                                                        "--seed",
                                                        "-1,2.5,3",
                                                        "--seed",
                                                        "4,5,1e-07",
                                                        "--cut",
                                                        "1, 2, 3, inlet",
                                                        "--cut",
                                                        "-1,2,3,0,0,1,out-2",
                                                        "--name-port",
                                                        "border_1=left"}));
  }

  /// Else a recipe would not repeat it: no parameter tells when somebody pressed the key.
  void anEvolutionThatWasEndedByHandIsRepeated() {
    Pipeline pipeline(source_);
    RunOptions options;
    options.control = std::make_shared<EvolutionControl>();
    options.control->finishNow = true;
    Parameters params = preset("thesis");
    const RunResult byHand = pipeline.run(params, options);
    QVERIFY(endedByHand(*byHand.evolve, params));
    const Recipe recipe = recipeOf(params, source_, byHand.evolve.get());
    Pipeline again(source_);
    const RunResult repeated = again.run(recipe.params);
    QCOMPARE(meshHash(*repeated.smoothed), meshHash(*byHand.smoothed));
    Pipeline otherwise(source_);
    QVERIFY(meshHash(*otherwise.run(params).smoothed) != meshHash(*byHand.smoothed));
  }

  void theMethodsAreThoseOfTheRun() {
    Parameters params = preset("angiomesh");
    params.levelset.gamma = 0.625;
    params.smooth.mu = -0.51;  // of no effect with keep-wall
    setFieldFromText(params, "seeds.points", "0,0,0");
    Pipeline pipeline(source_);
    const RunResult run = pipeline.run(params);
    const std::string text = methodsText(run);
    for (const std::string& told :
         {std::string("Angiomesh ") + versionText(), std::string("24 x 24 x 24 voxels of 0.5"),
          std::string("preset angiomesh, but for levelset.gamma = 0.625."),
          std::string("seeds (1)"), std::to_string(run.smoothed->triangles.size()) + " triangles",
          std::string("advancing front"), source_.hash, recipeHash(recipeOf(params, source_)),
          meshHash(*run.smoothed), std::string("\n[2] Frangi")})
      QVERIFY2(text.find(told) != std::string::npos, (told + " in " + text).c_str());
    for (const char* untold : {"Mustermann", "smooth.mu", "Lorensen", "Taubin"})
      QVERIFY2(text.find(untold) == std::string::npos, untold);
    RunOptions until;
    until.until = Step::Evolve;
    QCOMPARE(methodsText(pipeline.run(params, until)), std::string());
    params.surface.method = SurfaceMethod::MarchingCubes;
    params.smooth.method = SmoothMethod::Taubin;
    const std::string other = methodsText(pipeline.run(params));
    for (const char* told : {"Lorensen", "Taubin", "mu = -0.51", "surface.method = marching-cubes"})
      QVERIFY2(other.find(told) != std::string::npos, other.c_str());
    QVERIFY(other.find("advancing front") == std::string::npos);
  }
};

QTEST_GUILESS_MAIN(TestRecipe)
#include "tst_recipe.moc"
