// SPDX-License-Identifier: BSD-3-Clause
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "core/base/random.h"
#include "core/phantom/phantom.h"
#include "io/scan/image_io.h"
#include "io/volume/image_write.h"
#include "tests/app/cli_process.h"

using namespace angiomesh;

namespace {

/// The panel of a figure in figures.json.
QJsonObject panel(const QJsonObject& json, const QString& figure, qsizetype number) {
  for (const QJsonValue& value : json["figures"].toArray())
    if (value["figure"].toString() == figure) return value["panels"].toArray()[number].toObject();
  return {};
}

double triangles(const QJsonObject& panel) { return panel["triangles"].toDouble(); }

}  // namespace

/// A branching vessel that leaves the volume, with a rough wall.
Volume<float> roughBranch() {
  PhantomParams params;
  params.kind = PhantomKind::Bifurcation;
  params.size = {32, 32, 32};
  params.radius = 5.0;
  Volume<float> phi = phantomField(params);
  for (std::size_t i = 0; i < phi.voxels.size(); ++i)
    phi.voxels[i] += static_cast<float>(0.05 * randomNormal(1, i));
  return phi;
}

// `study figures` on a small vessel: the pictures are there and the numbers go the way that the
// thesis says.
class TestStudy : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void figuresOfALevelSetFunction() {
    const QTemporaryDir dir;
    writeVolume(roughBranch(), dir.filePath("phi.nrrd").toStdString());
    const QStringList command{"study", "figures", "phi.nrrd", "-o", "figures"};
    const CliResult result = runCli(dir.path(), command);
    QVERIFY2(result.code == 0, result.errors.constData());
    QVERIFY(result.output.contains("| 5.6 | marching cubes |"));

    QFile file(dir.filePath("figures/figures.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
    QCOMPARE(json["figures"].toArray().size(), 6);
    for (const QJsonValue& figure : json["figures"].toArray()) {
      QFile picture(dir.filePath("figures/" + figure["file"].toString()));
      QVERIFY(picture.open(QIODevice::ReadOnly));
      QVERIFY(picture.size() > 10000);
      QCOMPARE(picture.read(4), QByteArray("\x89PNG"));
      for (const QJsonValue& one : figure["panels"].toArray())
        QVERIFY(triangles(one.toObject()) > 100);
    }
    QVERIFY(triangles(panel(json, "B.1", 0)) < triangles(panel(json, "B.1", 1)));
    QVERIFY(triangles(panel(json, "B.1", 1)) < triangles(panel(json, "B.1", 2)));
    QVERIFY(triangles(panel(json, "5.4", 0)) > triangles(panel(json, "5.4", 1)));
    QVERIFY(panel(json, "5.6", 0)["radius_ratio_mean"].toDouble() <
            panel(json, "5.6", 1)["radius_ratio_mean"].toDouble());
    QVERIFY(panel(json, "5.5", 1)["triangles"] == panel(json, "B.2", 0)["triangles"]);

    QCOMPARE(runCli(dir.path(), command).code, 2);
  }

  void sensitivityOfAScan() {
    const QTemporaryDir dir;
    PhantomParams params;
    params.kind = PhantomKind::Bifurcation;
    params.size = {40, 40, 40};
    params.radius = 4.0;
    params.noiseSigma = 5.0;
    writeVolume(makePhantom(params).image, dir.filePath("scan.nrrd").toStdString());
    const QStringList command{
        "study",       "sensitivity",          "scan.nrrd",   "-o",         "moves",
        "--parameter", "levelset.refineLevel", "--parameter", "levelset.xi"};
    const CliResult result = runCli(dir.path(), command);
    QVERIFY2(result.code == 0, result.errors.constData());
    QVERIFY(result.output.contains("| levelset.refineLevel | 0.41 -> "));
    const auto lines = [&](const char* name) {
      QFile file(dir.filePath(QLatin1String("moves/") + QLatin1String(name)));
      return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed().split('\n')
                                            : QList<QByteArray>();
    };
    const QList<QByteArray> table = lines("sensitivity.csv");
    QCOMPARE(table.size(), 5);
    for (qsizetype n = 1; n < table.size(); ++n) {
      const QList<QByteArray> cells = table[n].split(',');
      QCOMPARE(cells.size(), table[0].split(',').size());
      QVERIFY(std::fabs(cells[3].toDouble()) <= cells[4].toDouble());
      QVERIFY(cells[8].toDouble() > 50.0 && cells[9].isEmpty());
    }
    const QList<QByteArray> branches = lines("branches.csv");
    QVERIFY(branches.size() >= 4);  // three branches meet
    QCOMPARE(branches[1].count(','), branches[0].count(','));
    QVERIFY(QFile(dir.filePath("moves/sensitivity.vtp")).size() > 10000);
    QCOMPARE(runCli(dir.path(), command).code, 2);
    QCOMPARE(runCli(dir.path(),
                    {"study", "sensitivity", "scan.nrrd", "-o", "no", "--parameter", "surface.rho"})
                 .code,
             2);
  }

  void panelOfChosenRows() {
    const QTemporaryDir dir;
    const QStringList command{"study",   "panel",  "-o",
                              "panel",   "--rows", "kissing-r3-g3,tube-r3-n20-axis",
                              "--cases", "1"};
    const CliResult result = runCli(dir.path(), command);
    QVERIFY2(result.code == 0, result.errors.constData());
    const QJsonArray rows = readJson(dir.filePath("panel/panel.json"))["rows"].toArray();
    QCOMPARE(rows.size(), 2);
    const QJsonObject tube = rows[0]["measures"].toObject();
    QVERIFY(tube["overlap_percent"].toDouble() > 95.0);
    QVERIFY(std::fabs(tube["radius_bias_voxels"].toDouble()) < 0.3);
    QVERIFY(!tube.contains("merged_vessels"));
    QCOMPARE(rows[0]["bars"].toArray().size(), 2);
    QCOMPARE(rows[0]["cases"].toArray().size(), 1);
    const QJsonObject kissing = rows[1]["measures"].toObject();
    QCOMPARE(kissing["components"].toDouble(), 2.0);
    QCOMPARE(kissing["merged_vessels"].toDouble(), 0.0);
    QVERIFY(kissing["centre_line_recall_percent"].toDouble() > 99.0);
    QFile csv(dir.filePath("panel/panel.csv"));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = csv.readAll().trimmed().split('\n');
    QCOMPARE(lines.size(), 5);  // the titles, and for each row all its cases and each
    for (const QByteArray& line : lines) QVERIFY(line.count(',') >= lines[0].count(','));
    QFile table(dir.filePath("panel/panel.md"));
    QVERIFY(table.open(QIODevice::ReadOnly));
    QVERIFY(table.readAll().contains("| kissing-r3-g3 |"));
    QCOMPARE(runCli(dir.path(), command).code, 2);  // would replace a former panel

    const CliResult unknown =
        runCli(dir.path(), {"study", "panel", "-o", "other", "--rows", "trees,ladders"});
    QCOMPARE(unknown.code, 2);
    QVERIFY(unknown.errors.contains("ladders"));
  }

  // The exported wall of a tube against the exact one, by the study and by `quality --truth`.
  void surfaceOfChosenShapes() {
    const QTemporaryDir dir;
    const QStringList command{"study",    "surface", "-o",      "surface",
                              "--shapes", "tube-3",  "--noise", "0,20"};
    const CliResult result = runCli(dir.path(), command);
    QVERIFY2(result.code == 0, result.errors.constData());
    const QJsonArray cases = readJson(dir.filePath("surface/surface.json"))["cases"].toArray();
    QCOMPARE(cases.size(), 2);
    for (const QJsonValue& one : cases) {
      const QJsonObject wall = one["exported"]["wall"].toObject();
      QVERIFY(wall["vertices"].toInt() > 500);
      QVERIFY(std::fabs(wall["distance_mm"]["mean"].toDouble()) < 0.1);
      QVERIFY(wall["distance_mm"]["spread"].toDouble() < 0.2);
      QVERIFY(wall["normal_deg"]["mean"].toDouble() < wall["normal_deg"]["p95"].toDouble());
      QVERIFY(one["exported"]["mesh"]["roughness"]["spread_mm"].toDouble() > 0.0);
      QCOMPARE(wall["by_radius"].toArray().size(), 1);
      QVERIFY(one["bars"].toArray().size() >= 5);
    }
    QVERIFY(!cases[0].toObject().contains("triangles_to_noise_0"));
    QVERIFY(cases[1]["triangles_to_noise_0"].toDouble() > 0.5);
    QFile table(dir.filePath("surface/surface.md"));
    QVERIFY(table.open(QIODevice::ReadOnly));
    QVERIFY(table.readAll().contains("| tube-3 | gaussian:0.5 | 20 |"));
    QFile csv(dir.filePath("surface/surface.csv"));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QCOMPARE(csv.readAll().trimmed().split('\n').size(), 3);
    QCOMPARE(runCli(dir.path(), command).code, 2);  // would replace a former table
    for (const QStringList& wrong :
         {QStringList{"--shapes", "ladder"}, {"--psf", "blurry"}, {"--noise", "much"}}) {
      const CliResult refused =
          runCli(dir.path(), QStringList{"study", "surface", "-o", "x"} + wrong);
      QCOMPARE(refused.code, 2);
      QVERIFY2(refused.errors.contains(wrong[1].toUtf8()), refused.errors.constData());
    }
  }

  void aMeshAgainstItsPhantom() {
    const QTemporaryDir dir;
    const auto cli = [&](const QStringList& command) { return runCli(dir.path(), command); };
    QCOMPARE(
        cli({"phantom", "stenosis", "--stenosis", "70", "--psf", "mr", "--size", "48", "-o", "p"})
            .code,
        0);
    PhantomParams params;
    params.kind = PhantomKind::Stenosis;
    params.size = {48, 48, 48};
    params.stenosisPercent = 70.0;
    writeVolume(phantomField(params), dir.filePath("phi.nrrd").toStdString());
    QCOMPARE(cli({"mesh", "phi.nrrd", "-o", "wall.ply"}).code, 0);
    const CliResult quality = cli({"quality", "wall.ply", "--truth", "p/truth.json", "--json"});
    QVERIFY2(quality.code == 0, quality.errors.constData());
    const QJsonObject wall = quality.json()["wall"].toObject();
    QVERIFY(std::fabs(wall["distance_mm"]["mean"].toDouble()) < 0.02);
    QVERIFY(wall["normal_deg"]["mean"].toDouble() < 6.0);
    QCOMPARE(wall["stenosis"]["true_diameter_mm"].toDouble(), 2.0 * 4.0 * 0.3);
    QVERIFY(std::fabs(wall["stenosis"]["error_percent"].toDouble()) < 5.0);
    QVERIFY(cli({"quality", "wall.ply", "--truth", "p/truth.json"}).output.contains("true wall"));
    const CliResult wrong = cli({"quality", "wall.ply", "--truth", "wall.ply"});
    QCOMPARE(wrong.code, 2);
    QVERIFY2(wrong.errors.contains("wall.ply"), wrong.errors.constData());
    QCOMPARE(cli({"phantom", "tube", "--psf", "blurry", "-o", "q"}).code, 2);
  }

  void ablationSwitchesOffOneAfterTheOther() {
    const QTemporaryDir dir;
    const CliResult result = runCli(dir.path(), {"study", "ablation", "-o", "ablation", "--rows",
                                                 "tube-r3-n20-oblique", "--cases", "1"});
    QVERIFY2(result.code == 0, result.errors.constData());
    const QJsonArray groups = readJson(dir.filePath("ablation/ablation.json"))["groups"].toArray();
    QVERIFY(groups.size() >= 8);
    const auto measure = [&](const QString& name, const char* key) {
      for (const QJsonValue& group : groups)
        if (group["switched_off"].toString() == name)
          return group["rows"][0]["measures"][key].toDouble();
      return std::nan("");
    };
    const char* const wall = "wall_distance_mean_voxels";
    QVERIFY(measure("all on", wall) < 0.9 * measure("wall.smooth off", wall));
    QVERIFY(std::fabs(measure("printed method", "radius_bias_voxels")) < 1.5);
  }

  // The figures of the segmentation of a scan: pictures, and the parameters' effect on what is
  // found.
  void figuresOfAnImage() {
    const QTemporaryDir dir;
    PhantomParams params;
    params.size = {32, 32, 32};
    params.noiseSigma = 20.0;
    writeVolume(makePhantom(params).image, dir.filePath("image.nrrd").toStdString());
    const CliResult result = runCli(dir.path(), {"study", "figures", "--image", "image.nrrd", "-o",
                                                 "figures", "--set", "levelset.maxIterations=100"});
    QVERIFY2(result.code == 0, result.errors.constData());
    QFile file(dir.filePath("figures/figures.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
    QCOMPARE(json["figures"].toArray().size(), 5);
    for (const QJsonValue& figure : json["figures"].toArray()) {
      QFile picture(dir.filePath("figures/" + figure["file"].toString()));
      QVERIFY(picture.open(QIODevice::ReadOnly));
      QCOMPARE(picture.read(4), QByteArray("\x89PNG"));
    }
    const auto inside = [&](const char* figure, qsizetype number) {
      return panel(json, figure, number)["inside_voxels"].toInt();
    };
    QVERIFY(inside("A.2", 0) > 0);
    QVERIFY(inside("A.2", 0) <= inside("A.2", 2));
    QVERIFY(inside("A.3", 0) >= inside("A.3", 2));
    QCOMPARE(inside("A.1", 1), inside("3.3", 1));
    QVERIFY(inside("5.2", 0) > 0);
    QVERIFY(inside("5.2", 1) > 0);
    QCOMPARE(inside("5.2", 2), inside("3.3", 1));
    QVERIFY(!panel(json, "A.1", 1).contains("overlap"));
  }

  // Each row adds up to all voxels, the vessel's share is that of the truth in every row, and the
  // curvature term finds more vessel, as in the thesis.
  void tablesOfTheAppendix() {
    const QTemporaryDir dir;
    const QStringList command{"study",  "table-a", "-o",    "tables",
                              "--size", "40",      "--set", "levelset.maxIterations=100"};
    const CliResult result = runCli(dir.path(), command);
    QVERIFY2(result.code == 0, result.errors.constData());
    QVERIFY(result.output.contains("Table A.2: 40 x 40 x 40 voxels, noise 60"));
    for (const char* name : {"tables/table-a1.csv", "tables/table-a2.csv"}) {
      QFile file(dir.filePath(name));
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
      QCOMPARE(lines.size(), 28);
      QCOMPARE(lines[0], QByteArray("gamma,d,xi,TPR,FPR,TNR,FNR,overlap"));
      double vessel = -1.0;
      double found[3] = {0.0, 0.0, 0.0};
      for (const QByteArray& line : lines.sliced(1)) {
        const QList<QByteArray> cells = line.split(',');
        QCOMPARE(cells.size(), 8);
        const auto cell = [&cells](qsizetype n) { return cells[n].toDouble(); };
        QVERIFY(std::fabs(cell(3) + cell(4) + cell(5) + cell(6) - 100.0) < 0.0025);
        if (vessel < 0.0) vessel = cell(3) + cell(6);
        QVERIFY(std::fabs(cell(3) + cell(6) - vessel) < 0.0025);
        found[static_cast<int>(cell(1) / 0.2 + 0.5)] += cell(3);
      }
      QVERIFY(found[0] > 0.0);
      QVERIFY(found[0] < found[1]);
      QVERIFY(found[1] <= found[2]);
    }
    QCOMPARE(runCli(dir.path(), command).code, 2);
  }
};

QTEST_GUILESS_MAIN(TestStudy)
#include "tst_study.moc"
