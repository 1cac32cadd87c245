// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>

#include "core/parameters/field.h"
#include "core/pipeline/report.h"
#include "io/recipe/command_line.h"
#include "io/recipe/recipe_file.h"
#include "io/scan/image_io.h"
#include "tests/app/cli_run.h"
#include "tests/core/random_parameters.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// Parameters that a run up to the preprocessing takes.
Parameters usableParameters(std::uint64_t seed) {
  Parameters params = randomParameters(seed);
  params.preprocess.clampLower.reset();
  params.preprocess.clampUpper.reset();
  params.preprocess.roi = std::array<double, 6>{-10.25, -9, -8, 10, 9.5, 8};
  params.seeds.automatic = true;
  for (const Field& field : parameterFields()) pushPartners(params, field);
  return params;
}

}  // namespace

// One file, or one line, from which a run is repeated.
class TestCliRecipe : public QObject, CliRun {
  Q_OBJECT

 private:
  Recipe recipe_;
  Source source_;

  /// What a shell makes of the line, with a volume and a folder in their places.
  CliResult shell(QString line, const QString& out, const QString& more) {
    line.replace("angiomesh-cli", "'" ANGIOMESH_CLI "'");
    line.replace(" SCAN ", " p/image.mha ").replace(" OUT", " " + out + more);
    QProcess process;
    process.setWorkingDirectory(dir.path());
    process.start("sh", {"-c", line});
    return finish(process);
  }

 private Q_SLOTS:
  void initTestCase() {
    makeRun();
    recipe_ = readRecipe(nativePath(at("out/recipe.json")), {});
    source_ = makeSource(readImage(nativePath(at("p/image.mha"))).image, "it");
  }

  void aRunSaysWhatItWasMadeOf() {
    QCOMPARE(recipe_.source->hash, source_.hash);
    QCOMPARE(readBytes(at("out/recipe.json")).toStdString(),
             recipeText(recipeOf(preset("angiomesh"), source_)));
    const QByteArray methods = readBytes(at("out/methods.txt"));
    const QByteArray hash = readJson(at("out/report.json")).value("mesh_hash").toString().toUtf8();
    QCOMPARE(hash.size(), 16);
    QVERIFY(methods.contains("mesh " + hash + "."));
    QVERIFY(methods.contains("recipe " + QByteArray::fromStdString(recipeHash(recipe_))));
    QVERIFY(!methods.contains(dir.path().toUtf8()) && !methods.contains("image.mha"));
  }

  void theRecipeGivesTheSameMesh() {
    QVERIFY(
        cli({"--threads", "1", "run", "p/image.mha", "--recipe", "out/recipe.json", "-o", "again"})
            .code == 0);
    for (const char* file : {"vessels.ply", "vessels.stl", "recipe.json", "methods.txt"}) {
      QVERIFY(!readBytes(at(QString("out/") + file)).isEmpty());
      QCOMPARE(readBytes(at(QString("again/") + file)), readBytes(at(QString("out/") + file)));
    }
  }

  void theLineGivesTheSameParameters() {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const Parameters params = usableParameters(seed);
      const QString out = QString::number(seed);
      const CliResult run =
          shell(QString::fromStdString(commandLine(params)), "line" + out, " --until preprocess");
      QVERIFY2(run.code == 0, run.errors.constData());
      QCOMPARE(readBytes(at("line" + out + "/recipe.json")).toStdString(),
               recipeText(recipeOf(params, source_)));
    }
  }

  void anotherVolumeIsSaidAndTaken() {
    QVERIFY(cli({"phantom", "tube", "--size", "36", "-o", "q"}).code == 0);
    const QStringList other{"run",     "q/image.mha", "--recipe", "out/recipe.json",
                            "--until", "preprocess",  "-o"};
    const CliResult run = cli(other + QStringList{"other"});
    QVERIFY2(run.code == 0, run.errors.constData());
    QVERIFY2(run.errors.contains("made for another volume, of 40 x 40 x 40 voxels"),
             run.errors.constData());
    const CliResult outside = cli(other + QStringList{"none", "--seed", "0,0,900"});
    QCOMPARE(outside.code, 2);
    QVERIFY2(outside.errors.contains("--set seeds.points=none"), outside.errors.constData());
    QVERIFY(!QDir(at("none")).exists());
    const CliResult own = cli({"run", "p/image.mha", "--recipe", "out/recipe.json", "--until",
                               "preprocess", "-o", "own"});
    QVERIFY2(own.code == 0 && own.errors.isEmpty(), own.errors.constData());
  }

  void badRecipesEndInALine() {
    const QByteArray good = readBytes(at("out/recipe.json"));
    const auto refuse = [&](const QByteArray& bytes) {
      QFile file(at("bad.json"));
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
      file.close();
      const CliResult run = cli({"run", "p/image.mha", "--recipe", "bad.json", "-o", "bad"});
      QVERIFY(!run.crashed);
      QCOMPARE(run.code, 2);
      QCOMPARE(run.errorLines().size(), 1);
      QVERIFY(!QDir(at("bad")).exists());
    };
    refuse(good.left(good.size() / 2));
    refuse({});
    refuse(QByteArray(good).replace("\"schema\": 1", "\"schema\": 2"));
    refuse(QByteArray(good).replace("\"gamma\"", "\"gamme\""));
    refuse(QByteArray(good).replace("\"hash\"", "\"path\""));
  }
};

QTEST_GUILESS_MAIN(TestCliRecipe)
#include "tst_cli_recipe.moc"
