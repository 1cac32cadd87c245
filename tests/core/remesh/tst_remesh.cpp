// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <functional>
#include <memory>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/contour/marching_cubes.h"
#include "core/phantom/phantom.h"
#include "core/quality/mesh_quality.h"
#include "core/remesh/remesh.h"
#include "core/remesh/remesh_mesh.h"
#include "core/sizing/guidance_field.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_bars.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

// A field, the wanted edge lengths of issue's accuracy, and marching cubes as the start.
struct Scene {
  std::unique_ptr<SplineField> field;
  std::unique_ptr<GuidanceField> size;
  PatchMesh start;
  int euler = 0;

  [[nodiscard]] EndPlanes ends() const { return EndPlanes(field->geometry()); }

  Scene(const Volume<float>& phi, int eulerNumber) : euler(eulerNumber) {
    field = std::make_unique<SplineField>(phi, SplineKind::InterpolatingBspline);
    size = std::make_unique<GuidanceField>(*field, SizingParams::printed());
    start.mesh = marchingCubes(phi);
    start.place.assign(start.mesh.points.size(), Place::onWall());
    start.patch.assign(start.mesh.triangles.size(), 0);
    start.origin.assign(start.mesh.triangles.size(), FaceOrigin::Front);
  }
};

double torusPart(const Vector3d& p, const Vector3d& centre) {
  const Vector3d d = p - centre;
  return std::hypot(std::hypot(d[0], d[1]) - 9.0, d[2]) - 3.2;
}

// Smooth minimum (two continuous derivatives).
double blend(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * h * k / 6.0;
}

Scene makeScene(const QString& name) {
  const Geometry cube = analytic::cube(40);
  const Vector3d c{19.6, 19.3, 19.8};
  if (name == "sphere")
    return {shapes::sampled(cube, [&](const Vector3d& p) { return (p - c).norm() - 12.3; }), 2};
  if (name == "torus")
    return {shapes::sampled(cube, [&](const Vector3d& p) { return torusPart(p, c); }), 0};
  if (name == "double torus") {
    Geometry g = cube;
    g.size = {56, 36, 20};
    const Vector3d a{17.2, 17.3, 9.6}, b{37.9, 17.5, 9.6};
    return {shapes::sampled(
                g, [&](const Vector3d& p) { return blend(torusPart(p, a), torusPart(p, b), 3.0); }),
            -2};
  }
  if (name == "thin sheet")
    return {shapes::sampled(cube,
                            [&](const Vector3d& p) {
                              const Vector3d d = (p - c).cwiseAbs() - Vector3d(12.0, 12.0, 0.4);
                              return d.cwiseMax(0.0).norm() + std::min(d.maxCoeff(), 0.0) - 1.2;
                            }),
            2};
  if (name == "oblique") {
    const Geometry g = shapes::obliqueGeometry({48, 40, 30}, true);
    const Vector3d middle = analytic::centreOf(g), axis = g.direction.col(0);
    return {shapes::sampled(g,
                            [&](const Vector3d& p) {
                              const Vector3d d = p - middle;
                              const double x = std::clamp(d.dot(axis), -5.0, 5.0);
                              return (d - x * axis).norm() - 3.0 - 0.2 * x;
                            }),
            2};
  }
  if (name == "noise") {
    const Volume<float> noise = shapes::noise(cube.size, 5);
    Volume<float> phi =
        shapes::sampled(cube, [&](const Vector3d& p) { return torusPart(p, c) - 0.6; });
    for (std::size_t i = 0; i < phi.voxels.size(); ++i) phi.voxels[i] += 0.1F * noise.voxels[i];
    return {phi, 0};
  }
  PhantomParams params;
  params.kind = PhantomKind::CapsuleTree;
  params.size = {64, 64, 64};
  params.radius = 2.5;
  return {phantomField(params), 0};
}

// A good mesh made bad: vertices jittered along the surface by up to 0.35 edge lengths.
void spoil(PatchMesh& mesh, const Scene& scene) {
  std::uint64_t n = 0;
  for (Vector3d& p : mesh.mesh.points) {
    const Vector3d normal = scene.field->at(p).gradient.normalized();
    Vector3d step{randomUniform(7, n) - 0.5, randomUniform(7, n + 1) - 0.5,
                  randomUniform(7, n + 2) - 0.5};
    step -= step.dot(normal) * normal;
    p += 0.35 * scene.size->at(p) * randomUniform(7, n + 3) * step.normalized();
    n += 4;
  }
}

// Puts a vertex into the middle of a triangle, which becomes the first of three.
void cutInThree(PatchMesh& mesh, std::size_t triangle) {
  const auto [a, b, c] = mesh.mesh.triangles[triangle];
  std::vector<Vector3d>& points = mesh.mesh.points;
  const auto middle = static_cast<std::uint32_t>(points.size());
  points.emplace_back((points[a] + points[b] + points[c]) / 3.0);
  mesh.place.push_back(Place::onWall());
  mesh.mesh.triangles[triangle] = {a, b, middle};
  mesh.mesh.triangles.push_back({b, c, middle});
  mesh.mesh.triangles.push_back({c, a, middle});
  mesh.patch.resize(mesh.mesh.triangles.size(), 0);
  mesh.origin.resize(mesh.mesh.triangles.size(), mesh.origin.front());
}

void verifyBars(const PatchMesh& result, const Scene& scene) {
  const TriMesh& mesh = result.mesh;
  const double voxel = scene.field->geometry().voxelMm();
  const MeshQuality q = measureQuality(mesh, scene.field.get());
  QVERIFY(q.closed);
  QCOMPARE(q.euler, scene.euler);
  verifySoundShape(q);
  QVERIFY2(q.vertexDeviation->maxMm <= 1e-5 * voxel,
           qPrintable(QString::number(q.vertexDeviation->maxMm)));
  std::size_t within = 0, sides = 0;
  double expected = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vector3d &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const Vector3d n = (b - a).cross(c - a);
    const double g = scene.size->at((a + b + c) / 3.0);
    expected += 0.5 * n.norm() / (std::sqrt(3.0) / 4.0 * g * g);
    for (std::size_t k = 0; k < 3; ++k, ++sides) {
      const Vector3d &p = mesh.points[t[k]], &r = mesh.points[t[(k + 1) % 3]];
      const double length = (r - p).norm() / scene.size->at(0.5 * (p + r));
      if (length >= 0.7 && length <= 1.4) ++within;
      QVERIFY(n.dot(scene.field->at(p).gradient.normalized()) > 0.3 * n.norm());
    }
  }
  QVERIFY(static_cast<double>(within) >= 0.95 * static_cast<double>(sides));
  const double share = static_cast<double>(mesh.triangles.size()) / expected;
  QVERIFY2(share > 0.85 && share < 1.15, qPrintable(QString::number(share)));
}

bool same(const PatchMesh& a, const PatchMesh& b) {
  return a.mesh.points == b.mesh.points && a.mesh.triangles == b.mesh.triangles &&
         a.place == b.place && a.patch == b.patch && a.origin == b.origin;
}

}  // namespace

class TestRemesh : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void meetsTheBars_data() {
    QTest::addColumn<QString>("shape");
    for (const char* name :
         {"sphere", "torus", "double torus", "thin sheet", "oblique", "noise", "capsule tree"})
      QTest::newRow(name) << name;
  }

  void meetsTheBars() {
    QFETCH(QString, shape);
    const Scene scene = makeScene(shape);
    PatchMesh mesh = remesh(scene.start, *scene.field, *scene.size, scene.ends());
    verifyBars(mesh, scene);
    QVERIFY(std::all_of(mesh.origin.begin(), mesh.origin.end(),
                        [](FaceOrigin o) { return o == FaceOrigin::Remesh; }));
    mesh.origin.assign(mesh.origin.size(), FaceOrigin::Front);
    spoil(mesh, scene);
    QVERIFY(measureQuality(mesh.mesh).minAngleMin < 30.0);
    improveTriangles(mesh, *scene.field, *scene.size, scene.ends());
    verifyBars(mesh, scene);
    QVERIFY(std::all_of(mesh.origin.begin(), mesh.origin.end(),
                        [](FaceOrigin o) { return o == FaceOrigin::Front; }));
  }

  // Five triangles in each good one: flips and relaxation leave angles that only work on the worst
  // triangles, one by one, makes good.
  void uselessVerticesLeaveNoBadAngle() {
    const Scene scene = makeScene("torus");
    PatchMesh mesh = remesh(scene.start, *scene.field, *scene.size, scene.ends());
    const std::size_t good = mesh.mesh.triangles.size();
    for (std::size_t t = 0; t < good; ++t)
      for (int n = 0; n < 2; ++n) cutInThree(mesh, t);
    QVERIFY(measureQuality(mesh.mesh).minAngleMin < 10.0);
    improveTriangles(mesh, *scene.field, *scene.size, scene.ends());
    const MeshQuality q = measureQuality(mesh.mesh);
    QVERIFY(q.closed && q.euler == scene.euler);
    QVERIFY(isAbove(q.minAngleMin, 33.0));
    QVERIFY(isBelow(q.maxAngleMax, 105.0));
  }

  void theNumberOfThreadsDoesNotMatter() {
    const Scene scene = makeScene("oblique");
    setThreads(1);
    PatchMesh one = remesh(scene.start, *scene.field, *scene.size, scene.ends());
    spoil(one, scene);
    PatchMesh spoiled = one;
    improveTriangles(one, *scene.field, *scene.size, scene.ends());
    setThreads(4);
    PatchMesh four = remesh(scene.start, *scene.field, *scene.size, scene.ends());
    spoil(four, scene);
    QVERIFY(same(spoiled, four));
    improveTriangles(four, *scene.field, *scene.size, scene.ends());
    setThreads(0);
    QVERIFY(same(one, four));
  }

  void rimsAndCapsStayInTheirPlanes_data() {
    QTest::addColumn<bool>("capped");
    QTest::newRow("open") << false;
    QTest::newRow("capped") << true;
  }

  // A tube that leaves the volume at both ends of the third axis.
  void rimsAndCapsStayInTheirPlanes() {
    QFETCH(bool, capped);
    const Geometry g = shapes::obliqueGeometry({24, 22, 18});
    const Vector3d middle = analytic::centreOf(g), axis = g.direction.col(2);
    const auto phi =
        shapes::sampled(g, [&](const Vector3d& p) { return analytic::tube(p, middle, axis, 2.6); });
    Scene scene(phi, capped ? 2 : 0);
    PatchMesh start = tube(g, middle, 2.6, capped);
    const PatchMesh result = remesh(start, *scene.field, *scene.size, scene.ends());
    const MeshQuality q = measureQuality(result.mesh);
    QCOMPARE(q.euler, scene.euler);
    QCOMPARE(q.boundaryLoops, std::size_t{capped ? 0U : 2U});
    QCOMPARE(q.nonManifoldEdges + q.selfIntersections, std::size_t{0});
    verifyAngles(q);
    const double last = g.size[2] - 1;
    std::size_t onPlanes = 0;
    for (std::size_t v = 0; v < result.mesh.points.size(); ++v) {
      const Vector3d& p = result.mesh.points[v];
      const double z = g.toIndex(p)[2];
      const Place place = result.place[v];
      const Vector3d d = p - middle;
      if (place.wall) QVERIFY(std::abs((d - d.dot(axis) * axis).norm() - 2.6) < 0.02);
      if (place.planes() == 0) continue;
      ++onPlanes;
      QVERIFY(std::abs(z - (place.liesIn(4) ? 0.0 : last)) < 1e-9);
    }
    QVERIFY(onPlanes > 20);
    // Vertices slide along an open rim until it is evenly divided.
    double shortest = 1e9, longest = 0.0;
    for (const auto& t : result.mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        const Place edge = result.place[a].shared(result.place[b]);
        if (!edge.wall || edge.planes() != 1) continue;
        const double length = (result.mesh.points[b] - result.mesh.points[a]).norm();
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
      }
    if (!capped)
      QVERIFY2(longest < 1.05 * shortest, qPrintable(QString::number(longest / shortest)));
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
      if (result.patch[t] == 0) continue;
      QVERIFY(capped);
      for (const std::uint32_t v : result.mesh.triangles[t])
        QVERIFY(result.place[v].liesIn(result.patch[t] - 1));
    }
  }

  // Of the torus of seven vertices, which all are joined.
  void noEdgeIsMadeTwice() {
    PatchMesh start;
    for (std::uint32_t i = 0; i < 7; ++i) {
      start.mesh.points.emplace_back(i, i * i, i * i * i);
      start.mesh.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
      start.mesh.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
    }
    start.place.assign(7, Place::onWall());
    start.patch.assign(14, 0);
    start.origin.assign(14, FaceOrigin::Front);
    const EditMesh mesh(start);
    for (std::uint32_t h = 0; h < mesh.halfEdgeSlots(); ++h) {
      QVERIFY(!mesh.locked(mesh.origin(h)));
      QCOMPARE(mesh.valence(mesh.origin(h)), 6U);
      QVERIFY(!mesh.canFlip(h));
    }
  }

  // Random changes to a torus with an open rim, half of them taken back.
  void changesKeepAManifold() {
    PatchMesh start;
    start.mesh = shapes::torus(16, 10, 3.0, 1.0);
    start.mesh.triangles.erase(start.mesh.triangles.begin());
    start.place.assign(start.mesh.points.size(), Place::onWall());
    start.patch.assign(start.mesh.triangles.size(), 0);
    start.origin.assign(start.mesh.triangles.size(), FaceOrigin::Front);
    EditMesh mesh(start);
    std::size_t done = 0;
    for (std::uint64_t n = 0; n < 3000; ++n) {
      const auto h = static_cast<std::uint32_t>(randomBits(3, 2 * n) % mesh.halfEdgeSlots());
      const std::uint64_t what = randomBits(3, 2 * n + 1) % 6;
      if (mesh.origin(h) == EditMesh::none) continue;
      const bool back = what % 2 == 0;
      const PatchMesh before = mesh.result();
      if (back) mesh.beginTrial();
      if (what < 2) {
        if (mesh.canFlip(h)) mesh.flip(h), ++done;
      } else if (what < 4) {
        if (mesh.canCollapse(h)) mesh.collapse(h), ++done;
      } else {
        const Vector3d middle = 0.5 * (mesh.point(mesh.origin(h)) + mesh.point(mesh.target(h)));
        mesh.set(mesh.split(h, Place::onWall()), middle, Vector3d::UnitX(), 1.0);
        ++done;
      }
      if (back) mesh.takeBack();
      if (back) QVERIFY(same(mesh.result(), before));
      if (n % 500 == 250) mesh.reorder();
      if (n % 50 != 0) continue;
      const MeshQuality q = measureQuality(mesh.result().mesh);
      QVERIFY(q.oriented);
      QCOMPARE(q.nonManifoldEdges + q.nonManifoldVertices, std::size_t{0});
      QCOMPARE(q.euler, -1);
      QCOMPARE(q.boundaryLoops, std::size_t{1});
      for (std::uint32_t v = 0; v < mesh.vertexSlots(); ++v)
        if (mesh.livesVertex(v)) QCOMPARE(mesh.valence(v), mesh.ring(v).count);
    }
    QVERIFY(done > 1000);
  }

  void neighboursComeToLieTogether() {
    PatchMesh start;
    start.mesh = shapes::icosphere(4);
    const auto count = static_cast<std::uint32_t>(start.mesh.points.size());
    // Shuffled.
    const auto moved = [&](std::uint32_t v) { return (v * 1013U + 77U) % count; };
    const std::vector<Vector3d> points = start.mesh.points;
    for (std::uint32_t v = 0; v < count; ++v) start.mesh.points[moved(v)] = points[v];
    for (auto& t : start.mesh.triangles)
      for (auto& v : t) v = moved(v);
    start.place.assign(count, Place::onWall());
    start.patch.assign(start.mesh.triangles.size(), 0);
    start.origin.assign(start.mesh.triangles.size(), FaceOrigin::Front);
    EditMesh mesh(start);
    const auto apart = [&] {
      double vertices = 0.0, triangles = 0.0;
      for (std::uint32_t h = 0; h < mesh.halfEdgeSlots(); ++h) {
        vertices += std::abs(1.0 * mesh.origin(h) - mesh.target(h));
        triangles += std::abs(1.0 * (h / 3) - mesh.twin(h) / 3);
      }
      return std::max(vertices / count, 0.5 * triangles / count) / mesh.halfEdgeSlots();
    };
    QVERIFY(isAbove(apart(), 0.2));
    mesh.reorder();
    QVERIFY(isBelow(apart(), 0.03));
  }

  void takesWhatThereIs() {
    const Scene scene = makeScene("sphere");
    PatchMesh empty;
    QVERIFY(remesh(empty, *scene.field, *scene.size, scene.ends()).mesh.triangles.empty());
    improveTriangles(empty, *scene.field, *scene.size, scene.ends());
    QVERIFY(empty.mesh.triangles.empty());
    PatchMesh wrong = scene.start;
    wrong.patch.pop_back();
    QVERIFY_THROWS_EXCEPTION(InputError,
                             improveTriangles(wrong, *scene.field, *scene.size, scene.ends()));
    // Two tetrahedra in one vertex: not a manifold there, so nothing changes around it.
    PatchMesh joined;
    joined.mesh = shapes::tetrahedron();
    const auto other = [](std::uint32_t v) { return v == 0 ? 0 : v + 3; };
    for (const auto& t : shapes::tetrahedron().triangles)
      joined.mesh.triangles.push_back({other(t[0]), other(t[1]), other(t[2])});
    for (int v = 1; v < 4; ++v) joined.mesh.points.emplace_back(-1.0 * joined.mesh.points[v]);
    joined.place.assign(7, Place::onWall());
    joined.patch.assign(8, 0);
    joined.origin.assign(8, FaceOrigin::Closing);
    const TriMesh before = joined.mesh;
    improveTriangles(joined, *scene.field, *scene.size, scene.ends());
    QVERIFY(joined.mesh.points == before.points && joined.mesh.triangles == before.triangles);
    Progress cancelled;
    cancelled.cancel();
    QVERIFY_THROWS_EXCEPTION(
        Cancelled, remesh(scene.start, *scene.field, *scene.size, scene.ends(), cancelled));
  }

 private:
  // Rings of eight vertices on the tube wall, closed by fans where `capped`.
  static PatchMesh tube(const Geometry& g, const Vector3d& middle, double radius, bool capped) {
    PatchMesh mesh;
    constexpr std::uint32_t around = 8, rings = 5;
    const Vector3d axis = g.direction.col(2);
    const double length = (g.size[2] - 1) * g.spacing[2];
    const auto add = [&](const Vector3d& p, const Place& place) {
      mesh.mesh.points.push_back(p);
      mesh.place.push_back(place);
    };
    for (std::uint32_t r = 0; r < rings; ++r)
      for (std::uint32_t i = 0; i < around; ++i) {
        const double angle = 2.0 * shapes::pi * i / around;
        const Vector3d out =
            std::cos(angle) * g.direction.col(0) + std::sin(angle) * g.direction.col(1);
        const double along = length * (1.0 * r / (rings - 1) - 0.5);
        const auto borders = static_cast<std::uint8_t>(r == 0 ? 16 : r == rings - 1 ? 32 : 0);
        add(middle + radius * out + along * axis, {borders, true, 0});
      }
    const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, int patch) {
      mesh.mesh.triangles.push_back({a, b, c});
      mesh.patch.push_back(static_cast<std::uint16_t>(patch));
      mesh.origin.push_back(FaceOrigin::Front);
    };
    for (std::uint32_t r = 0; r + 1 < rings; ++r)
      for (std::uint32_t i = 0; i < around; ++i) {
        const std::uint32_t a = r * around + i, b = r * around + (i + 1) % around;
        face(a, b, b + around, 0);
        face(a, b + around, a + around, 0);
      }
    if (!capped) return mesh;
    const std::uint32_t last = (rings - 1) * around;
    add(middle - 0.5 * length * axis, Place::inPlane(4));
    add(middle + 0.5 * length * axis, Place::inPlane(5));
    for (std::uint32_t i = 0; i < around; ++i) {
      face((i + 1) % around, i, rings * around, 5);
      face(last + i, last + (i + 1) % around, rings * around + 1, 6);
    }
    return mesh;
  }
};

QTEST_APPLESS_MAIN(TestRemesh)
#include "tst_remesh.moc"
