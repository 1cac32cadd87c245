// SPDX-License-Identifier: BSD-3-Clause
#include <QRegularExpression>
#include <QTest>
#include <cmath>
#include <functional>
#include <map>

#include "core/base/error.h"
#include "core/mesh/outward.h"
#include "io/mesh/mesh_io.h"
#include "io/vessel/openfoam_case.h"
#include "tests/io/external_mesher.h"
#include "tests/io/mesh_samples.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

constexpr double kRadius = 2.0;

/// A capped tube whose far end is `narrowing` times as wide as the near one.
TriMesh tube(int rings = 13, double narrowing = 1.0) {
  TriMesh mesh = cappedTube(48, rings, kRadius);
  double length = 0.0;
  for (const auto& p : mesh.points) length = std::max(length, p.z());
  for (auto& p : mesh.points) {
    p.head<2>() *= 1.0 + (narrowing - 1.0) * p.z() / length;
    p += Eigen::Vector3d(-31.3, 44.9, 712.6);
  }
  return mesh;
}

std::vector<Port> portsOf(const TriMesh& mesh, const std::vector<std::string>& names) {
  std::vector<Port> ports = measurePatches(mesh, names.size());
  for (std::size_t n = 0; n < names.size(); ++n) ports[n].name = names[n];
  return ports;
}

std::vector<Port> twoPorts(const TriMesh& mesh) { return portsOf(mesh, {"inlet", "outlet"}); }

/// The numbers behind a word in a file of the case.
std::vector<double> numbersBehind(const fs::path& file, const QString& word) {
  const QString text = QString::fromStdString(bytesOf(file));
  const QRegularExpression line(word + "\\s*\\(([^()]*)\\)");
  std::vector<double> numbers;
  for (const QString& number : line.match(text).captured(1).split(' ', Qt::SkipEmptyParts))
    numbers.push_back(number.toDouble());
  return numbers;
}

}  // namespace

class TestOpenFoamCase : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theSurfaceIsInMetresWithItsPatches() {
    const Folder folder;
    const TriMesh mesh = tube();
    const OpenFoamCase written = writeOpenFoamCase(insideOut(mesh), twoPorts(mesh), folder / "a");
    QVERIFY(written.warnings.empty());
    const LoadedMesh surface = loadMesh(folder / "a/constant/triSurface/vessel.stl");
    QCOMPARE(surface.patchNames, (std::vector<std::string>{"wall", "inlet", "outlet"}));
    QVERIFY(surface.unit == LengthUnit::Metre && surface.warnings.empty());
    QVERIFY(portFaults(twoPorts(mesh), surface.mesh).empty());
    QVERIFY(isClosed(surface.mesh));
    for (const char* name :
         {"Allrun", "README.txt", "system/controlDict", "system/fvSchemes", "system/fvSolution",
          "system/blockMeshDict", "system/snappyHexMeshDict", "system/surfaceFeatureExtractDict"}) {
      const std::string text = bytesOf(folder / "a" / name);
      QVERIFY2(!text.empty(), name);
      QVERIFY2(text.find(folder.path().string()) == std::string::npos, name);
      QCOMPARE(std::count(text.begin(), text.end(), '{'),
               std::count(text.begin(), text.end(), '}'));
    }
    QVERIFY((fs::status(folder / "a/Allrun").permissions() & fs::perms::owner_exec) !=
            fs::perms::none);
    QCOMPARE(entriesOf(folder.path()), 1);
  }

  void cellsFitTheNarrowestPort_data() {
    QTest::addColumn<int>("rings");
    QTest::addColumn<double>("narrowing");
    QTest::newRow("short") << 13 << 1.0;
    QTest::newRow("narrow end") << 61 << 0.2;
    QTest::newRow("long") << 901 << 0.1;
  }
  void cellsFitTheNarrowestPort() {
    QFETCH(int, rings);
    QFETCH(double, narrowing);
    const Folder folder;
    const TriMesh mesh = tube(rings, narrowing);
    const OpenFoamMesh plan = writeOpenFoamCase(mesh, twoPorts(mesh), folder / "a").mesh;
    const double finest = std::ldexp(plan.cell, -plan.finest);
    QVERIFY(std::fabs(2e-3 * narrowing * kRadius / finest - 11.0) < 0.1);
    const double wide = std::ldexp(plan.cell, -plan.levels[1]);
    QVERIFY(2e-3 * kRadius / wide > 10.9 && (plan.levels[1] == 0 || 2e-3 * kRadius / wide < 22.0));
    QCOMPARE(plan.levels[2], plan.finest);
    QCOMPARE(plan.levels[0], plan.levels[1]);
    QVERIFY(1.0 * plan.cells[0] * plan.cells[1] * plan.cells[2] < 2.5e5);
    for (int a = 0; a < 3; ++a) {
      const double cells = (plan.high[a] - plan.low[a]) / plan.cell;
      QVERIFY(std::fabs(cells - plan.cells[static_cast<std::size_t>(a)]) < 1e-9 * cells);
      for (const auto& p : mesh.points)
        QVERIFY(1e-3 * p[a] > plan.low[a] + plan.cell && 1e-3 * p[a] < plan.high[a] - plan.cell);
      // Away from the faces of cells of any level.
      const double place = (plan.inside[a] - plan.low[a]) / finest;
      QVERIFY(std::fabs(place - std::floor(place) - 0.5) < 0.01);
    }
    const fs::path system = folder / "a/system";
    QCOMPARE(numbersBehind(system / "blockMeshDict", "\\(0 1 2 3 4 5 6 7\\)"),
             (std::vector<double>(plan.cells.begin(), plan.cells.end())));
    const std::vector<double> inside =
        numbersBehind(system / "snappyHexMeshDict", "locationInMesh");
    QCOMPARE(inside, std::vector<double>(plan.inside.data(), plan.inside.data() + 3));
    // Within the cone, not near its wall.
    const double z = 1e3 * inside[2] - 712.6;
    const double length = (rings - 1) * 2.0 * kRadius * std::sin(M_PI / 48) * std::sqrt(0.75);
    QVERIFY(z > 0.0 && z < length);
    const double radius = kRadius * (1.0 + (narrowing - 1.0) * z / length);
    QVERIFY(std::hypot(1e3 * inside[0] + 31.3, 1e3 * inside[1] - 44.9) < 0.6 * radius);
  }

  void namesAreWordsOfADictionary() {
    const Folder folder;
    const TriMesh mesh = tube();
    const OpenFoamMesh plan =
        writeOpenFoamCase(mesh, portsOf(mesh, {"1", "a b.c;}\"/"}), folder / "a").mesh;
    QCOMPARE(plan.patches, (std::vector<std::string>{"wall", "port_1", "a_b_c____"}));
    const OpenFoamMesh same =
        writeOpenFoamCase(mesh, portsOf(mesh, {"WALL", "Wall"}), folder / "b").mesh;
    QCOMPARE(same.patches, (std::vector<std::string>{"wall", "WALL-2", "Wall-3"}));
    QCOMPARE(loadMesh(folder / "b/constant/triSurface/vessel.stl").patchNames, same.patches);
  }

  void whatCannotBeFilledIsRefusedInWords() {
    const Folder folder;
    const TriMesh mesh = tube();
    const auto complaint = [&](const TriMesh& with, const std::vector<Port>& ports) {
      return messageOf([&] { writeOpenFoamCase(with, ports, folder / "a"); });
    };
    TriMesh open = mesh;
    open.triangles.pop_back();
    open.patch.pop_back();
    QVERIFY(complaint(open, twoPorts(mesh)).contains("not closed"));
    TriMesh plain = mesh;
    plain.patch.clear();
    QVERIFY(complaint(plain, {}).contains("no ports"));
    QVERIFY(complaint(plain, twoPorts(mesh)).contains("no ports"));
    QVERIFY(complaint(mesh, portsOf(mesh, {"inlet"})).contains("in patch 2, and there are 1"));
    QVERIFY(complaint(mesh, portsOf(mesh, {"a", "b", "lost"})).contains("'lost' has no triangles"));
    TriMesh bare = mesh;
    for (auto& patch : bare.patch) patch = std::max<std::uint16_t>(1, patch);
    QVERIFY(complaint(bare, twoPorts(mesh)).contains("'wall' has no triangles"));
    QCOMPARE(entriesOf(folder.path()), 0);
  }

  void aSecondComponentIsSpokenOf() {
    const Folder folder;
    TriMesh mesh = tube();
    TriMesh ball = shapes::icosphere(2);
    shapes::append(mesh, ball);
    mesh.patch.resize(mesh.triangles.size(), 0);
    const OpenFoamCase written = writeOpenFoamCase(mesh, twoPorts(mesh), folder / "a");
    QCOMPARE(written.warnings.size(), std::size_t{1});
    QVERIFY(QString::fromStdString(written.warnings[0]).contains("2 components"));
    QVERIFY(written.mesh.inside.z() > 0.7);
  }

  void whatIsThereIsNotLost() {
    const Folder folder;
    const TriMesh mesh = tube();
    fs::create_directory(folder / "empty");
    writeOpenFoamCase(mesh, twoPorts(mesh), folder / "empty/");
    save(folder / "empty/mine", "x");
    save(folder / "empty/system/controlDict", "old");
    QVERIFY(messageOf([&] {
              writeOpenFoamCase(mesh, twoPorts(mesh), folder / "empty");
            }).contains("not empty"));
    QCOMPARE(bytesOf(folder / "empty/system/controlDict"), std::string("old"));
    writeOpenFoamCase(mesh, twoPorts(mesh), folder / "empty", true);
    QVERIFY(bytesOf(folder / "empty/system/controlDict") != "old");
    QCOMPARE(bytesOf(folder / "empty/mine"), std::string("x"));
    save(folder / "file", "x");
    for (const char* name : {"file", "none/a", "file/a"})
      QVERIFY_THROWS_EXCEPTION(IoError, writeOpenFoamCase(mesh, twoPorts(mesh), folder / name));
    // One of the names is taken by a folder: nothing of the former case is lost.
    fs::remove(folder / "empty/system/fvSchemes");
    fs::create_directories(folder / "empty/system/fvSchemes/x");
    save(folder / "empty/README.txt", "former");
    writeOpenFoamCase(mesh, twoPorts(mesh), folder / "empty", true);
    {
      const FullDisk full(200);
      QVERIFY_THROWS_EXCEPTION(IoError, writeOpenFoamCase(mesh, twoPorts(mesh), folder / "b"));
      QVERIFY_THROWS_EXCEPTION(IoError,
                               writeOpenFoamCase(mesh, twoPorts(mesh), folder / "empty", true));
    }
    QCOMPARE(entriesOf(folder.path()), 2);
  }

  void openFoamMeshesIt_data() {
    QTest::addColumn<int>("rings");
    QTest::addColumn<double>("narrowing");
    QTest::newRow("tube") << 25 << 1.0;
    QTest::newRow("cone with levels") << 61 << 0.4;
  }
  void openFoamMeshesIt() {
    if (!isInstalled("snappyHexMesh") || !isInstalled("checkMesh"))
      QSKIP("OpenFOAM is not installed");
    QFETCH(int, rings);
    QFETCH(double, narrowing);
    const Folder folder;
    const TriMesh mesh = tube(rings, narrowing);
    const OpenFoamMesh plan = writeOpenFoamCase(mesh, twoPorts(mesh), folder / "a").mesh;
    QString log;
    const bool fine =
        runProgram(QString::fromStdString((folder / "a/Allrun").string()), {}, folder.path(), log);
    const QString check = QString::fromStdString(bytesOf(folder / "a/log.checkMesh"));
    QVERIFY2(fine, qPrintable(log + check));
    const QString boundary =
        QString::fromStdString(bytesOf(folder / "a/constant/polyMesh/boundary"));
    for (const auto& [name, type] :
         std::map<QString, QString>{{"wall", "wall"}, {"inlet", "patch"}, {"outlet", "patch"}}) {
      const QRegularExpression entry("\\n\\s+" + name +
                                     "\\s*\\{\\s*type\\s+(\\w+);[^}]*nFaces\\s+(\\d+);");
      const auto match = entry.match(boundary);
      QVERIFY2(match.hasMatch(), qPrintable(boundary));
      QCOMPARE(match.captured(1), type);
      // A disc of 11 cells across has 95 of them.
      QVERIFY2(match.captured(2).toInt() > 70, qPrintable(boundary));
    }
    QVERIFY(!boundary.contains("background"));
    static const QRegularExpression volume("Total volume = ([0-9.e+-]+)\\.");
    const double filled = volume.match(check).captured(1).toDouble();
    const double wanted = 1e-9 * enclosedVolumeMm3(mesh);
    QVERIFY2(std::fabs(filled / wanted - 1.0) < 0.02,
             qPrintable(QString("%1 instead of %2").arg(filled).arg(wanted)));
    QCOMPARE(plan.finest, narrowing < 0.5 ? 1 : 0);
  }
};

QTEST_GUILESS_MAIN(TestOpenFoamCase)
#include "tst_openfoam_case.moc"
