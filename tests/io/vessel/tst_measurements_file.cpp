// SPDX-License-Identifier: BSD-3-Clause
#include "io/vessel/measurements_file.h"

#include <QTest>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

using Row = std::map<std::string, std::string>;

/// Of a table without line breaks in its values.
std::vector<Row> rowsOf(const std::string& table) {
  const auto cells = [](const std::string& line) {
    std::vector<std::string> all(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
        all.back() += line[++i];
      else if (line[i] == '"')
        quoted = !quoted;
      else if (line[i] == ',' && !quoted)
        all.emplace_back();
      else
        all.back() += line[i];
    }
    return all;
  };
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = cells(line);
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> values = cells(line);
    rows.emplace_back();
    if (values.size() != header.size()) qFatal("a row of another length");
    for (std::size_t i = 0; i < header.size(); ++i) rows.back()[header[i]] = values[i];
  }
  return rows;
}

CrossSection sectionOf(double least, double greatest, double area) {
  CrossSection section;
  section.centreLps = {1.5, 2.0, -3.25};
  section.areaMm2 = area;
  section.narrowest = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(least, 0, 0)};
  section.widest = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, greatest, 0)};
  return section;
}

Measurement distance() {
  Measurement m;
  m.name = "Neck, \"left\"";
  m.places = {{1.0, 2.0, 3.0}, {4.0, 6.0, 3.0}};
  return m;
}

Measurement stenosis() {
  Measurement m;
  m.kind = MeasurementKind::Stenosis;
  m.name = "Stenosis 1";
  m.key = "abc";
  m.places = {{0, 0, 0}, {9, 0, 0}};
  m.sections = {sectionOf(1.0, 1.5, 1.0), sectionOf(4.0, 4.0, 12.0), sectionOf(2.0, 2.5, 4.0)};
  m.profile = {{0.5, {1, 2, 3}, 3.0, 2.5, 3.5}, {8.75, {4, 5, 6}, 2.0, 1.5, 2.5}};
  return m;
}

}  // namespace

class TestMeasurementsFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachThingHasItsLine() {
    const std::vector<Row> rows = rowsOf(measurementsTable({distance(), stenosis()}, "abc"));
    QCOMPARE(rows.size(), std::size_t(3 + 4 + 2));
    QCOMPARE(rows[0].at("name"), distance().name);
    QCOMPARE(rows[0].at("kind"), std::string("distance"));
    QCOMPARE(rows[0].at("part"), std::string("whole"));
    QCOMPARE(rows[0].at("length_mm"), std::string("5"));
    QCOMPARE(rows[0].at("parameters"), std::string());
    QCOMPARE(rows[2].at("part"), std::string("to"));
    QCOMPARE(rows[2].at("y_mm"), std::string("6"));
    QCOMPARE(rows[2].at("length_mm"), std::string());
    const Row& whole = rows[3];
    QCOMPARE(whole.at("nascet_percent"), std::string("50"));
    QCOMPARE(whole.at("wasid_percent"), std::string("75"));
    QCOMPARE(whole.at("area_stenosis_percent"), std::string("75"));
    QCOMPARE(whole.at("length_mm"), std::string("8.25"));
    QCOMPARE(rows[4].at("part"), std::string("narrowest"));
    QCOMPARE(rows[4].at("min_diameter_mm"), std::string("1"));
    QCOMPARE(rows[5].at("part"), std::string("proximal"));
    QCOMPARE(rows[5].at("area_mm2"), std::string("12"));
    QCOMPARE(rows[5].at("equivalent_diameter_mm"), std::string("3.9088"));
    QCOMPARE(rows[6].at("part"), std::string("distal"));
    QCOMPARE(rows[6].at("max_diameter_mm"), std::string("2.5"));
    QCOMPARE(rows[6].at("z_mm"), std::string("-3.25"));
    QCOMPARE(rows[8].at("part"), std::string("along"));
    QCOMPARE(rows[8].at("along_mm"), std::string("8.75"));
    QCOMPARE(rows[8].at("x_mm"), std::string("4"));
    for (std::size_t i = 3; i < rows.size(); ++i)
      QCOMPARE(rows[i].at("parameters"), std::string("present"));
    QCOMPARE(rowsOf(measurementsTable({stenosis()}, "abd"))[0].at("parameters"),
             std::string("earlier"));
  }

  void whatCannotBeWrittenLeavesWhatWasThere() {
    const Folder folder;
    const fs::path file = folder / "m.csv";
    writeMeasurements(file, {distance()}, "");
    QCOMPARE(bytesOf(file), measurementsTable({distance()}, ""));
    QCOMPARE(entriesOf(folder.path()), 1);
    QVERIFY_THROWS_EXCEPTION(IoError, writeMeasurements(folder / "no" / "m.csv", {distance()}, ""));
    QCOMPARE(entriesOf(folder.path()), 1);
  }
};

QTEST_APPLESS_MAIN(TestMeasurementsFile)
#include "tst_measurements_file.moc"
