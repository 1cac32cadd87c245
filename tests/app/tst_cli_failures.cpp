// SPDX-License-Identifier: BSD-3-Clause
#include <sys/stat.h>

#include <QElapsedTimer>
#include <QTest>
#include <array>
#include <csignal>
#include <limits>

#include "core/phantom/phantom.h"
#include "io/scan/image_io.h"
#include "io/volume/image_write.h"
#include "tests/app/cli_process.h"

using namespace angiomesh;

namespace {

void writeBytes(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  QCOMPARE(file.write(bytes), bytes.size());
}

QByteArray metaImage(const char* dimensions, const char* size, const QByteArray& voxels) {
  return QByteArray("ObjectType = Image\nNDims = ") + dimensions +
         "\nBinaryData = True\nDimSize = " + size +
         "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + voxels;
}

}  // namespace

// Bad input, bad parameters, bad output places: one line, the right exit code, nothing left behind.
class TestCliFailures : public QObject, CliFolder {
  Q_OBJECT

 private:
  void verifyRefused(const CliResult& result, const QStringList& filesBefore) {
    QVERIFY2(!result.crashed, result.errors.constData());
    const QList<QByteArray> lines = result.errorLines();
    QVERIFY2(lines.size() == 1, result.errors.constData());
    QVERIFY2(lines[0].startsWith("angiomesh-cli: error: "), lines[0].constData());
    QVERIFY2(lines[0].count(": ") >= 3, "what, where: what to do");
    QCOMPARE(result.code, 2);
    QCOMPARE(filesIn(dir.path()), filesBefore);
  }

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(dir.isValid());
    PhantomParams params;
    params.psf.kind = PointSpread::Kind::Subvoxels;
    params.kind = PhantomKind::Tube;
    params.size = {32, 32, 32};
    params.radius = 3.0;
    const Phantom phantom = makePhantom(params);
    writeVolume(phantom.image, at("good.mha").toStdString());
    writeVolume(phantom.image, at("good.nrrd").toStdString());
    writeVolume(phantom.image, at("good.nii.gz").toStdString());
    writeVolume(phantom.truth, at("truth.mha").toStdString());
    params.noiseSigma = 20.0;
    writeVolume(makePhantom(params).image, at("noisy.mha").toStdString());

    for (const char* name : {"good.mha", "good.nrrd", "good.nii.gz"}) {
      QFile good(at(name));
      QVERIFY(good.open(QIODevice::ReadOnly));
      const QByteArray bytes = good.readAll();
      writeBytes(at(QString("truncated") + QString(name).mid(4)),
                 bytes.left(bytes.size() * 6 / 10));
    }
    writeBytes(at("empty.mha"), "");
    writeBytes(at("text.mha"), "This is not an image.\n");
    writeBytes(at("text.nrrd"), "This is not an image.\n");
    writeBytes(at("text.nii"), "This is not an image.\n");
    writeBytes(at("flat.mha"), metaImage("2", "32 32", QByteArray(32 * 32, 'x')));
    writeBytes(at("film.mha"), metaImage("4", "8 8 8 3", QByteArray(8 * 8 * 8 * 3, 'x')));
    writeBytes(at("slice.mha"), metaImage("3", "32 32 1", QByteArray(32 * 32, 'x')));
    writeBytes(at("constant.mha"), metaImage("3", "16 16 16", QByteArray(16 * 16 * 16, 'x')));
    writeBytes(at("short.mha"), metaImage("3", "16 16 16", QByteArray(100, 'x')));
    writeBytes(at("huge.mha"), metaImage("3", "99999999 99999999 99999999", QByteArray(100, 'x')));
    // Single voxels of this kind are replaced.
    Volume<float> holed = phantom.image;
    for (float& value : holed.voxels) value = std::numeric_limits<float>::quiet_NaN();
    writeVolume(holed, at("nan.nrrd").toStdString());
    QVERIFY(QDir(dir.path()).mkdir("folder"));
    writeBytes(at("bad.json"), "{\"levelset\": {\"gamma\": }");
    writeBytes(at("unknown.json"), "{\"levelset\": {\"gama\": 0.5}}");
    writeBytes(at("mesh.ply"), "ply\nformat ascii 1.0\nelement vertex 3\n");
  }

  void badInput_data() {
    QTest::addColumn<QString>("input");
    for (const char* name :
         {"missing.mha", "empty.mha", "truncated.mha", "truncated.nrrd", "truncated.nii.gz",
          "text.mha", "text.nrrd", "text.nii", "flat.mha", "film.mha", "slice.mha", "constant.mha",
          "short.mha", "huge.mha", "nan.nrrd", "folder", "/dev/null"})
      QTest::newRow(name) << name;
  }

  void badInput() {
    QFETCH(QString, input);
    const QStringList before = filesIn(dir.path());
    verifyRefused(cli({"run", input, "-o", "out"}), before);
    verifyRefused(cli({"info", input}), before);
    verifyRefused(cli({"vesselness", input, "-o", "v.nrrd"}), before);
    verifyRefused(cli({"convert", input, "-o", "c.nrrd"}), before);
  }

  void badCommandLine_data() {
    QTest::addColumn<QStringList>("arguments");
    const auto row = [](const char* arguments) {
      QTest::newRow(arguments) << QString(arguments).split(' ', Qt::SkipEmptyParts);
    };
    row("");
    row("paint");
    row("run");
    row("run good.mha");
    row("run good.mha -o out --colour red");
    row("run good.mha -o out --set levelset.gamma=7");
    row("run good.mha -o out --set levelset.gamma=nan");
    row("run good.mha -o out --set levelset.gamma=");
    row("run good.mha -o out --set levelset.gamma");
    row("run good.mha -o out --set levelset.gama=0.7");
    row("run good.mha -o out --set vesselness.sigmaMinMm=3 --set vesselness.sigmaMaxMm=2");
    row("run good.mha -o out --set surface.method=magic");
    row("run good.mha -o out --preset unheard");
    row("run good.mha -o out --params bad.json");
    row("run good.mha -o out --params unknown.json");
    row("run good.mha -o out --params missing.json");
    row("run good.mha -o out --until tomorrow");
    row("run good.mha -o out --until vesselness --truth truth.mha");
    row("run good.mha -o out --truth missing.mha");
    row("run good.mha -o out --seed 1,2");
    row("run good.mha -o out --seed -1000,2,3");
    row("run good.mha -o out --seed 1,2,x");
    row("run good.mha -o out --roi 1,2,3");
    row("run good.mha -o out --roi -1e4,-1e4,-1e4,-1e3,-1e3,-1e3");
    row("--threads 0 run good.mha -o out");
    row("--threads many run good.mha -o out");
    row("--progress loud run good.mha -o out");
    row("segment good.mha -o phi.nrrd --method magic");
    row("phantom sphere -o p");
    row("phantom tube --size 0 -o p");
    row("phantom tube --size 32.5 -o p");
    row("phantom tube --size 1e9 -o p");
    row("phantom tube --radius -2 -o p");
    row("phantom tube --spacing 1,0,1 -o p");
    row("phantom tree --radius-range 4,2 -o p");
    row("mesh good.mha -o out.xyz");
    row("mesh missing.nrrd -o out.ply");
    row("mesh truth.mha");
    row("mesh truth.mha --estimate -o out.ply");
    row("mesh truth.mha --estimate --set surface.method=marching-cubes");
    row("mesh truth.mha -o out.ply --set surface.edgesAround=2");
    row("mesh truth.mha -o out.ply --set surface.edgeMinMm=2 --set surface.edgeMaxMm=1");
    row("smooth mesh.ply -o out.ply");
    row("smooth good.mha -o out.ply");
    row("quality mesh.ply");
    row("quality missing.ply");
    row("snapshot . -o picture.png");
    row("snapshot . . -o picture.png");
    row("snapshot . --at 1,2,3 -o picture.png");
    row("snapshot . --at 1,2 --width 3 -o picture.png");
    row("snapshot . --at 1,2,3 --width -3 -o picture.png");
    row("evaluate good.mha good.nrrd extra");
    row("evaluate truth.mha missing.mha");
    row("convert good.mha -o out.xyz");
    row("convert good.mha -o out.ply");
  }

  void badCommandLine() {
    QFETCH(QStringList, arguments);
    const QStringList before = filesIn(dir.path());
    verifyRefused(cli(arguments), before);
  }

  void aRangeWithoutVesselsFindsNoSeedOrNoSurface() {
    const QStringList before = filesIn(dir.path());
    verifyRefused(cli({"run", "good.mha", "-o", "out", "--set", "vesselness.sigmaMinMm=25", "--set",
                       "vesselness.sigmaMaxMm=30"}),
                  before);
    verifyRefused(cli({"run", "good.mha", "-o", "out", "--set", "seeds.automatic=false"}), before);
  }

  /// What was computed before a surface that is not begun is written all the same.
  void aRefusedSurfaceKeepsTheSegmentation() {
    const CliResult refused =
        cli({"run", "good.mha", "-o", "refused", "--set", "surface.maxTriangles=100"});
    QCOMPARE(refused.code, 2);
    for (const char* word :
         {"not begun", "surface.maxTriangles = 100", "surface.edgeMinMm", "mask.nrrd"})
      QVERIFY2(refused.errors.contains(word), refused.errors.constData());
    const QStringList kept = QDir(at("refused")).entryList(QDir::Files);
    QCOMPARE(kept, (QStringList{"mask.nrrd", "params.json", "phi.nrrd", "preview.png",
                                "recipe.json", "report.json"}));
    QFile report(at("refused/report.json"));
    QVERIFY(report.open(QIODevice::ReadOnly));
    const QByteArray text = report.readAll();
    QVERIFY(text.contains("\"failure\"") && text.contains("\"inside_voxels\""));
    QCOMPARE(cli({"run", "good.mha", "-o", "all", "--until", "evolve"}).code, 0);
    for (const char* name : {"mask.nrrd", "phi.nrrd"}) {
      QFile one(at(QString("refused/") + name)), other(at(QString("all/") + name));
      QVERIFY(one.open(QIODevice::ReadOnly) && other.open(QIODevice::ReadOnly));
      QCOMPARE(one.readAll(), other.readAll());
    }
    QVERIFY(QDir(at("refused")).removeRecursively() && QDir(at("all")).removeRecursively());

    const QStringList before = filesIn(dir.path());
    verifyRefused(cli({"mesh", "truth.mha", "-o", "m.ply", "--set", "surface.maxTriangles=100"}),
                  before);
    QCOMPARE(cli({"mesh", "truth.mha", "-o", "m.ply", "--set", "surface.maxTriangles=0"}).code, 0);
    QVERIFY(QFile::remove(at("m.ply")));
  }

  void badOutputPlace_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("below a file") << QStringList{"run", "good.mha", "-o", "good.nrrd/out"};
    QTest::newRow("a file") << QStringList{"run", "good.mha", "-o", "good.nrrd"};
    QTest::newRow("a device") << QStringList{"run", "good.mha", "-o", "/dev/full"};
    QTest::newRow("proc") << QStringList{"run", "good.mha", "-o", "/proc/angiomesh/out"};
    QTest::newRow("proc itself") << QStringList{"run", "good.mha", "-o", "/proc/self"};
    QTest::newRow("phantom") << QStringList{"phantom", "tube", "-o", "good.nrrd/p"};
    QTest::newRow("vesselness") << QStringList{"vesselness", "good.mha", "-o", "none/v.nrrd"};
    QTest::newRow("segment") << QStringList{"segment", "good.mha", "-o", "/proc/phi.nrrd"};
    QTest::newRow("mesh") << QStringList{"mesh", "truth.mha", "-o", "none/m.ply"};
    QTest::newRow("convert") << QStringList{"convert", "good.mha", "-o", "/proc/v.nrrd"};
    QTest::newRow("device file") << QStringList{"convert", "good.mha", "-o", "/dev/full/v.nrrd"};
  }

  void badOutputPlace() {
    QFETCH(QStringList, arguments);
    const QStringList before = filesIn(dir.path());
    verifyRefused(cli(arguments), before);
  }

  void aFullMediumLeavesNothingBehind_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("run") << QStringList{"run", "good.mha", "-o",
                                        "out", "--set",    "levelset.maxIterations=20"};
    QTest::newRow("phantom") << QStringList{"phantom", "tube", "--size", "32",
                                            "--noise", "20",   "-o",     "p"};
    QTest::newRow("vesselness") << QStringList{"vesselness", "noisy.mha", "-o", "v.nrrd"};
    for (const char* name : {"c.mha", "c.nrrd", "c.nii", "c.nii.gz"})
      QTest::newRow(name) << QStringList{"convert", "noisy.mha", "-o", name};
    for (const char* name : {"m.ply", "m.stl", "m.obj", "m.vtp"})
      QTest::newRow(name) << QStringList{"mesh", "truth.mha", "-o", name};
  }

  void aFullMediumLeavesNothingBehind() {
    QFETCH(QStringList, arguments);
    const QStringList before = filesIn(dir.path());
    verifyRefused(runCliWithFileLimit(dir.path(), arguments, 1), before);
  }

  void aFormerResultSurvivesAFullMedium() {
    QCOMPARE(cli({"convert", "good.mha", "-o", "former.nrrd"}).code, 0);
    QFile file(at("former.nrrd"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    file.close();
    const QStringList before = filesIn(dir.path());
    verifyRefused(runCliWithFileLimit(dir.path(), {"convert", "noisy.mha", "-o", "former.nrrd"}, 1),
                  before);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), bytes);
  }

  void interruptCancelsCleanly_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("SIGINT") << SIGINT;
    QTest::newRow("SIGTERM") << SIGTERM;
    QTest::newRow("SIGHUP") << SIGHUP;
  }

  void interruptCancelsCleanly() {
    QFETCH(int, signal);
    QCOMPARE(cli({"phantom", "tree", "--size", "64", "--noise", "20", "-o", "long"}).code, 0);
    const QStringList before = filesIn(dir.path());
    QProcess process;
    process.setWorkingDirectory(dir.path());
    process.start(ANGIOMESH_CLI, {"--progress", "json", "run", "long/image.mha", "-o", "deep/out",
                                  "--set", "levelset.maxIterations=100000", "--set",
                                  "levelset.tolerance=1e-9", "--set", "levelset.toleranceDelta=0"});
    process.setReadChannel(QProcess::StandardError);
    QByteArray errors;
    QElapsedTimer timer;
    timer.start();
    while (!errors.contains("\"iterations\"") && timer.elapsed() < 30000 &&
           process.state() != QProcess::NotRunning) {
      process.waitForReadyRead(1000);
      errors += process.readAllStandardError();
    }
    QVERIFY2(errors.contains("\"iterations\""), errors.constData());
    timer.start();
    QCOMPARE(::kill(static_cast<pid_t>(process.processId()), signal), 0);
    const CliResult result = finish(process);
    QVERIFY(timer.elapsed() < 5000);
    QVERIFY(!result.crashed);
    QCOMPARE(result.code, 4);
    QVERIFY(result.errors.contains("cancelled"));
    QCOMPARE(filesIn(dir.path()), before);
  }

  void whatIsNoFileIsRefused() {
    QCOMPARE(::mkfifo(at("pipe.ply").toUtf8().constData(), 0600), 0);
    const QStringList before = filesIn(dir.path());
    for (const char* place : {"pipe.ply", "/dev/zero"}) {
      verifyRefused(cli({"quality", place}), before);
      verifyRefused(cli({"run", "good.mha", "-o", "none", "--params", place}), before);
    }
    verifyRefused(cli({"quality", "truth.mha", "--truth", "/dev/zero"}), before);
    QVERIFY(QFile::remove(at("pipe.ply")));
  }

  void deepAndHugeParametersAreRefused() {
    writeBytes(at("deep.json"), QByteArray(200000, '[') + QByteArray(200000, ']'));
    QByteArray many = "{\"a\":1";
    for (int n = 0; n < 1000000; ++n) many += ",\"k" + QByteArray::number(n) + "\":1";
    writeBytes(at("many.json"), many + "}");
    const QStringList before = filesIn(dir.path());
    for (const char* name : {"deep.json", "many.json"}) {
      verifyRefused(cli({"run", "good.mha", "-o", "none", "--params", name}), before);
      verifyRefused(cli({"quality", "truth.mha", "--truth", name}), before);
    }
    QVERIFY(QFile::remove(at("deep.json")) && QFile::remove(at("many.json")));
  }

  void outputThatDoesNotArriveIsAFailure() {
    for (const QStringList& arguments : {QStringList{"info", "good.mha"},
                                         {"info", "good.mha", "--json"},
                                         {"--help"},
                                         {"parameters"}}) {
      QProcess process;
      process.setWorkingDirectory(dir.path());
      process.setStandardOutputFile("/dev/full");
      process.start(ANGIOMESH_CLI, arguments);
      const CliResult result = finish(process);
      QCOMPARE(result.code, 2);
      QVERIFY2(result.errors.contains("standard output"), result.errors.constData());
    }
    // A pipe that is closed early.
    QProcess process;
    process.setWorkingDirectory(dir.path());
    process.start("bash", {"-c", "\"$0\" parameters | true; exit ${PIPESTATUS[0]}", ANGIOMESH_CLI});
    const CliResult result = finish(process);
    QVERIFY(result.code == 0 || result.code == 2);
  }

  // Without it every attribute would be of unknown kind, and every file damaged.
  void aDictionaryThatIsMissingIsSaid() {
    const QString data = qEnvironmentVariable("ANGIOMESH_DATA");
    if (data.isEmpty()) QSKIP("ANGIOMESH_DATA is not set");
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("DCMDICTPATH", at("none.dic"));
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(dir.path());
    process.start(ANGIOMESH_CLI, {"info", data + "/head-mr-dicom"});
    const CliResult result = finish(process);
    QCOMPARE(result.code, 2);
    QVERIFY2(result.errors.contains("dictionary"), result.errors.constData());
  }

  void theInputIsNotReplacedUnasked() {
    const QByteArray image = readBytes(at("good.nrrd"));
    QVERIFY(QFile::link(at("good.nrrd"), at("other.nrrd")));
    const QStringList before = filesIn(dir.path());
    for (const char* name : {"good.nrrd", "./good.nrrd", "other.nrrd"})
      verifyRefused(cli({"convert", "good.nrrd", "-o", name}), before);
    QCOMPARE(readBytes(at("good.nrrd")), image);
    QCOMPARE(cli({"convert", "good.nrrd", "-o", "good.nrrd", "--force"}).code, 0);
    QVERIFY(QFile::remove(at("other.nrrd")));
  }

  void patchFilesAppearTogetherOrNotAtAll() {
    const QByteArray name = "inlet" + QByteArray(250, 'x');
    writeBytes(at("m.obj"),
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng wall\nf 1 2 3\ng " + name + "\nf 1 2 4\n");
    const QStringList before = filesIn(dir.path());
    verifyRefused(cli({"convert", "m.obj", "-o", "n.stl", "--patch-files", "--solid-names"}),
                  before);
    QCOMPARE(cli({"convert", "m.obj", "-o", "n.stl", "--patch-files"}).code, 0);
    QCOMPARE(filesIn(dir.path()).size(), before.size() + 3);
    for (const QString& made : filesIn(dir.path()))
      if (!before.contains(made)) QVERIFY(QFile::remove(at(made)));
    QVERIFY(QFile::remove(at("m.obj")));
  }

  void twoRunsDoNotShareAFolder() {
    QProcess process;
    process.setWorkingDirectory(dir.path());
    process.start(ANGIOMESH_CLI, {"--progress", "json", "run", "good.mha", "-o", "shared", "--set",
                                  "levelset.maxIterations=100000", "--set",
                                  "levelset.tolerance=1e-9", "--set", "levelset.toleranceDelta=0"});
    process.setReadChannel(QProcess::StandardError);
    QVERIFY(process.waitForReadyRead(30000));
    const CliResult second = cli({"run", "good.mha", "-o", "shared"});
    QCOMPARE(second.code, 2);
    QVERIFY2(second.errors.contains("another run"), second.errors.constData());
    process.terminate();
    QCOMPARE(finish(process).code, 4);
    QVERIFY(!QFile::exists(at("shared")));
  }

  // Two boxes that cross: a solver refuses what smoothing makes of them.
  void aSurfaceThatCutsItselfIsRefused() {
    QByteArray obj;
    for (int box = 0; box < 2; ++box)
      for (int v = 0; v < 8; ++v)
        obj += QString("v %1 %2 %3\n")
                   .arg((v & 1) + 0.4 * box)
                   .arg((v >> 1 & 1) + 0.3 * box)
                   .arg((v >> 2 & 1) + 0.2 * box)
                   .toLatin1();
    const int sides[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5},
                             {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
    for (int box = 0; box < 2; ++box)
      for (const auto& s : sides)
        for (const auto& t : {std::array{s[0], s[1], s[2]}, std::array{s[0], s[2], s[3]}})
          obj += QString("f %1 %2 %3\n")
                     .arg(t[0] + 8 * box)
                     .arg(t[1] + 8 * box)
                     .arg(t[2] + 8 * box)
                     .toLatin1();
    writeBytes(at("crossing.obj"), obj);
    const QStringList before = filesIn(dir.path());
    const CliResult refused = cli({"smooth", "crossing.obj", "-o", "smooth.ply"});
    QCOMPARE(refused.code, 3);
    QCOMPARE(filesIn(dir.path()), before);
    QVERIFY2(refused.errors.contains("cuts itself in 1 place, near L "),
             refused.errors.constData());
    QVERIFY2(refused.errors.contains("--allow-unsound"), refused.errors.constData());
    const CliResult allowed =
        cli({"smooth", "crossing.obj", "-o", "smooth.ply", "--allow-unsound"});
    QCOMPARE(allowed.code, 0);
    QVERIFY2(allowed.errors.contains("warning: the surface cuts itself"),
             allowed.errors.constData());
    QVERIFY(QFile::remove(at("smooth.ply")) && QFile::remove(at("crossing.obj")));
  }
};

QTEST_GUILESS_MAIN(TestCliFailures)
#include "tst_cli_failures.moc"
