// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/front/mend_mesh.h"
#include "core/mesh/mesh_faults.h"
#include "core/quality/mesh_quality.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

const Vector3d kCentre{15.4, 15.2, 15.7};
constexpr double kRadius = 9.3;

const SplineField& ballField() {
  static const SplineField field(
      analytic::sampled(analytic::cube(32),
                        [](const Vector3d& p) { return analytic::ball(p, kCentre, kRadius); }),
      SplineKind::InterpolatingBspline);
  return field;
}

PatchMesh patchOf(const TriMesh& mesh) {
  PatchMesh patch;
  patch.mesh = mesh;
  patch.patch.assign(mesh.triangles.size(), 0);
  patch.place.assign(mesh.points.size(), Place::onWall());
  patch.origin.assign(mesh.triangles.size(), FaceOrigin::Front);
  return patch;
}

// The ball as 320 triangles that face outward.
PatchMesh ballMesh() {
  TriMesh mesh = shapes::icosphere(2);
  for (Vector3d& p : mesh.points) p = kCentre + kRadius * p;
  if (enclosedVolumeMm3(mesh) < 0.0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return patchOf(mesh);
}

void addTriangle(PatchMesh& mesh, const std::array<std::uint32_t, 3>& t) {
  mesh.mesh.triangles.push_back(t);
  mesh.patch.push_back(0);
  mesh.origin.push_back(FaceOrigin::Front);
}

PatchMesh without(const PatchMesh& mesh, const std::vector<std::uint32_t>& gone) {
  return selectTriangles(
      mesh, [&](std::uint32_t t) { return std::count(gone.begin(), gone.end(), t) == 0; });
}

// With the points in the order in which the triangles use them.
PatchMesh renumbered(const PatchMesh& mesh) { return without(mesh, {}); }

std::size_t closingOf(const PatchMesh& mesh) {
  return static_cast<std::size_t>(
      std::count(mesh.origin.begin(), mesh.origin.end(), FaceOrigin::Closing));
}

// A triangle that shares an edge with the given one.
std::uint32_t neighbourOf(const TriMesh& mesh, std::uint32_t t) {
  for (std::uint32_t u = 0; u < mesh.triangles.size(); ++u) {
    if (u == t) continue;
    int common = 0;
    for (const std::uint32_t v : mesh.triangles[u])
      common += static_cast<int>(std::count(mesh.triangles[t].begin(), mesh.triangles[t].end(), v));
    if (common == 2) return u;
  }
  return t;
}

// A mesh with one fault, by name.
PatchMesh damaged(const QString& how) {
  PatchMesh mesh = ballMesh();
  const std::uint32_t at = 40, beside = neighbourOf(mesh.mesh, at);
  if (how == "hole") return without(mesh, {at});
  if (how == "wide hole") return without(mesh, {at, beside});
  if (how == "two holes") return without(mesh, {at, 200});
  if (how == "turned face") std::swap(mesh.mesh.triangles[at][0], mesh.mesh.triangles[at][1]);
  if (how == "doubled face") addTriangle(mesh, mesh.mesh.triangles[at]);
  if (how == "third face") {
    // From an edge to a vertex far away.
    const auto& t = mesh.mesh.triangles[at];
    addTriangle(mesh, {t[0], t[1], mesh.mesh.triangles[200][0]});
  }
  if (how == "fans that meet") {
    // Two vertices of distant triangles become one.
    const std::uint32_t kept = mesh.mesh.triangles[at][0], other = mesh.mesh.triangles[200][0];
    for (auto& t : mesh.mesh.triangles)
      for (auto& v : t)
        if (v == other) v = kept;
    mesh = selectTriangles(mesh, [](std::uint32_t) { return true; });
  }
  return mesh;
}

}  // namespace

class TestMendMesh : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void findsWhatIsBroken() {
    QVERIFY(brokenTriangles(ballMesh(), false).empty());
    const PatchMesh hole = damaged("hole");
    const auto around = brokenTriangles(hole, false);
    QCOMPARE(around.size(), std::size_t{3});
    QVERIFY(std::is_sorted(around.begin(), around.end()));
    // On a wall a rim is a fault of open surfaces, too.
    QCOMPARE(brokenTriangles(hole, true).size(), std::size_t{3});
    // The turned one, its neighbours, and the fans around its corners.
    const auto turned = brokenTriangles(damaged("turned face"), false);
    QVERIFY(turned.size() >= 4 && turned.size() < 20);
    QVERIFY(std::count(turned.begin(), turned.end(), 40U) == 1);
    // Both copies of a doubled face, whose edges have three faces each, and all around.
    const auto doubled = brokenTriangles(damaged("doubled face"), false);
    QVERIFY(doubled.size() >= 5 && doubled.size() < 20);
    QVERIFY(std::count(doubled.begin(), doubled.end(), 40U) == 1);
    QVERIFY(doubled.back() == 320U);
    QVERIFY(brokenTriangles(damaged("fans that meet"), false).size() > 9);
  }

  // A rim in a plane that the surface ends in is a fault of closed surfaces alone.
  void rimsInPlanesAreNoFaultOfOpenSurfaces() {
    PatchMesh tube = patchOf(shapes::openTube(8, 6, 2.0));
    for (std::size_t v = 0; v < 8; ++v) tube.place[v].borders = 1U << 4U;
    for (std::size_t v = tube.place.size() - 8; v < tube.place.size(); ++v)
      tube.place[v].borders = 1U << 5U;
    QVERIFY(brokenTriangles(tube, true).empty());
    QCOMPARE(brokenTriangles(tube, false).size(), std::size_t{16});
  }

  void mendsEachFault_data() {
    QTest::addColumn<int>("rings");
    for (const char* how : {"hole", "wide hole", "two holes", "turned face", "doubled face",
                            "third face", "fans that meet"})
      for (const int rings : {0, 1, 2}) QTest::addRow("%s, %d", how, rings) << rings;
  }
  void mendsEachFault() {
    QFETCH(int, rings);
    const QString how = QString(QTest::currentDataTag()).section(',', 0, 0);
    PatchMesh mesh = damaged(how);
    const PatchMesh before = mesh;
    const auto broken = brokenTriangles(mesh, false);
    QVERIFY(!broken.empty());
    QVERIFY(mendMesh(mesh, broken, rings, ballField()));
    QVERIFY(brokenTriangles(mesh, false).empty());
    QCOMPARE(mesh.patch.size(), mesh.mesh.triangles.size());
    QCOMPARE(mesh.origin.size(), mesh.mesh.triangles.size());
    QCOMPARE(mesh.place.size(), mesh.mesh.points.size());
    const MeshQuality q = measureQuality(mesh.mesh);
    QVERIFY(q.closed && q.oriented);
    QCOMPARE(q.components, 1);
    QCOMPARE(q.euler, 2);
    // What is filled is marked; far from the fault all stays as it was.
    QVERIFY(closingOf(mesh) > 0);
    QVERIFY(mesh.mesh.triangles.size() - closingOf(mesh) + broken.size() <=
            before.mesh.triangles.size());
    if (rings == 0) QVERIFY(closingOf(mesh) < 40);
    QVERIFY(enclosedVolumeMm3(mesh.mesh) > 0.8 * enclosedVolumeMm3(ballMesh().mesh));
    QVERIFY(findFaults(mesh.mesh, true).none());
  }

  void moreRingsTakeOutMore() {
    std::size_t last = 0;
    for (const int rings : {0, 1, 2, 3}) {
      PatchMesh mesh = damaged("hole");
      QVERIFY(mendMesh(mesh, brokenTriangles(mesh, false), rings, ballField()));
      QVERIFY(closingOf(mesh) > last);
      last = closingOf(mesh);
    }
  }

  // Nothing broken: the mesh stays, triangle by triangle.
  void leavesASoundMeshAlone() {
    PatchMesh mesh = ballMesh();
    QVERIFY(mendMesh(mesh, {}, 3, ballField()));
    const PatchMesh same = renumbered(ballMesh());
    QVERIFY(mesh.mesh.triangles == same.mesh.triangles);
    QVERIFY(mesh.mesh.points == same.mesh.points);
  }

  // Triangles that touch a plane that the surface ends in are not taken out.
  void keepsWhatLiesInPlanes() {
    PatchMesh mesh = ballMesh();
    const std::uint32_t corner = mesh.mesh.triangles[40][0];
    mesh.place[corner].borders = 1;
    const auto fanOf = [](const PatchMesh& of, const Vector3d& centre) {
      std::set<std::array<std::uint32_t, 3>> fan;
      for (const auto& t : of.mesh.triangles)
        for (const std::uint32_t v : t)
          if (of.mesh.points[v] == centre) fan.insert(t);
      return fan.size();
    };
    const std::size_t before = fanOf(mesh, mesh.mesh.points[corner]);
    std::vector<std::uint32_t> broken;
    for (std::uint32_t t = 0; t < mesh.mesh.triangles.size(); ++t)
      for (const std::uint32_t v : mesh.mesh.triangles[t])
        if (v == corner) broken.push_back(t);
    const Vector3d centre = mesh.mesh.points[corner];
    const PatchMesh kept = renumbered(mesh);
    QVERIFY(mendMesh(mesh, broken, 0, ballField()));
    QVERIFY(mesh.mesh.triangles == kept.mesh.triangles);
    QCOMPARE(fanOf(mesh, centre), before);
    QCOMPARE(closingOf(mesh), std::size_t{0});
  }

  // A hole that is too long to be filled: the mesh stays as it is.
  void leavesWhatItCannotFill() {
    PatchMesh tube = patchOf(shapes::openTube(300, 4, 9.3));
    for (Vector3d& p : tube.mesh.points) p += kCentre;
    const PatchMesh before = tube;
    QVERIFY(!mendMesh(tube, {}, 0, ballField()));
    QVERIFY(tube.mesh.triangles == before.mesh.triangles);
  }
};

QTEST_GUILESS_MAIN(TestMendMesh)
#include "tst_mend_mesh.moc"
