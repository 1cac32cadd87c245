// SPDX-License-Identifier: BSD-3-Clause
#include <QFile>
#include <QJsonArray>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/openings/port.h"
#include "io/mesh/mesh_io.h"
#include "io/vessel/ports_file.h"
#include "tests/app/cli_process.h"
#include "tests/io/external_mesher.h"

using namespace angiomesh;

namespace {

const std::vector<std::string> kNames{"wall", "renal_left", "outlet-1", "outlet-2"};
const QStringList kCuts{"--cut", "27.5,27.5,10,0,0,-1,renal_left", "--cut", "18,27.5,41.5,outlet-1",
                        "--cut", "37,27.5,41.5,0.8,0,0.7,outlet-2"};

QByteArray solidsOf(const QString& path) {
  QByteArray names;
  for (const QByteArray& line : readBytes(path).split('\n'))
    if (line.startsWith("solid ")) names += line.mid(6).trimmed() + ' ';
  return names;
}

}  // namespace

// Inlets and outlets from the command line to the files that a solver takes.
class TestCliPorts : public QObject, CliFolder {
  Q_OBJECT

 private:
  std::vector<Port> ports_;

  std::filesystem::path place(const QString& name) const { return at(name).toStdString(); }
  // The file holds the ports that the run wrote.
  void holdsThePorts(const QString& file) const {
    const LoadedMesh back = loadMesh(place(file));
    QCOMPARE(back.patchNames, kNames);
    QVERIFY2(portFaults(ports_, back.mesh).empty(), qPrintable(file));
    const std::vector<Port> there = measurePatches(back.mesh, 3);
    for (std::size_t n = 0; n < 3; ++n)
      QVERIFY(std::abs(there[n].areaMm2 / ports_[n].areaMm2 - 1.0) < 1e-6);
  }

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(cli({"phantom", "bifurcation", "-o", "p", "--size", "56", "--radius", "3.5"}).code ==
            0);
    const CliResult run = cli(QStringList{"run", "p/image.mha", "-o", "out"} + kCuts);
    QVERIFY2(run.code == 0, run.errors.constData());
    ports_ = readPorts(place("out/ports.json"));
    QCOMPARE(ports_.size(), std::size_t{3});
    for (std::size_t n = 0; n < 3; ++n) QCOMPARE(ports_[n].name, kNames[n + 1]);
  }

  /// The image ends 40 degrees off the trunk's axis: that is said, and cut on demand.
  void openingsAtTheBorderSayHowTheySliceTheirVessel() {
    QVERIFY(cli({"phantom", "tube", "-o", "t", "--size", "48", "--radius", "4", "--axis",
                 "0.64,0,0.77"})
                .code == 0);
    const QStringList command{"mesh", "t/truth.mha", "-o", "t.vtp"};
    const CliResult plain = cli(command + QStringList{"--name-port", "border_1=inlet"});
    QVERIFY2(plain.code == 0, plain.errors.constData());
    QVERIFY(plain.output.contains("degrees off the vessel's axis"));
    QVERIFY(plain.errors.contains("the port 'inlet' slices its vessel"));
    QCOMPARE(loadMesh(place("t.vtp")).patchNames[1], std::string("inlet"));
    const CliResult across = cli(command + QStringList{"--cut-borders"});
    QVERIFY2(across.code == 0 && !across.errors.contains("slices"), across.errors.constData());
    QCOMPARE(loadMesh(place("t.vtp")).patchNames[1], std::string("across_1"));
    QCOMPARE(cli(command + QStringList{"--name-port", "border_1"}).code, 2);
  }

  void aRunNamesItsOpenings() {
    holdsThePorts("out/vessels.ply");
    holdsThePorts("out/vessels.stl");
    QCOMPARE(solidsOf(at("out/vessels.stl")), QByteArray("wall renal_left outlet-1 outlet-2 "));
    QFile file(at("out/report.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonArray ports =
        QJsonDocument::fromJson(file.readAll()).object().value("ports").toArray();
    QCOMPARE(ports.size(), 3);
    for (qsizetype n = 0; n < 3; ++n) {
      const QJsonObject port = ports[n].toObject();
      QCOMPARE(port.value("name").toString().toStdString(),
               kNames[static_cast<std::size_t>(n) + 1]);
      const double section = port.value("section_area_mm2").toDouble();
      QVERIFY(std::abs(port.value("area_mm2").toDouble() / section - 1.0) < 5e-3);
    }
  }

  void namesSurviveEveryFormatAndSmoothing() {
    for (const char* file : {"a.vtp", "a.obj", "a.ply", "a.stl"}) {
      QStringList arguments{"convert", "out/vessels.ply", "-o", file};
      if (QString(file).endsWith(".stl")) arguments << "--ascii";
      QVERIFY(cli(arguments).code == 0);
      holdsThePorts(file);
    }
    QVERIFY(cli({"smooth", "a.vtp", "-o", "s.ply", "--phi", "out/phi.nrrd"}).code == 0);
    QCOMPARE(loadMesh(place("s.ply")).patchNames, kNames);
    QVERIFY(portFaults(ports_, loadMesh(place("s.ply")).mesh).empty());
  }

  void parametersBringTheCutsBack() {
    QVERIFY(cli({"run", "p/image.mha", "-o", "again", "--recipe", "out/recipe.json"}).code == 0);
    const std::vector<Port> again = readPorts(place("again/ports.json"));
    QCOMPARE(again.size(), std::size_t{3});
    for (std::size_t n = 0; n < 3; ++n) {
      QCOMPARE(again[n].name, ports_[n].name);
      QCOMPARE(again[n].areaMm2, ports_[n].areaMm2);
    }
  }

  /// With other parameters than those of the surface that ports.json was written for.
  void portsAreReadBackAsCuts() {
    const CliResult run = cli({"run", "p/image.mha", "-o", "more", "--ports", "out/ports.json",
                               "--set", "wall.smooth=false"});
    QVERIFY2(run.code == 0, run.errors.constData());
    const std::vector<Port> more = readPorts(place("more/ports.json"));
    QCOMPARE(more.size(), ports_.size());
    for (std::size_t n = 0; n < more.size(); ++n) {
      QCOMPARE(more[n].name, ports_[n].name);
      QVERIFY((more[n].centreLps - ports_[n].centreLps).norm() < 0.3);
      QVERIFY(more[n].normalLps.dot(ports_[n].normalLps) > 0.9999);
      QVERIFY(std::abs(more[n].areaMm2 / ports_[n].areaMm2 - 1.0) < 0.1);
    }
    QCOMPARE(cli({"run", "p/image.mha", "-o", "none", "--ports", "out/recipe.json"}).code, 2);
  }

  /// The name goes with the opening, whatever number that gets.
  void anOpeningKeepsItsNameByItsPlace() {
    const QStringList whole{"run", "p/image.mha", "-o", "whole", "--name-port", "border_3=trunk"};
    const CliResult run = cli(whole);
    QVERIFY2(run.code == 0, run.errors.constData());
    const std::vector<Port> named = readPorts(place("whole/ports.json"));
    QCOMPARE(named.size(), std::size_t{3});
    QCOMPARE(named[2].name, std::string("trunk"));
    QVERIFY(solidsOf(at("whole/vessels.stl")).contains("trunk"));
    // A cut takes one of the others away.
    const QStringList cut = named[2].centreLps.z() < 20.0 ? kCuts.mid(2, 2) : kCuts.mid(0, 2);
    QVERIFY(
        cli(QStringList{"run", "p/image.mha", "-o", "less", "--ports", "whole/ports.json"} + cut)
            .code == 0);
    const std::vector<Port> less = readPorts(place("less/ports.json"));
    const auto trunk = std::find_if(less.begin(), less.end(),
                                    [](const Port& port) { return port.name == "trunk"; });
    QVERIFY(trunk != less.end());
    QVERIFY((trunk->centreLps - named[2].centreLps).norm() < 0.1);
    QVERIFY(trunk->atBorder);
  }

  void everyMethodEndsAtTheCuts_data() {
    QTest::addColumn<QString>("method");
    for (const char* method : {"advancing-front", "remesh", "marching-cubes"})
      QTest::newRow(method) << method;
  }
  void everyMethodEndsAtTheCuts() {
    QFETCH(QString, method);
    const QString file = method + ".stl";
    const CliResult mesh =
        cli(QStringList{"mesh", "p/truth.mha", "-o", file, "--set", "surface.method=" + method} +
            kCuts);
    QVERIFY2(mesh.code == 0, mesh.errors.constData());
    QCOMPARE(solidsOf(at(file)), QByteArray("wall renal_left outlet-1 outlet-2 "));
    if (!test::isInstalled("gmsh")) QSKIP("gmsh is not installed");
    QString log;
    QVERIFY2(test::fillsWithTetrahedra(place(file), log), qPrintable(log));
  }

  void whatASmoothedRunWritesIsFilled() {
    if (!test::isInstalled("gmsh")) QSKIP("gmsh is not installed");
    QString log;
    QVERIFY2(test::fillsWithTetrahedra(place("out/vessels.stl"), log), qPrintable(log));
  }

  void openRimsAreNamedToo() {
    const CliResult run = cli(
        QStringList{"run", "p/image.mha", "-o", "open", "--set", "surface.border=open"} + kCuts);
    QVERIFY2(run.code == 0, run.errors.constData());
    const std::vector<Port> open = readPorts(place("open/ports.json"));
    QCOMPARE(open.size(), std::size_t{3});
    for (std::size_t n = 0; n < 3; ++n) {
      QCOMPARE(open[n].name, ports_[n].name);
      QVERIFY(std::abs(open[n].areaMm2 / ports_[n].areaMm2 - 1.0) < 1e-3);
    }
  }

  void endsAreCutOnDemand() {
    QVERIFY(cli({"phantom", "capsule-tree", "-o", "tree", "--size", "72"}).code == 0);
    const CliResult run = cli({"run", "tree/image.mha", "-o", "ends", "--cut-ends", "1.5", "--set",
                               "segmentation.keep=largest"});
    QVERIFY2(run.code == 0, run.errors.constData());
    const std::vector<Port> ends = readPorts(place("ends/ports.json"));
    QVERIFY2(ends.size() >= 2, run.errors.constData());
    for (std::size_t n = 0; n < ends.size(); ++n) {
      QCOMPARE(ends[n].name, "end_" + std::to_string(n + 1));
      QVERIFY(ends[n].areaMm2 > 0.5);
    }
    QCOMPARE(loadMesh(place("ends/vessels.ply")).patchNames.size(), ends.size() + 1);
  }

  void badCutsAreRefused_data() {
    QTest::addColumn<QString>("cut");
    QTest::addColumn<QByteArray>("why");
    QTest::newRow("no name") << "27.5,27.5,10" << QByteArray("is no cut");
    QTest::newRow("outside") << "2,2,2,in" << QByteArray("there is no vessel");
    QTest::newRow("along the vessel")
        << "27.5,27.5,10,1,0,0,in" << QByteArray("reaches the border of the volume");
    QTest::newRow("twice") << "27.5,27.5,10,0,0,-1,renal_left"
                           << QByteArray("two cuts are called 'renal_left'");
  }
  void badCutsAreRefused() {
    QFETCH(QString, cut);
    QFETCH(QByteArray, why);
    QStringList arguments{"run", "p/image.mha", "-o", "bad", "--cut", cut};
    if (why.startsWith("two")) arguments << kCuts;
    const CliResult run = cli(arguments);
    QCOMPARE(run.code, 2);
    QCOMPARE(run.errorLines().size(), 1);
    QVERIFY2(run.errors.contains(why), run.errors.constData());
    // What was segmented before the cut was found to be bad is kept.
    QVERIFY(!QFile::exists(at("bad/vessels.ply")) && !QFile::exists(at("bad/ports.json")));
    QDir(at("bad")).removeRecursively();
  }
};

QTEST_GUILESS_MAIN(TestCliPorts)
#include "tst_cli_ports.moc"
