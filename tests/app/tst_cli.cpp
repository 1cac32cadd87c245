// SPDX-License-Identifier: BSD-3-Clause
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/phantom/phantom.h"
#include "core/surface/tri_mesh.h"
#include "io/image_io.h"
#include "io/mesh_io.h"
#include "tests/app/cli_process.h"

using namespace angiomesh;

namespace {

/// A few iterations are enough where not the result but the files matter.
const QStringList kQuick{"--set", "levelset.maxIterations=150", "--set", "levelset.checkEvery=50"};

const QStringList kRunFiles{"marching-cubes.ply", "mask.nrrd",   "params.json",
                            "phi.nrrd",           "ports.json",  "preview.png",
                            "report.json",        "vessels.ply", "vessels.stl"};

QJsonObject readJson(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QJsonDocument::fromJson(file.readAll()).object();
}

QByteArray readBytes(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

std::string nativePath(const QString& path) { return path.toStdString(); }

/// Whether `object` has the key a.b.c.
bool hasKey(QJsonObject object, const QString& dotted) {
  const QStringList parts = dotted.split('.');
  for (qsizetype i = 0; i + 1 < parts.size(); ++i) {
    if (!object.value(parts[i]).isObject()) return false;
    object = object.value(parts[i]).toObject();
  }
  return object.contains(parts.back()) && !object.value(parts.back()).isNull();
}

}  // namespace

// angiomesh-cli as a user meets it: files, numbers, exit codes.
class TestCli : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir dir_;

  QString at(const QString& name) const { return dir_.filePath(name); }
  CliResult cli(const QStringList& arguments) const { return runCli(dir_.path(), arguments); }

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(dir_.isValid());
    const CliResult made = cli(
        {"phantom", "bifurcation", "--size", "40", "--radius", "3", "--noise", "10", "-o", "p"});
    QCOMPARE(made.errors, QByteArray());
    QCOMPARE(made.code, 0);
    QCOMPARE(filesIn(at("p")), QStringList({"image.mha", "truth.json", "truth.mha"}));
    const CliResult run =
        cli(QStringList{"run", "p/image.mha", "--truth", "p/truth.mha", "-o", "out"});
    QVERIFY2(run.code == 0, run.errors.constData());
    QVERIFY(run.output.contains("marching cubes"));
  }

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
    QVERIFY(!filesIn(dir_.path()).join(' ').contains("part"));
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
    QCOMPARE(stages, QStringList({"load", "preprocess", "vesselness", "seeds", "evolve", "surface",
                                  "smooth", "quality"}));
    QCOMPARE(report.value("parameters").toObject(), readJson(at("out/params.json")));
  }

  void reportNamesNoPath() {
    for (const char* name : {"out/report.json", "out/params.json", "out/vessels.ply"}) {
      const QByteArray bytes = readBytes(at(name));
      QVERIFY(!bytes.contains(dir_.path().toUtf8()));
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
                                               "preview.png", "report.json"}));
  }

  void untilWritesWhatExists_data() {
    QTest::addColumn<QStringList>("files");
    QTest::addColumn<QString>("lastStage");
    const QStringList always{"params.json", "report.json"};
    const QStringList volumes{"mask.nrrd", "params.json", "phi.nrrd", "preview.png", "report.json"};
    QTest::newRow("preprocess") << QStringList{"params.json", "preprocessed.nrrd", "report.json"}
                                << "preprocess";
    QTest::newRow("vesselness") << QStringList{"params.json", "report.json", "vesselness.nrrd"}
                                << "vesselness";
    QTest::newRow("seeds") << QStringList{"params.json", "report.json", "vesselness.nrrd"}
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

  void parametersOfARunRepeatIt() {
    QCOMPARE(cli({"run", "p/image.mha", "-o", "one", "--preset", "thesis", "--set",
                  "levelset.maxIterations=80", "--until", "evolve"})
                 .code,
             0);
    QCOMPARE(cli({"--threads", "1", "run", "p/image.mha", "-o", "two", "--params",
                  "one/params.json", "--until", "evolve"})
                 .code,
             0);
    QCOMPARE(readJson(at("two/params.json")), readJson(at("one/params.json")));
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

  void stepsAloneLeadToTheSameSurface() {
    QCOMPARE(cli({"vesselness", "p/image.mha", "-o", "v.nrrd"}).code, 0);
    const auto range = valueRange(readImage(nativePath(at("v.nrrd"))).image);
    QVERIFY(range[0] >= -1.0F && range[1] <= 1.0F && range[1] > 0.0F);

    const CliResult segment = cli({"segment", "p/image.mha", "-o", "phi.nrrd"});
    QVERIFY2(segment.code == 0, segment.errors.constData());
    QVERIFY(readImage(nativePath(at("phi.nrrd"))).image.voxels ==
            readImage(nativePath(at("out/phi.nrrd"))).image.voxels);
    const CliResult mesh = cli({"mesh", "phi.nrrd", "-o", "raw.ply", "--json"});
    QVERIFY2(mesh.code == 0, mesh.errors.constData());
    const QJsonObject report = readJson(at("out/report.json"));
    QCOMPARE(mesh.json().value("surface"), report.value("surface"));
    QCOMPARE(static_cast<int>(readMesh(nativePath(at("raw.ply"))).triangles.size()),
             report.value("mesh_unsmoothed").toObject().value("triangles").toInt());
    QCOMPARE(
        cli({"mesh", "phi.nrrd", "-o", "cubes.ply", "--set", "surface.method=marching-cubes"}).code,
        0);
    QVERIFY(readMesh(nativePath(at("cubes.ply"))).triangles ==
            readMesh(nativePath(at("out/marching-cubes.ply"))).triangles);
    QCOMPARE(cli({"smooth", "raw.ply", "-o", "smooth.ply", "--phi", "phi.nrrd"}).code, 0);
    QCOMPARE(readMesh(nativePath(at("smooth.ply"))).points.size(),
             readMesh(nativePath(at("raw.ply"))).points.size());
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

  void trianglesAreEstimatedBeforeMeshing() {
    const QStringList before = filesIn(dir_.path());
    const CliResult text = cli({"mesh", "out/phi.nrrd", "--estimate"});
    QVERIFY2(text.code == 0, text.errors.constData());
    QVERIFY(text.output.contains("triangles estimated"));
    const QJsonObject surface =
        cli({"mesh", "out/phi.nrrd", "--estimate", "--json"}).json().value("surface").toObject();
    const QJsonObject made = readJson(at("out/report.json")).value("surface").toObject();
    QCOMPARE(surface.value("estimated_triangles"), made.value("estimated_triangles"));
    double triangles = 0.0;
    for (const QJsonValue& part : made.value("components").toArray())
      triangles += part.toObject().value("triangles").toDouble();
    const double ratio = triangles / made.value("estimated_triangles").toDouble();
    QVERIFY2(ratio > 0.7 && ratio < 1.3, qPrintable(QString::number(ratio)));
    QCOMPARE(filesIn(dir_.path()), before);
  }

  void theRemesherIsAMethodOfItsOwn() {
    const CliResult mesh = cli(
        {"mesh", "out/phi.nrrd", "-o", "remeshed.ply", "--json", "--set", "surface.method=remesh"});
    QVERIFY2(mesh.code == 0, mesh.errors.constData());
    const QJsonObject surface = mesh.json().value("surface").toObject();
    QCOMPARE(surface.value("method").toString(), QString("remesh"));
    QVERIFY(!surface.contains("from_front_percent"));
    QCOMPARE(cli({"quality", "remeshed.ply", "--gate", "closed"}).code, 0);
  }

  void aMaskIsMeshedToo() {
    QCOMPARE(cli({"mesh", "p/truth.mha", "-o", "truth.stl"}).code, 0);
    const TriMesh mesh = readMesh(nativePath(at("truth.stl")));
    const Volume<std::uint8_t> truth = readMask(nativePath(at("p/truth.mha")));
    const auto voxels = std::count_if(truth.voxels.begin(), truth.voxels.end(),
                                      [](std::uint8_t v) { return v != 0; });
    QVERIFY(std::fabs(enclosedVolumeMm3(mesh) / static_cast<double>(voxels) - 1.0) < 0.15);
  }

  void qualityMeasuresAndGates() {
    const CliResult quality =
        cli({"quality", "out/vessels.ply", "--phi", "out/phi.nrrd", "--against",
             "out/marching-cubes.ply", "--gate", "closed", "--json"});
    QVERIFY2(quality.code == 0, quality.errors.constData());
    const QJsonObject report = readJson(at("out/report.json"));
    QCOMPARE(quality.json().value("mesh").toObject().value("triangles"),
             report.value("mesh").toObject().value("triangles"));
    QCOMPARE(quality.json().value("against").toObject().value("min_angle_deg"),
             report.value("marching_cubes").toObject().value("min_angle_deg"));
    QVERIFY(quality.json().value("gate").toObject().value("passed").toBool());

    QCOMPARE(cli(QStringList{"run", "p/image.mha", "-o", "open", "--set", "surface.border=open"} +
                 kQuick)
                 .code,
             0);
    const CliResult open = cli({"quality", "open/vessels.ply", "--gate", "closed"});
    QCOMPARE(open.code, 3);
    QVERIFY(open.errors.contains("boundary edges"));
    QVERIFY(!hasKey(readJson(at("open/report.json")), "mesh.volume_mm3"));
  }

  void qualityComparesWithTheZeroSet() {
    const auto measured = [this](const QStringList& more) {
      const CliResult result =
          cli(QStringList{"quality", "out/vessels.ply", "--phi", "out/phi.nrrd", "--json"} + more);
      return result.code == 0 ? result.json() : QJsonObject();
    };
    const QJsonObject report = measured({});
    const QJsonObject mesh = report.value("mesh").toObject();
    const QJsonObject zeroSet = report.value("zero_set").toObject();
    QVERIFY(hasKey(mesh, "deviation.centroid_times_curvature.p99"));
    const double change =
        100.0 *
        (mesh.value("volume_mm3").toDouble() / zeroSet.value("volume_mm3").toDouble() - 1.0);
    QVERIFY(std::fabs(change) < 10.0);
    QVERIFY(std::fabs(change - zeroSet.value("volume_change_percent").toDouble()) < 1e-9);
    // The plain B-spline smooths phi: its zero set encloses less.
    const QJsonObject smaller = measured({"--spline", "bspline"}).value("zero_set").toObject();
    QVERIFY(smaller.value("volume_mm3").toDouble() < zeroSet.value("volume_mm3").toDouble());
    QCOMPARE(measured({"--set", "surface.spline=bspline"}).value("zero_set").toObject(), smaller);
    QCOMPARE(cli({"quality", "out/vessels.ply", "--phi", "out/phi.nrrd", "--spline", "best"}).code,
             2);
    QVERIFY(!cli({"quality", "out/vessels.ply", "--json"}).json().contains("zero_set"));
  }

  void qualityComparesWithTheWantedEdgeLength() {
    const auto sizing = [this](const char* setting) {
      return cli({"quality", "out/vessels.ply", "--phi", "out/phi.nrrd", "--json", "--set",
                  setting})
          .json()
          .value("sizing")
          .toObject();
    };
    const QJsonObject fine = sizing("surface.rho=0.2");
    const QJsonObject coarse = sizing("surface.rho=0.4");
    QCOMPARE(fine.value("triangles"), coarse.value("triangles"));
    QVERIFY(fine.value("wanted_triangles").toDouble() >
            2.0 * coarse.value("wanted_triangles").toDouble());
    QVERIFY(fine.value("edge_ratio_mean").toDouble() > coarse.value("edge_ratio_mean").toDouble());
    const double inRange = coarse.value("edges_in_range_percent").toDouble();
    QVERIFY(inRange > 0.0 && inRange <= 100.0);
    const double excess =
        100.0 *
        (coarse.value("triangles").toDouble() / coarse.value("wanted_triangles").toDouble() - 1.0);
    QVERIFY(std::fabs(excess - coarse.value("triangle_excess_percent").toDouble()) < 1e-9);
    QVERIFY(std::fabs(coarse.value("estimated_triangles").toDouble() /
                          coarse.value("wanted_triangles").toDouble() -
                      1.0) < 0.25);
  }

  void theSolverGateIsStrict() {
    const CliResult result = cli({"quality", "out/marching-cubes.ply", "--gate", "solver"});
    QCOMPARE(result.code, 3);
    for (const char* what : {"least angle", "largest angle", "least radius ratio"})
      QVERIFY2(result.errors.contains(what), result.errors.constData());
  }

  void evaluateAgreesWithTheRun() {
    const QJsonObject truth = readJson(at("out/report.json")).value("truth").toObject();
    for (const char* name : {"out/phi.nrrd", "out/mask.nrrd"}) {
      const CliResult result = cli({"evaluate", name, "p/truth.mha", "--json"});
      QVERIFY2(result.code == 0, result.errors.constData());
      QCOMPARE(result.json().value("truth").toObject(), truth);
    }
    const CliResult self = cli({"evaluate", "p/truth.mha", "p/truth.mha", "--json"});
    QCOMPARE(self.json().value("truth").toObject().value("overlap").toDouble(), 100.0);
    QCOMPARE(self.json().value("truth").toObject().value("hd95_mm").toDouble(), 0.0);
  }

  void masksBecomeMeshesOfTheirVolume() {
    const CliResult mesh = cli({"mesh", "p/truth.mha", "-o", "mask.ply", "--json"});
    QVERIFY2(mesh.code == 0, mesh.errors.constData());
    const QJsonObject source = mesh.json().value("source").toObject();
    QCOMPARE(source.value("kind").toString(), QString("mask"));
    QVERIFY(source.value("largest_shift_voxels").toDouble() < 0.5);
    QVERIFY(std::fabs(source.value("volume_change_percent").toDouble()) < 1.0);

    // The same mask beside another label.
    Volume<std::uint8_t> labels = readMask(nativePath(at("p/truth.mha")));
    for (std::uint8_t& voxel : labels.voxels) voxel = voxel != 0 ? 5 : 0;
    labels.voxels[0] = 9;
    writeVolume(labels, nativePath(at("labels.nii.gz")));
    const CliResult none = cli({"mesh", "labels.nii.gz", "-o", "label.ply"});
    QCOMPARE(none.code, 2);
    QVERIFY(none.errors.contains("9 (1 voxels)") && none.errors.contains("--label"));
    const CliResult five =
        cli({"mesh", "labels.nii.gz", "-o", "label.ply", "--label", "5", "--json"});
    QVERIFY2(five.code == 0, five.errors.constData());
    QCOMPARE(five.json().value("source").toObject().value("kind").toString(), QString("label"));
    QCOMPARE(five.json().value("surface"), mesh.json().value("surface"));
    const QJsonArray listed =
        cli({"info", "labels.nii.gz", "--json"}).json()["input"].toObject()["labels"].toArray();
    QCOMPARE(listed.size(), 2);
    QCOMPARE(listed.at(1).toObject().value("value").toInt(), 9);
  }

  void convertKeepsValuesAndPlaces() {
    QCOMPARE(cli({"convert", "p/image.mha", "-o", "image.nii.gz"}).code, 0);
    const Volume<float> before = readImage(nativePath(at("p/image.mha"))).image;
    const Volume<float> after = readImage(nativePath(at("image.nii.gz"))).image;
    QVERIFY(after.voxels == before.voxels);
    QVERIFY((after.geometry.direction - before.geometry.direction).norm() < 1e-6);
    QVERIFY((after.geometry.origin - before.geometry.origin).norm() < 1e-4);

    QCOMPARE(
        cli({"convert", "out/vessels.ply", "-o", "m.stl", "--unit", "m", "--frame", "ras"}).code,
        0);
    const double mm3 = enclosedVolumeMm3(readMesh(nativePath(at("out/vessels.ply"))));
    const double again = enclosedVolumeMm3(readMesh(nativePath(at("m.stl"))));
    QVERIFY(std::fabs(again / mm3 - 1.0) < 1e-3 || std::fabs(again * 1e9 / mm3 - 1.0) < 1e-3);
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
