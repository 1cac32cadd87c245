// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>

#include "core/base/error.h"
#include "core/mesh/mesh_edges.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;

class TestTriMesh : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void closedForms() {
    QVERIFY(std::abs(surfaceAreaMm2(shapes::cube()) - 6.0) < 1e-14);
    QVERIFY(std::abs(enclosedVolumeMm3(shapes::cube()) - 1.0) < 1e-14);
    QVERIFY(std::abs(enclosedVolumeMm3(shapes::tetrahedron()) - 1.0 / 6.0) < 1e-15);
    QVERIFY(std::abs(surfaceAreaMm2(shapes::tetrahedron()) - (1.5 + std::sqrt(0.75))) < 1e-14);
    // The icosahedron of circumradius 1: edge a with a^2 = 4 / (phi sqrt 5).
    const double a = 4.0 / std::sqrt(10.0 + 2.0 * std::sqrt(5.0));
    QVERIFY(std::abs(surfaceAreaMm2(shapes::icosahedron()) - 5.0 * std::sqrt(3.0) * a * a) < 1e-12);
    QVERIFY(std::abs(enclosedVolumeMm3(shapes::icosahedron()) -
                     5.0 / 12.0 * (3.0 + std::sqrt(5.0)) * a * a * a) < 1e-12);
  }

  void torusConvergesToPappus() {
    const TriMesh mesh = shapes::torus(400, 200, 3.0, 1.0);
    QVERIFY(std::abs(enclosedVolumeMm3(mesh) / (2.0 * shapes::pi * shapes::pi * 3.0) - 1.0) < 5e-4);
    QVERIFY(std::abs(surfaceAreaMm2(mesh) / (4.0 * shapes::pi * shapes::pi * 3.0) - 1.0) < 5e-4);
  }

  void volumeDoesNotDependOnThePlace() {
    const TriMesh far = shapes::moved(shapes::cube(), {1000.0, -2000.0, 500.0});
    QVERIFY(std::abs(enclosedVolumeMm3(far) - 1.0) < 1e-12);
    TriMesh inverted = far;
    for (auto& t : inverted.triangles) std::swap(t[0], t[1]);
    QVERIFY(std::abs(enclosedVolumeMm3(inverted) + 1.0) < 1e-12);
    QCOMPARE(enclosedVolumeMm3(TriMesh()), 0.0);
  }

  void smallComponentsGo() {
    TriMesh mesh = shapes::cube();
    shapes::append(mesh, shapes::moved(shapes::tetrahedron(), {5.0, 0.0, 0.0}));
    shapes::append(mesh, shapes::moved(shapes::icosahedron(), {-5.0, 0.0, 0.0}));
    mesh.points.emplace_back(9.0, 9.0, 9.0);
    QCOMPARE(meshComponents(mesh).count, std::size_t{3});
    QCOMPARE(dropSmallComponents(mesh, 0.5), 1);
    QCOMPARE(mesh.points.size(), std::size_t{20});
    QCOMPARE(mesh.triangles.size(), std::size_t{32});
    QVERIFY(std::abs(enclosedVolumeMm3(mesh) - 1.0 - enclosedVolumeMm3(shapes::icosahedron())) <
            1e-12);
    QCOMPARE(dropSmallComponents(mesh, 100.0), 2);
    QVERIFY(mesh.points.empty() && mesh.triangles.empty());
  }

  void patchesStayWithTheirTriangles() {
    TriMesh mesh = shapes::tetrahedron();
    shapes::append(mesh, shapes::moved(shapes::cube(), {5.0, 0.0, 0.0}));
    mesh.patch.assign(mesh.triangles.size(), 0);
    mesh.patch[5] = 3;
    checkMesh(mesh);
    QCOMPARE(dropSmallComponents(mesh, 0.5), 1);
    checkMesh(mesh);
    QCOMPARE(mesh.patch, (std::vector<std::uint16_t>{0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    mesh.patch.pop_back();
    QVERIFY_THROWS_EXCEPTION(InputError, checkMesh(mesh));
  }

  void componentsTouchingInAPointAreTwo() {
    const TriMesh mesh = shapes::touchingTetrahedra();
    QCOMPARE(meshComponents(mesh).count, std::size_t{2});
    QVERIFY(std::abs(enclosedVolumeMm3(mesh) - 1.0 / 3.0) < 1e-15);
  }
};

QTEST_APPLESS_MAIN(TestTriMesh)
#include "tst_tri_mesh.moc"
