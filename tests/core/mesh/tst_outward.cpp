// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/outward.h"

#include <QTest>

#include "tests/core/mesh_shapes.h"

using namespace angiomesh;
using namespace angiomesh::shapes;

namespace {

TriMesh inward(TriMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

TriMesh ball(double radius, const Eigen::Vector3d& centre) {
  TriMesh mesh = icosphere(2);
  for (auto& p : mesh.points) p = centre + radius * p;
  return mesh;
}

/// Two tetrahedra with one edge in common, opposite to one another; their triangles alternate.
TriMesh hinged() {
  const TriMesh one = tetrahedron();
  TriMesh mesh{one.points, {}};
  for (const std::size_t v : {1, 2}) mesh.points.push_back(-one.points[v]);
  for (auto t : one.triangles) {
    mesh.triangles.push_back(t);
    for (std::uint32_t& v : t) v = v == 1 || v == 2 ? v + 3 : v;
    mesh.triangles.push_back(t);
  }
  return mesh;
}

TriMesh together(const std::vector<TriMesh>& meshes) {
  TriMesh all;
  for (const TriMesh& mesh : meshes) append(all, mesh);
  return all;
}

}  // namespace

class TestOutward : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void partsAreTurnedByTheirVolume() {
    const Eigen::Vector3d far(0, 0, 300);
    TriMesh mesh = together(
        {ball(1.0, far), inward(torus(12, 8, 5.0, 1.0)), inward(moved(cube(), {20, 0, 0}))});
    const TriMesh wanted =
        together({ball(1.0, far), torus(12, 8, 5.0, 1.0), moved(cube(), {20, 0, 0})});
    const OutwardTurn turn = turnOutward(mesh);
    QCOMPARE(turn.closedParts, std::size_t{3});
    QCOMPARE(turn.turnedParts, std::size_t{2});
    // Turned triangles begin at the same corner, so only the sense may differ.
    QVERIFY(mesh.triangles == wanted.triangles);
    QCOMPARE(turnOutward(mesh).turnedParts, std::size_t{0});
  }

  void cavitiesStayCavities() {
    const Eigen::Vector3d c(100.0, -50.0, 10.0);
    const TriMesh shell = together(
        {ball(5.0, c), inward(ball(2.0, c)), inward(ball(1.0, c + Eigen::Vector3d(3.4, 0, 0)))});
    TriMesh mesh = shell;
    QCOMPARE(turnOutward(mesh).turnedParts, std::size_t{0});
    mesh = inward(shell);
    QCOMPARE(turnOutward(mesh).turnedParts, std::size_t{3});
    QVERIFY(mesh.triangles == shell.triangles);
    // A body of its own inside another, such as a lumen in its wall.
    const TriMesh bodies = together({ball(2.0, c), ball(5.0, c)});
    mesh = inward(bodies);
    turnOutward(mesh);
    QVERIFY(mesh.triangles == bodies.triangles);
  }

  void partsInTheHollowOfAnotherAreNotInsideIt() {
    // The ball lies in the hole of the torus: inside its box, outside its surface.
    TriMesh mesh = together({torus(24, 12, 5.0, 1.0), inward(ball(1.0, {0.3, 0.2, 0.1}))});
    QCOMPARE(turnOutward(mesh).turnedParts, std::size_t{1});
    QVERIFY(mesh.triangles == together({torus(24, 12, 5.0, 1.0), ball(1.0, {0, 0, 0})}).triangles);
  }

  void raysThroughEdgesAndVerticesCountOnce() {
    // Points of the inner cubes lie on the diagonals, edges and vertices of the outer one, seen
    // along z.
    for (const double x : {0.0, 1.0, 1.5, 2.0})
      for (const double y : {0.0, 1.0, 1.5, 2.0}) {
        TriMesh outer = cube();
        for (auto& p : outer.points) p = 4.0 * p - Eigen::Vector3d(0, 0, 1);
        const TriMesh mesh = together({outer, inward(moved(cube(), {x, y, 0.25}))});
        TriMesh turned = inward(mesh);
        QCOMPARE(turnOutward(turned).turnedParts, std::size_t{2});
        QVERIFY(turned.triangles == mesh.triangles);
      }
  }

  void whatIsNotClosedIsLeftAlone() {
    TriMesh open = inward(openTube(8, 5, 1.0));
    TriMesh torn = inward(cube());
    std::swap(torn.triangles[0][1], torn.triangles[0][2]);
    for (TriMesh* mesh : {&open, &torn}) {
      const TriMesh before = *mesh;
      const OutwardTurn turn = turnOutward(*mesh);
      QCOMPARE(turn.closedParts, std::size_t{0});
      QVERIFY(mesh->triangles == before.triangles);
    }
    TriMesh nothing;
    QCOMPARE(turnOutward(nothing).turnedParts, std::size_t{0});
  }

  /// The four triangles at the edge that two bodies share run along it in either way twice.
  void bodiesThatShareAnEdgeAreOneClosedPart() {
    const TriMesh wanted = hinged();
    TriMesh mesh = inward(wanted);
    const OutwardTurn turn = turnOutward(mesh);
    QCOMPARE(turn.closedParts, std::size_t{1});
    QCOMPARE(turn.turnedParts, std::size_t{1});
    QVERIFY(mesh.triangles == wanted.triangles);
    QVERIFY(!isClosed(wanted));
    // Such an edge does not say which of its triangles are alike.
    const AlikeTurn none = turnAlike(mesh);
    QVERIFY(none.turned == 0 && none.oneSided == 0);
    std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);
    QCOMPARE(turnAlike(mesh).turned, std::size_t{1});
    QVERIFY(mesh.triangles == wanted.triangles);
  }

  void partsAreMadeAlikeByTheFewestTurns() {
    const TriMesh wanted = together({icosphere(1), moved(torus(12, 8, 5.0, 1.0), {30, 0, 0})});
    for (const std::size_t every : {4, 7}) {
      TriMesh mesh = wanted;
      for (std::size_t t = 0; t < mesh.triangles.size(); t += every)
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
      const AlikeTurn turn = turnAlike(mesh);
      QCOMPARE(turn.oneSided, std::size_t{0});
      QCOMPARE(turn.turned, (wanted.triangles.size() + every - 1) / every);
      QVERIFY(mesh.triangles == wanted.triangles);
      QCOMPARE(turnAlike(mesh).turned, std::size_t{0});
    }
    // A single one of many.
    TriMesh one = wanted;
    std::swap(one.triangles[7][1], one.triangles[7][2]);
    QCOMPARE(turnAlike(one).turned, std::size_t{1});
    QVERIFY(one.triangles == wanted.triangles);
    // A Moebius strip of five triangles.
    TriMesh strip;
    for (std::uint32_t i = 0; i < 5; ++i) {
      strip.points.emplace_back(i, i * i, i * i * i);
      strip.triangles.push_back({i, (i + 1) % 5, (i + 2) % 5});
    }
    const TriMesh before = strip;
    QCOMPARE(turnAlike(strip).oneSided, std::size_t{1});
    QVERIFY(strip.triangles == before.triangles);
  }

  void closednessIsTwoTrianglesAtEachEdge() {
    QVERIFY(isClosed(cube()));
    QVERIFY(!isClosed(openTube(8, 5, 1.0)));
    QVERIFY(!isClosed({}));
    TriMesh pierced = cube();
    pierced.triangles.pop_back();
    QVERIFY(!isClosed(pierced));
  }
};

QTEST_APPLESS_MAIN(TestOutward)
#include "tst_outward.moc"
