// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <limits>

#include "core/base/error.h"
#include "io/vessel/ports_file.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

std::vector<Port> somePorts() {
  return {{"inlet", {12.1, -30.7, 1.0 / 3.0}, Eigen::Vector3d(1, 2, -2) / 3.0, 12.56},
          {"outlet \"links\" \xc3\xa4", {0, 1e-300, -4e3}, {0, 0, -1}, 0.7}};
}

constexpr const char* kText =
    R"({"schema": 1, "frame": "LPS", "unit": "mm", "ports": [
  {"name": "a", "centre_mm": [1, 2, 3], "normal": [0, 0, 1], "area_mm2": 0.7853981633974483,
   "equivalent_diameter_mm": 1},
  {"name": "b", "centre_mm": [4, 5, 6], "normal": [0, -1, 0], "area_mm2": 0,
   "equivalent_diameter_mm": 0}]})";

}  // namespace

class TestPortsFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void portsComeBackBitForBit() {
    const Folder folder;
    const std::vector<Port> ports = somePorts();
    writePorts(ports, folder / "ports.json");
    const std::vector<Port> back = readPorts(folder / "ports.json");
    QCOMPARE(back.size(), ports.size());
    for (std::size_t n = 0; n < ports.size(); ++n) {
      QCOMPARE(back[n].name, ports[n].name);
      QCOMPARE(back[n].centreLps, ports[n].centreLps);
      QCOMPARE(back[n].normalLps, ports[n].normalLps);
      QCOMPARE(back[n].areaMm2, ports[n].areaMm2);
    }
    QCOMPARE(entriesOf(folder.path()), 1);
    writePorts({}, folder / "ports.json");
    QVERIFY(readPorts(folder / "ports.json").empty());
  }

  void theSlantOfABorderPortComesBack() {
    const Folder folder;
    std::vector<Port> ports = somePorts();
    ports[1].slant = BorderSlant{41.3, 1.0 / 3.0, 13.0, {1, 2, 3.3}, {0, 0.6, -0.8}};
    writePorts(ports, folder / "ports.json");
    const std::vector<Port> back = readPorts(folder / "ports.json");
    QVERIFY(!back[0].slant && back[1].slant);
    const BorderSlant& slant = *back[1].slant;
    QVERIFY(slant.angleDeg == 41.3 && slant.areaRatio == 1.0 / 3.0 && slant.sectionAreaMm2 == 13.0);
    QVERIFY(slant.flagged());
    QCOMPARE(slant.centreLps, Eigen::Vector3d(1, 2, 3.3));
    QCOMPARE(slant.axisLps, Eigen::Vector3d(0, 0.6, -0.8));
    std::string text = bytesOf(folder / "ports.json");
    text.replace(text.find("\"area_ratio\""), 12, "\"area_rate\"");
    save(folder / "ports.json", text);
    QVERIFY(messageOf([&] {
              readPorts(folder / "ports.json");
            }).contains("ports[1].vessel.area_ratio is missing"));
  }

  void theKindOfAPortComesBack() {
    const Folder folder;
    std::vector<Port> ports = somePorts();
    ports[1].atBorder = true;
    writePorts(ports, folder / "ports.json");
    std::vector<Port> back = readPorts(folder / "ports.json");
    QVERIFY(!back[0].atBorder && back[1].atBorder);
    std::string text = bytesOf(folder / "ports.json");
    text.replace(text.find("\"border\""), 8, "\"inflow\"");
    save(folder / "ports.json", text);
    QVERIFY(messageOf([&] {
              readPorts(folder / "ports.json");
            }).contains("ports[1].kind is neither \"cut\" nor \"border\""));
    // Of files without it the names tell.
    text = kText;
    text.replace(text.find("\"b\""), 3, "\"border_2\"");
    save(folder / "ports.json", text);
    back = readPorts(folder / "ports.json");
    QVERIFY(!back[0].atBorder && back[1].atBorder);
  }

  void theFileSaysWhatItIs() {
    const Folder folder;
    save(folder / "ports.json", kText);
    const std::vector<Port> ports = readPorts(folder / "ports.json");
    QCOMPARE(ports[0].centreLps, Eigen::Vector3d(1, 2, 3));
    QCOMPARE(ports[1].normalLps, Eigen::Vector3d(0, -1, 0));
    writePorts(ports, folder / "again.json");
    const std::string text = bytesOf(folder / "again.json");
    for (const char* part : {"\"schema\": 1,", "\"frame\": \"LPS\",", "\"unit\": \"mm\",",
                             "\"area_mm2\": 0.785398", "\"equivalent_diameter_mm\": "})
      QVERIFY2(text.find(part) != std::string::npos, part);
  }

  void whatIsWrongIsNamed_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* from, const char* to, const char* says) {
      QTest::newRow(says) << from << to << says;
    };
    row("\"schema\": 1", "\"schema\": 2", "newer Angiomesh (schema 2)");
    row("\"schema\": 1", "\"schema\": \"1\"", "schema is not 1");
    row("\"LPS\"", "\"RAS\"", "frame is not \"LPS\"");
    row("\"mm\"", "\"m\"", "unit is not \"mm\"");
    row("\"unit\": \"mm\", ", "", "unit is missing");
    row("\"unit\"", "\"more\": 1, \"unit\"", "more is not known");
    row("\"name\": \"b\"", "\"name\": 3", "ports[1].name is no text");
    row("\"name\": \"b\"", "\"name\": \"\"", "ports[1].name is empty");
    row("\"name\": \"b\"", "\"name\": \"a\"", "ports[1].name is another port's");
    row("\"name\": \"b\"", "\"name\": \"wall\"", "ports[1].name is the wall's");
    row("\"name\": \"b\", ", "", "ports[1].name is missing");
    row("\"name\": \"b\"", "\"name\": \"b\", \"flow\": 1", "ports[1].flow is not known");
    row("[4, 5, 6]", "[4, 5]", "ports[1].centre_mm is no list of three numbers");
    row("[4, 5, 6]", "[4, null, 6]", "ports[1].centre_mm[1] is no number");
    row("[4, 5, 6]", "4", "ports[1].centre_mm is no list");
    row("[0, 0, 1]", "[0, 0, 1.01]", "ports[0].normal is not of length 1");
    row("\"area_mm2\": 0,", "\"area_mm2\": -1,", "ports[1].area_mm2 is negative");
    row("\"equivalent_diameter_mm\": 1}", "\"equivalent_diameter_mm\": 1.1}",
        "ports[0].equivalent_diameter_mm is not that of a circle");
    row("[\n", "[3, ", "ports[0] is no object");
    row("\"ports\": [", "\"ports\": 1, \"x\": [", "x is not known");
    row("{\"schema\"", "{\"scheme\"", "not a file of ports");
  }
  void whatIsWrongIsNamed() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, says);
    const Folder folder;
    QString text = kText;
    QCOMPARE(text.count(from), 1);
    text.replace(from, to);
    save(folder / "ports.json", text.toStdString());
    QString message;
    try {
      readPorts(folder / "ports.json");
    } catch (const Error& error) {
      message = error.what();
    }
    QVERIFY2(message.contains(says) && message.contains("ports.json"), qPrintable(message));
    QVERIFY(!message.contains('\n'));
  }

  void everyCutIsRefused() {
    const Folder folder;
    const std::string text = kText;
    for (std::size_t length = 0; length < text.size(); ++length) {
      save(folder / "p.json", text.substr(0, length));
      QVERIFY_THROWS_EXCEPTION(IoError, readPorts(folder / "p.json"));
    }
    QVERIFY_THROWS_EXCEPTION(IoError, readPorts(folder / "none.json"));
  }

  void unusablePortsAreNotWritten() {
    const Folder folder;
    for (const char* name : {"", "wall", "inlet"}) {
      std::vector<Port> ports = somePorts();
      ports[1].name = name;
      QVERIFY_THROWS_EXCEPTION(InputError, writePorts(ports, folder / "p.json"));
    }
    std::vector<Port> ports = somePorts();
    ports[0].areaMm2 = std::numeric_limits<double>::quiet_NaN();
    QVERIFY_THROWS_EXCEPTION(InputError, writePorts(ports, folder / "p.json"));
    QVERIFY_THROWS_EXCEPTION(IoError, writePorts(somePorts(), folder / "none" / "p.json"));
    QCOMPARE(entriesOf(folder.path()), 0);
  }
};

QTEST_APPLESS_MAIN(TestPortsFile)
#include "tst_ports_file.moc"
