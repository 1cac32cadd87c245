// SPDX-License-Identifier: BSD-3-Clause
#include <QJsonArray>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/mesh/tri_mesh.h"
#include "io/mesh/mesh_io.h"
#include "io/scan/image_io.h"
#include "io/volume/image_write.h"
#include "tests/app/cli_run.h"

using namespace angiomesh;

// The commands that do one step, on what a run wrote.
class TestCliSteps : public QObject, CliRun {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { makeRun(); }

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

  void trianglesAreEstimatedBeforeMeshing() {
    const QStringList before = filesIn(dir.path());
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
    QCOMPARE(filesIn(dir.path()), before);
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
    const Volume<std::uint8_t> truth = readMask(nativePath(at("p/truth.mha"))).mask;
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
    const QJsonObject fine = sizing("surface.edgeMinVoxels=0.25");
    const QJsonObject coarse = sizing("surface.edgeMinVoxels=0.5");
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
    // Voxels that are inside by half of their volume miss h^2 / 24 times the curvature of the wall.
    QVERIFY(std::fabs(source.value("volume_change_percent").toDouble()) < 1.25);

    // The same mask beside another label.
    Volume<std::uint8_t> labels = readMask(nativePath(at("p/truth.mha"))).mask;
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

  void whatIsKeptIsKeptBeforeTheSurfaceToo() {
    Geometry grid;
    grid.size = {24, 12, 12};
    Volume<std::uint8_t> boxes(grid);
    for (int k = 3; k < 9; ++k)
      for (int j = 3; j < 9; ++j)
        for (int i = 3; i < 20; ++i)
          if (i < 13 || i > 15) boxes.at(i, j, k) = 1;
    writeVolume(boxes, nativePath(at("boxes.mha")));
    const QStringList call{"run",   "boxes.mha",
                           "--set", "segmentation.method=label",
                           "--set", "segmentation.keep=largest"};
    for (const QStringList& until : {QStringList{}, {"--until", "evolve"}}) {
      QCOMPARE(cli(call + until + QStringList{"-o", "kept", "--force"}).code, 0);
      const Volume<std::uint8_t> mask = readMask(nativePath(at("kept/mask.nrrd"))).mask;
      QVERIFY(mask.at(8, 6, 6) == 1 && mask.at(18, 6, 6) == 0);
      const Volume<float> phi = readImage(nativePath(at("kept/phi.nrrd"))).image;
      QVERIFY(phi.at(8, 6, 6) < 0.0F && phi.at(18, 6, 6) > 0.0F);
    }
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
};

QTEST_GUILESS_MAIN(TestCliSteps)
#include "tst_cli_steps.moc"
