// SPDX-License-Identifier: BSD-3-Clause
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QJsonArray>
#include <QPlainTextEdit>
#include <QProcess>

#include "core/pipeline/report.h"
#include "io/volume/image_write.h"
#include "tests/app/cli_process.h"
#include "tests/gui/port_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

const QString kPerson = QStringLiteral("Mustermann_Erika");

/// A window with two tubes from a file of a person's name: one of them is left out, the other one
/// has a seed by hand, a cut, and a name for an opening.
struct EditedCase : WindowCase {
  EditedCase() {
    openPath = folder.filePath(kPerson + ".nrrd");
    writeVolume(*twoTubes().image, openPath.toStdString());
    trigger(*this, "open");
    click(find<QPushButton>("run"));
    models().document.addSeed(insideOf(models(), 0.25));
    models().results.setComponentTicked(1, false);
    click(find<QPushButton>("run"));
    cutAt(*this, 0.5);
    PortParams ports = models().document.parameters().ports;
    ports.names = {"border_1=inlet"};
    (void)models().document.setPorts(ports, "rename");
    models().corrections.setRadius(2.0);
    models().corrections.paint(true, {insideOf(models(), 0.3)});
    models().corrections.setToEdge(false);
    models().corrections.paint(true, {insideOf(models(), 0.3), insideOf(models(), 0.35)});
    click(find<QPushButton>("run"));
  }

  [[nodiscard]] std::string hash() { return meshHash(*models().results.mesh(MeshKind::Exported)); }
  QString copied(const char* action) {
    QGuiApplication::clipboard()->clear();
    trigger(*this, action);
    return QGuiApplication::clipboard()->text();
  }
  QString log() { return find<QPlainTextEdit>("log")->toPlainText(); }
  /// Of a run that was made in `name`.
  [[nodiscard]] std::string hashIn(const QString& name) const {
    return readJson(folder.filePath(name + "/report.json"))
        .value("mesh_hash")
        .toString()
        .toStdString();
  }
  CliResult cli(const QStringList& arguments) { return runCli(folder.path(), arguments); }
};

}  // namespace

/// A case leaves the window as a file, a line or a paragraph, and comes to the same mesh elsewhere.
class TestRecipeExport : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theCommandLineProgramMakesTheSameMesh() {
    EditedCase c;
    const Parameters& params = c.models().document.parameters();
    QVERIFY(params.seeds.points.size() == 3 && params.segmentation.drop.size() == 3);
    QVERIFY(!params.segmentation.corrections.empty());
    QVERIFY(params.ports.cuts.size() == 1 && c.models().results.meshFresh());
    c.savePath = c.folder.filePath("case");
    trigger(c, "exportRecipe");
    const QByteArray recipe = readBytes(c.folder.filePath("case.recipe.json"));
    QVERIFY(!recipe.isEmpty() && !recipe.contains("Mustermann"));
    QVERIFY(c.log().contains("case.recipe.json") && !c.log().contains(c.folder.path()));

    const CliResult run =
        c.cli({"run", kPerson + ".nrrd", "--recipe", "case.recipe.json", "-o", "out"});
    QVERIFY2(run.code == 0, run.errors.constData());
    QVERIFY2(!run.errors.contains("another volume"), run.errors.constData());
    QCOMPARE(c.hashIn("out"), c.hash());
    QCOMPARE(readBytes(c.folder.filePath("out/recipe.json")), recipe);
    QCOMPARE(readJson(c.folder.filePath("out/report.json"))
                 .value("ports")
                 .toArray()
                 .first()
                 .toObject()
                 .value("name")
                 .toString()
                 .toStdString(),
             c.models().results.ports(MeshKind::Exported).front().name);

    const QString methods = c.copied("copyMethods");
    QCOMPARE(methods.toUtf8(), readBytes(c.folder.filePath("out/methods.txt")));
    QVERIFY(methods.contains("corrections of the segmentation"));
    QVERIFY(methods.contains(QString::fromStdString(c.hash())));
    QVERIFY(!methods.contains("Mustermann") && !methods.contains(c.folder.path()));

    QString line = c.copied("copyCommandLine");
    QVERIFY2(!line.contains("Mustermann") && !line.contains(c.folder.path()), qPrintable(line));
    QVERIFY(line.startsWith("angiomesh-cli run SCAN -o OUT --seed "));
    line.replace("angiomesh-cli", "'" ANGIOMESH_CLI "'").replace("SCAN", kPerson + ".nrrd");
    line.replace("OUT", "line");
    QProcess shell;
    shell.setWorkingDirectory(c.folder.path());
    shell.start("sh", {"-c", line});
    const CliResult byLine = finish(shell);
    QVERIFY2(byLine.code == 0, byLine.errors.constData());
    QCOMPARE(c.hashIn("line"), c.hash());
    QCOMPARE(readBytes(c.folder.filePath("line/recipe.json")), recipe);
  }

  void aNewNameOfAnOpeningIsInTheRecipeAtOnce() {
    EditedCase c;
    const QString before = c.copied("copyMethods");
    PortParams ports = c.models().document.parameters().ports;
    ports.names = {"border_1=trunk"};
    (void)c.models().document.setPorts(ports, "rename");
    QVERIFY(c.copied("copyCommandLine").contains(" --name-port border_1=trunk "));
    const QString after = c.copied("copyMethods");
    QVERIFY(after != before && c.models().results.meshFresh());
    QCOMPARE(after.section("mesh ", -1), before.section("mesh ", -1));
  }

  void whatIsNotThereCannotBeTaken() {
    WindowCase c;
    const auto enabled = [&](const char* name) {
      return c.window->findChild<QAction*>(QLatin1String(name))->isEnabled();
    };
    for (const char* name : {"exportRecipe", "copyCommandLine", "copyMethods"})
      QVERIFY2(!enabled(name), name);
    c.models().files.take(twoTubes());
    QVERIFY(enabled("exportRecipe") && enabled("copyCommandLine") && !enabled("copyMethods"));
    c.savePath = c.folder.filePath("none/case.recipe.json");
    trigger(c, "exportRecipe");
    QVERIFY(c.find<QPlainTextEdit>("log")->toPlainText().contains("Cannot write the recipe"));
    c.click(c.find<QPushButton>("run"));
    QVERIFY(enabled("copyMethods"));
    c.models().document.setField("smooth.method", std::string("none"));
    trigger(c, "copyMethods");
    QVERIFY(c.find<QPlainTextEdit>("log")->toPlainText().contains("earlier parameters"));
  }
};

int main(int argc, char** argv) { return runWindowTests<TestRecipeExport>(argc, argv); }
#include "tst_recipe_export.moc"
