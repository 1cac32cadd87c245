// SPDX-License-Identifier: BSD-3-Clause
#include <QMenu>

#include "tests/gui/window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// The tubes with contrast medium, in HU.
Source ctTubes() {
  Volume<float> image = *twoTubes().image;
  const auto [least, greatest] = valueRange(image);
  for (float& value : image.voxels)
    value = -800.0F + 1300.0F * (value - least) / (greatest - least);
  return makeSource(std::move(image), "ct-tubes");
}

/// Pixels of a lit, reddish or ivory body, apart from text and frame.
int bodyPixels(const QImage& picture) {
  int count = 0;
  for (int y = picture.height() / 5; y < 4 * picture.height() / 5; ++y)
    for (int x = picture.width() / 5; x < 4 * picture.width() / 5; ++x) {
      const QRgb p = picture.pixel(x, y);
      if (qRed(p) > 100 && qRed(p) > qBlue(p) + 30) ++count;
    }
  return count;
}

int whitePixels(const QImage& picture) {
  int count = 0;
  for (int y = picture.height() / 5; y < 4 * picture.height() / 5; ++y)
    for (int x = picture.width() / 5; x < 4 * picture.width() / 5; ++x)
      if (qGreen(picture.pixel(x, y)) > 200) ++count;
  return count;
}

struct VolumeCase : WindowCase {
  explicit VolumeCase(Source source) {
    models().files.take(std::move(source));
    surface = window->views().surface();
    QTest::mouseMove(surface, surface->rect().center());
  }

  void key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(window.get(), key, modifiers);
  }
  QAction* action(const char* name) { return window->findChild<QAction*>(QLatin1String(name)); }

  SurfaceView* surface = nullptr;
};

constexpr Qt::KeyboardModifiers kCtrlShift = Qt::ControlModifier | Qt::ShiftModifier;

}  // namespace

class TestVolume3d : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void keysChooseHowTheVolumeIsSeen() {
    VolumeCase c(ctTubes());
    const QImage mip = c.surface->grabFramebuffer();
    QVERIFY(c.action("mip")->isChecked());
    QCOMPARE(bodyPixels(mip), 0);
    c.key(Qt::Key_V, kCtrlShift);
    QVERIFY(c.state().volumeView() == VolumeView::MrAngio);
    QVERIFY(!c.action("mip")->isChecked() && c.action("volumeMr")->isChecked());
    const QImage mr = c.surface->grabFramebuffer();
    QVERIFY(bodyPixels(mr) > 300);
    c.key(Qt::Key_T, kCtrlShift);
    QVERIFY(c.state().volumeView() == VolumeView::CtAngio);
    const QImage ct = c.surface->grabFramebuffer();
    QVERIFY(bodyPixels(ct) > 300 && ct != mr);
    c.key(Qt::Key_T, kCtrlShift);
    QVERIFY(c.state().volumeView() == VolumeView::None);
    QCOMPARE(bodyPixels(c.surface->grabFramebuffer()), 0);
    c.key(Qt::Key_I, Qt::ControlModifier);
    QVERIFY(c.state().volumeView() == VolumeView::Mip);
  }

  void aPaneOfAnotherSizeIsDrawnQuicklyAtFirst() {
    VolumeCase c(ctTubes());
    QTest::qWait(600);
    const QImage atRest = c.surface->grabFramebuffer();
    c.window->resize(c.window->width(), c.window->height() - 40);
    QTRY_VERIFY(c.surface->height() < atRest.height());
    const QImage quick = c.surface->grabFramebuffer();
    QTRY_VERIFY(c.surface->grabFramebuffer() != quick);
  }

  void theRightClickOfThePaneHasTheMenu() {
    VolumeCase c(ctTubes());
    const QPoint at = c.surface->rect().center();
    QTest::mouseClick(c.surface, Qt::RightButton, Qt::NoModifier, at);
    QTRY_VERIFY(QApplication::activePopupWidget());
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    QVERIFY(menu->actions().contains(c.action("volumeMenu")));
    menu->close();
  }

  void hounsfieldPresetsAreForCt() {
    Volume<float> narrow = *twoTubes().image;
    for (float& value : narrow.voxels) value *= 0.01F;
    VolumeCase c(makeSource(std::move(narrow), "narrow"));
    QVERIFY(!c.action("volumeCt")->isEnabled());
    c.state().setVolumeView(VolumeView::CtAngio);
    QVERIFY(c.state().volumeShown() == VolumeView::MrAngio);
    QVERIFY(bodyPixels(c.surface->grabFramebuffer()) > 300);
  }

  void theCaseKeepsTheChoice() {
    CaseView kept;
    {
      VolumeCase c(ctTubes());
      c.state().setVolumeView(VolumeView::CtAngio);
      kept = c.state().caseView();
    }
    VolumeCase c(ctTubes());
    c.state().take(kept);
    QVERIFY(c.state().volumeView() == VolumeView::CtAngio);
    c.state().setResultBeside(true);
    kept = c.state().caseView();
    c.state().setResultBeside(false);
    c.state().setVolumeView(VolumeView::None);
    c.state().take(kept);
    QVERIFY(c.state().volumeView() == VolumeView::Mip);
    QVERIFY(c.state().resultBeside());
    QVERIFY(!c.state().surface());
    c.state().setVolumeView(VolumeView::None);
    kept = c.state().caseView();
    c.state().setVolumeView(VolumeView::MrAngio);
    c.state().take(kept);
    QVERIFY(c.state().volumeView() == VolumeView::None);
  }

  void theResultStandsBesideTheImage() {
    VolumeCase c(ctTubes());
    c.models().runs.run();
    SurfaceView* beside = c.window->views().comparison();
    QVERIFY(beside->isHidden());
    c.key(Qt::Key_B, kCtrlShift);
    QTRY_VERIFY(beside->isVisible());
    QTRY_VERIFY(beside->width() > 20 && std::abs(beside->width() - c.surface->width()) < 3);
    QVERIFY(!c.state().surface() && c.state().volumeView() == VolumeView::Mip);
    QCOMPARE(c.window->views().titleOf(beside), QString("3D, result"));
    c.surface->grabFramebuffer();
    const QImage result = beside->grabFramebuffer();
    QVERIFY(whitePixels(result) > 300);
    // One camera: a drag in either turns both.
    const QPoint from = c.surface->rect().center();
    const QImage image = c.surface->grabFramebuffer();
    QTest::mousePress(beside, Qt::LeftButton, Qt::NoModifier, from);
    QTest::mouseMove(beside, from + QPoint(40, 20));
    QTest::mouseRelease(beside, Qt::LeftButton, Qt::NoModifier, from + QPoint(40, 20));
    QVERIFY(beside->grabFramebuffer() != result);
    QVERIFY(c.surface->grabFramebuffer() != image);
    // Marching cubes take its place, and the surface is back.
    c.state().setComparison(true);
    QVERIFY(!c.state().resultBeside() && c.state().surface());
    QVERIFY(whitePixels(beside->grabFramebuffer()) < 100);
    c.key(Qt::Key_B, kCtrlShift);
    QVERIFY(c.state().resultBeside() && !c.state().comparison());
    c.key(Qt::Key_B, kCtrlShift);
    QTRY_VERIFY(beside->isHidden());
    QVERIFY(c.state().surface());
  }

  void volumesAreMadeReadyOffTheWindowsThread() {
    WindowCase threaded(makeThreadedJobRunner);
    threaded.models().files.take(ctTubes());
    threaded.state().setVolumeView(VolumeView::CtAngio);
    QTRY_VERIFY_WITH_TIMEOUT(
        bodyPixels(threaded.window->views().surface()->grabFramebuffer()) > 300, kPatienceMs);
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestVolume3d>(argc, argv); }
#include "tst_volume_3d.moc"
