// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/quality/quality_gates.h"
#include "core/quality/quality_json.h"
#include "core/quality/quality_table.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;

namespace {

const QualityMeasure& measureOf(const std::string& key) {
  const auto& table = qualityMeasures();
  return *std::find_if(table.begin(), table.end(),
                       [&](const QualityMeasure& m) { return key == m.key; });
}

const QualityGate& gateOf(const std::string& name) {
  const auto& gates = qualityGates();
  return *std::find_if(gates.begin(), gates.end(),
                       [&](const QualityGate& gate) { return name == gate.name; });
}

/// Of a mesh that passes every gate.
MeshQuality faultless() { return measureQuality(shapes::icosahedron()); }

}  // namespace

class TestQualityTable : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // What people read is what the table holds.
  void thePageNamesEachMeasure() {
    std::vector<std::string> rows;
    std::ifstream page(ANGIOMESH_SOURCE_DIR "/docs/quality.md");
    for (std::string line; std::getline(page, line);)
      if (line.compare(0, 3, "| `") == 0) rows.push_back(line);
    std::vector<std::string> expected;
    for (const QualityMeasure& m : qualityMeasures()) {
      const std::string bold = m.main ? "**" : "";
      expected.push_back(std::string("| `") + m.key + "` | " + bold + m.label + bold + " | " +
                         m.unit + " | " + m.meaning + " |");
    }
    for (const QualityGate& gate : qualityGates())
      expected.push_back(std::string("| `") + gate.name + "` | " + gate.help + " |");
    QVERIFY(rows == expected);
  }

  // Angles to a hundredth of a degree, areas and volumes to six digits, what is fine to three or
  // four.
  void numbersHaveTheDigitsThatCount() {
    for (const QualityMeasure& m : qualityMeasures()) {
      const std::string unit = m.unit;
      if (m.kind == MeasureKind::Fixed && unit == "deg")
        QCOMPARE(m.digits, 2);
      else if (m.kind == MeasureKind::Fixed)
        QVERIFY2(m.digits >= (unit == "%" ? 2 : 3) && m.digits <= 4, m.key);
      else if (m.kind == MeasureKind::Significant && (unit == "mm2" || unit == "mm3"))
        QCOMPARE(m.digits, 6);
      else if (m.kind == MeasureKind::Significant)
        QVERIFY2(m.digits >= 3 && m.digits <= 4, m.key);
      else
        QCOMPARE(m.digits, 0);
    }
  }

  void valuesAreWrittenByTheirKind() {
    MeshQuality q = faultless();
    q.triangles = 12345;
    q.minAngleMin = 12.3456;
    q.edgeMinMm = 0.0123456;
    q.volumeMm3 = 1234567.0;
    const auto text = [&q](const char* key) { return measureText(measureOf(key), q); };
    QCOMPARE(text("triangles"), std::string("12345"));
    QCOMPARE(text("closed"), std::string("yes"));
    QCOMPARE(text("min_angle_deg.min"), std::string("12.35"));
    QCOMPARE(text("edge_length_mm.min"), std::string("0.01235"));
    QCOMPARE(text("volume_mm3"), std::string("1.23457e+06"));
    QCOMPARE(text("from_front_percent"), std::string("-"));
    q.fromFrontPercent = 98.765;
    QCOMPARE(text("from_front_percent"), std::string("98.77"));
    // A volume is that of a closed surface that faces outwards.
    q.closed = false;
    QCOMPARE(text("closed"), std::string("no"));
    QCOMPARE(text("volume_mm3"), std::string("-"));
    // Without triangles there are no shapes.
    QCOMPARE(measureText(measureOf("min_angle_deg.min"), MeshQuality()), std::string("-"));
  }

  void gatesTellWhatFails() {
    for (const QualityGate& gate : qualityGates()) {
      QVERIFY(gateFailures(gate, faultless()).empty());
      QVERIFY(!gateFailures(gate, MeshQuality()).empty());
    }
    using Texts = std::vector<std::string>;
    MeshQuality q = faultless();
    q.nonManifoldEdges = 3;
    for (const QualityGate& gate : qualityGates())
      QCOMPARE(gateFailures(gate, q), Texts{"3 non-manifold edges"});
    // One is one too many.
    for (const auto count : {&MeshQuality::nonManifoldEdges, &MeshQuality::nonManifoldVertices,
                             &MeshQuality::degenerateTriangles, &MeshQuality::selfIntersections}) {
      q = faultless();
      q.*count = 1;
      for (const QualityGate& gate : qualityGates())
        QCOMPARE(gateFailures(gate, q).size(), std::size_t{1});
    }
    q = faultless();
    q.boundaryEdges = 1;
    for (const char* gate : {"closed", "cfd", "solver"})
      QCOMPARE(gateFailures(gateOf(gate), q).size(), std::size_t{1});
    q = faultless();
    q.oriented = false;
    QCOMPARE(gateFailures(gateOf("manifold"), q), Texts{"not oriented"});
    q = faultless();
    q.boundaryEdges = 4;
    QVERIFY(gateFailures(gateOf("manifold"), q).empty());
    QCOMPARE(gateFailures(gateOf("closed"), q), Texts{"4 boundary edges"});
    for (const auto& [angle, cfd, solver] :
         {std::tuple{30.0, true, true}, std::tuple{29.9, true, false},
          std::tuple{15.0, true, false}, std::tuple{14.9, false, false}}) {
      q = faultless();
      q.minAngleMin = angle;
      QCOMPARE(gateFailures(gateOf("cfd"), q).empty(), cfd);
      QCOMPARE(gateFailures(gateOf("solver"), q).empty(), solver);
    }
    q.minAngleMin = 12.0;
    QCOMPARE(gateFailures(gateOf("cfd"), q), Texts{"least angle 12.00 deg, below 15"});
    q = faultless();
    q.maxAngleMax = 110.0;
    q.radiusRatioMin = 0.6;
    QVERIFY(gateFailures(gateOf("solver"), q).empty());
    q.maxAngleMax = 110.5;
    q.radiusRatioMin = 0.59;
    QCOMPARE(gateFailures(gateOf("solver"), q),
             (Texts{"largest angle 110.50 deg, above 110", "least radius ratio 0.590, below 0.6"}));
    // In corners of the outline no mesher chooses the angles.
    q = faultless();
    q.minAngleMin = 5.0;
    q.corners = CornerShapes();
    q.corners->otherMinAngle = 40.0;
    QVERIFY(gateFailures(gateOf("cfd"), q).empty());
    q.corners->otherMinAngle = 10.0;
    QCOMPARE(gateFailures(gateOf("cfd"), q).size(), std::size_t{1});
  }

  // The meshes are as good as their solids; what they are printed from is in mm.
  void printingAsksForOneThickPart() {
    const QualityGate& print = gateOf("print");
    using Texts = std::vector<std::string>;
    MeshQuality q = faultless();
    q.minAngleMin = 1.0;
    QVERIFY(gateFailures(print, q).empty());
    q.components = 3;
    q.gaps.thickness1Mm = 0.25;
    QCOMPARE(gateFailures(print, q), (Texts{"3 components", "thickness, 1 % 0.25 mm, below 0.5"}));
    std::vector<std::string> asked;
    for (const GateCheck& check : checkGate(print, q)) {
      asked.push_back(limitText(check));
      QCOMPARE(check.passed, failureText(check).empty());
      QVERIFY(*check.limit->why != '\0');
      if (!check.passed) QVERIFY(*fixText(check.limit->fix) != '\0');
    }
    QCOMPARE(asked, (Texts{"at least 1", "yes", "none", "none", "none", "none", "none", "at most 1",
                           "at least 0.5 mm"}));
  }

  void theBetterFigureIsKnown() {
    MeshQuality a = faultless(), b = faultless(), c = faultless();
    a.minAngleMin = 30.0;
    b.minAngleMin = 35.0;
    c.minAngleMin = 35.001;
    using Which = std::vector<std::size_t>;
    const QualityMeasure& angle = qualityMeasure("min_angle_deg.min");
    QCOMPARE(betterOnes(angle, {&a, &b}), Which{1});
    // What is written alike is as good.
    QCOMPARE(betterOnes(angle, {&a, &b, nullptr, &c}), (Which{1, 3}));
    QCOMPARE(betterOnes(angle, {&b, &c}), Which{});
    QCOMPARE(betterOnes(angle, {&a, nullptr}), Which{});
    QCOMPARE(betterOnes(qualityMeasure("max_angle_deg.max"), {&a, &b}), Which{});
    a.maxAngleMax = 80.0;
    QCOMPARE(betterOnes(qualityMeasure("max_angle_deg.max"), {&a, &b}), Which{1});
    a.areaMm2 = 1.0;
    QCOMPARE(betterOnes(qualityMeasure("area_mm2"), {&a, &b}), Which{});
  }

  void reportsNestTheMeasures() {
    MeshQuality q = faultless();
    q.vertexDeviation = DeviationStats{0.25, 0.5, 0.75};
    const auto block = qualityJson<nlohmann::ordered_json>(q);
    QCOMPARE(block["triangles"].get<int>(), 20);
    QVERIFY(block["closed"].is_boolean() && block["closed"].get<bool>());
    QVERIFY(std::fabs(block["min_angle_deg"]["min"].get<double>() - 60.0) < 1e-9);
    QCOMPARE(block["deviation"]["vertex"]["mean_mm"].get<double>(), 0.25);
    QCOMPARE(block["deviation"]["vertex"]["max_mm"].get<double>(), 0.75);
    QVERIFY(!block.contains("from_front_percent") && !block.contains("roughness"));
    QVERIFY(!block["deviation"].contains("centroid"));
  }
};

QTEST_GUILESS_MAIN(TestQualityTable)
#include "tst_quality_table.moc"
