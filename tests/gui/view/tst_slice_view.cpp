// SPDX-License-Identifier: BSD-3-Clause
#include <vtkRenderWindow.h>

#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "core/base/formatted.h"
#include "gui/view/slice_view.h"
#include "gui/view/surface_view.h"
#include "tests/gui/window_events.h"

using namespace angiomesh;
using angiomesh::test::drag;
using angiomesh::test::litShare;
using angiomesh::test::makeImage;
using angiomesh::test::sendMouse;
using angiomesh::test::wheel;

namespace {

Eigen::Vector3d position(const QList<QVariant>& arguments) {
  return {arguments[0].toDouble(), arguments[1].toDouble(), arguments[2].toDouble()};
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

class TestSliceView : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<Volume<float>> image_ = makeImage();

  std::unique_ptr<SliceView> sliceView(int plane) {
    auto view = std::make_unique<SliceView>();
    view->resize(320, 280);
    view->setPlane(plane);
    view->setImage(image_);
    view->setWindowLevel(1000.0, 500.0);
    view->setWindowLimits({0.0, 1000.0, 1000.0});
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
      view->setSlab({});
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
    surface.setVolumeView(VolumeView::Mip);
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
    QVERIFY(changed.last()[0].value<Slab>() == view->slab());
    QCOMPARE(view->slab().mode, SlabMode::Mip);
    QVERIFY(std::abs(view->slab().thicknessMm - 2.4) < 1e-9);
    wheel(*view, {50, 50}, {0, 120}, Qt::AltModifier);
    QVERIFY(std::abs(view->slab().thicknessMm - 3.6) < 1e-9);
    wheel(*view, {50, 50}, {0, 120});
    QCOMPARE(view->slab().mode, SlabMode::Mip);  // stays on while scrolling
    wheel(*view, {50, 50}, {0, -240}, Qt::AltModifier);
    QCOMPARE(view->slab().mode, SlabMode::None);
    QVERIFY(changed.last()[0].value<Slab>() == view->slab());
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
    view->setSlab({SlabMode::Mip, 12.0});
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
    QVERIFY(text.endsWith(QString::fromStdString(placeText(view->lpsAt(at)))));
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

  void pixelRatioReachesTheScene() {
    const auto view = sliceView(2);
    const int* size = view->renderWindow()->GetSize();
    QCOMPARE(size[0], qRound(view->width() * view->devicePixelRatioF()));
    QCOMPARE(view->renderWindow()->GetDPI(), qRound(72.0 * view->devicePixelRatioF()));
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestSliceView>(argc, argv); }
#include "tst_slice_view.moc"
