// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <memory>

#include "core/base/parallel.h"
#include "core/phantom/phantom.h"
#include "core/quality/mesh_quality.h"
#include "core/smooth/sagitta_offset.h"
#include "core/smooth/smoothing.h"
#include "core/surface/zero_set_mesh.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_bars.h"
#include "tests/core/mesh_shapes.h"
#include "tests/core/threads.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

struct Scene {
  std::unique_ptr<SplineField> field;
  TriMesh mesh;

  Scene(const Volume<float>& phi, double rho, SurfaceBorder border = SurfaceBorder::Cap) {
    field = std::make_unique<SplineField>(phi, SplineKind::InterpolatingBspline);
    mesh =
        meshZeroSet(*field, SizingParams::printed(rho), SurfaceMethod::AdvancingFront, border).mesh;
  }
  [[nodiscard]] TriMesh kept() const { return keepWallSmooth(mesh, {}, field.get()); }
};

// An oblique grid through which a tube of `radius` voxels leaves along the third axis.
struct TubeGrid {
  Geometry g;
  Vector3d middle, axis;
  double radius, length;

  explicit TubeGrid(double radiusVoxels)
      : g(shapes::obliqueGeometry({static_cast<int>(2.0 * radiusVoxels) + 9,
                                   static_cast<int>(2.0 * radiusVoxels) + 9, 24})) {
    g.spacing.setConstant(0.5);
    middle = analytic::centreOf(g) + g.direction * Vector3d(0.07, -0.11, 0.0);
    axis = g.direction.col(2);
    radius = 0.5 * radiusVoxels;
    length = 0.5 * (g.size[2] - 1);
  }
  // A quadratic, which the spline takes over exactly; a distance has its kink within reach.
  [[nodiscard]] Volume<float> phi() const {
    return shapes::sampled(g, [&](const Vector3d& p) {
      const double d = analytic::tube(p, middle, axis, 0.0);
      return 0.5 * (d * d / radius - radius);
    });
  }
};

}  // namespace

class TestSagittaOffset : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aBallGetsItsVolumeBack() {
    Geometry g = shapes::obliqueGeometry({40, 34, 26}, true);
    const Vector3d centre = analytic::centreOf(g);
    const Scene scene(
        shapes::sampled(g, [&](const Vector3d& p) { return analytic::ball(p, centre, 6.0); }), 0.4);
    QVERIFY(inscribedInZeroSet(scene.mesh, *scene.field));
    const TriMesh kept = scene.kept();
    QVERIFY(kept.triangles == scene.mesh.triangles);
    const double truth = 4.0 / 3.0 * shapes::pi * 216.0;
    QVERIFY(enclosedVolumeMm3(scene.mesh) < 0.99 * truth);
    QVERIFY(isNear(enclosedVolumeMm3(kept) / truth, 1.0, 5e-4));
    verifySoundShape(measureQuality(kept));
  }

  void tubesKeepTheirRadius_data() {
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("rho");
    QTest::addColumn<bool>("open");
    for (const double rho : {0.2, 0.4})
      for (const double radius : {1.0, 2.0, 4.0, 8.0}) {
        QTest::addRow("%g voxels, rho %g", radius, rho) << radius << rho << false;
        QTest::addRow("%g voxels, rho %g, open", radius, rho) << radius << rho << true;
      }
  }

  void tubesKeepTheirRadius() {
    QFETCH(double, radius);
    QFETCH(double, rho);
    QFETCH(bool, open);
    const TubeGrid tube(radius);
    const Scene scene(tube.phi(), rho, open ? SurfaceBorder::Open : SurfaceBorder::Cap);
    QVERIFY(inscribedInZeroSet(scene.mesh, *scene.field));
    const TriMesh kept = scene.kept();
    verifySoundShape(measureQuality(kept));
    // The wall's area and, where there are caps, the volume.
    double area = 0.0, distance = 0.0, weight = 0.0;
    for (const auto& t : kept.triangles) {
      const Vector3d &a = kept.points[t[0]], &b = kept.points[t[1]], &c = kept.points[t[2]];
      const Vector3d n = (b - a).cross(c - a);
      if (std::abs(n.dot(tube.axis)) > 0.9 * n.norm()) continue;
      area += 0.5 * n.norm();
      // The mean distance from the axis, by the middles of the edges.
      for (const Vector3d& p :
           {Vector3d(0.5 * (a + b)), Vector3d(0.5 * (b + c)), Vector3d(0.5 * (c + a))}) {
        const Vector3d d = p - tube.middle;
        distance += n.norm() / 3.0 * (d - d.dot(tube.axis) * tube.axis).norm();
        weight += n.norm() / 3.0;
      }
    }
    const double byDistance = distance / weight / tube.radius;
    const double byArea = area / (2.0 * shapes::pi * tube.radius * tube.length);
    QVERIFY(isNear(byDistance, 1.0, 0.01));
    QVERIFY(isNear(byArea, 1.0, 0.01));
    if (!open) {
      const double truth = shapes::pi * tube.radius * tube.radius * tube.length;
      const double byVolume = std::sqrt(enclosedVolumeMm3(kept) / truth);
      QVERIFY(isNear(byVolume, 1.0, 0.01));
    }
    // Rims and caps are as flat as before.
    for (std::size_t v = 0; v < kept.points.size(); ++v) {
      const double z = tube.g.toIndex(scene.mesh.points[v])[2];
      if (z > 1e-6 && z < tube.g.size[2] - 1 - 1e-6) continue;
      QVERIFY(std::abs(tube.g.toIndex(kept.points[v])[2] - z) < 1e-9);
    }
  }

  void treesKeepTheirVolume() {
    PhantomParams params;
    params.kind = PhantomKind::CapsuleTree;
    params.size = {64, 64, 64};
    params.radius = 3.0;
    const Volume<float> phi = phantomField(params);
    const Scene coarse(phi, 0.4), fine(phi, 0.1);
    const TriMesh kept = coarse.kept();
    verifySoundShape(measureQuality(kept));
    const double truth = enclosedVolumeMm3(fine.kept());
    QVERIFY(enclosedVolumeMm3(fine.mesh) < truth);
    QVERIFY(std::abs(enclosedVolumeMm3(kept) / truth - 1.0) < 0.001);
    // Centroids of an inscribed mesh lie 0.008 of the radius of curvature inside.
    double sum = 0.0;
    for (const auto& t : kept.triangles) {
      const Vector3d c = (kept.points[t[0]] + kept.points[t[1]] + kept.points[t[2]]) / 3.0;
      Vector3d foot = c;
      QVERIFY(coarse.field->projectToZero(foot));
      const PrincipalCurvatures k = principalCurvatures(coarse.field->secondAt(foot));
      sum += (foot - c).norm() * std::max(std::abs(k.k1), std::abs(k.k2));
    }
    QVERIFY(sum / static_cast<double>(kept.triangles.size()) < 0.006);
  }

  void theNumberOfThreadsDoesNotMatter() {
    const Scene scene(TubeGrid(3.0).phi(), 0.4);
    const auto [one, four] = onOneAndSeveralThreads([&] { return scene.kept(); }, 4);
    setThreads(0);
    QVERIFY(one.points == four.points);
  }

  void leavesOtherMeshesToTheWallsSmoother() {
    const TubeGrid tube(4.0);
    const Volume<float> phi = tube.phi();
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    QVERIFY(!inscribedInZeroSet(marchingCubes(phi), field));
    QVERIFY(!inscribedInZeroSet({}, field));
    const Scene scene(phi, 0.4);
    SmoothParams none;
    none.iterations = 0;
    QVERIFY(keepWallSmooth(scene.mesh, none, scene.field.get()).points == scene.mesh.points);
    // What lies beside the wall is no longer inscribed.
    QVERIFY(!inscribedInZeroSet(scene.kept(), field));
  }
};

QTEST_APPLESS_MAIN(TestSagittaOffset)
#include "tst_sagitta_offset.moc"
