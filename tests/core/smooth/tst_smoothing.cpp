// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <QTest>
#include <memory>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/contour/marching_cubes.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/self_intersection.h"
#include "core/mesh/triangle_tree.h"
#include "core/quality/mesh_quality.h"
#include "core/smooth/smoothing.h"
#include "core/smooth/wall_places.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

// Mean distance from the z axis of the vertices in the middle third of the tube's rings.
double middleRadius(const TriMesh& tube, int around, int rings) {
  double sum = 0.0;
  int count = 0;
  for (int v = around * (rings / 3); v < around * (2 * rings / 3); ++v, ++count) {
    sum += tube.points[static_cast<std::size_t>(v)].head<2>().norm();
  }
  return sum / count;
}

struct Scene {
  Volume<float> phi;
  TriMesh mesh;
  std::unique_ptr<SplineField> field;

  template <class F>
  Scene(const Geometry& g, F f, SurfaceBorder border = SurfaceBorder::Cap)
      : phi(shapes::sampled(g, f)),
        mesh(marchingCubes(phi, border)),
        field(std::make_unique<SplineField>(phi, SplineKind::InterpolatingBspline)) {}
};

// A tube through an oblique grid, along its third axis; distances in mm.
Scene tubeScene(double radiusVoxels, SurfaceBorder border = SurfaceBorder::Cap) {
  const int n = static_cast<int>(2.0 * radiusVoxels) + 9;
  Geometry g = shapes::obliqueGeometry({n, n + 1, 24});
  g.spacing.setConstant(0.5);
  const Vector3d centre = g.toPhysical({n / 2.0 + 0.13, n / 2.0 - 0.21, 0.0});
  const Vector3d axis = g.direction.col(2);
  return {g,
          [=](const Vector3d& p) {
            const Vector3d d = p - centre;
            return std::min(2.5, (d - d.dot(axis) * axis).norm() - 0.5 * radiusVoxels);
          },
          border};
}

// Two balls, joined; anisotropic and mirrored.
Scene dumbbellScene() {
  const Geometry g = shapes::obliqueGeometry({40, 26, 20}, true);
  const Vector3d one = g.toPhysical({13.2, 12.7, 9.6}), other = g.toPhysical({25.6, 12.2, 9.1});
  return {g, [=](const Vector3d& p) {
            const double a = (p - one).norm() - 3.1, b = (p - other).norm() - 2.4;
            const double h = std::max(1.0 - std::abs(a - b), 0.0);
            return std::min(a, b) - h * h / 4.0;
          }};
}

// A box across an oblique, anisotropic grid; its half sides in mm.
Scene boxScene(const Vector3d& half) {
  const Geometry g = shapes::obliqueGeometry({26, 26, 20}, true);
  const Vector3d centre = g.toPhysical({12.2, 12.7, 9.6});
  return {g, [=](const Vector3d& p) { return ((p - centre).cwiseAbs() - half).maxCoeff(); }};
}

double furthestFromWall(const TriMesh& mesh, const SplineField& field) {
  const MeshQuality q = measureQuality(mesh, &field);
  return q.vertexDeviation->maxMm / field.geometry().voxelMm();
}

}  // namespace

class TestSmoothing : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void taubinScalesTubes_data() {
    QTest::addColumn<int>("around");
    QTest::addColumn<double>("expected");
    QTest::newRow("6") << 6 << 0.69;
    QTest::newRow("8") << 8 << 1.00;
    QTest::newRow("12") << 12 << 1.08;
    QTest::newRow("16") << 16 << 1.06;
    QTest::newRow("24") << 24 << 1.03;
  }

  void taubinScalesTubes() {
    QFETCH(int, around);
    QFETCH(double, expected);
    // 100 steps reach 100 rings in from the rim.
    const int rings = 330;
    const TriMesh tube = shapes::openTube(around, rings, 2.0);
    const TriMesh smooth = taubinSmooth(tube, {SmoothMethod::Taubin});
    const double factor = middleRadius(smooth, around, rings) / 2.0;
    // The radius is an eigenmode of the uniform Laplacian: two neighbours on the ring, four on the
    // next rings half an edge aside.
    const double k =
        1.0 - (2.0 * std::cos(2.0 * shapes::pi / around) + 4.0 * std::cos(shapes::pi / around)) / 6;
    const double exact = std::pow((1.0 - 0.5 * k) * (1.0 + 0.54 * k), 50);
    QVERIFY(isNear(factor, exact, 1e-9));
    QVERIFY(isNear(factor, expected, 6e-3));
  }

  /// A part that is inscribed is smoothed as if it were alone, beside one that is not, and
  /// whichever comes first.
  void partsAreSmoothedEachInItsWay() {
    const Vector3d c{9.5, 9.3, 9.6}, far{26.2, 9.5, 9.4};
    const double radius = 5.0;
    Geometry g = analytic::cube(20);
    g.size = {36, 20, 20};
    const Volume<float> phi = shapes::sampled(g, [&](const Vector3d& p) {
      return std::min(analytic::ball(p, c, radius), analytic::ball(p, far, radius));
    });
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    TriMesh inscribed = shapes::icosphere(3);
    for (Vector3d& p : inscribed.points) {
      p = c + radius * p;
      QVERIFY(field.projectToZero(p));
    }
    TriMesh rough = shapes::icosphere(3);
    for (std::size_t v = 0; v < rough.points.size(); ++v)
      rough.points[v] = far + (radius + (v % 2 == 0 ? 0.2 : -0.2)) * rough.points[v];
    const TriMesh alone = keepWallSmooth(inscribed, {}, &field);
    QVERIFY((alone.points[0] - c).norm() > (inscribed.points[0] - c).norm() + 1e-3);
    for (const bool last : {false, true}) {
      TriMesh both = last ? rough : inscribed;
      shapes::append(both, last ? inscribed : rough);
      const TriMesh smooth = keepWallSmooth(both, {}, &field);
      const std::size_t from = last ? rough.points.size() : 0;
      for (std::size_t v = 0; v < alone.points.size(); ++v)
        QVERIFY((smooth.points[from + v] - alone.points[v]).norm() < 1e-9);
    }
  }

  void keepWallKeepsTubes_data() { taubinScalesTubes_data(); }

  void keepWallKeepsTubes() {
    QFETCH(int, around);
    const int rings = 45;
    const TriMesh tube = shapes::openTube(around, rings, 2.0);
    const TriMesh smooth = keepWallSmooth(tube, {});
    QVERIFY(std::abs(middleRadius(smooth, around, rings) / 2.0 - 1.0) < 0.01);
    QCOMPARE(smooth.points.size(), tube.points.size());
    QVERIFY(measureQuality(smooth).minAngleMin > 55.0);
  }

  void taubinKeepsRimsInTheirPlane() {
    const TriMesh tube = shapes::openTube(12, 30, 2.0);
    const TriMesh smooth = taubinSmooth(tube, {SmoothMethod::Taubin});
    const double length = tube.points.back().z();
    for (std::size_t v = 0; v < 12; ++v) {
      QCOMPARE(smooth.points[v].z(), 0.0);
      QVERIFY(std::abs(smooth.points[smooth.points.size() - 1 - v].z() - length) < 1e-12);
    }
  }

  void taubinFiltersWhatIsNoManifold() {
    // Two tetrahedra in one vertex and a vertex of no triangle, beside a tube that does not notice.
    const TriMesh tube = shapes::openTube(12, 30, 2.0);
    TriMesh mixed = tube;
    const auto base = static_cast<std::uint32_t>(tube.points.size());
    const auto other = [&](std::uint32_t v) { return v == 0 ? base : base + v + 3; };
    const TriMesh tetrahedron = shapes::tetrahedron();
    for (const Vector3d& p : tetrahedron.points) mixed.points.push_back(p);
    for (std::size_t v = 1; v < 4; ++v) mixed.points.emplace_back(-1.0 * tetrahedron.points[v]);
    for (const auto& t : tetrahedron.triangles) {
      mixed.triangles.push_back({base + t[0], base + t[1], base + t[2]});
      mixed.triangles.push_back({other(t[0]), other(t[1]), other(t[2])});
    }
    mixed.points.emplace_back(9.0, 9.0, 9.0);
    const SmoothParams params{SmoothMethod::Taubin};
    const TriMesh alone = taubinSmooth(tube, params), beside = taubinSmooth(mixed, params);
    QVERIFY(beside.triangles == mixed.triangles);
    QVERIFY(beside.points.back() == Vector3d(9.0, 9.0, 9.0));
    for (std::size_t v = 0; v < tube.points.size(); ++v)
      QVERIFY((alone.points[v] - beside.points[v]).norm() < 1e-12);
    // The vertex that they share stays between them.
    QVERIFY(beside.points[base].norm() < 1e-12);
  }

  void noneAndNoIterationsChangeNothing() {
    const TriMesh mesh = shapes::torus(12, 8, 3.0, 1.0);
    SmoothParams params;
    params.method = SmoothMethod::None;
    QVERIFY(smoothSurface(mesh, params).points == mesh.points);
    params.iterations = 0;
    for (const SmoothMethod method : {SmoothMethod::KeepWall, SmoothMethod::Taubin}) {
      params.method = method;
      QVERIFY(smoothSurface(mesh, params).points == mesh.points);
    }
    QVERIFY(smoothSurface(TriMesh(), SmoothParams()).triangles.empty());
  }

  void keepWallKeepsTheRadius_data() {
    QTest::addColumn<double>("radius");
    QTest::addColumn<bool>("withPhi");
    for (const double r : {2.0, 4.0, 8.0}) QTest::addRow("%g phi", r) << r << true;
    for (const double r : {1.0, 2.0, 4.0, 8.0}) QTest::addRow("%g", r) << r << false;
  }

  void keepWallKeepsTheRadius() {
    QFETCH(double, radius);
    QFETCH(bool, withPhi);
    const Scene scene = tubeScene(radius);
    const TriMesh smooth = keepWallSmooth(scene.mesh, {}, withPhi ? scene.field.get() : nullptr);
    const double ratio = std::sqrt(enclosedVolumeMm3(smooth) / enclosedVolumeMm3(scene.mesh));
    QVERIFY(isNear(ratio, 1.0, 0.01));
    const MeshQuality before = measureQuality(scene.mesh), after = measureQuality(smooth);
    QVERIFY(after.closed && after.oriented);
    QCOMPARE(after.selfIntersections, std::size_t{0});
    QCOMPARE(after.euler, before.euler);
    QCOMPARE(after.vertices, before.vertices);
    QCOMPARE(after.triangles, before.triangles);
    QVERIFY(isAbove(after.minAngleMin, 30.0));
    QVERIFY(after.radiusRatioMean > 0.9);
  }

  void withoutPhiTheInputIsTheWall() {
    const Scene scene = dumbbellScene();
    const TriMesh smooth = keepWallSmooth(scene.mesh, {});
    const TriangleTree tree(scene.mesh);
    const double bound = 0.05 * measureQuality(scene.mesh).edgeMeanMm;
    for (const Vector3d& p : smooth.points) QVERIFY(tree.closest(p).distance < 1.02 * bound);
    QVERIFY(std::abs(enclosedVolumeMm3(smooth) / enclosedVolumeMm3(scene.mesh) - 1.0) < 0.01);
    QVERIFY(measureQuality(smooth).minAngleMin > 30.0);
  }

  void thinTubesComeCloserToTheWall() {
    // Marching cubes cuts a tube of one voxel by more than the bound: it may only grow towards
    // the wall.
    const Scene scene = tubeScene(1.0);
    const TriMesh smooth = keepWallSmooth(scene.mesh, {}, scene.field.get());
    const double truth = shapes::pi * 0.25 * 24.0 * 0.5;
    QVERIFY(enclosedVolumeMm3(smooth) > enclosedVolumeMm3(scene.mesh));
    QVERIFY(enclosedVolumeMm3(smooth) < truth);
    QVERIFY(furthestFromWall(smooth, *scene.field) <= 0.05);
  }

  void verticesStayNearTheWall() {
    const Scene scene = dumbbellScene();
    const TriMesh smooth = keepWallSmooth(scene.mesh, {}, scene.field.get());
    QVERIFY(furthestFromWall(smooth, *scene.field) <= 0.05);
    QVERIFY(std::abs(enclosedVolumeMm3(smooth) / enclosedVolumeMm3(scene.mesh) - 1.0) < 0.01);
    for (const auto& t : smooth.triangles) {
      const Vector3d& a = smooth.points[t[0]];
      const Vector3d n = (smooth.points[t[1]] - a).cross(smooth.points[t[2]] - a).normalized();
      QVERIFY(n.dot(scene.field->at(a).gradient.normalized()) > 0.5);
    }
    SmoothParams tight;
    tight.wallBoundVoxels = 0.001;
    QVERIFY(furthestFromWall(keepWallSmooth(scene.mesh, tight, scene.field.get()), *scene.field) <=
            0.001);
  }

  // At a box's edges and corners triangles turn or get thin before their vertices are at the wall;
  // they get there all the same.
  void verticesComeToSharpWallsToo() {
    for (const double size : {0.7, 1.0, 2.0}) {
      const Scene scene = boxScene(size * Vector3d(1.0, 1.3, 1.7));
      for (const int iterations : {1, 3, 10, 50}) {
        SmoothParams params;
        params.iterations = iterations;
        const double furthest =
            furthestFromWall(keepWallSmooth(scene.mesh, params, scene.field.get()), *scene.field);
        QVERIFY2(furthest < 1.02 * params.wallBoundVoxels, qPrintable(QString::number(furthest)));
      }
    }
  }

  void capsStayFlat() {
    const Scene scene = tubeScene(4.0);
    const Geometry& g = scene.phi.geometry;
    const TriMesh smooth = keepWallSmooth(scene.mesh, {}, scene.field.get());
    int onCaps = 0;
    for (std::size_t v = 0; v < smooth.points.size(); ++v) {
      const double before = g.toIndex(scene.mesh.points[v]).z();
      const double after = g.toIndex(smooth.points[v]).z();
      if (before < -0.25 || before > g.size[2] - 0.75) {
        QVERIFY(std::abs(after - before) < 1e-9);
        ++onCaps;
      } else {
        QVERIFY(after > -0.5 && after < g.size[2] - 0.5);
      }
    }
    QVERIFY(onCaps > 50);
  }

  void capsThatMeetStayInTheirPlanes() {
    Geometry g;
    g.size = {20, 20, 20};
    const Scene scene(g,
                      [](const Vector3d& p) { return (p - Vector3d(1.3, 2.2, 9.6)).norm() - 5.4; });
    const TriMesh smooth = keepWallSmooth(scene.mesh, {}, scene.field.get());
    int held = 0;
    for (std::size_t v = 0; v < smooth.points.size(); ++v) {
      const Vector3d before = scene.mesh.points[v], after = smooth.points[v];
      const bool x = before.x() < -0.25, y = before.y() < -0.25;
      if (x) QVERIFY(std::abs(after.x() - before.x()) < 1e-9);
      if (y) QVERIFY(std::abs(after.y() - before.y()) < 1e-9);
      held += x || y ? 1 : 0;
    }
    QVERIFY(held > 50);
    const MeshQuality q = measureQuality(smooth);
    QVERIFY(q.closed && q.oriented);
    QCOMPARE(q.selfIntersections, std::size_t{0});
    QVERIFY(isAbove(q.minAngleMean, measureQuality(scene.mesh).minAngleMean + 10.0));
  }

  // Where the border runs along a vessel marching cubes ends it far inside the wall.
  void rimsOfCapsComeToTheWall() {
    Geometry g;
    g.size = {30, 18, 14};
    g.spacing.setConstant(0.5);
    const double radius = 2.0;
    const Scene scene(g, [&](const Vector3d& p) {
      return std::hypot(p.y() - 4.3, p.z() + 0.7 - 0.05 * p.x()) - radius;
    });
    const TriMesh smooth = keepWallSmooth(scene.mesh, {}, scene.field.get());
    const auto capArea = [&](const TriMesh& mesh) {
      double area = 0.0;
      for (const auto& t : mesh.triangles) {
        const Vector3d &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
        if (std::max({a.z(), b.z(), c.z()}) < -0.24) area += 0.5 * (b - a).cross(c - a).norm();
      }
      return area;
    };
    // Half a voxel beyond the border the wall goes on straight from there.
    double truth = 0.0;
    for (int i = 0; i < 2900; ++i) {
      const double depth = 0.7 - 0.05 * (0.005 * i);
      truth += 0.005 * 2.0 * std::sqrt(radius * radius - depth * depth);
    }
    QVERIFY(capArea(scene.mesh) < 0.95 * truth);
    QVERIFY(isNear(capArea(smooth) / truth, 1.0, 0.01));
  }

  void openRimsStayInTheirPlane() {
    const Scene scene = tubeScene(3.0, SurfaceBorder::Open);
    const Geometry& g = scene.phi.geometry;
    const TriMesh smooth = keepWallSmooth(scene.mesh, {}, scene.field.get());
    int rim = 0;
    for (const RimEdge& edge : rimEdges(smooth)) {
      const double k = g.toIndex(smooth.points[edge.from]).z();
      QVERIFY(std::abs(k) < 1e-9 || std::abs(k - (g.size[2] - 1)) < 1e-9);
      ++rim;
    }
    QVERIFY(rim > 20);
    QCOMPARE(measureQuality(smooth).boundaryLoops, std::size_t{2});
    QVERIFY(furthestFromWall(smooth, *scene.field) <= 0.05);
  }

  // Both rims of a tube that ends in the outermost planes of voxel centres are of its wall.
  void openRimsAreAlikeAtBothEnds() {
    const Scene scene = tubeScene(3.0, SurfaceBorder::Open);
    const Geometry& g = scene.phi.geometry;
    const WallPlaces places(scene.mesh, scene.field.get(), {},
                            std::vector<char>(scene.mesh.points.size(), 0));
    int rims[2] = {0, 0};
    for (std::size_t v = 0; v < scene.mesh.points.size(); ++v) {
      const double k = g.toIndex(scene.mesh.points[v]).z();
      const bool low = k<1e-6, high = k> g.size[2] - 1 - 1e-6;
      QCOMPARE(places.mesh.place[v].planes(), low || high ? 1 : 0);
      QVERIFY(places.mesh.place[v].wall && places.offWall[v] == 0 && places.fixed[v] == 0);
      if (low || high) ++rims[high ? 1 : 0];
    }
    QVERIFY(rims[0] > 10 && rims[0] == rims[1]);
  }

  // A mesh that tells its patches apart says no more about its open rims than one that does not.
  void openRimsStayOfTheWallBesidePatches() {
    const Scene scene = tubeScene(3.0, SurfaceBorder::Open);
    TriMesh mesh = scene.mesh;
    mesh.patch.assign(mesh.triangles.size(), 0);
    const WallPlaces places(mesh, scene.field.get(), {}, std::vector<char>(mesh.points.size(), 0));
    int rim = 0;
    for (const RimEdge& edge : rimEdges(mesh)) {
      const Place& place = places.mesh.place[edge.from];
      QVERIFY(place.wall && place.planes() == 1 && places.offWall[edge.from] == 0);
      QVERIFY(!places.planes[static_cast<std::size_t>(place.firstPlane() - 6)].isZero());
      ++rim;
    }
    QVERIFY(rim > 20);
  }

  void noiseStaysSound() {
    const Volume<float> phi = shapes::noise({8, 8, 8}, 5);
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    const TriMesh mesh = marchingCubes(phi);
    for (const SplineField* wall : {&field, static_cast<const SplineField*>(nullptr)}) {
      const TriMesh smooth = keepWallSmooth(mesh, {}, wall);
      const MeshQuality q = measureQuality(smooth);
      QVERIFY(q.closed && q.oriented);
      QCOMPARE(q.nonManifoldEdges + q.nonManifoldVertices, std::size_t{0});
      QCOMPARE(q.selfIntersections, std::size_t{0});
      QCOMPARE(q.euler, measureQuality(mesh).euler);
    }
  }

  void anyTriangleListSurvives() {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      TriMesh soup;
      for (std::uint64_t i = 0; i < 30; ++i) {
        soup.points.emplace_back(randomUniform(seed, 3 * i), randomUniform(seed, 3 * i + 1),
                                 seed % 4 == 0 ? 0.0 : randomUniform(seed, 3 * i + 2));
      }
      if (seed % 3 == 0) soup.points[7] = soup.points[8];
      for (std::uint64_t i = 0; i < 80; ++i) {
        std::array<std::uint32_t, 3> t{};
        for (std::uint64_t k = 0; k < 3; ++k) {
          t[k] = static_cast<std::uint32_t>(randomBits(seed, 1000 + 3 * i + k) % 30);
        }
        soup.triangles.push_back(t);
      }
      for (const SmoothMethod method : {SmoothMethod::KeepWall, SmoothMethod::Taubin}) {
        SmoothParams params;
        params.method = method;
        const TriMesh smooth = smoothSurface(soup, params);
        QCOMPARE(smooth.points.size(), soup.points.size());
        QCOMPARE(smooth.triangles.size(), soup.triangles.size());
        for (const Vector3d& p : smooth.points) QVERIFY(p.allFinite());
        QCOMPARE(measureQuality(smooth).triangles, soup.triangles.size());
      }
    }
    TriMesh wrong = shapes::cube();
    wrong.triangles.push_back({0, 1, 99});
    QVERIFY_THROWS_EXCEPTION(InputError, keepWallSmooth(wrong, {}));
    QVERIFY_THROWS_EXCEPTION(InputError, taubinSmooth(wrong, {}));
  }

  void threadsDoNotMatter() {
    const Scene scene = dumbbellScene();
    setThreads(1);
    const TriMesh one = keepWallSmooth(scene.mesh, {}, scene.field.get());
    const TriMesh taubinOne = taubinSmooth(scene.mesh, {});
    setThreads(4);
    const TriMesh four = keepWallSmooth(scene.mesh, {}, scene.field.get());
    const TriMesh taubinFour = taubinSmooth(scene.mesh, {});
    setThreads(0);
    QVERIFY(one.points == four.points && one.triangles == four.triangles);
    QVERIFY(taubinOne.points == taubinFour.points);
  }

  void cancels() {
    const Progress progress;
    progress.cancel();
    const TriMesh mesh = shapes::torus(12, 8, 3.0, 1.0);
    for (const SmoothMethod method : {SmoothMethod::KeepWall, SmoothMethod::Taubin}) {
      SmoothParams params;
      params.method = method;
      QVERIFY_THROWS_EXCEPTION(angiomesh::Cancelled,
                               smoothSurface(mesh, params, nullptr, progress));
    }
  }
};

QTEST_APPLESS_MAIN(TestSmoothing)
#include "tst_smoothing.moc"
