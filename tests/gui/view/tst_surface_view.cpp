// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <QHBoxLayout>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "gui/view/slice_view.h"
#include "gui/view/surface_view.h"
#include "tests/gui/window_events.h"

using namespace angiomesh;
using angiomesh::test::drag;
using angiomesh::test::litShare;
using angiomesh::test::makeImage;
using angiomesh::test::wheel;

namespace {

std::shared_ptr<TriMesh> makeTetrahedron(const Eigen::Vector3d& centre, double size) {
  auto mesh = std::make_shared<TriMesh>();
  mesh->points = {
      centre + size * Eigen::Vector3d(1, 1, 1), centre + size * Eigen::Vector3d(1, -1, -1),
      centre + size * Eigen::Vector3d(-1, 1, -1), centre + size * Eigen::Vector3d(-1, -1, 1)};
  mesh->triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  return mesh;
}

}  // namespace

class TestSurfaceView : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<Volume<float>> image_ = makeImage();

 private Q_SLOTS:
  void surfaceTurnsAndNewOnesKeepTheCamera() {
    SurfaceView view;
    view.resize(300, 260);
    view.setImage(image_);
    view.setVolumeView(VolumeView::None);
    const Eigen::Vector3d centre = image_->geometry.toPhysical({20, 22, 18});
    view.setSurface(makeTetrahedron(centre, 12.0));
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QVERIFY(litShare(view.grabFramebuffer()) > 0.03);
    vtkCamera* camera = view.renderWindow()->GetRenderers()->GetFirstRenderer()->GetActiveCamera();
    const Eigen::Vector3d start(camera->GetPosition());
    drag(view, Qt::LeftButton, {100, 100}, {170, 130});
    const Eigen::Vector3d turned(camera->GetPosition());
    QVERIFY((turned - start).norm() > 5.0);
    view.setSurface(makeTetrahedron(centre, 3.0));
    view.grabFramebuffer();
    QVERIFY((Eigen::Vector3d(camera->GetPosition()) - turned).norm() < 1e-9);
    const double distance = camera->GetDistance();
    wheel(view, {100, 100}, {0, 120});
    QVERIFY(camera->GetDistance() < distance);
    const std::array<std::pair<char, Eigen::Vector3d>, 6> sides{{{'A', {0, -1, 0}},
                                                                 {'P', {0, 1, 0}},
                                                                 {'L', {1, 0, 0}},
                                                                 {'R', {-1, 0, 0}},
                                                                 {'S', {0, 0, 1}},
                                                                 {'I', {0, 0, -1}}}};
    for (const auto& [side, from] : sides) {
      view.viewFrom(side);
      Eigen::Vector3d forward;
      camera->GetDirectionOfProjection(forward.data());
      QVERIFY((forward + from).norm() < 1e-9);
    }
    QTest::keyClick(&view, Qt::Key_L);
    Eigen::Vector3d forward;
    camera->GetDirectionOfProjection(forward.data());
    QVERIFY((forward - Eigen::Vector3d(-1, 0, 0)).norm() < 1e-9);
    // The front goes to the right: from there the patient's right side is seen.
    QTest::keyClick(&view, Qt::Key_A);
    for (int i = 0; i < 15; ++i) QTest::keyClick(&view, Qt::Key_Right);
    camera->GetDirectionOfProjection(forward.data());
    QVERIFY((forward - Eigen::Vector3d(1, 0, 0)).norm() < 1e-9);
    QTest::keyClick(&view, Qt::Key_A);
    for (int i = 0; i < 5; ++i) QTest::keyClick(&view, Qt::Key_Up);
    camera->GetDirectionOfProjection(forward.data());
    QVERIFY(std::abs(forward.z() - 0.5) < 1e-9);  // 30 degrees from below
    auto* fromLeft = view.findChild<QToolButton*>("fromL");
    QVERIFY(fromLeft->isVisible());
    QTest::mouseClick(fromLeft, Qt::LeftButton);
    camera->GetDirectionOfProjection(forward.data());
    QVERIFY((forward - Eigen::Vector3d(-1, 0, 0)).norm() < 1e-9);
    for (const char key : {'q', 'e', 'w', 'p', '3'}) QTest::keyClick(&view, key);
    QVERIFY(litShare(view.grabFramebuffer()) > 0.001);
  }

  void twoViewsCanShareACamera() {
    SurfaceView first;
    SurfaceView second;
    for (SurfaceView* view : {&first, &second}) {
      view->resize(240, 220);
      view->setSurface(makeTetrahedron({10, 20, 30}, 8.0));
      view->show();
      QVERIFY(QTest::qWaitForWindowExposed(view));
    }
    connect(&first, &SurfaceView::cameraMoved, &second, [&] { second.takeCameraOf(first); });
    connect(&second, &SurfaceView::cameraMoved, &first, [&] { first.takeCameraOf(second); });
    const auto camera = [](SurfaceView& view) {
      return view.renderWindow()->GetRenderers()->GetFirstRenderer()->GetActiveCamera();
    };
    const Eigen::Vector3d start(camera(second)->GetPosition());
    drag(first, Qt::LeftButton, {100, 100}, {150, 120});
    const Eigen::Vector3d moved(camera(second)->GetPosition());
    QVERIFY((moved - start).norm() > 1.0);
    QVERIFY((moved - Eigen::Vector3d(camera(first)->GetPosition())).norm() < 1e-9);
    wheel(second, {100, 100}, {0, 120});
    QVERIFY(std::abs(camera(first)->GetDistance() - camera(second)->GetDistance()) < 1e-9);
  }

  void manySnapshotsMakeFewFrames() {
    SurfaceView view;
    view.resize(300, 260);
    view.setImage(image_);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QTest::qWait(100);
    QSignalSpy frames(&view, &VtkView::rendered);
    const Eigen::Vector3d centre = image_->geometry.toPhysical({20, 22, 18});
    for (int k = 0; k < 50; ++k) view.setSurface(makeTetrahedron(centre, 1.0 + 0.2 * k));
    QTRY_VERIFY(frames.count() >= 1);
    QVERIFY(frames.count() < 10);
  }

  void viewsComeAndGo() {
    for (int round = 0; round < 4; ++round) {
      auto window = std::make_unique<QWidget>();
      auto* layout = new QHBoxLayout(window.get());
      std::vector<SliceView*> slices;
      for (int plane = 0; plane < 3; ++plane) {
        slices.push_back(new SliceView);
        slices.back()->setPlane(plane);
        slices.back()->setImage(image_);
        layout->addWidget(slices.back());
      }
      auto* surface = new SurfaceView;
      surface->setImage(image_);
      surface->setSurface(makeTetrahedron(image_->geometry.origin, 20.0));
      layout->addWidget(surface);
      window->resize(900, 240);
      if (round % 2 == 0) {  // some are destroyed without ever having been shown
        window->show();
        QVERIFY(QTest::qWaitForWindowExposed(window.get()));
        QVERIFY(litShare(slices[0]->grabFramebuffer()) > 0.02);
        // To another top level and back: a new OpenGL context each time.
        surface->setParent(nullptr);
        surface->show();
        QVERIFY(QTest::qWaitForWindowExposed(surface));
        QVERIFY(litShare(surface->grabFramebuffer()) > 0.01);
        layout->addWidget(surface);
        surface->show();
        QTest::qWait(50);
        QVERIFY(litShare(surface->grabFramebuffer()) > 0.01);
      }
    }
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestSurfaceView>(argc, argv); }
#include "tst_surface_view.moc"
