// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <QTest>

#include <Eigen/Geometry>
#include <cmath>

#include "render/marks/port_drag.h"
#include "render/marks/surface_pick.h"
#include "render/slice/slice_scene.h"
#include "render/stage/conversion.h"
#include "render/surface/surface_scene.h"

using namespace angiomesh;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// A box whose upper side is patch 1.
std::shared_ptr<TriMesh> box(double half) {
  auto mesh = std::make_shared<TriMesh>();
  for (int k = 0; k < 8; ++k)
    mesh->points.emplace_back(half * ((k & 1) * 2 - 1), half * ((k >> 1 & 1) * 2 - 1),
                              half * ((k >> 2 & 1) * 2 - 1));
  mesh->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  mesh->patch.assign(12, 0);
  mesh->patch[2] = mesh->patch[3] = 1;
  return mesh;
}

PortMark markAt(const Vector3d& point, const Vector3d& normal, double radius = 2.0) {
  PortMark mark;
  mark.name = "inlet";
  mark.plane = {point, normal.normalized()};
  mark.radiusMm = radius;
  mark.colour = {0.1, 0.9, 0.9};
  return mark;
}

/// The line of sight along y through a point.
ViewRay alongY(double x, double z) { return {{x, -100.0, z}, {0.0, 1.0, 0.0}}; }

/// A quarter of a circle about the origin in the plane y = 0, from the x to the z axis.
std::vector<Vector3d> arc(double radius) {
  std::vector<Vector3d> path;
  for (int k = 0; k <= 180; ++k) {
    const double angle = 0.5 * M_PI * k / 180.0;
    path.emplace_back(radius * std::cos(angle), 0.0, radius * std::sin(angle));
  }
  return path;
}

/// How many pixels are bright in green and blue and dark in red.
int cyanOf(vtkRenderWindow* window) {
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, 299, 239, 0, pixels);
  int count = 0;
  for (vtkIdType i = 0; i < 300 * 240; ++i) {
    const unsigned char* p = pixels->GetPointer(4 * i);
    if (p[1] > 100 && p[2] > 100 && p[0] < p[1] / 2) ++count;
  }
  return count;
}

struct Pane {
  SurfaceScene scene;
  vtkNew<vtkRenderWindow> window;

  Pane() {
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(300, 240);
    scene.attach(window);
  }
  ~Pane() { scene.detach(); }

  int cyan() { return cyanOf(window); }
};

}  // namespace

class TestPortMarks : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pointsAreDoubledAtRimsAlone() {
    const auto data = toPolyData(*box(1.0));
    QCOMPARE(data->GetNumberOfPoints(), vtkIdType(12));
    QCOMPARE(data->GetNumberOfPolys(), vtkIdType(12));
    // The cap's normals are its own.
    int up = 0;
    for (vtkIdType i = 0; i < 12; ++i)
      if (data->GetPointData()->GetNormals()->GetTuple3(i)[2] > 0.999) ++up;
    QCOMPARE(up, 4);
    TriMesh plain = *box(1.0);
    plain.patch.clear();
    QCOMPARE(toPolyData(plain)->GetNumberOfPoints(), vtkIdType(8));
  }

  void raysMeetWhatTheyShow() {
    Pane pane;
    pane.scene.setSurface(box(5.0));
    pane.scene.viewFrom('A');
    pane.window->Render();
    const Vector3d corner(5.0, -5.0, 5.0);
    const Vector2d at = pane.scene.displayAt(corner);
    const ViewRay ray = pane.scene.rayAt(at[0], at[1]);
    QVERIFY((corner - ray.from).cross(ray.direction).norm() < 1e-9);
    // VTK agrees where the point is.
    pane.scene.renderer()->SetWorldPoint(corner[0], corner[1], corner[2], 1.0);
    pane.scene.renderer()->WorldToDisplay();
    const double* display = pane.scene.renderer()->GetDisplayPoint();
    QVERIFY((Vector2d(display[0], display[1]) - at).norm() < 1.0);
    const Vector2d middle = pane.scene.displayAt({1.0, -5.0, 2.0});
    const auto hit = pane.scene.surfaceAt(middle[0], middle[1]);
    QVERIFY(hit && (*hit - Vector3d(1.0, -5.0, 2.0)).norm() < 1e-6);
    QVERIFY(!pane.scene.surfaceAt(1.0, 1.0));
    pane.scene.setSurfaceVisible(false);
    QVERIFY(!pane.scene.surfaceAt(middle[0], middle[1]));
  }

  void theDiscSlidesAlongItsVesselAndTurnsWithIt() {
    PortMark mark = markAt({20.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    mark.path = arc(20.0);
    // Grabbed a little beside its centre it does not jump.
    PortDrag drag(mark, PortDrag::Grip::Disc, 5.0, alongY(21.0, 0.0));
    QVERIFY((drag.moved(alongY(21.0, 0.0), false).pointLps - mark.plane.pointLps).norm() < 1e-9);
    CutPlane there;
    for (int k = 1; k <= 10; ++k) {
      const double angle = 0.025 * M_PI * k;
      there = drag.moved(alongY(21.0 * std::cos(angle), 21.0 * std::sin(angle)), false);
    }
    const double s = std::sqrt(0.5);
    QVERIFY((there.pointLps - 20.0 * Vector3d(s, 0.0, s)).norm() < 0.3);
    QVERIFY(there.normalLps.dot(Vector3d(-s, 0.0, s)) > 0.995);
  }

  void withoutAVesselItGoesAlongItsNormal() {
    const PortMark mark = markAt({0.0, 0.0, 0.0}, {1.0, 0.0, 1.0});
    PortDrag drag(mark, PortDrag::Grip::Disc, 5.0, alongY(0.0, 0.0));
    const CutPlane moved = drag.moved(alongY(4.0, 0.0), false);
    QVERIFY((moved.pointLps - Vector3d(2.0, 0.0, 2.0)).norm() < 1e-9);
    QVERIFY((moved.normalLps - mark.plane.normalLps).norm() < 1e-12);
    const CutPlane anywhere = drag.moved(alongY(4.0, -1.0), true);
    QVERIFY((anywhere.pointLps - Vector3d(4.0, 0.0, -1.0)).norm() < 1e-9);
    // Seen end-on, where a way along the normal cannot be seen, it moves across.
    PortDrag away(markAt({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}), PortDrag::Grip::Disc, 5.0,
                  alongY(0.0, 0.0));
    QVERIFY((away.moved(alongY(3.0, 1.0), false).pointLps - Vector3d(3.0, 0.0, 1.0)).norm() < 1e-9);
  }

  void aVesselSeenEndOnLetsTheDiscGoAcross() {
    PortMark mark = markAt({1.0, 0.0, 0.0}, {0.3, 1.0, 0.0});
    for (int k = -20; k <= 20; ++k) mark.path.emplace_back(1.0, 0.5 * k, 0.0);
    PortDrag drag(mark, PortDrag::Grip::Disc, 5.0, alongY(1.0, 0.0));
    const CutPlane moved = drag.moved(alongY(2.0, 0.5), false);
    QVERIFY((moved.pointLps - Vector3d(2.0, 0.0, 0.5)).norm() < 1e-9);
    QVERIFY((moved.normalLps - mark.plane.normalLps).norm() < 1e-12);
  }

  void theArrowTurnsAboutTheLineOfSight() {
    const PortMark mark = markAt({1.0, 2.0, 3.0}, {0.0, -0.3, 1.0});
    // Grabbed anywhere, it turns as the mouse does.
    for (const double grabbed : {2.0, 10.0}) {
      PortDrag drag(mark, PortDrag::Grip::Turn, 10.0, alongY(1.0, 3.0 + grabbed));
      const CutPlane turned = drag.moved(alongY(6.0, 3.0), false);
      QVERIFY((turned.pointLps - mark.plane.pointLps).norm() < 1e-12);
      QVERIFY((turned.normalLps - Vector3d(1.0, -0.3, 0.0).normalized()).norm() < 1e-9);
      const CutPlane none = drag.moved(alongY(1.0, 3.0), false);
      QVERIFY((none.normalLps - mark.plane.normalLps).norm() < 1e-9);
    }
  }

  void theArrowTilts() {
    const PortMark mark = markAt({1.0, 2.0, 3.0}, {0.0, -0.1, 1.0});
    PortDrag drag(mark, PortDrag::Grip::Arrow, 10.0, alongY(1.0, 13.0));
    const CutPlane tilted = drag.moved(alongY(7.0, 11.0), false);
    QVERIFY((tilted.pointLps - mark.plane.pointLps).norm() < 1e-12);
    QVERIFY((tilted.normalLps - Vector3d(0.6, 0.0, 0.8)).norm() < 1e-6);
    // Inside the circle of its tip it leans towards the viewer or away, as it did.
    QVERIFY(drag.moved(alongY(1.0, 8.0), false).normalLps[1] < -0.8);
    // Beyond, it points there.
    QVERIFY((drag.moved(alongY(31.0, 3.0), false).normalLps - Vector3d(1.0, 0.0, 0.0)).norm() <
            1e-9);
  }

  void discsAndArrowsAreSeenAndFound() {
    Pane pane;
    pane.scene.setSurface(box(5.0));
    pane.scene.viewFrom('A');
    QCOMPARE(pane.cyan(), 0);
    // The arrow is seen though it lies inside.
    pane.scene.setPorts({markAt({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 1.0)});
    const int arrow = pane.cyan();
    QVERIFY2(arrow > 20, qPrintable(QString::number(arrow)));
    pane.scene.setPorts({markAt({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 5.0)});
    pane.window->Render();
    const Vector2d tip = pane.scene.displayAt(pane.scene.arrowTip(0));
    auto hit = pane.scene.portAt(tip[0], tip[1]);
    QVERIFY(hit && hit->grip == PortDrag::Grip::Arrow);
    // Edge-on a disc is a line, and found beside it too.
    const Vector2d centre = pane.scene.displayAt({3.0, 0.0, 0.0});
    hit = pane.scene.portAt(centre[0], centre[1] + 3.0);
    QVERIFY(hit && hit->grip == PortDrag::Grip::Disc);
    QVERIFY(!pane.scene.portAt(centre[0], centre[1] + 40.0));
    PortMark fixed = pane.scene.ports()[0];
    fixed.movable = false;
    pane.scene.setPorts({fixed});
    QVERIFY(!pane.scene.portAt(centre[0], centre[1]));
    // What hides it keeps it from being grabbed.
    pane.scene.setPorts({markAt({0.0, 80.0, 0.0}, {0.0, -1.0, 0.0}, 2.0)});
    const Vector2d behind = pane.scene.displayAt({0.0, 80.0, 0.0});
    QVERIFY(pane.scene.gripAt(behind[0], behind[1]));
    QVERIFY(!pane.scene.portAt(behind[0], behind[1]));
    pane.scene.setPorts({});
    QCOMPARE(pane.cyan(), 0);
  }

  void slicesShowWhereADiscPassesThem() {
    SliceScene scene;
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(300, 240);
    window->AddRenderer(scene.renderer());
    Geometry g;
    g.size = {41, 41, 41};
    scene.setImage(std::make_shared<Volume<float>>(g));
    scene.setCrosshairVisible(false);
    scene.setSlice(20);
    QCOMPARE(cyanOf(window), 0);
    // Across the slice a line and an arrow, in it an outline, off it nothing.
    scene.setPorts({markAt({20.0, 20.0, 20.0}, {1.0, 0.0, 0.0}, 8.0)});
    QVERIFY(cyanOf(window) > 50);
    scene.setPorts({markAt({20.0, 20.0, 20.0}, {0.0, 0.0, 1.0}, 8.0)});
    QVERIFY(cyanOf(window) > 100);
    scene.setSlice(23);
    QCOMPARE(cyanOf(window), 0);
    scene.setPorts({markAt({20.0, 20.0, 5.0}, {1.0, 0.0, 0.0}, 8.0)});
    QCOMPARE(cyanOf(window), 0);
    window->RemoveRenderer(scene.renderer());
  }

  void slicesFindDiscsAndArrows() {
    SliceScene scene;
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetSize(300, 240);
    window->AddRenderer(scene.renderer());
    Geometry g;
    g.size = {41, 41, 41};
    // Oblique, with slices thicker than pixels.
    g.spacing = {1.0, 1.0, 2.0};
    g.direction = Eigen::AngleAxisd(0.2, Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
    scene.setImage(std::make_shared<Volume<float>>(g));
    scene.setSlice(20);
    const Vector3d u = g.direction.col(0), v = g.direction.col(1), w = g.direction.col(2);
    const Vector3d middle = g.toPhysical({20.0, 20.0, 20.0});
    const auto hitAt = [&](const Vector3d& lps) {
      const Vector2d at = scene.displayAt(lps);
      return scene.portAt(at[0], at[1]);
    };
    QVERIFY(!hitAt(middle));
    scene.setPorts({markAt({500.0, 0.0, 0.0}, {1.0, 0.0, 0.0}), markAt(middle, u, 8.0)});
    for (const double along : {-9.0, 0.0, 9.0}) {
      const auto hit = hitAt(middle + along * v);
      QVERIFY(hit && hit->mark == 1 && hit->grip == PortDrag::Grip::Disc);
    }
    const auto tip = hitAt(middle + scene.ports()[1].discRadiusMm() * u);
    QVERIFY(tip && tip->mark == 1 && tip->grip == PortDrag::Grip::Turn);
    QVERIFY(!hitAt(middle - 6.0 * u) && !hitAt(middle + 16.0 * v));
    const Vector2d at = scene.displayAt(middle);
    const ViewRay ray = scene.rayAt(at[0], at[1]);
    QVERIFY((ray.from - middle).norm() < 1e-9 && ray.direction.cross(w).norm() < 1e-9);
    // An opening that nobody cut stays where it is.
    PortMark fixed = markAt(middle, u, 8.0);
    fixed.movable = false;
    scene.setPorts({fixed});
    QVERIFY(!hitAt(middle));
    // In the slice the outline is found; beside its slice nothing is.
    scene.setPorts({markAt(middle, w, 8.0)});
    const auto rim = hitAt(middle + scene.ports()[0].discRadiusMm() * u);
    QVERIFY(rim && rim->grip == PortDrag::Grip::Disc && !hitAt(middle));
    scene.setSlice(23);
    QVERIFY(!hitAt(middle + scene.ports()[0].discRadiusMm() * u));
    scene.setImage(nullptr);
    QVERIFY(!hitAt(middle));
    window->RemoveRenderer(scene.renderer());
  }

  void capsHaveTheColoursOfTheirPorts() {
    Pane pane;
    pane.scene.setSurface(box(5.0));
    pane.scene.viewFrom('S');
    QCOMPARE(pane.cyan(), 0);
    pane.scene.setPatchColours({{0.1, 0.9, 0.9}});
    QVERIFY(pane.cyan() > 1000);
    pane.scene.setSurfaceColours(std::vector<float>(12, 0.0F), "quality", 0.0, 1.0);
    QVERIFY(pane.cyan() < 200);  // the colour bar has some
    pane.scene.clearSurfaceColours();
    QVERIFY(pane.cyan() > 1000);
  }
};

QTEST_MAIN(TestPortMarks)
#include "tst_port_marks.moc"
