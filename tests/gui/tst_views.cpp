// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <Eigen/Geometry>
#include <QApplication>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "gui/view/open_gl.h"
#include "gui/view/slice_view.h"
#include "gui/view/surface_view.h"

using namespace angiomesh;

namespace {

std::shared_ptr<Volume<float>> makeImage() {
  Geometry g;
  g.size = {40, 44, 36};
  g.spacing = {0.9, 1.0, 1.2};
  g.direction = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  g.origin = {-20.0, 15.0, 130.0};
  auto image = std::make_shared<Volume<float>>(g);
  for (std::size_t p = 0; p < image->voxels.size(); ++p) {
    const Index3 v = g.indexOf(p);
    const double r = (Eigen::Vector3d(v[0], v[1], v[2]) - Eigen::Vector3d(20, 22, 18)).norm();
    image->voxels[p] = static_cast<float>(r < 10.0 ? 1000.0 : 5.0 * (p % 7));
  }
  return image;
}

std::shared_ptr<TriMesh> makeTetrahedron(const Eigen::Vector3d& centre, double size) {
  auto mesh = std::make_shared<TriMesh>();
  mesh->points = {
      centre + size * Eigen::Vector3d(1, 1, 1), centre + size * Eigen::Vector3d(1, -1, -1),
      centre + size * Eigen::Vector3d(-1, 1, -1), centre + size * Eigen::Vector3d(-1, -1, 1)};
  mesh->triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  return mesh;
}

void sendMouse(QWidget& widget, QEvent::Type type, const QPoint& at, Qt::MouseButton button,
               Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QMouseEvent event(type, at, widget.mapToGlobal(QPointF(at)), button, buttons, modifiers);
  QApplication::sendEvent(&widget, &event);
}

void drag(QWidget& widget, Qt::MouseButton button, const QPoint& from, const QPoint& to,
          Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  sendMouse(widget, QEvent::MouseButtonPress, from, button, button, modifiers);
  for (int step = 1; step <= 5; ++step)
    sendMouse(widget, QEvent::MouseMove, from + (to - from) * step / 5, Qt::NoButton, button,
              modifiers);
  sendMouse(widget, QEvent::MouseButtonRelease, to, button, Qt::NoButton, modifiers);
}

void wheel(QWidget& widget, const QPoint& at, const QPoint& delta,
           Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QWheelEvent event(at, widget.mapToGlobal(QPointF(at)), QPoint(), delta, Qt::NoButton, modifiers,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &event);
}

Eigen::Vector3d position(const QList<QVariant>& arguments) {
  return {arguments[0].toDouble(), arguments[1].toDouble(), arguments[2].toDouble()};
}

/// Share of the pixels that are not nearly black.
double litShare(const QImage& picture) {
  int lit = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (qGray(picture.pixel(x, y)) > 60) ++lit;
  return static_cast<double>(lit) / (picture.width() * picture.height());
}

/// Middle of the nearly white pixels.
QPointF brightSpot(const QImage& picture) {
  double sx = 0.0, sy = 0.0, n = 0.0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (qGray(picture.pixel(x, y)) > 250) {
        sx += x;
        sy += y;
        n += 1.0;
      }
  return n > 0.0 ? QPointF(sx / n, sy / n) : QPointF(-1, -1);
}

}  // namespace

class TestViews : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<Volume<float>> image_ = makeImage();

  std::unique_ptr<SliceView> sliceView(int plane) {
    auto view = std::make_unique<SliceView>();
    view->resize(320, 280);
    view->setPlane(plane);
    view->setImage(image_);
    view->setWindowLevel(1000.0, 500.0);
    view->setCrosshairVisible(false);
    view->show();
    [[maybe_unused]] const bool exposed = QTest::qWaitForWindowExposed(view.get());
    return view;
  }

 private Q_SLOTS:
  void picturesReachTheScreen() {
    for (int plane = 0; plane < 3; ++plane) {
      const auto view = sliceView(plane);
      const QImage frame = view->grabFramebuffer();
      QVERIFY(litShare(frame) > 0.05);
      QVERIFY(litShare(frame) < 0.6);
      const QPointF ball = brightSpot(frame);
      const QPointF expected =
          view->positionOf(image_->geometry.toPhysical(Eigen::Vector3d(20, 22, 18)));
      QVERIFY(QLineF(ball / view->devicePixelRatioF(), expected).length() < 3.0);
      // What a parent composes is the same: no holes from a transparent frame.
      QVERIFY(std::abs(litShare(view->grab().toImage()) - litShare(frame)) < 0.05);
    }
  }

  void positionsAreTrueBothWays() {
    const auto view = sliceView(1);
    for (const QPointF& p : {QPointF(100, 80), QPointF(0, 0), QPointF(300.5, 211.25)})
      QVERIFY(QLineF(view->positionOf(view->lpsAt(p)), p).length() < 1e-6);
  }

  void leftDragChangesWindowAndLevel() {
    const auto view = sliceView(2);
    QSignalSpy changed(view.get(), &SliceView::windowLevelChanged);
    drag(*view, Qt::LeftButton, {100, 100}, {140, 100});
    QVERIFY(changed.count() >= 4);
    QVERIFY(view->windowWidth() > 1000.0);
    QCOMPARE(view->windowLevel(), 500.0);
    QCOMPARE(changed.last()[0].toDouble(), view->windowWidth());
    const double window = view->windowWidth();
    drag(*view, Qt::LeftButton, {100, 100}, {100, 60});
    QCOMPARE(view->windowWidth(), window);
    QVERIFY(view->windowLevel() < 500.0);  // upwards: brighter
    const double coarse = 500.0 - view->windowLevel();
    view->setWindowLevel(1000.0, 500.0);
    drag(*view, Qt::LeftButton, {100, 100}, {100, 60}, Qt::ControlModifier);
    QVERIFY(std::abs((500.0 - view->windowLevel()) - 0.1 * coarse) < 1e-6 * coarse);
    drag(*view, Qt::LeftButton, {300, 100}, {-5000, 100});
    QVERIFY(view->windowWidth() > 0.0);
  }

  void tellingTheSameAgainLeavesADragAlone() {
    const auto view = sliceView(2);
    connect(view.get(), &SliceView::windowLevelChanged, view.get(), [&](double w, double l) {
      view->setWindowLevel(w, l);
      view->setTool(Tool::Navigate);
      view->setSlab(SlabMode::None, 0.0);
      view->setRoi(std::nullopt);
    });
    QSignalSpy changed(view.get(), &SliceView::windowLevelChanged);
    drag(*view, Qt::LeftButton, {100, 100}, {140, 100});
    QCOMPARE(changed.count(), 5);
    SurfaceView surface;
    surface.setImage(image_);
    surface.show();
    QVERIFY(QTest::qWaitForWindowExposed(&surface));
    QTest::qWait(600);  // past the refinement
    QSignalSpy frames(&surface, &VtkView::rendered);
    surface.setMipVisible(true);
    surface.setSurfaceVisible(true);
    surface.setEdgesVisible(false);
    surface.setSeeds({});
    surface.setRoi(std::nullopt);
    QTest::qWait(500);
    QCOMPARE(frames.count(), 0);
  }

  void wheelAndKeysStepSlices() {
    const auto view = sliceView(2);
    const int middle = view->slice();
    QSignalSpy changed(view.get(), &SliceView::sliceChanged);
    QSignalSpy moved(view.get(), &SliceView::cursorMoved);
    const Eigen::Vector3d before = view->cursor();
    wheel(*view, {50, 50}, {0, 120});
    QCOMPARE(std::abs(view->slice() - middle), 1);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed.last()[0].toInt(), view->slice());
    QCOMPARE(moved.count(), 1);
    QVERIFY(position(moved.last())[2] > before[2]);  // away from the user: towards the head
    wheel(*view, {50, 50}, {0, -60});
    wheel(*view, {50, 50}, {0, -60});  // fine wheels add up
    QCOMPARE(view->slice(), middle);
    QTest::keyClick(view.get(), Qt::Key_Up);
    const int step = view->slice() - middle;
    QCOMPARE(std::abs(step), 1);
    QTest::keyClick(view.get(), Qt::Key_Down, Qt::ShiftModifier);
    QCOMPARE(view->slice(), middle + step - 10 * step);
    view->setSlice(1000);
    QCOMPARE(view->slice(), view->sliceCount() - 1);
    wheel(*view, {50, 50}, {0, 120 * step * 3});
    QCOMPARE(view->slice(), view->sliceCount() - 1);
  }

  void controlWheelZoomsAboutThePointer() {
    const auto view = sliceView(0);
    const Eigen::Vector3d under = view->lpsAt({60, 200});
    const double before = (view->lpsAt({0, 0}) - view->lpsAt({100, 0})).norm();
    const int slice = view->slice();
    wheel(*view, {60, 200}, {0, 240}, Qt::ControlModifier);
    QVERIFY((view->lpsAt({60, 200}) - under).norm() < 1e-6);
    QVERIFY((view->lpsAt({0, 0}) - view->lpsAt({100, 0})).norm() < 0.9 * before);
    QCOMPARE(view->slice(), slice);
    QTest::keyClick(view.get(), Qt::Key_R);
    QVERIFY(std::abs((view->lpsAt({0, 0}) - view->lpsAt({100, 0})).norm() - before) < 1e-9);
  }

  void otherButtonsPanAndZoom() {
    const auto view = sliceView(2);
    const Eigen::Vector3d grabbed = view->lpsAt({120, 120});
    drag(*view, Qt::MiddleButton, {120, 120}, {160, 90});
    QVERIFY((view->lpsAt({160, 90}) - grabbed).norm() < 1e-6);
    const double before = (view->lpsAt({0, 0}) - view->lpsAt({100, 0})).norm();
    const Eigen::Vector3d fixed = view->lpsAt({100, 150});
    drag(*view, Qt::RightButton, {100, 150}, {100, 100});
    QVERIFY((view->lpsAt({0, 0}) - view->lpsAt({100, 0})).norm() < 0.8 * before);
    QVERIFY((view->lpsAt({100, 150}) - fixed).norm() < 1e-6);
    QCOMPARE(view->windowWidth(), 1000.0);
  }

  void altWheelChangesTheSlab() {
    const auto view = sliceView(2);
    QSignalSpy changed(view.get(), &SliceView::slabChanged);
    wheel(*view, {50, 50}, {120, 0}, Qt::AltModifier);  // Alt turns the wheel sideways
    QCOMPARE(changed.count(), 1);
    QCOMPARE(view->slabMode(), SlabMode::Mip);
    QVERIFY(std::abs(changed.last()[0].toDouble() - 2.4) < 1e-9);
    wheel(*view, {50, 50}, {0, 120}, Qt::AltModifier);
    QVERIFY(std::abs(view->slabThicknessMm() - 3.6) < 1e-9);
    wheel(*view, {50, 50}, {0, 120});
    QCOMPARE(view->slabMode(), SlabMode::Mip);  // stays on while scrolling
    wheel(*view, {50, 50}, {0, -240}, Qt::AltModifier);
    QCOMPARE(view->slabMode(), SlabMode::None);
    QCOMPARE(changed.last()[0].toDouble(), 0.0);
  }

  void shiftMoveSetsTheCrosshair() {
    const auto view = sliceView(1);
    QSignalSpy moved(view.get(), &SliceView::cursorMoved);
    sendMouse(*view, QEvent::MouseMove, {90, 140}, Qt::NoButton, Qt::NoButton);
    QCOMPARE(moved.count(), 0);
    sendMouse(*view, QEvent::MouseMove, {91, 141}, Qt::NoButton, Qt::NoButton, Qt::ShiftModifier);
    QCOMPARE(moved.count(), 1);
    QVERIFY((position(moved.last()) - view->lpsAt({91, 141})).norm() < 1e-9);
    QVERIFY((view->cursor() - view->lpsAt({91, 141})).norm() < 1e-9);
  }

  void linkedPanesMeetAtTheCrosshair() {
    const auto first = sliceView(2);
    const auto second = sliceView(0);
    QObject::connect(first.get(), &SliceView::cursorMoved, second.get(),
                     [&](double x, double y, double z) {
                       second->setCursor({x, y, z});
                     });
    QSignalSpy echoed(second.get(), &SliceView::cursorMoved);
    QSignalSpy changed(second.get(), &SliceView::sliceChanged);
    sendMouse(*first, QEvent::MouseMove, {220, 140}, Qt::NoButton, Qt::NoButton, Qt::ShiftModifier);
    const Eigen::Vector3d index = image_->geometry.toIndex(first->cursor());
    const int across = paneAxes(image_->geometry, 0).across;
    QCOMPARE(second->slice(), static_cast<int>(std::lround(index[across])));
    QCOMPARE(changed.count(), 1);
    QCOMPARE(echoed.count(), 0);
  }

  void leftButtonMovesTheCrosshairInTheOtherScheme() {
    const auto view = sliceView(2);
    view->setScheme(MouseScheme::Engineering);
    QSignalSpy moved(view.get(), &SliceView::cursorMoved);
    drag(*view, Qt::LeftButton, {100, 100}, {130, 90});
    QVERIFY((view->cursor() - view->lpsAt({130, 90})).norm() < 1e-9);
    QVERIFY(moved.count() >= 2);
    QCOMPARE(view->windowWidth(), 1000.0);
  }

  void clickPicksASeed() {
    for (int plane = 0; plane < 3; ++plane) {
      const auto view = sliceView(plane);
      view->setTool(Tool::PickSeed);
      QSignalSpy picked(view.get(), &SliceView::seedPicked);
      const Index3 voxel{24, 19, 21};
      const Eigen::Vector3d lps = image_->geometry.toPhysical(Eigen::Vector3d(24, 19, 21));
      view->setSlice(voxel[static_cast<std::size_t>(paneAxes(image_->geometry, plane).across)]);
      QTest::mouseClick(view.get(), Qt::LeftButton, {}, view->positionOf(lps).toPoint());
      QCOMPARE(picked.count(), 1);
      const Eigen::Vector3d index = image_->geometry.toIndex(position(picked.last()));
      QVERIFY((index - Eigen::Vector3d(24, 19, 21)).cwiseAbs().maxCoeff() < 0.5);
      QCOMPARE(view->windowWidth(), 1000.0);
      QTest::mouseClick(view.get(), Qt::LeftButton, {}, QPoint(1, 1));  // beside the image
      drag(*view, Qt::LeftButton, {100, 100}, {140, 100});              // a drag is no click
      QCOMPARE(picked.count(), 1);
      QVERIFY(view->windowWidth() > 1000.0);
    }
  }

  void seedInASlabLiesAtTheBrightestVoxel() {
    auto image = std::make_shared<Volume<float>>(image_->geometry);
    const PaneAxes axes = paneAxes(image->geometry, 2);
    QCOMPARE(axes.across, 2);
    image->at(24, 19, 25) = 100.0F;
    const auto view = sliceView(2);
    view->setImage(image);
    view->setSlice(22);
    view->setSlab(SlabMode::Mip, 12.0);
    view->setTool(Tool::PickSeed);
    QSignalSpy picked(view.get(), &SliceView::seedPicked);
    const QPointF at = view->positionOf(image->geometry.toPhysical({24, 19, 22}));
    QTest::mouseClick(view.get(), Qt::LeftButton, {}, at.toPoint());
    QCOMPARE(picked.count(), 1);
    const Eigen::Vector3d index = image->geometry.toIndex(position(picked.last()));
    QVERIFY((index - Eigen::Vector3d(24, 19, 25)).cwiseAbs().maxCoeff() < 0.5);
  }

  void dragDrawsARegionOfInterest() {
    const RoiBox whole = volumeBox(image_->geometry);
    for (int plane = 0; plane < 3; ++plane) {
      const auto view = sliceView(plane);
      view->setTool(Tool::DrawRoi);
      QSignalSpy drawn(view.get(), &SliceView::roiDrawn);
      QTest::mouseClick(view.get(), Qt::LeftButton, {}, QPoint(100, 100));
      QCOMPARE(drawn.count(), 0);
      drag(*view, Qt::LeftButton, {180, 160}, {120, 110});
      QCOMPARE(drawn.count(), 1);
      const auto box = drawn.last()[0].value<RoiBox>();
      const Eigen::Vector3d a = view->lpsAt({180, 160});
      const Eigen::Vector3d b = view->lpsAt({120, 110});
      for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        if (axis == plane) {
          QCOMPARE(box[k], whole[k]);
          QCOMPARE(box[k + 3], whole[k + 3]);
        } else {
          QVERIFY(std::abs(box[k] - std::min(a[axis], b[axis])) < 1e-9);
          QVERIFY(std::abs(box[k + 3] - std::max(a[axis], b[axis])) < 1e-9);
        }
      }
      // A second rectangle keeps what the first one fixed across the slice.
      RoiBox flat = box;
      flat[static_cast<std::size_t>(plane)] += 4.0;
      view->setRoi(flat);
      drag(*view, Qt::LeftButton, {100, 100}, {170, 170});
      const auto second = drawn.last()[0].value<RoiBox>();
      QCOMPARE(second[static_cast<std::size_t>(plane)], flat[static_cast<std::size_t>(plane)]);
    }
  }

  void doubleClickAsksToMaximise() {
    const auto view = sliceView(2);
    QSignalSpy asked(view.get(), &VtkView::maximiseRequested);
    QTest::mouseDClick(view.get(), Qt::LeftButton, {}, QPoint(100, 100));
    QCOMPARE(asked.count(), 1);
    QCOMPARE(view->windowWidth(), 1000.0);
    SurfaceView surface;
    surface.show();
    QVERIFY(QTest::qWaitForWindowExposed(&surface));
    QSignalSpy askedToo(&surface, &VtkView::maximiseRequested);
    QTest::mouseDClick(&surface, Qt::LeftButton, {}, QPoint(50, 50));
    QCOMPARE(askedToo.count(), 1);
  }

  void hoveringTellsValueVoxelAndPosition() {
    const auto view = sliceView(2);
    QSignalSpy hovered(view.get(), &SliceView::hovered);
    const Eigen::Vector3d lps = image_->geometry.toPhysical(Eigen::Vector3d(20, 22, view->slice()));
    const QPoint at = view->positionOf(lps).toPoint();
    sendMouse(*view, QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
    const QString text = hovered.last()[0].toString();
    QVERIFY2(text.startsWith(QString("1000, voxel 20,22,%1, ").arg(view->slice())),
             qPrintable(text));
    QVERIFY(text.endsWith(QString::fromStdString(positionText(view->lpsAt(at)))));
    sendMouse(*view, QEvent::MouseMove, {2, 2}, Qt::NoButton, Qt::NoButton);
    QVERIFY(hovered.last()[0].toString().isEmpty());
  }

  void viewsWithoutAnImageTakeAnyEvent() {
    SliceView view;
    view.resize(200, 150);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QSignalSpy moved(&view, &SliceView::cursorMoved);
    for (const Tool tool : {Tool::Navigate, Tool::PickSeed, Tool::DrawRoi}) {
      view.setTool(tool);
      drag(view, Qt::LeftButton, {20, 20}, {90, 90});
      drag(view, Qt::RightButton, {20, 20}, {90, 90});
      wheel(view, {20, 20}, {0, 120});
      wheel(view, {20, 20}, {0, 120}, Qt::AltModifier);
      sendMouse(view, QEvent::MouseMove, {50, 50}, Qt::NoButton, Qt::NoButton, Qt::ShiftModifier);
    }
    view.setCursor({1, 2, 3});
    view.setRoi(RoiBox{0, 0, 0, 1, 1, 1});
    view.setSeeds({{1, 2, 3}});
    view.setContour(image_);
    QCOMPARE(moved.count(), 0);
    QCOMPARE(view.sliceCount(), 0);
    QCOMPARE(litShare(view.grabFramebuffer()), 0.0);
    view.setImage(image_);
    QVERIFY(litShare(view.grabFramebuffer()) > 0.02);
  }

  void surfaceTurnsAndNewOnesKeepTheCamera() {
    SurfaceView view;
    view.resize(300, 260);
    view.setImage(image_);
    view.setMipVisible(false);
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

  void pixelRatioReachesTheScene() {
    const auto view = sliceView(2);
    const int* size = view->renderWindow()->GetSize();
    QCOMPARE(size[0], qRound(view->width() * view->devicePixelRatioF()));
    QCOMPARE(view->renderWindow()->GetDPI(), qRound(72.0 * view->devicePixelRatioF()));
  }
};

int main(int argc, char** argv) {
  prepareOpenGl();
  QApplication application(argc, argv);
  TestViews test;
  return QTest::qExec(&test, argc, argv);
}
#include "tst_views.moc"
