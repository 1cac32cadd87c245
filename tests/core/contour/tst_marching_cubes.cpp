// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <QTest>
#include <set>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/contour/marching_cubes.h"
#include "core/mesh/mesh_edges.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_shapes.h"
#include "tests/core/threads.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using analytic::ball;

namespace {

struct Manifoldness {
  std::size_t open = 0;   ///< edges of one triangle
  std::size_t wrong = 0;  ///< edges of more than two triangles, or of two that disagree
  long euler = 0;
  bool distinct = true;
};

Manifoldness manifoldness(const TriMesh& mesh) {
  Manifoldness m;
  std::size_t edges = 0;
  const auto sides = sortedEdgeSides(mesh);
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i), ++edges) {
    const std::size_t n = edgeRunEnd(sides, i) - i;
    if (n == 1) ++m.open;
    if (n > 2 || (n == 2 && sides[i].forward == sides[i + 1].forward)) ++m.wrong;
  }
  m.euler = static_cast<long>(mesh.points.size()) - static_cast<long>(edges) +
            static_cast<long>(mesh.triangles.size());
  std::set<std::array<double, 3>> places;
  for (const auto& p : mesh.points) places.insert({p.x(), p.y(), p.z()});
  m.distinct = places.size() == mesh.points.size();
  return m;
}

}  // namespace

class TestMarchingCubes : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void ballConverges() {
    // Inscribed facets: the error falls with the square of the voxel.
    double previous = 1.0;
    for (const int n : {12, 24, 48}) {
      Geometry g;
      g.size = {n, n, n};
      g.spacing = Eigen::Vector3d::Constant(12.0 / n);
      const TriMesh mesh = marchingCubes(shapes::sampled(g, [](const Eigen::Vector3d& p) {
        return ball(p, {5.61, 5.43, 5.72}, 4.0);
      }));
      const Manifoldness m = manifoldness(mesh);
      QCOMPARE(m.open + m.wrong, std::size_t{0});
      QCOMPARE(m.euler, 2L);
      const double volume = enclosedVolumeMm3(mesh) / (4.0 / 3.0 * shapes::pi * 64.0) - 1.0;
      const double area = surfaceAreaMm2(mesh) / (4.0 * shapes::pi * 16.0) - 1.0;
      QVERIFY(isNear(volume, 0.0, previous / 3.0));
      QVERIFY(std::abs(area) < 0.05 * (12.0 / n));
      previous = std::abs(volume);
    }
    QVERIFY(isBelow(previous, 4e-3));
  }

  void everyDirectionGivesTheSameSurface_data() {
    QTest::addColumn<bool>("mirrored");
    QTest::newRow("rotated") << false;
    QTest::newRow("mirrored") << true;
  }

  void everyDirectionGivesTheSameSurface() {
    QFETCH(bool, mirrored);
    const Geometry g = shapes::obliqueGeometry({24, 22, 18}, mirrored);
    const Eigen::Vector3d centre = g.toPhysical({11.3, 10.6, 8.4});
    const TriMesh mesh = marchingCubes(
        shapes::sampled(g, [&](const Eigen::Vector3d& p) { return ball(p, centre, 3.1); }));
    QVERIFY(enclosedVolumeMm3(mesh) > 0.97 * 4.0 / 3.0 * shapes::pi * std::pow(3.1, 3));
    for (const auto& t : mesh.triangles) {
      const Eigen::Vector3d& a = mesh.points[t[0]];
      const Eigen::Vector3d normal = (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a);
      QVERIFY(normal.dot(a - centre) > 0.0);
    }
    for (const auto& p : mesh.points) {
      QVERIFY(std::abs((p - centre).norm() - 3.1) < 0.02);
    }
    // The same voxels in index space.
    Volume<float> plain(
        shapes::sampled(g, [&](const Eigen::Vector3d& p) { return ball(p, centre, 3.1); }));
    plain.geometry.origin.setZero();
    plain.geometry.direction.setIdentity();
    const TriMesh straight = marchingCubes(plain);
    QCOMPARE(straight.points.size(), mesh.points.size());
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const Eigen::Vector3d expected = g.toPhysical(straight.points[v].cwiseQuotient(g.spacing));
      QVERIFY((expected - mesh.points[v]).norm() < 1e-12);
    }
  }

  void axesMayBeExchanged() {
    // The same field with x and y exchanged: the same surface up to the choice of diagonals.
    Geometry g;
    g.size = {20, 17, 14};
    Geometry swapped = g;
    swapped.size = {17, 20, 14};
    const auto field = [](double x, double y, double z) {
      return ball({x, y, z}, {9.2, 8.1, 6.4}, 5.03) + 0.2 * std::sin(x) * std::cos(2.0 * y);
    };
    const TriMesh one = marchingCubes(
        shapes::sampled(g, [&](const Eigen::Vector3d& p) { return field(p.x(), p.y(), p.z()); }));
    const TriMesh other = marchingCubes(shapes::sampled(
        swapped, [&](const Eigen::Vector3d& p) { return field(p.y(), p.x(), p.z()); }));
    QCOMPARE(one.points.size(), other.points.size());
    QCOMPARE(one.triangles.size(), other.triangles.size());
    std::set<std::array<double, 3>> places;
    for (const auto& p : one.points) places.insert({p.x(), p.y(), p.z()});
    for (const auto& p : other.points) {
      QVERIFY(places.count({p.y(), p.x(), p.z()}) == 1);
    }
    QVERIFY(std::abs(enclosedVolumeMm3(one) / enclosedVolumeMm3(other) - 1.0) < 2e-3);
  }

  void noiseIsClosedAndManifold_data() {
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 6; ++seed) QTest::addRow("%d", seed) << seed;
  }

  void noiseIsClosedAndManifold() {
    QFETCH(int, seed);
    Volume<float> phi = shapes::noise({21, 18, 16}, static_cast<std::uint64_t>(seed));
    if (seed > 4) {
      // Integer values: many exact zeros.
      for (float& v : phi.voxels) v = std::round(v);
    }
    const TriMesh mesh = marchingCubes(phi);
    const Manifoldness m = manifoldness(mesh);
    QVERIFY(mesh.triangles.size() > 5000);
    QCOMPARE(m.open, std::size_t{0});
    QCOMPARE(m.wrong, std::size_t{0});
    QVERIFY(m.distinct);
    QVERIFY(enclosedVolumeMm3(mesh) > 0.0);
  }

  void extremeValuesKeepVerticesApart() {
    Volume<float> phi = shapes::noise({12, 12, 12}, 9);
    for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
      if (i % 3 == 0) phi.voxels[i] *= 1e30F;
      if (i % 5 == 0) phi.voxels[i] *= 1e-30F;
    }
    const Manifoldness m = manifoldness(marchingCubes(phi));
    QCOMPARE(m.open + m.wrong, std::size_t{0});
    QVERIFY(m.distinct);
  }

  void capsAreFlatAndHalfAVoxelOutside() {
    const Geometry g = shapes::obliqueGeometry({20, 18, 12});
    const auto tube = shapes::sampled(g, [&](const Eigen::Vector3d& p) {
      const Eigen::Vector3d q = g.toIndex(p).cwiseProduct(g.spacing);
      return std::hypot(q.x() - 3.9, q.y() - 4.2) - 2.0;
    });
    const TriMesh closed = marchingCubes(tube, SurfaceBorder::Cap);
    double lowest = 0.0, highest = 0.0;
    for (const auto& p : closed.points) {
      const double k = g.toIndex(p).z();
      lowest = std::min(lowest, k);
      highest = std::max(highest, k);
      QVERIFY((k > -1e-9 && k < 11.0 + 1e-9) || std::abs(k + 0.5) < 1e-9 ||
              std::abs(k - 11.5) < 1e-9);
    }
    QVERIFY(std::abs(lowest + 0.5) < 1e-9 && std::abs(highest - 11.5) < 1e-9);
    QCOMPARE(manifoldness(closed).open, std::size_t{0});
    QCOMPARE(manifoldness(closed).euler, 2L);

    const TriMesh open = marchingCubes(tube, SurfaceBorder::Open);
    const Manifoldness m = manifoldness(open);
    QCOMPARE(m.wrong, std::size_t{0});
    QVERIFY(m.open > 0);
    QCOMPARE(m.euler, 0L);
    for (const auto& side : sortedEdgeSides(open)) {
      QVERIFY(g.toIndex(open.points[side.low]).z() > -1e-9);
    }
  }

  void zeroIsOutside() {
    Geometry g;
    g.size = {5, 5, 5};
    QVERIFY(marchingCubes(Volume<float>(g, 0.0F)).triangles.empty());
    Volume<float> one(g, 1.0F);
    one.at(2, 2, 2) = -1e-12F;
    const TriMesh drop = marchingCubes(one);
    QCOMPARE(manifoldness(drop).euler, 2L);
    for (const auto& p : drop.points) {
      QVERIFY(std::abs((p - Eigen::Vector3d(2, 2, 2)).norm() - 1e-3 / 1.001) < 1e-9);
    }
    QVERIFY(marchingCubes(Volume<float>()).points.empty());
  }

  void fullVolumeBecomesABox() {
    Geometry g;
    g.size = {4, 5, 6};
    const TriMesh box = marchingCubes(Volume<float>(g, -2.0F));
    QCOMPARE(manifoldness(box).euler, 2L);
    // Edges and corners are bevelled by half a voxel.
    QVERIFY(enclosedVolumeMm3(box) > 100.0 && enclosedVolumeMm3(box) < 120.0);
    QVERIFY(marchingCubes(Volume<float>(g, -2.0F), SurfaceBorder::Open).triangles.empty());
  }

  void threadsDoNotMatter() {
    const Volume<float> phi = shapes::noise({16, 16, 16}, 77);
    const auto [one, four] = onOneAndSeveralThreads([&] { return marchingCubes(phi); }, 4);
    setThreads(0);
    QVERIFY(one.points == four.points);
    QVERIFY(one.triangles == four.triangles);
  }

  void cancels() {
    const Progress progress;
    progress.cancel();
    QVERIFY_THROWS_EXCEPTION(angiomesh::Cancelled, marchingCubes(shapes::noise({8, 8, 8}, 1),
                                                                 SurfaceBorder::Cap, progress));
  }

  void axesAreAlike() {
    const Volume<float> phi = analytic::unlikeVessels(true);
    const TriMesh one = marchingCubes(phi), other = marchingCubes(analytic::turned(phi));
    QCOMPARE(other.points.size(), one.points.size());
    const auto sorted = [](std::vector<Eigen::Vector3d> points) {
      std::sort(points.begin(), points.end(),
                [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
                });
      return points;
    };
    const auto a = sorted({one.points.begin(), one.points.end()}),
               b = sorted({other.points.begin(), other.points.end()});
    for (std::size_t i = 0; i < a.size(); ++i) QVERIFY((a[i] - b[i]).norm() < 1e-4);
  }
};

QTEST_APPLESS_MAIN(TestMarchingCubes)
#include "tst_marching_cubes.moc"
