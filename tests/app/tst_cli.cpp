// SPDX-License-Identifier: BSD-3-Clause
#include <QJsonArray>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/mesh/tri_mesh.h"
#include "core/phantom/phantom.h"
#include "io/mesh/mesh_io.h"
#include "io/scan/image_io.h"
#include "io/volume/image_write.h"
#include "tests/app/cli_run.h"

using namespace angiomesh;

namespace {

const QStringList kRunFiles{"marching-cubes.ply", "mask.nrrd",   "methods.txt", "params.json",
                            "phi.nrrd",           "ports.json",  "preview.png", "recipe.json",
                            "report.json",        "vessels.ply", "vessels.stl"};

}  // namespace

// angiomesh-cli as a user meets it: files, numbers, exit codes.
class TestCli : public QObject, CliRun {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { makeRun(); }

  void phantomsAreTheSameEachTimeAndReplaceThemselves() {
    const QByteArray before = readBytes(at("p/image.mha"));
    QCOMPARE(
        cli({"phantom", "bifurcation", "--size", "40", "--radius", "3", "--noise", "10", "-o", "p"})
            .code,
        0);
    QVERIFY(!before.isEmpty());
    QCOMPARE(readBytes(at("p/image.mha")), before);
    QVERIFY(!readJson(at("p/truth.json")).isEmpty());
  }

  void infoTellsGeometryAndRange() {
    const CliResult info = cli({"info", "p/image.mha", "--json"});
    QCOMPARE(info.code, 0);
    const QJsonObject input = info.json().value("input").toObject();
    QCOMPARE(input.value("size").toArray(), QJsonArray({40, 40, 40}));
    QCOMPARE(input.value("spacing_mm").toArray(), QJsonArray({1.0, 1.0, 1.0}));
    const Volume<float> image = readImage(nativePath(at("p/image.mha"))).image;
    const auto range = valueRange(image);
    QCOMPARE(static_cast<float>(input.value("range").toArray().at(0).toDouble()), range[0]);
    QCOMPARE(static_cast<float>(input.value("range").toArray().at(1).toDouble()), range[1]);
    QVERIFY(cli({"info", "p/image.mha"}).output.contains("40 x 40 x 40 voxels"));
  }

  void runWritesAllFilesAndNothingElse() {
    QCOMPARE(filesIn(at("out")), kRunFiles);
    QVERIFY(!filesIn(dir.path()).join(' ').contains("part"));
    QVERIFY(readBytes(at("out/preview.png")).startsWith("\x89PNG"));
  }

  void reportHasEveryKey() {
    const QJsonObject report = readJson(at("out/report.json"));
    QStringList wanted{"schema",
                       "version",
                       "key",
                       "threads",
                       "total_seconds",
                       "cpu_seconds",
                       "peak_rss_mb",
                       "parameters",
                       "warnings",
                       "input.size",
                       "input.spacing_mm",
                       "working.size",
                       "working.spacing_mm",
                       "stages",
                       "segmentation.method",
                       "segmentation.components_found",
                       "segmentation.component_list",
                       "segmentation.iterations",
                       "segmentation.converged",
                       "segmentation.stop_reason",
                       "segmentation.inside_voxels",
                       "segmentation.components",
                       "segmentation.thresholds.a",
                       "segmentation.thresholds.b",
                       "segmentation.thresholds.v_avg",
                       "segmentation.thresholds.clamped",
                       "segmentation.seeds",
                       "truth.overlap",
                       "truth.sensitivity",
                       "truth.precision",
                       "truth.assd_mm",
                       "truth.hd95_mm",
                       "surface.method",
                       "surface.estimated_triangles",
                       "surface.from_front_percent",
                       "surface.components",
                       "surface.unverified",
                       "surface.dropped",
                       "smoothing.radius_change_percent",
                       "smoothing.area_change_percent",
                       "smoothing.volume_change_percent",
                       "mesh.from_front_percent",
                       "mesh_unsmoothed.from_front_percent"};
    for (const char* mesh : {"mesh.", "mesh_unsmoothed.", "marching_cubes."})
      for (const char* key : {"vertices",
                              "triangles",
                              "components",
                              "boundary_edges",
                              "boundary_loops",
                              "non_manifold_edges",
                              "non_manifold_vertices",
                              "degenerate_triangles",
                              "self_intersections",
                              "euler",
                              "genus",
                              "closed",
                              "oriented",
                              "area_mm2",
                              "volume_mm3",
                              "min_angle_deg.min",
                              "min_angle_deg.p01",
                              "min_angle_deg.mean",
                              "max_angle_deg.max",
                              "max_angle_deg.p99",
                              "radius_ratio.min",
                              "radius_ratio.p01",
                              "radius_ratio.mean",
                              "edge_length_mm.min",
                              "edge_length_mm.mean",
                              "edge_length_mm.max",
                              "below_20_deg_percent",
                              "below_30_deg_percent",
                              "deviation.vertex.mean_mm",
                              "deviation.vertex.p99_mm",
                              "deviation.vertex.max_mm",
                              "deviation.centroid.mean_mm",
                              "deviation.centroid.p99_mm",
                              "deviation.centroid.max_mm"})
        wanted << QString(mesh) + key;
    QStringList missing;
    for (const QString& key : wanted)
      if (!hasKey(report, key)) missing << key;
    QVERIFY2(missing.isEmpty(), qPrintable(missing.join(", ")));

    QStringList stages;
    for (const QJsonValue& stage : report.value("stages").toArray())
      stages << stage.toObject().value("name").toString();
    QCOMPARE(stages, QStringList({"load", "preprocess", "vesselness", "seeds", "evolve", "correct",
                                  "surface", "smooth", "quality"}));
    QCOMPARE(report.value("parameters").toObject(),
             readJson(at("out/recipe.json")).value("parameters").toObject());
  }

  void reportNamesNoPath() {
    for (const char* name :
         {"out/report.json", "out/recipe.json", "out/methods.txt", "out/vessels.ply"}) {
      const QByteArray bytes = readBytes(at(name));
      QVERIFY(!bytes.contains(dir.path().toUtf8()));
      QVERIFY(!bytes.contains("image.mha"));
    }
  }

  void filesAgreeWithTheReport() {
    const QJsonObject report = readJson(at("out/report.json"));
    const QJsonObject mesh = report.value("mesh").toObject();
    const TriMesh ply = readMesh(nativePath(at("out/vessels.ply")));
    const TriMesh stl = readMesh(nativePath(at("out/vessels.stl")));
    QCOMPARE(static_cast<int>(ply.triangles.size()), mesh.value("triangles").toInt());
    QCOMPARE(static_cast<int>(ply.points.size()), mesh.value("vertices").toInt());
    QCOMPARE(stl.triangles.size(), ply.triangles.size());
    QVERIFY(mesh.value("closed").toBool() && mesh.value("oriented").toBool());
    const double volume = enclosedVolumeMm3(ply);
    QVERIFY(volume > 0.0);
    QVERIFY(std::fabs(volume / mesh.value("volume_mm3").toDouble() - 1.0) < 1e-6);

    const Volume<float> phi = readImage(nativePath(at("out/phi.nrrd"))).image;
    const auto inside =
        std::count_if(phi.voxels.begin(), phi.voxels.end(), [](float v) { return v < 0.0F; });
    QCOMPARE(static_cast<int>(inside),
             report.value("segmentation").toObject().value("inside_voxels").toInt());
    QVERIFY(report.value("truth").toObject().value("overlap").toDouble() > 60.0);
  }

  void maskLiesOnTheGridOfAnObliqueAnisotropicInput() {
    PhantomParams params;
    params.psf.kind = PointSpread::Kind::Subvoxels;
    params.kind = PhantomKind::Tube;
    params.size = {36, 36, 20};
    params.spacingMm = {0.8, 0.8, 1.6};
    params.radius = 3.0;
    Phantom phantom = makePhantom(params);
    Geometry geometry = phantom.image.geometry;
    geometry.direction << 0.8, -0.6, 0.0, 0.6, 0.8, 0.0, 0.0, 0.0, 1.0;
    geometry.origin = {-30.0, -12.5, -70.0};
    phantom.image.geometry = geometry;
    writeVolume(phantom.image, nativePath(at("oblique.nrrd")));

    const Eigen::Vector3d centre = geometry.toPhysical({17.5, 17.5, 9.5});
    QVERIFY(centre.x() < 0.0);
    const QString seed = QStringLiteral("%1,%2,%3").arg(centre.x()).arg(centre.y()).arg(centre.z());
    const CliResult run =
        cli(QStringList{"run", "oblique.nrrd", "-o", "oblique", "--seed", seed} + kQuick);
    QVERIFY2(run.code == 0, run.errors.constData());

    const Volume<float> mask = readImage(nativePath(at("oblique/mask.nrrd"))).image;
    QVERIFY(mask.geometry.size == geometry.size);
    QVERIFY((mask.geometry.origin - geometry.origin).norm() < 1e-6);
    QVERIFY((mask.geometry.direction - geometry.direction).norm() < 1e-6);
    QVERIFY((mask.geometry.spacing - geometry.spacing).norm() < 1e-6);
    for (const float value : mask.voxels) QVERIFY(value == 0.0F || value == 1.0F);
    QCOMPARE(mask.at(17, 17, 9), 1.0F);
    const QJsonObject report = readJson(at("oblique/report.json"));
    QVERIFY(report.value("working").toObject().value("size") !=
            report.value("input").toObject().value("size"));
    QCOMPARE(report.value("parameters")
                 .toObject()
                 .value("seeds")
                 .toObject()
                 .value("points")
                 .toArray()
                 .size(),
             3);
  }

  void aFormerRunIsReplacedOnlyByForce() {
    const QStringList again = QStringList{"run", "p/image.mha", "-o", "kept"} + kQuick;
    QCOMPARE(cli(again).code, 0);
    QFile note(at("kept/note.txt"));
    QVERIFY(note.open(QIODevice::WriteOnly));
    note.close();
    const QByteArray before = readBytes(at("kept/phi.nrrd"));

    const CliResult refused = cli(again);
    QCOMPARE(refused.code, 2);
    QVERIFY(refused.errors.contains("--force"));
    QCOMPARE(readBytes(at("kept/phi.nrrd")), before);

    QCOMPARE(cli(QStringList{"run", "missing.mha", "-o", "kept", "--force"}).code, 2);
    QCOMPARE(readBytes(at("kept/phi.nrrd")), before);

    const CliResult forced = cli(again + QStringList{"--force", "--until", "evolve"});
    QCOMPARE(forced.code, 0);
    QCOMPARE(filesIn(at("kept")), QStringList({"mask.nrrd", "note.txt", "params.json", "phi.nrrd",
                                               "preview.png", "recipe.json", "report.json"}));
  }

  void untilWritesWhatExists_data() {
    QTest::addColumn<QStringList>("files");
    QTest::addColumn<QString>("lastStage");
    const QStringList volumes{"mask.nrrd",   "params.json", "phi.nrrd",
                              "preview.png", "recipe.json", "report.json"};
    QTest::newRow("preprocess") << QStringList{"params.json", "preprocessed.nrrd", "recipe.json",
                                               "report.json"}
                                << "preprocess";
    QTest::newRow("vesselness") << QStringList{"params.json", "recipe.json", "report.json",
                                               "vesselness.nrrd"}
                                << "vesselness";
    QTest::newRow("seeds") << QStringList{"params.json", "recipe.json", "report.json",
                                          "vesselness.nrrd"}
                           << "seeds";
    QTest::newRow("evolve") << volumes << "evolve";
    QTest::newRow("surface") << kRunFiles << "surface";
    QTest::newRow("smooth") << kRunFiles << "smooth";
  }

  void untilWritesWhatExists() {
    QFETCH(QStringList, files);
    QFETCH(QString, lastStage);
    const QString step = QTest::currentDataTag();
    const QString folder = "until-" + step;
    const CliResult run =
        cli(QStringList{"run", "p/image.mha", "-o", folder, "--until", step} + kQuick);
    QVERIFY2(run.code == 0, run.errors.constData());
    QCOMPARE(filesIn(at(folder)), files);
    const QJsonObject report = readJson(at(folder + "/report.json"));
    QCOMPARE(report.value("stages").toArray().last().toObject().value("name").toString(),
             lastStage);
    QVERIFY(!report.contains("mesh"));
    QVERIFY(!report.contains("truth"));
    QCOMPARE(report.contains("segmentation"), files.contains("phi.nrrd"));
  }

  void theRecipeOfARunRepeatsIt() {
    QCOMPARE(cli({"run", "p/image.mha", "-o", "one", "--preset", "thesis", "--set",
                  "levelset.maxIterations=80", "--until", "evolve"})
                 .code,
             0);
    QCOMPARE(cli({"--threads", "1", "run", "p/image.mha", "-o", "two", "--recipe",
                  "one/recipe.json", "--until", "evolve"})
                 .code,
             0);
    QCOMPARE(readBytes(at("two/recipe.json")), readBytes(at("one/recipe.json")));
    QCOMPARE(readJson(at("two/report.json")).value("key"),
             readJson(at("one/report.json")).value("key"));
    QCOMPARE(readBytes(at("two/phi.nrrd")), readBytes(at("one/phi.nrrd")));
  }

  void otherMethodsSegmentToo() {
    const CliResult other =
        cli({"segment", "p/image.mha", "-o", "other.nrrd", "--method", "threshold"});
    QVERIFY2(other.code == 0, other.errors.constData());
    const CliResult run = cli({"run", "p/image.mha", "-o", "other", "--set",
                               "segmentation.method=threshold", "--until", "surface"});
    QVERIFY2(run.code == 0, run.errors.constData());
    QVERIFY(readImage(nativePath(at("other.nrrd"))).image.voxels ==
            readImage(nativePath(at("other/phi.nrrd"))).image.voxels);
    const QJsonObject report = readJson(at("other/report.json"));
    QVERIFY(hasKey(report, "segmentation.intensity.lower"));
    QVERIFY(!hasKey(report, "segmentation.thresholds.b"));
    QVERIFY(!hasKey(report, "segmentation.iterations"));
    const QJsonObject part = report.value("segmentation")
                                 .toObject()
                                 .value("component_list")
                                 .toArray()
                                 .first()
                                 .toObject();
    QVERIFY(part.value("length_mm").toDouble() > 0.0);
    QVERIFY(part.value("mean_radius_mm").toDouble() > 0.0);
    QVERIFY(part.value("kept").toBool() && !part.value("seeded").toBool());
    const CliResult unknown = cli({"segment", "p/image.mha", "-o", "x.nrrd", "--method", "snake"});
    QCOMPARE(unknown.code, 2);
    QVERIFY(unknown.errors.contains("geodesic-active-contour"));
  }

  void reportSaysWhatSmoothingDidToTheSize() {
    const QJsonObject report = readJson(at("out/report.json"));
    const auto number = [&](const char* block, const char* key) {
      return report.value(block).toObject().value(key).toDouble();
    };
    const double volume = number("mesh", "volume_mm3") / number("mesh_unsmoothed", "volume_mm3");
    const double area = number("mesh", "area_mm2") / number("mesh_unsmoothed", "area_mm2");
    QVERIFY(volume > 1.0);
    QVERIFY(std::abs(number("smoothing", "volume_change_percent") - 100.0 * (volume - 1.0)) < 1e-9);
    QVERIFY(std::abs(number("smoothing", "area_change_percent") - 100.0 * (area - 1.0)) < 1e-9);
    QVERIFY(std::abs(number("smoothing", "radius_change_percent") - 100.0 * (volume / area - 1.0)) <
            1e-9);
  }

  void progressIsJsonLines() {
    const CliResult run =
        cli(QStringList{"--progress", "json", "run", "p/image.mha", "-o", "progress"} + kQuick);
    QCOMPARE(run.code, 0);
    double last = 0.0;
    const QList<QByteArray> lines = run.errorLines();
    QVERIFY(!lines.isEmpty());
    for (const QByteArray& line : lines) {
      const QJsonObject state = QJsonDocument::fromJson(line).object();
      QVERIFY2(state.contains("phase"), line.constData());
      QVERIFY(state.value("fraction").toDouble() >= last);
      last = state.value("fraction").toDouble();
    }
    QCOMPARE(last, 1.0);
  }
};

QTEST_GUILESS_MAIN(TestCli)
#include "tst_cli.moc"
