// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/random.h"
#include "core/mesh/triangle_tree.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

using Corners = std::array<Vector3d, 3>;

Vector3d randomPoint(std::uint64_t seed, std::uint64_t number) {
  return {randomUniform(seed, 3 * number) - 0.5, randomUniform(seed, 3 * number + 1) - 0.5,
          randomUniform(seed, 3 * number + 2) - 0.5};
}

Vector3d pointAt(const Corners& corners, const Vector3d& weights) {
  return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
}

/// A point of a convex set is the closest to another one where and only where no corner of the set
/// lies farther in the direction of that one.
bool isClosest(const Corners& corners, const Vector3d& on, const Vector3d& point) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](const Vector3d& corner) { return (point - on).dot(corner - on) < 1e-12; });
}

}  // namespace

class TestTriangleTree : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theClosestPointMayBeACornerOnAnEdgeOrInside() {
    std::array<int, 8> found{};  // by which weights are above 0
    for (std::uint64_t n = 0; n < 200; ++n) {
      const Corners corners{randomPoint(3, 3 * n), randomPoint(3, 3 * n + 1),
                            randomPoint(3, 3 * n + 2)};
      for (std::uint64_t k = 0; k < 20; ++k) {
        const Vector3d point = 2.0 * randomPoint(4, 20 * n + k);
        const Vector3d weights = closestWeights(corners, point);
        QVERIFY(weights.minCoeff() >= 0.0 && std::fabs(weights.sum() - 1.0) < 1e-12);
        QVERIFY(isClosest(corners, pointAt(corners, weights), point));
        ++found[(weights[0] > 0.0 ? 1U : 0U) + (weights[1] > 0.0 ? 2U : 0U) +
                (weights[2] > 0.0 ? 4U : 0U)];
      }
    }
    QVERIFY(std::all_of(found.begin() + 1, found.end(), [](int count) { return count > 50; }));
  }

  void closestIsTheClosestOfAllTriangles() {
    TriMesh mesh = shapes::icosphere(2);
    shapes::append(mesh, shapes::moved(shapes::torus(20, 12, 0.9, 0.3), {0.4, -0.2, 0.5}));
    const TriangleTree tree(mesh);
    for (std::uint64_t n = 0; n < 100; ++n) {
      const Vector3d point = 4.0 * randomPoint(5, n);
      const TriangleTree::Closest closest = tree.closest(point);
      const Corners corners = cornersOf(mesh, closest.triangle);
      QVERIFY((pointAt(corners, closest.weights) - closest.point).norm() < 1e-12);
      QVERIFY(std::fabs((closest.point - point).norm() - closest.distance) < 1e-12);
      QVERIFY(isClosest(corners, closest.point, point));
      for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Corners other = cornersOf(mesh, t);
        const Vector3d on = pointAt(other, closestWeights(other, point));
        QVERIFY((on - point).norm() > closest.distance - 1e-12);
      }
    }
  }
};

QTEST_APPLESS_MAIN(TestTriangleTree)
#include "tst_triangle_tree.moc"
