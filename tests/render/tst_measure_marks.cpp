// SPDX-License-Identifier: BSD-3-Clause
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <QTest>

#include <Eigen/Geometry>
#include <cmath>

#include "render/slice/slice_measures.h"
#include "render/slice/slice_scene.h"
#include "render/surface/surface_scene.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

/// Slices along z, 2 mm apart.
Geometry grid() {
  Geometry g;
  g.size = {40, 32, 20};
  g.spacing = {0.5, 0.5, 2.0};
  g.origin = {-7.0, 3.0, 11.0};
  return g;
}

SlicePlane axial(int slice) { return {grid(), paneAxes(grid(), 2), slice}; }

Vector3d at(double i, double j, double k) { return grid().toPhysical({i, j, k}); }

/// A circle of 2 mm about the middle of slice 10, across a direction.
MeasureMark circle(const Vector3d& axis) {
  MeasureMark mark;
  mark.outlines.emplace_back();
  const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  for (int n = 0; n < 60; ++n) {
    const double angle = 2.0 * M_PI * (n + 0.5) / 60.0;
    mark.outlines[0].push_back(at(20, 16, 10) + 2.0 * (std::cos(angle) * u + std::sin(angle) * v));
  }
  mark.label = "Section 1";
  return mark;
}

double lengthOf(const DrawnMeasure& drawn) {
  double length = 0.0;
  for (const auto& line : drawn.lines) length += (line[1] - line[0]).norm();
  return length;
}

/// Bright in green and blue and dark in red.
int cyanOf(vtkRenderWindow* window) {
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, 299, 239, 0, pixels);
  int count = 0;
  for (vtkIdType i = 0; i < 300 * 240; ++i) {
    const unsigned char* p = pixels->GetPointer(4 * i);
    if (p[1] > 100 && p[2] > 100 && p[0] < 0.6 * p[1]) ++count;
  }
  return count;
}

MeasureMark lineOf(const Vector3d& from, const Vector3d& to) {
  MeasureMark mark;
  mark.lines = {{from, to}};
  mark.points = {from, to};
  return mark;
}

}  // namespace

class TestMeasureMarks : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void linesAreSeenAsFarAsTheyLieInTheSlice() {
    const MeasureMark flat = lineOf(at(10, 10, 10), at(30, 20, 10));
    QVERIFY(std::abs(lengthOf(drawnInSlice(flat, axial(10), 0.75)) - std::hypot(10.0, 5.0)) < 1e-9);
    QCOMPARE(drawnInSlice(flat, axial(10), 0.75).points.size(), std::size_t(2));
    for (const int other : {9, 11, 15}) {
      const DrawnMeasure none = drawnInSlice(flat, axial(other), 0.75);
      QVERIFY(none.lines.empty() && none.points.empty() && none.label.empty());
    }
    // In a slab.
    QCOMPARE(drawnInSlice(flat, axial(12), 2.5).lines.size(), std::size_t(1));
    // Across slices 8 to 12: of four slices' way one and a half.
    const MeasureMark steep = lineOf(at(10, 10, 8), at(30, 10, 12));
    const DrawnMeasure part = drawnInSlice(steep, axial(10), 0.75);
    QVERIFY(std::abs(lengthOf(part) - 10.0 * 1.5 / 4.0) < 1e-9);
    QVERIFY(part.points.empty());
    const DrawnMeasure end = drawnInSlice(steep, axial(8), 0.75);
    QVERIFY(std::abs(lengthOf(end) - 10.0 * 0.75 / 4.0) < 1e-9);
    QCOMPARE(end.points.size(), std::size_t(1));
  }

  void sectionsAreOutlinesOrChords() {
    const DrawnMeasure flat = drawnInSlice(circle(Vector3d::UnitZ()), axial(10), 0.75);
    QCOMPARE(flat.lines.size(), std::size_t(60));
    QVERIFY(std::abs(lengthOf(flat) - 4.0 * M_PI) < 0.03);
    QCOMPARE(flat.label, std::string("Section 1"));
    MeasureMark measured = circle(Vector3d::UnitZ());
    measured.diameters = {{at(16, 16, 10), at(24, 16, 10)}, {at(20, 16, 9), at(20, 16, 11)}};
    QCOMPARE(drawnInSlice(measured, axial(10), 0.75).lines.size(), std::size_t(61));
    // Upright it is cut along its diameter, and half a radius higher along a shorter chord.
    const MeasureMark upright = circle(Vector3d::UnitX());
    const DrawnMeasure across = drawnInSlice(upright, axial(10), 0.25);
    QCOMPARE(across.lines.size(), std::size_t(1));
    QVERIFY(std::abs(lengthOf(across) - 4.0) < 0.02);
    MeasureMark higher = upright;
    for (Vector3d& p : higher.outlines[0]) p.z() += 1.0;
    QVERIFY(std::abs(lengthOf(drawnInSlice(higher, axial(10), 0.25)) - 2.0 * std::sqrt(3.0)) <
            0.02);
    for (Vector3d& p : higher.outlines[0]) p.z() += 2.0;
    QVERIFY(drawnInSlice(higher, axial(10), 0.25).lines.empty());
  }

  void theyFollowTheSlice() {
    auto image = std::make_shared<Volume<float>>(grid());
    image->voxels[3] = 1.0F;
    SliceScene scene;
    SliceMeasures measures(scene);
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetSize(300, 240);
    window->AddRenderer(scene.renderer());
    scene.setImage(image);
    scene.setPlane(2);
    scene.setSlice(10);
    scene.setCrosshairVisible(false);
    QCOMPARE(cyanOf(window), 0);
    measures.set({lineOf(at(5, 10, 10), at(35, 20, 10))});
    QVERIFY(cyanOf(window) > 100);
    scene.setSlice(13);
    QCOMPARE(cyanOf(window), 0);
    scene.setSlab({SlabMode::Mip, 16.0});
    QVERIFY(cyanOf(window) > 100);
    scene.setSlab({});
    scene.setSlice(10);
    QVERIFY(cyanOf(window) > 100);
    measures.set({});
    QCOMPARE(cyanOf(window), 0);
  }

  /// Also what lies inside a surface is seen.
  void theyAreSeenThroughSurfaces() {
    auto mesh = std::make_shared<TriMesh>();
    for (int k = 0; k < 8; ++k)
      mesh->points.emplace_back(5.0 * ((k & 1) * 2 - 1), 5.0 * ((k >> 1 & 1) * 2 - 1),
                                5.0 * ((k >> 2 & 1) * 2 - 1));
    mesh->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                       {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    SurfaceScene scene;
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetSize(300, 240);
    scene.attach(window);
    scene.setSurface(mesh);
    const int before = cyanOf(window);
    scene.setMeasures({lineOf({-4.0, 0.0, -4.0}, {4.0, 0.0, 4.0})});
    QVERIFY(cyanOf(window) > before + 100);
    MeasureMark chosen = lineOf({-4.0, 0.0, -4.0}, {4.0, 0.0, 4.0});
    chosen.selected = true;
    scene.setMeasures({chosen});
    QCOMPARE(cyanOf(window), before);
    scene.detach();
  }
};

QTEST_MAIN(TestMeasureMarks)
#include "tst_measure_marks.moc"
