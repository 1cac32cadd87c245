// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/mesh/inside_point.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;

class TestInsidePoint : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void itLiesOnTheCircleWithinATorus() {
    const Eigen::Vector3d centre(-120.0, 43.0, 801.0);
    const InsidePoint inside = pointInside(shapes::moved(shapes::torus(90, 30, 10.0, 2.0), centre));
    const Eigen::Vector3d p = inside.pointLps - centre;
    const double fromCircle = std::hypot(p.head<2>().norm() - 10.0, p.z());
    QVERIFY(isBelow(fromCircle, 0.4));
    QVERIFY(std::fabs(inside.depthMm - (2.0 - fromCircle)) < 0.05);
  }

  void itLiesInTheLargestOfTwoBodies() {
    TriMesh mesh = shapes::icosphere(2);
    TriMesh larger = shapes::icosphere(2);
    for (auto& p : larger.points) p = Eigen::Vector3d(50, 0, 0) + 3.0 * p;
    shapes::append(mesh, larger);
    const InsidePoint inside = pointInside(mesh);
    QVERIFY((inside.pointLps - Eigen::Vector3d(50, 0, 0)).norm() < 1.0);
    QVERIFY(inside.depthMm > 2.0);
  }

  void itLiesBetweenABodyAndItsCavity() {
    TriMesh mesh = shapes::icosphere(3);
    for (auto& p : mesh.points) p *= 4.0;
    TriMesh cavity = shapes::icosphere(2);
    for (auto& t : cavity.triangles) std::swap(t[1], t[2]);
    shapes::append(mesh, cavity);
    const InsidePoint inside = pointInside(mesh);
    QVERIFY(inside.pointLps.norm() > 1.5 && inside.pointLps.norm() < 3.5);
    QVERIFY(inside.depthMm > 1.0);
  }

  void aCubeHasOne() {
    const InsidePoint inside = pointInside(shapes::cube());
    QVERIFY(inside.depthMm > 0.1);
    QVERIFY(((inside.pointLps.array() - 0.5).abs() < 0.4).all());
  }

  void whatHasNoInsideIsRefused() {
    QVERIFY_THROWS_EXCEPTION(InputError, pointInside({}));
    QVERIFY_THROWS_EXCEPTION(NumericError,
                             pointInside({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}));
    TriMesh inward = shapes::icosphere(2);
    for (auto& t : inward.triangles) std::swap(t[1], t[2]);
    QVERIFY_THROWS_EXCEPTION(NumericError, pointInside(inward));
  }
};

QTEST_APPLESS_MAIN(TestInsidePoint)
#include "tst_inside_point.moc"
