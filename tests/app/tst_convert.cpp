// SPDX-License-Identifier: BSD-3-Clause
#include <QFile>
#include <QTest>
#include <filesystem>

#include "core/mesh/outward.h"
#include "io/mesh/mesh_io.h"
#include "tests/app/cli_process.h"
#include "tests/core/mesh_shapes.h"
#include "tests/io/mesh_samples.h"

using namespace angiomesh;
using namespace angiomesh::test;

/// Meshes from one format to another on the command line.
class TestConvert : public QObject, CliFolder {
  Q_OBJECT

 private:
  const Eigen::Vector3d centre_{10, 20, 30};

  [[nodiscard]] std::filesystem::path place(const QString& name) const {
    return at(name).toStdString();
  }
  [[nodiscard]] Eigen::Vector3d middle(const QString& name) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const TriMesh mesh = readMesh(place(name));
    for (const auto& p : mesh.points) sum += p;
    return sum / static_cast<double>(mesh.points.size());
  }

  /// A cube: "wall_1" of eight triangles and "roe_jane" of four, two opposite sides.
  void writeSolids() const {
    TriMesh mesh = shapes::cube();
    mesh.patch = readPatches();
    MeshWriteOptions write;
    write.encoding = MeshEncoding::Ascii;
    write.patchNames = {"wall", "wall_1", "roe_jane"};
    writeMesh(mesh, place("solids.stl"), write);
  }
  static std::vector<std::uint16_t> readPatches() { return {1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2}; }

 private Q_SLOTS:
  void initTestCase() {
    TriMesh ball = shapes::icosphere(2);
    for (auto& p : ball.points) p = centre_ + 5.0 * p;
    writeMesh(ball, place("ball.ply"));
    // The same without a word on its frame, and inside out.
    QByteArray text;
    for (const auto& p : ball.points)
      text += QString("v %1 %2 %3\n").arg(p.x()).arg(p.y()).arg(p.z()).toLatin1();
    QByteArray faces, turned;
    for (const auto& t : ball.triangles) {
      faces += QString("f %1 %2 %3\n").arg(t[0] + 1).arg(t[1] + 1).arg(t[2] + 1).toLatin1();
      turned += QString("f %1 %3 %2\n").arg(t[0] + 1).arg(t[1] + 1).arg(t[2] + 1).toLatin1();
    }
    QFile silent(at("silent.obj")), inside(at("inside.obj"));
    QVERIFY(silent.open(QIODevice::WriteOnly) && inside.open(QIODevice::WriteOnly));
    silent.write(text + faces);
    inside.write("# SPACE=LPS\n" + text + turned);
  }

  void everyFormatHoldsTheMesh_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QStringList>("more");
    QTest::newRow("ply") << "a.ply" << QStringList{"--normals", "--quality"};
    QTest::newRow("ply text") << "b.ply" << QStringList{"--ascii", "--quality"};
    QTest::newRow("stl") << "a.stl" << QStringList{"--unit", "m", "--frame", "ras"};
    QTest::newRow("stl text") << "b.stl" << QStringList{"--ascii", "--unit", "m"};
    QTest::newRow("obj") << "a.obj" << QStringList{"--frame", "ras"};
    QTest::newRow("vtp") << "a.vtp" << QStringList{"--normals", "--unit", "m"};
  }
  void everyFormatHoldsTheMesh() {
    QFETCH(QString, name);
    QFETCH(QStringList, more);
    const CliResult result = cli(QStringList{"convert", "ball.ply", "-o", name} + more);
    QVERIFY2(result.code == 0 && result.errors.isEmpty(), result.errors.constData());
    const LoadedMesh mesh = loadMesh(place(name));
    QVERIFY(isClosed(mesh.mesh));
    QVERIFY((middle(name) - centre_).norm() < 1e-5);
    QCOMPARE(mesh.hasNormals, more.contains("--normals"));
    QCOMPARE(mesh.hasQuality, more.contains("--quality"));
    QVERIFY(mesh.unit == (more.contains("m") ? LengthUnit::Metre : LengthUnit::Millimetre));
    QVERIFY(mesh.frame == (more.contains("ras") ? Frame::Ras : Frame::Lps));
    if (name == "b.ply") QVERIFY(readBytes(at(name)).startsWith("ply\nformat ascii 1.0\n"));
    if (name == "b.stl")
      QVERIFY(readBytes(at(name)).startsWith("solid surface SPACE=LPS UNIT=m\n"));
    if (name == "a.stl") QVERIFY(!readBytes(at(name)).startsWith("solid"));
  }

  void theFrameOfASilentMeshIsAskedFor() {
    const CliResult silent = cli({"convert", "silent.obj", "-o", "silent.ply"});
    QCOMPARE(silent.code, 0);
    QVERIFY(silent.errors.contains("warning: ") && silent.errors.contains("--from-frame"));
    QVERIFY((middle("silent.ply") - centre_).norm() < 1e-3);
    const CliResult told =
        cli({"convert", "silent.obj", "-o", "told.ply", "--from-frame", "ras", "--from-unit", "m"});
    QVERIFY2(told.code == 0 && told.errors.isEmpty(), told.errors.constData());
    const Eigen::Vector3d turned(-1e3 * centre_.x(), -1e3 * centre_.y(), 1e3 * centre_.z());
    QVERIFY((middle("told.ply") - turned).norm() < 1.0);
    const CliResult overruled =
        cli({"convert", "ball.ply", "-o", "told.ply", "--from-frame", "ras"});
    QCOMPARE(overruled.code, 0);
    QVERIFY(overruled.errors.contains("the header says LPS"));
  }

  void qualityTakesTheFrameToo() {
    const QString mm = "area_mm2";
    const auto area = [&](const QStringList& more) {
      return cli(QStringList{"quality", "silent.obj", "--json"} + more)
          .json()
          .value("mesh")
          .toObject()
          .value(mm)
          .toDouble();
    };
    QVERIFY(area({}) > 100.0);
    QVERIFY(std::abs(area({"--unit", "m"}) / (1e6 * area({})) - 1.0) < 1e-9);
    QCOMPARE(area({"--frame", "ras"}), area({}));
    QCOMPARE(cli({"quality", "silent.obj", "--frame", "lap"}).code, 2);
    const CliResult against = cli({"quality", "silent.obj", "--against", "inside.obj"});
    QCOMPARE(against.code, 0);
    QVERIFY(against.errors.contains("inside out"));
  }

  void insideOutIsTurnedWithAWarning() {
    const CliResult result = cli({"convert", "inside.obj", "-o", "turned.vtp"});
    QCOMPARE(result.code, 0);
    QVERIFY(result.errors.contains("inside out"));
    QVERIFY(loadMesh(place("turned.vtp")).warnings.empty());
  }

  void solidsGoFromStlToStl() {
    writeSolids();
    for (const bool named : {false, true}) {
      QStringList command{"convert", "solids.stl", "-o", "again.stl", "--ascii"};
      if (named) command << "--solid-names";
      const CliResult result = cli(command);
      QCOMPARE(result.code, 0);
      QCOMPARE(result.errors.contains("--solid-names"), !named);
      const LoadedMesh back = loadMesh(place("again.stl"));
      QCOMPARE(back.patchNames,
               (std::vector<std::string>{"wall", "wall_1", named ? "roe_jane" : "part-2"}));
      QCOMPARE(back.mesh.patch, readPatches());
    }
  }

  void patchesGoFromFormatToFormat_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"again.ply", "again.obj", "again.vtp"}) QTest::newRow(name) << name;
  }
  void patchesGoFromFormatToFormat() {
    QFETCH(QString, name);
    writeSolids();
    for (const bool named : {false, true}) {
      QStringList command{"convert", "solids.stl", "-o", name};
      if (named) command << "--solid-names";
      const CliResult result = cli(command);
      QCOMPARE(result.code, 0);
      QCOMPARE(result.errors.contains("--solid-names"), !named);
      const LoadedMesh back = loadMesh(place(name));
      QCOMPARE(back.patchNames.back(), std::string(named ? "roe_jane" : "part-2"));
      QCOMPARE(back.mesh.patch, readPatches());
    }
  }

  void aBinaryStlFileSaysThatItLosesThePatches() {
    writeSolids();
    const CliResult result = cli({"convert", "solids.stl", "-o", "lost.stl"});
    QCOMPARE(result.code, 0);
    QVERIFY(result.errors.contains("patches are lost") && result.errors.contains("VTP"));
    QVERIFY(!result.errors.contains("--solid-names"));
    QVERIFY(loadMesh(place("lost.stl")).mesh.patch.empty());
  }

  void eachPatchGoesToAFileOfItsOwn() {
    writeSolids();
    const CliResult result = cli({"convert", "solids.stl", "-o", "all.ply", "--patch-files",
                                  "--solid-names", "--unit", "m"});
    QVERIFY2(result.code == 0 && result.errors.isEmpty(), result.errors.constData());
    QCOMPARE(readMesh(place("all.ply")).triangles.size(), std::size_t{12});
    const LoadedMesh first = loadMesh(place("all_wall_1.ply")),
                     second = loadMesh(place("all_roe_jane.ply"));
    QCOMPARE(first.mesh.triangles.size(), std::size_t{8});
    QCOMPARE(second.mesh.triangles.size(), std::size_t{4});
    QVERIFY(second.unit == LengthUnit::Metre);
    QVERIFY(std::abs(surfaceAreaMm2(first.mesh) - 4.0) < 1e-9);
    QVERIFY(std::abs(surfaceAreaMm2(second.mesh) - 2.0) < 1e-9);
    QVERIFY(!std::filesystem::exists(place("all_wall.ply")));
    const CliResult none = cli({"convert", "ball.ply", "-o", "none.ply", "--patch-files"});
    QCOMPARE(none.code, 2);
    QVERIFY(none.errors.contains("no patches") && !std::filesystem::exists(place("none.ply")));
  }

  void aCaseForOpenFoamIsWritten() {
    MeshWriteOptions write;
    write.patchNames = {"wall", "inlet_1", "roe_jane"};
    writeMesh(cappedTube(24, 9, 2.0), place("tube.vtp"), write);
    const QStringList command{"convert", "tube.vtp", "-o", "foam", "--openfoam"};
    const CliResult result = cli(command);
    QCOMPARE(result.code, 0);
    QVERIFY(result.errors.contains("--solid-names"));
    const LoadedMesh surface = loadMesh(place("foam/constant/triSurface/vessel.stl"));
    QCOMPARE(surface.patchNames, (std::vector<std::string>{"wall", "inlet_1", "part-2"}));
    QVERIFY(surface.unit == LengthUnit::Metre);
    QVERIFY(readBytes(at("foam/system/snappyHexMeshDict")).contains("part-2 { name part-2; }"));
    QVERIFY(!readBytes(at("foam/system/snappyHexMeshDict")).contains("roe_jane"));

    const CliResult again = cli(command);
    QCOMPARE(again.code, 2);
    QVERIFY(again.errors.contains("--force"));
    const CliResult forced = cli(command + QStringList{"--force", "--solid-names"});
    QVERIFY2(forced.code == 0 && forced.errors.isEmpty(), forced.errors.constData());
    QVERIFY(readBytes(at("foam/system/snappyHexMeshDict")).contains("roe_jane { name roe_jane; }"));
  }

  void whichNameIsWrongIsSaid() {
    QFile volume(at("a.nrrd"));
    QVERIFY(volume.open(QIODevice::WriteOnly));
    volume.write("NRRD0004\n");
    volume.close();
    const auto said = [&](const QString& line) {
      const CliResult result = cli(line.split(' '));
      return result.code == 2 ? QString(result.errors) : QString("no error");
    };
    for (const QString name : {"x.vtu", "x", "x.vtk"}) {
      const QString error = said("convert ball.ply -o " + name);
      QVERIFY(error.contains(name) && !error.contains("ball.ply"));
      QVERIFY(error.contains(".ply, .stl, .obj, .off or .vtp"));
      QVERIFY(said("smooth missing.ply -o " + name).contains(name));
    }
    QVERIFY(said("convert ball.ply -o x.nrrd").contains("does not become a volume, x.nrrd"));
    QVERIFY(said("convert a.nrrd -o x.stl").contains("'mesh'"));
    QVERIFY(said("mesh missing.nrrd -o x.vtu").contains("x.vtu"));
  }

  void anOpenSurfaceForOpenFoamIsCalledOpen() {
    writeMesh(shapes::openTube(24, 9, 2.0), place("open.stl"));
    const CliResult result = cli({"convert", "open.stl", "-o", "openfoam", "--openfoam"});
    QCOMPARE(result.code, 2);
    QVERIFY(result.errors.contains("is not closed (48 open edges, 0 of"));
    QVERIFY(result.errors.contains("--merge-distance") && result.errors.contains("--cut"));
  }

  void pointsAndCracksAreJoinedAsAsked() {
    TriMesh soup;
    const TriMesh tube = cappedTube(24, 9, 2.0);
    double gap = 0.0;
    for (const auto& triangle : tube.triangles)
      for (const std::uint32_t corner : triangle) {
        soup.points.emplace_back(tube.points[corner] + Eigen::Vector3d(gap, 0.0, -gap));
        gap = 1e-6 - gap;
      }
    for (std::uint32_t p = 0; p < soup.points.size(); p += 3)
      soup.triangles.push_back({p, p + 1, p + 2});
    writeMesh(soup, place("cracks.ply"));
    const auto closed = [&](const QStringList& more) {
      const CliResult result = cli(QStringList{"quality", "cracks.ply", "--json"} + more);
      return result.json()["mesh"].toObject()["closed"].toBool();
    };
    QVERIFY(!closed({}) && closed({"--merge-distance", "1e-5"}));
    const CliResult converted =
        cli({"convert", "cracks.ply", "-o", "whole.stl", "--merge-distance", "1e-5"});
    QCOMPARE(converted.code, 0);
    QVERIFY(converted.errors.contains("at open edges became one with another one"));
    QVERIFY(isClosed(readMesh(place("whole.stl"))));
    QCOMPARE(cli({"smooth", "cracks.ply", "-o", "whole.ply", "--merge-distance", "1e-5"}).code, 0);
    QVERIFY(isClosed(readMesh(place("whole.ply"))));
    QCOMPARE(cli({"quality", "cracks.ply", "--merge-distance", "0"}).code, 2);
    QCOMPARE(cli({"convert", "cracks.ply", "-o", "kept.ply", "--keep-points"}).code, 0);
    MeshReadOptions keep;
    keep.keepPoints = true;
    QCOMPARE(loadMesh(place("kept.ply"), keep).mesh.points.size(), soup.points.size());
  }

  void smoothingKeepsThePatches() {
    writeSolids();
    const CliResult result =
        cli({"smooth", "solids.stl", "-o", "smooth.vtp", "--set", "smooth.method=taubin"});
    QVERIFY2(result.code == 0, result.errors.constData());
    const LoadedMesh back = loadMesh(place("smooth.vtp"));
    QCOMPARE(back.mesh.patch, readPatches());
    QCOMPARE(back.patchNames.back(), std::string("part-2"));
  }

  void whatTheOutputHasNotIsRefused_data() {
    QTest::addColumn<QString>("line");
    for (const char* line :
         {"convert ball.ply -o x.stl --normals", "convert ball.ply -o x.obj --quality",
          "convert ball.ply -o x.vtp --ascii", "convert ball.ply -o x.nrrd --unit m",
          "convert ball.ply -o x.nrrd --ascii", "convert ball.ply -o x.ply --from-frame up",
          "convert ball.ply -o x.stl --solid-names", "convert ball.ply -o x.nrrd --patch-files",
          "convert ball.ply -o x --openfoam", "convert ball.ply -o x --openfoam --ascii"})
      QTest::newRow(line) << line;
  }
  void whatTheOutputHasNotIsRefused() {
    QFETCH(QString, line);
    const QStringList before = filesIn(dir.path());
    const CliResult result = cli(line.split(' '));
    QCOMPARE(result.code, 2);
    QCOMPARE(result.errorLines().size(), 1);
    QCOMPARE(filesIn(dir.path()), before);
  }
};

QTEST_GUILESS_MAIN(TestConvert)
#include "tst_convert.moc"
