// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/mesh/coarse_mesh.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;

class TestCoarseMesh : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aSphereStaysASphere() {
    const TriMesh sphere = shapes::icosphere(6);
    const CoarseMesh coarse = coarseMesh(sphere, 4000);
    const std::size_t count = coarse.mesh.triangles.size();
    QVERIFY2(count > 2400 && count < 5600, qPrintable(QString::number(count)));
    for (const Eigen::Vector3d& point : coarse.mesh.points)
      QVERIFY(std::abs(point.norm() - 1.0) < 0.02);
    QVERIFY(std::abs(surfaceAreaMm2(coarse.mesh) / surfaceAreaMm2(sphere) - 1.0) < 0.05);
    QVERIFY(std::abs(enclosedVolumeMm3(coarse.mesh) / enclosedVolumeMm3(sphere) - 1.0) < 0.05);
    checkMesh(coarse.mesh);
  }

  /// It is much thinner than a cell.
  void aThinVesselDoesNotVanish() {
    const TriMesh ring = shapes::torus(2000, 24, 30.0, 0.1);
    const CoarseMesh coarse = coarseMesh(ring, 400);
    QVERIFY2(coarse.mesh.triangles.size() < 600,
             qPrintable(QString::number(coarse.mesh.triangles.size())));
    double length = 0.0;
    for (const auto& t : coarse.mesh.triangles)
      length = std::max(length, (coarse.mesh.points[t[0]] - coarse.mesh.points[t[1]]).norm());
    QVERIFY(length < 8.0);
    // In each direction from the centre there is some of it.
    std::array<bool, 20> seen{};
    for (const auto& t : coarse.mesh.triangles)
      for (const std::uint32_t vertex : t) {
        const Eigen::Vector3d& p = coarse.mesh.points[vertex];
        seen[static_cast<std::size_t>((std::atan2(p.y(), p.x()) / (2.0 * M_PI) + 0.5) * 19.999)] =
            true;
      }
    QCOMPARE(std::count(seen.begin(), seen.end(), true), 20);
  }

  void trianglesKnowWhatTheyStandFor() {
    TriMesh sphere = shapes::icosphere(5);
    for (const auto& t : sphere.triangles)
      sphere.patch.push_back(sphere.points[t[0]].z() > 0.0 ? 2 : 0);
    const CoarseMesh coarse = coarseMesh(sphere, 2000);
    QCOMPARE(coarse.from.size(), coarse.mesh.triangles.size());
    for (std::size_t i = 0; i < coarse.from.size(); ++i) {
      const auto& whole = sphere.triangles[coarse.from[i]];
      const auto& part = coarse.mesh.triangles[i];
      QVERIFY((sphere.points[whole[0]] - coarse.mesh.points[part[0]]).norm() < 0.3);
      QCOMPARE(coarse.mesh.patch[i], sphere.patch[coarse.from[i]]);
    }
  }

  void nothingMakesNothing() {
    QVERIFY(coarseMesh(TriMesh(), 100).mesh.triangles.empty());
    QVERIFY(coarseMesh(shapes::cube(), 0).mesh.triangles.empty());
  }
};

QTEST_GUILESS_MAIN(TestCoarseMesh)
#include "tst_coarse_mesh.moc"
