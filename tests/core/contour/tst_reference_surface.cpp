// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/contour/reference_surface.h"
#include "core/mesh/outward.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

/// Vessels that leave the volume at both ends of an axis, across an edge, and around a corner.
Volume<float> leavingVessels(const Geometry& g, int axis) {
  const Vector3d middle = analytic::centreOf(g), last = g.toPhysical({14.0, 13.0, 12.0});
  return shapes::sampled(g, [&](const Vector3d& p) {
    return std::min({analytic::tube(p, middle, g.direction.col(axis), 1.1),
                     analytic::ball(p, last, 1.6), analytic::ball(p, g.origin, 1.3)});
  });
}

}  // namespace

class TestReferenceSurface : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void wallAndCapsAreOneClosedMesh_data() {
    QTest::addColumn<int>("axis");
    QTest::addColumn<bool>("mirrored");
    for (int axis = 0; axis < 3; ++axis)
      for (const bool mirrored : {false, true})
        QTest::addRow("%d%s", axis, mirrored ? " mirrored" : "") << axis << mirrored;
  }
  void wallAndCapsAreOneClosedMesh() {
    QFETCH(int, axis);
    QFETCH(bool, mirrored);
    const Geometry g = shapes::obliqueGeometry({15, 14, 13}, mirrored);
    const Volume<float> phi = leavingVessels(g, axis);
    const EndPlanes ends(g);
    const PatchMesh capped = referenceSurface(phi, ends, SurfaceBorder::Cap);
    QVERIFY(isClosed(capped.mesh));
    QVERIFY(enclosedVolumeMm3(capped.mesh) > 0.0);
    // Nothing lies about that no triangle uses.
    std::vector<int> uses(capped.mesh.points.size(), 0);
    for (const auto& t : capped.mesh.triangles)
      for (const std::uint32_t v : t) ++uses[v];
    QCOMPARE(std::count(uses.begin(), uses.end(), 0), std::ptrdiff_t{0});
    QCOMPARE(capped.place.size(), capped.mesh.points.size());
    QCOMPARE(capped.patch.size(), capped.mesh.triangles.size());
    QCOMPARE(capped.origin.size(), capped.mesh.triangles.size());
    // What belongs to a cap lies in its plane, and what belongs to the wall is said to.
    std::vector<char> onWall(capped.mesh.points.size(), 0);
    std::size_t planes = 0;
    for (std::size_t t = 0; t < capped.patch.size(); ++t) {
      for (const std::uint32_t v : capped.mesh.triangles[t]) {
        if (capped.patch[t] == 0)
          onWall[v] = 1;
        else
          QVERIFY(capped.place[v].liesIn(capped.patch[t] - 1));
      }
      planes |= std::size_t{1} << capped.patch[t];
    }
    QCOMPARE(planes, std::size_t{127});
    for (std::size_t v = 0; v < onWall.size(); ++v) {
      QVERIFY(g.holds(capped.mesh.points[v], -1e-9) ||
              ends.borders(capped.mesh.points[v]).planes() > 0);
      QCOMPARE(capped.place[v].wall, onWall[v] != 0);
      QCOMPARE(capped.place[v].borders, ends.borders(capped.mesh.points[v]).borders);
    }
    // Without caps the same wall is left, open.
    const PatchMesh open = referenceSurface(phi, ends, SurfaceBorder::Open);
    QVERIFY(std::all_of(open.patch.begin(), open.patch.end(), [](auto p) { return p == 0; }));
    QVERIFY(!isClosed(open.mesh));
    QCOMPARE(open.mesh.triangles.size(), wallOf(capped).triangles.size());
    QCOMPARE(wallOf(capped).points.size(), capped.mesh.points.size());
  }

  /// The outermost planes of a part of the grid are no ends but where they are the grid's too.
  void aPartOfTheGridHasNoCapsInside() {
    const Geometry g = shapes::obliqueGeometry({15, 14, 13});
    const SplineField field = analytic::fieldOf(leavingVessels(g, 2));
    const EndPlanes ends(g);
    for (const int finer : {1, 2, 3}) {
      const GridPart part{{2, 3, 0}, {12, 11, 7}, finer};
      const Volume<float> values = sampleField(field, part);
      for (std::size_t a = 0; a < 3; ++a)
        QCOMPARE(values.geometry.size[a], (part.last[a] - part.first[a]) * finer + 1);
      QVERIFY(
          (values.geometry.toPhysical(Vector3d::Zero()) - g.toPhysical({2.0, 3.0, 0.0})).norm() <
          1e-12);
      for (std::size_t i = 0; i < values.voxels.size(); i += 7)
        QVERIFY(std::fabs(static_cast<double>(values.voxels[i]) -
                          field.valueAt(voxelCentre(values.geometry, i))) < 1e-5);
      const PatchMesh mesh = referenceSurface(values, ends, SurfaceBorder::Cap);
      for (std::size_t t = 0; t < mesh.patch.size(); ++t)
        QVERIFY(mesh.patch[t] == 0 || mesh.patch[t] == 5);
      QVERIFY(std::count(mesh.patch.begin(), mesh.patch.end(), 5) > 0);
      QVERIFY(!isClosed(mesh.mesh));
    }
    const GridPart whole = wholeGrid(g);
    QVERIFY(whole.finer == 1 && sampleField(field, whole).geometry == g);
  }

  void nothingHasNoSurface() {
    const Geometry g = analytic::cube(5);
    for (const SurfaceBorder border : {SurfaceBorder::Cap, SurfaceBorder::Open}) {
      const PatchMesh mesh = referenceSurface(Volume<float>(g, 1.0F), EndPlanes(g), border);
      QVERIFY(mesh.mesh.points.empty() && mesh.mesh.triangles.empty() && mesh.place.empty());
    }
  }
};

QTEST_APPLESS_MAIN(TestReferenceSurface)
#include "tst_reference_surface.moc"
