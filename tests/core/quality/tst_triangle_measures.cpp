// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/quality/mesh_quality.h"
#include "core/quality/neighbours.h"
#include "core/quality/quality_gates.h"
#include "core/quality/roughness.h"
#include "core/quality/triangle_measures.h"
#include "core/quality/wall_gaps.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

const TriangleMeasure& measureOf(const std::string& key) {
  const auto& table = triangleMeasures();
  return *std::find_if(table.begin(), table.end(),
                       [&key](const TriangleMeasure& m) { return key == m.key; });
}

std::vector<float> valuesOf(const std::string& key, const TriMesh& mesh) {
  return measureOf(key).values(mesh, {});
}

bool near(double a, double b, double tolerance = 1e-6) { return std::abs(a - b) <= tolerance; }

/// Two boxes of 10 x 10 x 2, `gap` apart, of squares of side 1 that are cut along a diagonal.
TriMesh plates(double gap) {
  const auto plate = [](double from, double to) {
    TriMesh mesh;
    const auto side = [&mesh](const Vector3d& corner, const Vector3d& u, const Vector3d& v, int n,
                              int m) {
      const auto at = static_cast<std::uint32_t>(mesh.points.size());
      for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i) mesh.points.emplace_back(corner + i * u + j * v);
      for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(m); ++j)
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n); ++i) {
          const std::uint32_t a = at + i + j * (static_cast<std::uint32_t>(n) + 1);
          const std::uint32_t b = a + static_cast<std::uint32_t>(n) + 1;
          mesh.triangles.push_back({a, a + 1, b});
          mesh.triangles.push_back({a + 1, b + 1, b});
        }
    };
    side({0, 0, to}, {1, 0, 0}, {0, 1, 0}, 10, 10);
    side({0, 0, from}, {0, 1, 0}, {1, 0, 0}, 10, 10);
    return mesh;
  };
  TriMesh mesh = plate(0.0, 2.0);
  shapes::append(mesh, plate(2.0 + gap, 4.0 + gap));
  return mesh;
}

}  // namespace

class TestTriangleMeasures : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachMeasureKnowsItsScale() {
    const TriMesh ball = shapes::icosahedron();
    for (const TriangleMeasure& m : triangleMeasures()) {
      QVERIFY2(m.worst != m.best, m.key);
      QCOMPARE(m.values(ball, {}).size(), ball.triangles.size());
      QVERIFY2(m.values(TriMesh(), {}).empty(), m.key);
      if (*m.gateKey != '\0')
        QCOMPARE(std::string(qualityMeasure(m.gateKey).key), std::string(m.gateKey));
      if (m.fitted) QVERIFY2(m.worst == 0.0 || m.best == 0.0, m.key);
    }
  }

  /// Of shapes equilateral triangles of one size are the best, and one without an area the worst.
  void scalesEndAtTheBestAndTheWorstTriangle() {
    for (const char* key :
         {"min-angle", "max-angle", "radius-ratio", "skewness", "aspect-ratio", "gradation"})
      for (const float value : valuesOf(key, shapes::icosahedron()))
        QVERIFY2(near(value, measureOf(key).best, 1e-4), key);
    const TriMesh line{{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0, 1, 2}}};
    for (const char* key : {"min-angle", "max-angle", "radius-ratio", "skewness"})
      QVERIFY2(near(valuesOf(key, line)[0], measureOf(key).worst, 1e-4), key);
  }

  void shapesOfARightTriangle() {
    // Sides 3, 4, 5: inradius 1, circumradius 2.5.
    const TriMesh right{{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 1, 2}}};
    const double smallest = std::atan2(3, 4) * 180 / shapes::pi;
    QVERIFY(near(valuesOf("min-angle", right)[0], smallest, 1e-5));
    QVERIFY(near(valuesOf("max-angle", right)[0], 90.0, 1e-5));
    QVERIFY(near(valuesOf("radius-ratio", right)[0], 0.8));
    QVERIFY(near(valuesOf("skewness", right)[0], (60.0 - smallest) / 60.0));
    QVERIFY(near(valuesOf("aspect-ratio", right)[0], 5.0 / std::sqrt(12.0)));
    const MeshQuality q = measureQuality(right);
    QVERIFY(near(q.aspectMax, 5.0 / std::sqrt(12.0), 1e-12));
    // What has no area has no aspect ratio in reports.
    const MeshQuality line = measureQuality({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}});
    QCOMPARE(measureText(qualityMeasure("aspect_ratio.max"), line), std::string("-"));
    QVERIFY(near(measureQuality(shapes::icosahedron()).aspectMax, 1.0, 1e-12));
  }

  void valencesCountTriangles() {
    const auto ball = measureValences(shapes::icosahedron());
    QVERIFY(ball && ball->least == 5 && ball->most == 5 && ball->regularPercent == 100.0);
    for (const float off : valuesOf("valence", shapes::icosahedron())) QCOMPARE(off, 1.0F);
    const auto tetrahedron = measureValences(shapes::tetrahedron());
    QVERIFY(tetrahedron && tetrahedron->least == 3 && tetrahedron->regularPercent == 0.0);
    // Two of a cube's corners have 3 triangles in shapes::cube(), the others 5.
    const auto cube = measureValences(shapes::cube());
    QVERIFY(cube && cube->least == 3 && cube->most == 5 && cube->regularPercent == 75.0);
    // At the corners of an octahedron there are 4.
    const TriMesh octahedron{
        {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
    const auto four = measureValences(octahedron);
    QVERIFY(four && four->least == 4 && four->most == 4 && four->regularPercent == 0.0);
    // On open rims nothing is to be even: of a fan of five round a vertex only that counts.
    TriMesh fan{{{0, 0, 0}}, {}};
    for (std::uint32_t i = 0; i < 5; ++i) {
      fan.points.emplace_back(std::cos(i * 0.4 * shapes::pi), std::sin(i * 0.4 * shapes::pi), 0.0);
      fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % 5});
    }
    const auto open = measureValences(fan);
    QVERIFY(open && open->least == 5 && open->most == 5);
    fan.triangles.pop_back();
    QVERIFY(!measureValences(fan));
    QVERIFY(std::isnan(valuesOf("valence", fan)[0]));
  }

  void gradationComparesNeighbours() {
    // An equilateral triangle of side 1, one with sides 1, 2, 2 below it, and one of side 1 above.
    const double low = -std::sqrt(4.0 - 0.25);
    const TriMesh mesh{
        {{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}, {0.5, low, 0}, {1.5, std::sqrt(0.75), 0}},
        {{0, 1, 2}, {1, 0, 3}, {1, 4, 2}}};
    const std::vector<float> ratios = valuesOf("gradation", mesh);
    QVERIFY(near(ratios[0], 5.0 / 3.0) && near(ratios[1], 5.0 / 3.0) && near(ratios[2], 1.0));
    QVERIFY(near(*measureQuality(mesh).gradationMax, 5.0 / 3.0));
    QVERIFY(near(*measureQuality(shapes::icosahedron()).gradationMax, 1.0));
    QVERIFY(!measureQuality({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}).gradationMax);
  }

  void gapsAndThicknessAreMeasuredStraight() {
    const double edge = (2.0 + std::sqrt(2.0)) / 3.0;
    const MeshQuality q = measureQuality(plates(0.5));
    QVERIFY(near(*q.gaps.leastGapEdges, 0.5 / edge));
    // Half of the four faces look at one another.
    QVERIFY(near(q.gaps.narrowPercent, 50.0));
    QVERIFY(near(*q.gaps.leastThicknessMm, 2.0) && near(*q.gaps.thickness1Mm, 2.0));
    const std::vector<float> gaps = valuesOf("gap", plates(0.5));
    QCOMPARE(std::count_if(gaps.begin(), gaps.end(), [](float g) { return std::isnan(g); }),
             std::ptrdiff_t(400));
    for (const float through : valuesOf("thickness", plates(0.5))) QVERIFY(near(through, 2.0));
    // A cap has no thickness.
    TriMesh capped = plates(0.5);
    capped.patch.assign(capped.triangles.size(), 0);
    capped.patch[7] = 1;
    QVERIFY(std::isnan(valuesOf("thickness", capped)[7]));
    QVERIFY(!std::isnan(valuesOf("thickness", capped)[8]));
    // Beyond three edges nothing is a gap.
    QVERIFY(measureQuality(plates(3.0 * edge - 0.01)).gaps.leastGapEdges);
    QVERIFY(!measureQuality(plates(3.0 * edge + 0.01)).gaps.leastGapEdges);
    // Opposite faces of an icosahedron are twice its inradius apart.
    const double g = (1.0 + std::sqrt(5.0)) / 2.0;
    const double inradius = g * g / std::sqrt(3.0) / std::sqrt(1.0 + g * g);
    const MeshQuality ball = measureQuality(shapes::icosahedron());
    QVERIFY(near(*ball.gaps.leastThicknessMm, 2.0 * inradius));
    QVERIFY(!ball.gaps.leastGapEdges);
    // In a tetrahedron the way through ends at a neighbour, which does not count.
    QVERIFY(!measureQuality(shapes::tetrahedron()).gaps.leastThicknessMm);
  }

  void roughnessIsThatOfThePlace() {
    // A tube of radius 2 whose upper half is noisy.
    TriMesh tube;
    constexpr std::uint32_t around = 40, along = 120;
    for (std::uint32_t j = 0; j <= along; ++j)
      for (std::uint32_t i = 0; i < around; ++i) {
        const double angle = 2.0 * shapes::pi * i / around;
        const double r = 2.0 + (j > along / 2 ? 0.05 * randomNormal(7, j * around + i) : 0.0);
        tube.points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.3 * j);
      }
    for (std::uint32_t j = 0; j < along; ++j)
      for (std::uint32_t i = 0; i < around; ++i) {
        const std::uint32_t a = j * around + i, b = j * around + (i + 1) % around;
        tube.triangles.push_back({a, b, a + around});
        tube.triangles.push_back({b, b + around, a + around});
      }
    const std::vector<float> values = valuesOf("roughness", tube);
    const auto meanOver = [&](std::size_t first, std::size_t last) {
      double sum = 0.0;
      for (std::size_t t = first; t < last; ++t) sum += values[t];
      return sum / static_cast<double>(last - first);
    };
    const std::size_t ring = 2 * std::size_t{around};
    QVERIFY(meanOver(10 * ring, 50 * ring) < 1e-4);
    // Noise in the radius of which the fit takes a part.
    const double rough = meanOver(75 * ring, 110 * ring);
    QVERIFY2(near(rough, 0.05, 0.01), qPrintable(QString::number(rough)));
    // The mesh's figure is the median of the same.
    QVERIFY(vertexSpreads(tube).size() == tube.points.size());
  }

  void scalesAreSharedByMeshes() {
    const std::vector<float> thin{0.5F, 1.0F, 1.5F}, thick{2.0F, 4.0F, 4.0F, 4.0F};
    QCOMPARE(scaleOf(measureOf("thickness"), {&thin, nullptr, &thick}).best, 4.0);
    QCOMPARE(scaleOf(measureOf("thickness"), {&thin, &thick}).worst, 0.0);
    QCOMPARE(scaleOf(measureOf("roughness"), {&thick}).worst, 4.0);
    QCOMPARE(scaleOf(measureOf("min-angle"), {&thick}).best, 60.0);
    QCOMPARE(scaleOf(measureOf("thickness"), {}).best, 1.0);
    QCOMPARE(scaleOf(measureOf("thickness"), {&thick, &thin}).best, 4.0);
    QCOMPARE(scaleOf(measureOf("roughness"), {&thick}).best, 0.0);
  }

  /// A few values that stand out do not stretch the scale, and what is no number has no say in it.
  void scalesEndAtThe98thPercentile() {
    std::vector<float> values;
    for (int n = 100; n >= 0; --n) values.push_back(static_cast<float>(n));
    const TriangleMeasure& thickness = measureOf("thickness");
    QCOMPARE(scaleOf(thickness, {&values}).best, 98.0);
    values[0] = 1e6F;  // in place of the largest
    QCOMPARE(scaleOf(thickness, {&values}).best, 98.0);
    const float none = std::numeric_limits<float>::quiet_NaN();
    values.insert(values.begin(), 300, none);
    QCOMPARE(scaleOf(thickness, {&values}).best, 98.0);
    const std::vector<float> unknown(5, none), empty, flat(5, 0.0F);
    QCOMPARE(scaleOf(thickness, {&unknown, &values, &empty}).best, 98.0);
    for (const auto* nothing : {&unknown, &empty, &flat})
      QCOMPARE(scaleOf(thickness, {nothing}).best, thickness.best);
  }

  void bandsFollowTheGates() {
    const auto limits = bandLimits(measureOf("min-angle"));
    QCOMPARE(limits.size(), std::size_t{2});
    QVERIFY(limits[0].at == 15.0 && limits[0].gate == "cfd");
    QVERIFY(limits[1].at == 30.0 && limits[1].gate == "solver");
    const float none = std::numeric_limits<float>::quiet_NaN();
    using Shares = std::vector<double>;
    QCOMPARE(bandShares(measureOf("min-angle"), {14.0F, 15.0F, 30.0F, 50.0F, none}),
             (Shares{25.0, 25.0, 50.0}));
    // 110 passes the gate, so it is on the better side: below.
    QCOMPARE(bandShares(measureOf("max-angle"), {110.0F, 110.1F, 60.0F, 70.0F}),
             (Shares{75.0, 25.0}));
    QCOMPARE(bandShares(measureOf("radius-ratio"), {}), (Shares{0.0, 0.0}));
    for (const TriangleMeasure& m : triangleMeasures())
      QVERIFY2(m.fitted || !bandLimits(m).empty(), m.key);
  }

  void worstPlacesAreApart() {
    const TriMesh mesh = plates(1.0);
    std::vector<float> values(mesh.triangles.size(), 50.0F);
    values[20] = 10.0F;
    values[21] = 11.0F;  // the other half of the same square
    values[300] = 12.0F;
    values[5] = std::numeric_limits<float>::quiet_NaN();
    using List = std::vector<std::uint32_t>;
    QCOMPARE(worstTriangles(measureOf("min-angle"), mesh, values, 2), (List{20, 300}));
    values.assign(values.size(), 60.0F);
    values[40] = 100.0F;
    QCOMPARE(worstTriangles(measureOf("max-angle"), mesh, values, 1), List{40});
    QCOMPARE(worstTriangles(measureOf("max-angle"), mesh, values, 10).size(), std::size_t{10});
    // No more of them than there is room for.
    QCOMPARE(worstTriangles(measureOf("max-angle"), shapes::tetrahedron(), {1, 2, 3, 4}, 9),
             List{3});
  }
};

QTEST_GUILESS_MAIN(TestTriangleMeasures)
#include "tst_triangle_measures.moc"
