// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/remesh/remesh_ground.h"
#include "core/remesh/remesh_shape.h"
#include "core/remesh/remesh_worker.h"
#include "tests/core/bars.h"
#include "tests/core/surface/surface_bed.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

class EvenSize final : public EdgeSize {
 public:
  [[nodiscard]] double at(const Vector3d& /*point*/) const override { return 1.0; }
};

double worstOf(const TriMesh& mesh) {
  double worst = 0.0;
  for (const auto& t : mesh.triangles)
    worst = std::max(worst,
                     remeshing::badness(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]));
  return worst;
}

}  // namespace

class TestRelocation : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// In rings of held vertices on a plane: to where all that is bad is mended, or where no place of
  /// a fine lattice is better, unless edges get too long or too short there.
  void aVertexGoesWhereItsWorstTriangleIsBest() {
    const Vector3d centre{8.2, 8.3, 8.0};
    const SplineField field = analytic::fieldOf(
        analytic::sampled(analytic::cube(17), [](const Vector3d& p) { return p.z() - 8.0; }));
    const EndPlanes ends(field.geometry());
    const EvenSize size;
    const ZeroSetGround ground(field, size, ends);
    int rings = 0, best = 0;
    for (std::uint64_t seed = 0; seed < 250; ++seed) {
      const auto n = static_cast<std::uint32_t>(5 + seed % 3);
      PatchMesh start = patchOf({{centre}, {}});
      for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 2.0 * M_PI / n * (i + 0.5 * randomUniform(seed, 2 * i));
        const double radius = 0.65 + 0.7 * randomUniform(seed, 2 * i + 1);
        start.mesh.points.push_back(centre +
                                    radius * Vector3d(std::cos(angle), std::sin(angle), 0));
        start.place.push_back(Place::onWall());
        addTriangle(start, {0, 1 + i, 1 + (i + 1) % n});
      }
      if (worstOf(start.mesh) < 1.0) continue;
      double least = 1e9;
      Vector3d there = centre;
      TriMesh moved = start.mesh;
      for (int j = -20; j <= 20; ++j)
        for (int i = -20; i <= 20; ++i) {
          moved.points[0] = centre + 0.04 * Vector3d(i, j, 0);
          const bool up =
              std::all_of(moved.triangles.begin(), moved.triangles.end(), [&](const auto& t) {
                const Vector3d& p = moved.points[0];
                return (moved.points[t[1]] - p).cross(moved.points[t[2]] - p).z() > 0.0;
              });
          if (!up || worstOf(moved) >= least) continue;
          least = worstOf(moved);
          there = moved.points[0];
        }
      const bool inReach = std::all_of(
          start.mesh.points.begin() + 1, start.mesh.points.end(),
          [&](const auto& p) { return (p - there).norm() > 0.62 && (p - there).norm() < 1.58; });
      if (!inReach) continue;
      std::vector<char> held(n + 1, 1);
      held[0] = 0;
      RemeshWorker worker(start, ground, {}, held);
      worker.repair();
      ++rings;
      best += worstOf(worker.result().mesh) < std::max(1.0, least) + 0.02 ? 1 : 0;
    }
    QVERIFY(rings > 80);
    // A search that goes downhill alone may end in a lesser valley.
    QVERIFY(isAbove(best, 0.95 * rings));
  }
};

QTEST_APPLESS_MAIN(TestRelocation)
#include "tst_relocation.moc"
