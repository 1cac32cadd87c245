// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/quality/local_wall.h"
#include "core/quality/roughness.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_shapes.h"
#include "tests/core/threads.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

TriMesh scaled(TriMesh mesh, double factor) {
  for (Vector3d& p : mesh.points) p *= factor;
  return mesh;
}

/// A tube whose rings of quadrilaterals are cut along a diagonal: its neighbours' angles are 0 or
/// a whole step around.
TriMesh quadTube(int around, int rings, double radius, double step) {
  TriMesh mesh;
  const auto id = [&](int ring, int i) {
    return static_cast<std::uint32_t>(ring * around + i % around);
  };
  for (int ring = 0; ring < rings; ++ring)
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * shapes::pi * i / around;
      mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), ring * step);
    }
  for (int ring = 0; ring + 1 < rings; ++ring)
    for (int i = 0; i < around; ++i) {
      mesh.triangles.push_back({id(ring, i), id(ring, i + 1), id(ring + 1, i + 1)});
      mesh.triangles.push_back({id(ring, i), id(ring + 1, i + 1), id(ring + 1, i)});
    }
  return mesh;
}

/// Moves the vertices by sigma along the directions from the z axis, or from the origin.
TriMesh roughened(TriMesh mesh, double sigma, bool tube, std::uint64_t seed = 1) {
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    Vector3d way = mesh.points[v];
    if (tube) way[2] = 0.0;
    mesh.points[v] += sigma * randomNormal(seed, v) * way.normalized();
  }
  return mesh;
}

/// The wall around a vertex, in a frame that leans by 30 degrees against the normal.
LocalWall leaning(const TriMesh& mesh, std::uint32_t vertex, double turn, bool graph) {
  const MeshRings rings(mesh);
  std::vector<char> marks(mesh.points.size(), 0);
  std::vector<std::uint32_t> found;
  rings.around(vertex, 0.0, 0, graph ? 2 : 4, marks, found);
  const Vector3d normal = rings.normalAt(vertex);
  const Vector3d aside = Eigen::AngleAxisd(turn, normal) * normal.unitOrthogonal();
  return LocalWall::fit(mesh, found, (std::sqrt(0.75) * normal + 0.5 * aside).normalized(), graph)
      .value();
}

}  // namespace

class TestRoughness : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { setThreads(0); }

  void ballsAreSmoothAtAnySize() {
    for (int level = 1; level <= 4; ++level)
      for (const double radius : {1e-3, 1.0, 250.0}) {
        const auto r = measureRoughness(scaled(shapes::icosphere(level), radius));
        QVERIFY(r.has_value());
        QVERIFY2(r->spreadMm < 1e-5 * radius, QByteArray::number(r->spreadMm / radius));
        QVERIFY(isBelow(r->angleDeg, 1e-2));
        QVERIFY(r->spread95Mm < 1e-4 * radius);
      }
  }

  void tubesAreSmoothAtAnySizeAndFineness() {
    for (const int around : {8, 16, 40})
      for (const double radius : {0.02, 5.0}) {
        const auto even = measureRoughness(shapes::openTube(around, 2 * around, radius));
        const auto quads =
            measureRoughness(quadTube(around, 2 * around, radius, 4.0 * radius / around));
        for (const auto& r : {even, quads}) {
          QVERIFY(r.has_value());
          QVERIFY2(r->spreadMm < 2e-5 * radius, QByteArray::number(r->spreadMm / radius));
          QVERIFY(isBelow(r->angleDeg, 5e-3));
        }
      }
  }

  /// What a wall is does not depend on the frame that it is measured in.
  void aLeaningFrameSeesTheSameWall() {
    TriMesh ball = scaled(shapes::icosphere(5), 3.0);
    constexpr std::uint32_t vertex = 1234;
    for (const double turn : {0.0, 0.7, 1.6, 2.5, 4.0, 5.3}) {
      QVERIFY(isNear(leaning(ball, vertex, turn, true).meanCurvature(), 1.0 / 3.0, 0.003));
      const LocalWall wall = leaning(ball, vertex, turn, false);
      const Vector3d& on = ball.points[vertex];
      for (const double off : {-0.05, 0.0, 0.05}) {
        const Vector3d foot = wall.foot((1.0 + off) * on);
        QVERIFY(isNear(foot.norm(), 3.0, 1e-4));
      }
    }
  }

  /// A vessel that bends at five times its radius is far smoother than noise of 0.01 radius.
  void aBentVesselIsNearlySmooth() {
    const auto bent = measureRoughness(shapes::torus(180, 30, 5.0, 1.0));
    QVERIFY(isBelow(bent->spreadMm, 1e-3));
    QVERIFY(isBelow(bent->angleDeg, 0.05));
  }

  void noiseOfTheVerticesIsFoundAgain() {
    for (const bool tube : {false, true}) {
      const TriMesh smooth = tube ? shapes::openTube(24, 60, 1.0) : shapes::icosphere(4);
      double before = 0.0;
      double angleBefore = 0.0;
      for (const double sigma : {0.002, 0.005, 0.02}) {
        const auto r = measureRoughness(roughened(smooth, sigma, tube));
        QVERIFY(isNear(r->spreadMm / sigma, 1.0, 0.06));
        QVERIFY(r->spreadMm > before && r->angleDeg > 1.5 * angleBefore);
        before = r->spreadMm;
        angleBefore = r->angleDeg;
      }
    }
  }

  /// The radius comes from the way through the vessel: the window of a wide vessel does not see a
  /// ripple's single waves as its shape.
  void aRippleLongerThanAnEdgeIsRough() {
    TriMesh mesh = shapes::openTube(60, 120, 1.0);
    const auto smooth = measureRoughness(mesh);
    constexpr double height = 0.01;
    for (Vector3d& p : mesh.points) {
      const double angle = std::atan2(p[1], p[0]);
      const double wave = std::sin(2.0 * shapes::pi * p[2] / 0.5) * std::cos(12.0 * angle);
      p += height * wave * Vector3d(p[0], p[1], 0.0);
    }
    const auto rough = measureRoughness(mesh);
    QVERIFY(smooth->spreadMm < 1e-4);
    QVERIFY(isAbove(rough->spreadMm, 0.4 * height * 0.5));
    QVERIFY(isBelow(rough->spreadMm, height));
  }

  void capsDoNotCount() {
    TriMesh mesh = shapes::openTube(24, 60, 1.0);
    mesh.patch.assign(mesh.triangles.size(), 0);
    const auto open = measureRoughness(mesh);
    const auto rim = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.emplace_back(0.0, 0.0, 3.0);  // a spike instead of a flat cap
    for (std::uint32_t i = 0; i < 24; ++i) {
      mesh.triangles.push_back({rim, (i + 1) % 24, i});
      mesh.patch.push_back(1);
    }
    const auto capped = measureRoughness(mesh);
    QCOMPARE(capped->places, open->places);
    QVERIFY(std::fabs(capped->spread95Mm - open->spread95Mm) < 1e-3);
  }

  void nothingIsSaidOfTooFewVertices() {
    QVERIFY(!measureRoughness(TriMesh()).has_value());
    QVERIFY(!measureRoughness(shapes::tetrahedron()).has_value());
    QVERIFY_THROWS_EXCEPTION(InputError, measureRoughness({{{0, 0, 0}}, {{0, 0, 7}}}));
  }

  void doesNotDependOnTheThreads() {
    const TriMesh mesh = roughened(shapes::openTube(24, 60, 1.0), 0.01, true);
    const auto [one, two] = onOneAndSeveralThreads([&] { return measureRoughness(mesh); });
    QCOMPARE(one->spreadMm, two->spreadMm);
    QCOMPARE(one->spread95Mm, two->spread95Mm);
    QCOMPARE(one->angleDeg, two->angleDeg);
  }
};

QTEST_GUILESS_MAIN(TestRoughness)
#include "tst_roughness.moc"
