// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/smooth/wall_places.h"
#include "core/smooth/wall_smoother.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

/// z = 0, outside above.
class Ground final : public Wall {
 public:
  [[nodiscard]] Sample at(const Vector3d& point) const override {
    return {Vector3d::UnitZ(), point.z()};
  }
  [[nodiscard]] double unitMm() const override { return 1.0; }
};

/// A fan of six at z = 1, of which only the vertex in the middle may move: where it ends.
double heightInFan(double radius, const SmoothParams& params) {
  TriMesh fan{{{0, 0, 1}}, {}};
  for (std::uint32_t k = 0; k < 6; ++k) {
    const double angle = shapes::pi * k / 3.0;
    fan.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 1.0);
    fan.triangles.push_back({0, 1 + k, 1 + (k + 1) % 6});
  }
  std::vector<char> frozen(7, 1);
  frozen[0] = 0;
  const Ground wall;
  const WallPlaces places(fan, nullptr, {}, frozen);
  const WallGround ground(wall, places);
  const TriMesh smooth = WallSmoother(places, ground, wall, params, {}).run();
  for (std::size_t v = 1; v < 7; ++v)
    if (smooth.points[v] != fan.points[v]) return std::nan("");
  return smooth.points[0].z();
}

}  // namespace

class TestWallSmoother : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Between vertices that stay far off the wall, one that has to go there makes its triangles
  /// steep: it goes within the bound all the same, but not where they would all but stand upright.
  void theBoundIsWorthSteepTriangles() {
    for (const double bound : {0.05, 0.2}) {
      SmoothParams params;
      params.wallBoundVoxels = bound;
      for (const double radius : {3.0, 0.4, 0.2})
        QVERIFY(std::fabs(heightInFan(radius, params)) <= 1.01 * bound);
      QCOMPARE(heightInFan(0.05, params), 1.0);
    }
  }
};

QTEST_APPLESS_MAIN(TestWallSmoother)
#include "tst_wall_smoother.moc"
