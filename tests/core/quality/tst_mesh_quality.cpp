// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <QTest>
#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/contour/marching_cubes.h"
#include "core/mesh/predicates.h"
#include "core/mesh/self_intersection.h"
#include "core/mesh/triangle_intersection.h"
#include "core/mesh/triangle_shape.h"
#include "core/mesh/triangle_tree.h"
#include "core/quality/mesh_quality.h"
#include "tests/core/mesh_shapes.h"
#include "tests/core/threads.h"

using namespace angiomesh;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// Whole numbers times 2^-40 about an offset: products of three need 128 bits at most.
__extension__ using Wide = __int128;

Wide wideDeterminant(const std::array<std::array<std::int64_t, 3>, 4>& p) {
  std::array<std::array<Wide, 3>, 3> d{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) d[r][c] = Wide(p[r + 1][c]) - Wide(p[0][c]);
  }
  return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
         d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
         d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
}

int signOf(Wide x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

}  // namespace

class TestMeshQuality : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void orient2dIsExact() {
    QCOMPARE(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
    QCOMPARE(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
    // Kettner et al. 2008: points on a grid of one unit in the last place about a line through
    // (12, 12) and (24, 24). In units of 2^-53 all of it is whole.
    const double ulp = std::ldexp(1.0, -53);
    for (int i = 0; i < 64; ++i) {
      for (int j = 0; j < 64; ++j) {
        const Vector2d p(0.5 + i * ulp, 0.5 + j * ulp);
        const auto sign = j > i ? 1 : j < i ? -1 : 0;
        QCOMPARE(orient2d({12.0, 12.0}, {24.0, 24.0}, p), sign);
        QCOMPARE(orient2d({24.0, 24.0}, p, {12.0, 12.0}), sign);
        QCOMPARE(orient2d({24.0, 24.0}, {12.0, 12.0}, p), -sign);
      }
    }
  }

  void orient3dIsExact() {
    QCOMPARE(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
    // Nearly coplanar points, held as whole numbers: the reference is exact in 128 bits.
    const double scale = std::ldexp(1.0, -38);
    int zeros = 0, disagreements = 0;
    for (std::uint64_t n = 0; n < 20000; ++n) {
      std::array<std::array<std::int64_t, 3>, 4> whole{};
      for (std::size_t r = 0; r < 4; ++r) {
        for (std::size_t c = 0; c < 2; ++c) {
          whole[r][c] = static_cast<std::int64_t>(randomBits(n, 16 * r + c) % (1ULL << 40));
        }
        whole[r][2] = whole[r][0] + 2 * whole[r][1] +
                      static_cast<std::int64_t>(randomBits(n, 16 * r + 5) % 3) - 1;
        if (n % 2 == 0 && r > 0)
          whole[r][2] = whole[r][0] + 2 * whole[r][1] + whole[0][2] - whole[0][0] - 2 * whole[0][1];
      }
      std::array<Vector3d, 4> p;
      for (std::size_t r = 0; r < 4; ++r) {
        for (std::size_t c = 0; c < 3; ++c) {
          p[r][static_cast<int>(c)] = static_cast<double>(whole[r][c]) * scale;
        }
      }
      const int expected = signOf(wideDeterminant(whole));
      if (expected == 0) ++zeros;
      if (orient3d(p[0], p[1], p[2], p[3]) != expected) ++disagreements;
      if (orient3d(p[1], p[0], p[2], p[3]) != -expected) ++disagreements;
      if (orient3d(p[2], p[3], p[0], p[1]) != expected) ++disagreements;
    }
    QCOMPARE(disagreements, 0);
    QVERIFY(zeros >= 10000);
  }

  void anglesAndRatios() {
    const double root3 = std::sqrt(3.0);
    const TriangleShape even = triangleShape({0, 0, 0}, {2, 0, 0}, {1, root3, 0});
    QVERIFY(near(even.minAngle, 60, 1e-12) && near(even.maxAngle, 60, 1e-12));
    QVERIFY(near(even.radiusRatio, 1.0, 1e-12));
    const TriangleShape right = triangleShape({0, 0, 0}, {4, 0, 0}, {0, 3, 0});
    QVERIFY(near(right.minAngle, std::atan2(3, 4) * 180 / shapes::pi, 1e-12));
    QVERIFY(near(right.maxAngle, 90, 1e-12));
    QVERIFY(near(right.radiusRatio, 2.0 * 1.0 / 2.5, 1e-12));
    for (int i = 0; i <= 3600; ++i) {
      const double turns = i / 7200.0;
      const double x = std::cos(2 * shapes::pi * turns),
                   y = std::abs(std::sin(2 * shapes::pi * turns));
      QVERIFY(near(angleDegrees(y, x), 360.0 * turns, 1e-10));
    }
    QCOMPARE(triangleShape({0, 0, 0}, {1, 1, 1}, {2, 2, 2}).radiusRatio, 0.0);
  }

  void tetrahedronAndCube() {
    const MeshQuality t = measureQuality(shapes::tetrahedron());
    QCOMPARE(t.vertices, std::size_t{4});
    QCOMPARE(t.triangles, std::size_t{4});
    QVERIFY(t.closed && t.oriented);
    QCOMPARE(t.euler, 2);
    QCOMPARE(t.genus, 0);
    QCOMPARE(t.components, 1);
    QVERIFY(near(t.minAngleMin, 45.0, 1e-12) && near(t.maxAngleMax, 90.0, 1e-12));
    // Both parts of the definition give a quarter: 30 / 120 and 15 / 60.
    QVERIFY(near(t.skewnessMax, 0.25, 1e-12));
    // Three such triangles and an equilateral one.
    QVERIFY(near(t.skewnessMean, 0.75 / 4.0, 1e-11));
    // Of one with three different angles the smallest counts.
    const MeshQuality right = measureQuality({{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 1, 2}}});
    const double smallest = std::atan2(3, 4) * 180 / shapes::pi;
    QVERIFY(near(right.skewnessMax, (60.0 - smallest) / 60.0, 1e-11));
    QVERIFY(near(t.edgeMinMm, 1.0, 1e-15) && near(t.edgeMaxMm, std::sqrt(2.0), 1e-15));
    QVERIFY(near(t.edgeMeanMm, (3.0 + 3.0 * std::sqrt(2.0)) / 6.0, 1e-14));
    // Least angles of 45, 26.6, 26.6 and 14 degrees.
    const MeshQuality fan =
        measureQuality({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0.25}},
                        {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}}});
    QCOMPARE(fan.below20Percent, 25.0);
    QCOMPARE(fan.below30Percent, 75.0);
    const MeshQuality c = measureQuality(shapes::cube());
    QVERIFY(near(c.volumeMm3, 1.0, 1e-14) && near(c.areaMm2, 6.0, 1e-14));
    QCOMPARE(c.selfIntersections, std::size_t{0});
    QCOMPARE(c.below20Percent, 0.0);
    const MeshQuality i = measureQuality(shapes::icosahedron());
    QVERIFY(near(i.minAngleMin, 60.0, 1e-10) && near(i.radiusRatioMin, 1.0, 1e-12));
    QVERIFY(near(i.skewnessMax, 0.0, 1e-11) && near(i.skewnessMean, 0.0, 1e-11));
    QVERIFY(!i.vertexDeviation && !i.centroidDeviation);
  }

  void insideOutIsNotOriented() {
    TriMesh mesh = shapes::icosahedron();
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    QVERIFY(!measureQuality(mesh).oriented);
    TriMesh one = shapes::icosahedron();
    std::swap(one.triangles[7][0], one.triangles[7][1]);
    const MeshQuality q = measureQuality(one);
    QVERIFY(q.closed && !q.oriented);
  }

  void torusHasGenusOne() {
    TriMesh mesh = shapes::torus(24, 12, 3.0, 1.0);
    shapes::append(mesh, shapes::moved(shapes::torus(20, 10, 3.0, 1.0), {0, 0, 9}));
    shapes::append(mesh, shapes::moved(shapes::icosahedron(), {9, 0, 0}));
    const MeshQuality q = measureQuality(mesh);
    QCOMPARE(q.components, 3);
    QCOMPARE(q.genus, 2);
    QCOMPARE(q.euler, 2);
    QVERIFY(q.closed && q.oriented);
    QCOMPARE(q.selfIntersections, std::size_t{0});
  }

  void openTubeHasTwoLoops() {
    const MeshQuality q = measureQuality(shapes::openTube(12, 9, 2.0));
    QCOMPARE(q.boundaryLoops, std::size_t{2});
    QCOMPARE(q.boundaryEdges, std::size_t{24});
    QCOMPARE(q.euler, 0);
    QCOMPARE(q.genus, 0);
    QVERIFY(!q.closed && q.oriented);
    QCOMPARE(q.nonManifoldVertices, std::size_t{0});
    QCOMPARE(q.volumeMm3, 0.0);
  }

  void pinchedVertexIsCounted() {
    const TriMesh mesh = shapes::touchingTetrahedra();
    const MeshQuality q = measureQuality(mesh);
    QCOMPARE(q.nonManifoldVertices, std::size_t{1});
    QCOMPARE(q.nonManifoldEdges, std::size_t{0});
    QCOMPARE(q.components, 2);
    QCOMPARE(q.genus, 0);
    QCOMPARE(q.selfIntersections, std::size_t{0});
    // Two triangles that touch in a corner have one rim each.
    const MeshQuality bow = measureQuality(
        {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}});
    QCOMPARE(bow.boundaryLoops, std::size_t{2});
    QCOMPARE(bow.nonManifoldVertices, std::size_t{1});
  }

  void thirdTriangleOnAnEdgeIsCounted() {
    const TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                       {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
    const MeshQuality q = measureQuality(mesh);
    QCOMPARE(q.nonManifoldEdges, std::size_t{1});
    QCOMPARE(q.nonManifoldVertices, std::size_t{2});
    QVERIFY(!q.oriented && !q.closed);
    QCOMPARE(q.selfIntersections, std::size_t{0});
  }

  void degenerateTrianglesAreCounted() {
    // A needle on a line whose points no double rounds: exactly collinear.
    const TriMesh mesh{{{0, 0, 0}, {3, 3, 3}, {1, 1, 1}, {0, 1, 0}, {0, 1, 1e-300}},
                       {{0, 1, 2}, {0, 0, 3}, {0, 2, 3}, {0, 3, 4}}};
    const MeshQuality q = measureQuality(mesh);
    QCOMPARE(q.degenerateTriangles, std::size_t{2});
    QCOMPARE(shapesOf(mesh)[0].minAngle, 0.0);
    QCOMPARE(shapesOf(mesh)[1].radiusRatio, 0.0);
    QVERIFY(shapesOf(mesh)[2].minAngle > 30.0);
  }

  // Wherever triangles that repeat a vertex stand, the topology is that of the others.
  void trianglesThatRepeatAVertexDoNotCountInTheTopology() {
    const TriMesh torus = shapes::torus(24, 12, 3.0, 1.0);
    for (const std::ptrdiff_t place : {0, 100, 576}) {
      TriMesh mesh = torus;
      QCOMPARE(mesh.triangles.size(), std::size_t{576});
      mesh.triangles.insert(mesh.triangles.begin() + place, {7, 7, 8});
      const MeshQuality q = measureQuality(mesh);
      QVERIFY(q.closed && q.oriented);
      QCOMPARE(q.components, 1);
      QCOMPARE(q.euler, 0);
      QCOMPARE(q.genus, 1);
      QCOMPARE(q.boundaryLoops, std::size_t{0});
      QCOMPARE(q.degenerateTriangles, std::size_t{1});
    }
  }

  void interpenetratingBodies() {
    TriMesh mesh = shapes::tetrahedron();
    shapes::append(mesh, shapes::moved(shapes::tetrahedron(), {0.2, 0.2, 0.2}));
    // The slanted face of the first cuts the three faces of the second that meet in its corner.
    const MeshQuality q = measureQuality(mesh);
    QCOMPARE(q.selfIntersections, std::size_t{3});
    QCOMPARE(q.intersectingPairs.size(), std::size_t{3});
    for (const auto& pair : q.intersectingPairs) QVERIFY(pair.first < 4 && pair.second >= 4);

    TriMesh apart = shapes::tetrahedron();
    shapes::append(apart, shapes::moved(shapes::tetrahedron(), {0.34, 0.34, 0.34}));
    QCOMPARE(measureQuality(apart).selfIntersections, std::size_t{0});
    // Nested without contact.
    TriMesh nested = shapes::icosahedron();
    TriMesh inner = shapes::icosahedron();
    for (auto& p : inner.points) p *= 0.5;
    shapes::append(nested, inner);
    QCOMPARE(measureQuality(nested).selfIntersections, std::size_t{0});
  }

  void trianglePairs() {
    const Triangle3 t{Vector3d(0, 0, 0), Vector3d(4, 0, 0), Vector3d(0, 4, 0)};
    const auto meets = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
      const Triangle3 s{a, b, c};
      const bool meet = trianglesMeet(t, s);
      // Every order of both must agree.
      const Triangle3 turned{c, a, b}, swapped{b, a, c};
      if (meet != trianglesMeet(s, t) || meet != trianglesMeet(t, turned) ||
          meet != trianglesMeet(swapped, {t[2], t[1], t[0]})) {
        return -1;
      }
      return meet ? 1 : 0;
    };
    QCOMPARE(meets({1, 1, -1}, {1, 1, 1}, {9, 9, 1}), 1);  // pierces
    QCOMPARE(meets({1, 1, 0}, {1, 1, 1}, {9, 9, 1}), 1);   // a corner touches the inside
    QCOMPARE(meets({1, 1, 1e-300}, {1, 1, 1}, {9, 9, 1}), 0);
    QCOMPARE(meets({2, 2, -1}, {2, 2, 1}, {9, 9, 0}), 1);       // edges touch
    QCOMPARE(meets({1, 1, 0}, {2, 1, 0}, {1, 2, 0}), 1);        // coplanar, inside
    QCOMPARE(meets({-9, -9, 0}, {30, -9, 0}, {-9, 30, 0}), 1);  // coplanar, around
    QCOMPARE(meets({3, 3, 0}, {9, 3, 0}, {3, 9, 0}), 0);        // coplanar, apart
    QCOMPARE(meets({2, 2, 0}, {9, 3, 0}, {3, 9, 0}), 1);        // coplanar, touching an edge
    QCOMPARE(meets({0, 0, 1}, {4, 0, 1}, {0, 4, 1}), 0);        // parallel
    QCOMPARE(meets({5, -1, -1}, {5, 1, -1}, {5, 0, 2}), 0);     // crosses the plane beside
  }

  void neighboursThatFold() {
    // Sharing an edge: a flat fold overlaps, any angle does not.
    const auto pair = [](const Vector3d& apex) {
      return TriMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, apex}, {{0, 1, 2}, {1, 0, 3}}};
    };
    QCOMPARE(measureQuality(pair({0.3, 0.5, 0.0})).selfIntersections, std::size_t{1});
    QCOMPARE(measureQuality(pair({0.3, 0.5, 1e-200})).selfIntersections, std::size_t{0});
    QCOMPARE(measureQuality(pair({0.3, -0.5, 0.0})).selfIntersections, std::size_t{0});
    // Sharing a corner.
    const auto corner = [](const Vector3d& a, const Vector3d& b) {
      return TriMesh{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, a, b}, {{0, 1, 2}, {0, 3, 4}}};
    };
    QCOMPARE(measureQuality(corner({0, 0, 1}, {-1, 0, 1})).selfIntersections, std::size_t{0});
    QCOMPARE(measureQuality(corner({1, 1, 1}, {1, 1, -1})).selfIntersections, std::size_t{1});
    QCOMPARE(measureQuality(corner({0.5, 0.5, 0}, {-1, 0, 1})).selfIntersections, std::size_t{1});
    QCOMPARE(measureQuality(corner({5, 5, 0}, {5, 4, 3})).selfIntersections, std::size_t{1});
    QCOMPARE(measureQuality(corner({-1, 0, 0}, {0, -1, 0})).selfIntersections, std::size_t{0});
    QCOMPARE(measureQuality(corner({0.1, 0.2, 0}, {0.2, 0.1, 0})).selfIntersections,
             std::size_t{1});
    // The same triangle twice.
    const TriMesh twice{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 0, 2}}};
    QCOMPARE(measureQuality(twice).selfIntersections, std::size_t{1});
  }

  void treeFindsWhatBruteForceFinds() {
    // Small random triangles in a box, each on its own.
    TriMesh soup;
    for (std::uint64_t i = 0; i < 400; ++i) {
      const Vector3d centre(randomUniform(i, 0), randomUniform(i, 1), randomUniform(i, 2));
      std::array<std::uint32_t, 3> t{};
      for (std::uint64_t k = 0; k < 3; ++k) {
        t[k] = static_cast<std::uint32_t>(soup.points.size());
        soup.points.push_back(centre + 0.3 * Vector3d(randomUniform(i, 3 + 3 * k),
                                                      randomUniform(i, 4 + 3 * k),
                                                      randomUniform(i, 5 + 3 * k)));
      }
      soup.triangles.push_back(t);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
    for (std::uint32_t i = 0; i < 400; ++i) {
      for (std::uint32_t j = i + 1; j < 400; ++j) {
        if (trianglesMeet(cornersOf(soup, i), cornersOf(soup, j))) expected.emplace_back(i, j);
      }
    }
    QVERIFY(expected.size() > 50);
    QVERIFY(selfIntersections(soup) == expected);

    const TriangleTree tree(soup);
    for (std::uint64_t n = 0; n < 50; ++n) {
      const Vector3d p(randomUniform(n, 100), randomUniform(n, 101), randomUniform(n, 102));
      double best = 1e9;
      for (std::uint32_t i = 0; i < 400; ++i) {
        const auto t = cornersOf(soup, i);
        const Vector3d w = closestWeights(t, p);
        QVERIFY(w.minCoeff() >= 0.0 && near(w.sum(), 1.0, 1e-14));
        best = std::min(best, (w[0] * t[0] + w[1] * t[1] + w[2] * t[2] - p).norm());
      }
      QVERIFY(near(tree.closest(p).distance, best, 1e-14));
    }
  }

  void theFirstExitIsThroughTheTriangle() {
    TriMesh mesh;
    mesh.points = {{0.0, 0.0, 1.0}, {3.0, 0.0, 1.0}, {0.0, 3.0, 1.0}};
    mesh.triangles = {{0, 1, 2}};
    const TriangleTree tree(mesh);
    const Vector3d up(0.0, 0.0, 1.0);
    QVERIFY(tree.firstExit({1.0, 1.0, 0.0}, up, 0.0) == 1.0);
    QVERIFY(std::isinf(tree.firstExit({1.0, 1.0, 0.0}, up, 1.5)));
    QVERIFY(std::isinf(tree.firstExit({1.0, 1.0, 2.0}, -up, 0.0)));  // from outside
    QVERIFY(std::isinf(tree.firstExit({2.0, 2.0, 0.0}, up, 0.0)));
    QVERIFY(std::isinf(tree.firstExit({-1.0, -1.0, 0.0}, up, 0.0)));
  }

  void orderOfVerticesAndTrianglesDoesNotMatter() {
    TriMesh mesh = shapes::torus(17, 9, 3.0, 1.0);
    shapes::append(mesh, shapes::moved(shapes::openTube(10, 5, 1.0), {2.5, 0.1, 0.2}));
    TriMesh mixed;
    const auto n = static_cast<std::uint32_t>(mesh.points.size());
    std::vector<std::uint32_t> order(n), place(n);
    for (std::uint32_t i = 0; i < n; ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [](std::uint32_t a, std::uint32_t b) { return randomBits(5, a) < randomBits(5, b); });
    for (std::uint32_t i = 0; i < n; ++i) {
      place[order[i]] = i;
      mixed.points.push_back(mesh.points[order[i]]);
    }
    for (auto t = mesh.triangles.rbegin(); t != mesh.triangles.rend(); ++t) {
      mixed.triangles.push_back({place[(*t)[1]], place[(*t)[2]], place[(*t)[0]]});
    }
    const MeshQuality a = measureQuality(mesh), b = measureQuality(mixed);
    QVERIFY(a.selfIntersections > 0);
    QCOMPARE(a.selfIntersections, b.selfIntersections);
    QCOMPARE(a.genus, b.genus);
    QCOMPARE(a.euler, b.euler);
    QCOMPARE(a.boundaryLoops, b.boundaryLoops);
    QCOMPARE(a.components, b.components);
    QVERIFY(near(a.areaMm2, b.areaMm2, 1e-10));
    QVERIFY(near(a.minAngleP01, b.minAngleP01, 1e-9));
    QVERIFY(near(a.radiusRatioMean, b.radiusRatioMean, 1e-12));
  }

  void threadsDoNotMatter() {
    const TriMesh mesh = marchingCubes(shapes::noise({14, 14, 14}, 3));
    const auto [a, b] = onOneAndSeveralThreads([&] { return measureQuality(mesh); }, 4);
    setThreads(0);
    QVERIFY(a.intersectingPairs == b.intersectingPairs);
    QCOMPARE(a.radiusRatioMean, b.radiusRatioMean);
    QCOMPARE(a.areaMm2, b.areaMm2);
  }

  void marchingCubesOfNoiseIsSound_data() {
    QTest::addColumn<int>("seed");
    for (int seed = 11; seed <= 14; ++seed) QTest::addRow("%d", seed) << seed;
  }

  void marchingCubesOfNoiseIsSound() {
    QFETCH(int, seed);
    const MeshQuality q = measureQuality(
        marchingCubes(shapes::noise({16, 15, 14}, static_cast<std::uint64_t>(seed))));
    QVERIFY(q.closed && q.oriented);
    QCOMPARE(q.nonManifoldEdges + q.nonManifoldVertices, std::size_t{0});
    QCOMPARE(q.degenerateTriangles, std::size_t{0});
    QCOMPARE(q.selfIntersections, std::size_t{0});
  }

  void deviationFromTheWall() {
    // A sphere of radius 5.1 about a field whose zero set is the sphere of radius 5.
    Geometry g = shapes::obliqueGeometry({40, 34, 26});
    const Vector3d centre = g.toPhysical({19.5, 16.5, 12.5});
    const SplineField field(
        shapes::sampled(g, [&](const Vector3d& p) { return (p - centre).norm() - 5.0; }),
        SplineKind::InterpolatingBspline);
    TriMesh mesh = shapes::icosphere(4);
    for (auto& p : mesh.points) p = centre + 5.1 * p;
    const MeshQuality q = measureQuality(mesh, &field);
    QVERIFY(q.vertexDeviation && q.centroidDeviation);
    QVERIFY(near(q.vertexDeviation->meanMm, 0.1, 2e-3));
    QVERIFY(near(q.vertexDeviation->maxMm, 0.1, 4e-3));
    QVERIFY(q.centroidDeviation->meanMm < q.vertexDeviation->meanMm);
    QVERIFY(q.centroidDeviation->meanMm > 0.08);
    // Points beyond the outermost voxel centres are caps and do not count.
    const TriMesh outside = shapes::moved(mesh, {100.0, 0.0, 0.0});
    QVERIFY(!measureQuality(outside, &field).vertexDeviation);
  }

  void badMeshesAreRefused() {
    QVERIFY_THROWS_EXCEPTION(InputError, measureQuality({{{0, 0, 0}}, {{0, 0, 7}}}));
    QVERIFY_THROWS_EXCEPTION(
        InputError, measureQuality({{{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}, {{0, 1, 2}}}));
    const MeshQuality nothing = measureQuality(TriMesh());
    QVERIFY(!nothing.closed && !nothing.oriented);
    QCOMPARE(nothing.euler, 0);
    const Progress progress;
    progress.cancel();
    QVERIFY_THROWS_EXCEPTION(angiomesh::Cancelled,
                             measureQuality(shapes::cube(), nullptr, progress));
  }
};

QTEST_APPLESS_MAIN(TestMeshQuality)
#include "tst_mesh_quality.moc"
