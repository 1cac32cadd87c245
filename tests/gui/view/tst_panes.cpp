// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <QDoubleSpinBox>
#include <QEnterEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSet>

#include "core/base/formatted.h"
#include "io/volume/image_write.h"
#include "tests/gui/window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

void enter(QWidget& widget) {
  const QPointF at = widget.rect().center();
  QEnterEvent event(at, at, widget.mapToGlobal(at));
  QApplication::sendEvent(&widget, &event);
}

void click(QWidget& widget, const QPoint& at) {
  sendMouse(widget, QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
  // No hand is that still.
  sendMouse(widget, QEvent::MouseMove, at + QPoint(1, 1), Qt::NoButton, Qt::LeftButton);
  sendMouse(widget, QEvent::MouseButtonRelease, at + QPoint(1, 1), Qt::LeftButton, Qt::NoButton);
}

void hover(QWidget& widget, const QPoint& at) {
  sendMouse(widget, QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
}

/// How many shades of grey a picture has.
int shades(const QImage& picture) {
  QSet<int> found;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) found.insert(qGray(picture.pixel(x, y)));
  return static_cast<int>(found.size());
}

/// Of the lower left corner, where the lines on the pointer are.
QImage corner(SliceView* view) {
  const QImage frame = view->grabFramebuffer();
  return frame.copy(0, frame.height() - 64, frame.width() / 2, 64);
}

/// Two tubes on the disk, as a CT.
QString saveCt(const WindowCase& c) {
  QString path = c.folder.filePath("ct.mha");
  writeVolume(*twoTubes().image, path.toStdString());
  QFile file(path);
  [[maybe_unused]] const bool read = file.open(QIODevice::ReadOnly);
  QByteArray bytes = file.readAll();
  file.close();
  bytes.replace("ElementType", "Modality = MET_MOD_CT\nElementType");
  [[maybe_unused]] const bool written = file.open(QIODevice::WriteOnly);
  file.write(bytes);
  return path;
}

}  // namespace

class TestPanes : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void interpolationIsSwitchedAndRemembered() {
    auto image = std::make_shared<Volume<float>>(Geometry{{8, 8, 8}});
    for (std::size_t p = 0; p < image->voxels.size(); ++p)
      image->voxels[p] = static_cast<float>(image->geometry.indexOf(p)[0] % 2);
    CaseView view;
    {
      WindowCase c;
      c.models().files.take(makeSource(*image, "stripes"));
      SliceView* axial = c.window->views().slice(2);
      axial->setCrosshairVisible(false);
      const QRect middle(axial->width() / 4, axial->height() / 4, axial->width() / 2,
                         axial->height() / 8);
      const int smooth = shades(axial->grabFramebuffer().copy(middle));
      QTest::keyClick(c.window.get(), Qt::Key_T, Qt::ControlModifier);
      const int plain = shades(axial->grabFramebuffer().copy(middle));
      QVERIFY2(smooth > 20 && plain <= 3, qPrintable(QString("%1 %2").arg(smooth).arg(plain)));
      QVERIFY(!c.window->findChild<QAction*>("interpolate")->isChecked());
      view = c.state().caseView();
    }
    WindowCase c;
    QVERIFY(!c.state().interpolated());
    c.window->findChild<QAction*>("interpolate")->trigger();
    QVERIFY(c.state().interpolated());
    c.state().take(view);
    QVERIFY(!c.state().interpolated());
    WindowCase next;
    QVERIFY(next.state().interpolated());  // the case's switch is not the user's
  }

  void aClickSetsTheCrosshairAndADragDoesNot() {
    WindowCase c;
    c.models().files.take(twoTubes());
    ViewGrid& views = c.window->views();
    SliceView* axial = views.slice(2);
    const double window = axial->windowWidth(), level = axial->windowLevel();
    const QPoint at(axial->width() / 3, axial->height() / 3);
    const Eigen::Vector3d expected = axial->lpsAt(at);
    click(*axial, at);
    for (int plane = 0; plane < 3; ++plane)
      QVERIFY((views.slice(plane)->cursor() - expected).norm() < 1e-6);
    QCOMPARE(axial->windowWidth(), window);
    QCOMPARE(axial->windowLevel(), level);
    drag(*axial, Qt::LeftButton, at + QPoint(40, 40), at + QPoint(90, 70));
    QVERIFY((axial->cursor() - expected).norm() < 1e-6);
    QVERIFY(axial->windowWidth() > window);
    click(*axial, {1, axial->height() / 2});  // beside the image, or on its edge
    c.clickTool("toolSeed");
    click(*axial, at + QPoint(20, 0));
    QCOMPARE(c.models().document.seeds().size(), std::size_t{1});
    QVERIFY((axial->cursor() - c.models().document.seeds().front()).norm() > 1.0);
  }

  void aClickOnTheSurfaceTakesTheSlicesThere() {
    WindowCase c;
    c.models().files.take(twoTubes());
    auto mesh = std::make_shared<TriMesh>();
    const Eigen::Vector3d centre = c.models().document.image()->geometry.toPhysical({8, 9, 10});
    for (const Eigen::Vector3d& corner : {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, -1, -1),
                                          Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(-1, -1, 1)})
      mesh->points.push_back(centre + 2.0 * corner);
    mesh->triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    ViewGrid& views = c.window->views();
    SurfaceView* surface = views.surface();
    surface->setSurface(mesh);
    surface->viewFrom('A');
    surface->grabFramebuffer();
    vtkCamera* camera =
        surface->renderWindow()->GetRenderers()->GetFirstRenderer()->GetActiveCamera();
    const Eigen::Vector3d eye(camera->GetPosition());
    const Eigen::Vector3d before = views.crosshair();
    const QPoint at = surface->positionOf(centre).toPoint();
    drag(*surface, Qt::LeftButton, at, at + QPoint(30, 0));
    QVERIFY((views.crosshair() - before).norm() < 1e-9);
    surface->viewFrom('A');
    click(*surface, surface->positionOf(centre).toPoint());
    const Eigen::Vector3d found = views.crosshair();
    QVERIFY2((found - centre).norm() < 2.5, qPrintable(QString::number((found - centre).norm())));
    QVERIFY((views.slice(0)->cursor() - found).norm() < 1e-9);
    click(*surface, {3, 3});  // on nothing
    QVERIFY((views.crosshair() - found).norm() < 1e-9);
    c.clickTool("toolSeed");
    surface->viewFrom('P');
    click(*surface, surface->positionOf(centre).toPoint());
    QVERIFY((views.crosshair() - found).norm() < 1e-9);
  }

  void keysActOnThePaneThatTheMouseEnters() {
    WindowCase c;
    c.models().files.take(twoTubes());
    ViewGrid& views = c.window->views();
    SliceView *axial = views.slice(2), *coronal = views.slice(1);
    enter(*axial);
    QVERIFY(axial->hasFocus());
    enter(*coronal);
    QVERIFY(coronal->hasFocus());
    const int axialSlice = axial->slice(), coronalSlice = coronal->slice();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Up);
    QCOMPARE(axial->slice(), axialSlice);
    QVERIFY(coronal->slice() != coronalSlice);
    enter(*views.surface());
    QVERIFY(views.surface()->hasFocus());
    // A list or a chooser is no editor.
    c.find<QComboBox>("layer")->setFocus();
    enter(*axial);
    QVERIFY(axial->hasFocus());
  }

  void whoeverTypesKeepsTheKeyboard() {
    WindowCase c;
    c.models().files.take(twoTubes());
    SliceView* axial = c.window->views().slice(2);
    auto* spin = c.find<QDoubleSpinBox>("spin", "field:levelset.xi");
    auto* line = spin->findChild<QLineEdit*>();
    // A click into the text, before the first digit.
    QTest::mouseClick(line, Qt::LeftButton, {}, line->rect().center());
    QVERIFY(spin->hasFocus());
    enter(*axial);
    QVERIFY(spin->hasFocus());
    QTest::keyClick(spin, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(spin, "31");
    enter(*axial);
    QVERIFY(spin->hasFocus());
    QTest::keyClick(spin, Qt::Key_Return);
    QCOMPARE(spin->value(), 31.0);
    enter(*axial);
    QVERIFY(axial->hasFocus());
    // The arrows of a spin box take the focus too, but nobody types.
    QTest::mouseClick(spin, Qt::LeftButton, {}, QPoint(spin->width() - 6, 5));
    QVERIFY(spin->hasFocus() && spin->value() > 31.0);
    enter(*axial);
    QVERIFY(axial->hasFocus());
    // Digits choose windows, but not while one is typed.
    const double window = axial->windowWidth();
    spin->setFocus(Qt::TabFocusReason);
    enter(*axial);
    QVERIFY(spin->hasFocus());
    QTest::keyClick(spin, Qt::Key_3);
    QCOMPARE(axial->windowWidth(), window);
  }

  void thePaneSaysWhatIsUnderThePointer() {
    WindowCase c;
    c.window->open(saveCt(c));
    QTRY_VERIFY(c.models().document.hasCase());
    SliceView* axial = c.window->views().slice(2);
    auto* bar = c.find<QLabel>("hover");
    const QImage away = corner(axial);
    const QPoint at = axial->rect().center() + QPoint(7, 9);
    hover(*axial, at);
    const QImage over = corner(axial);
    QVERIFY(over != away);
    c.models().live.setOn(false);  // it draws in the corner, too
    const std::shared_ptr<const Volume<float>> image = c.models().document.image();
    const auto saidAt = [&](int slice) {
      const Eigen::Vector3d index = image->geometry.toIndex(axial->lpsAt(at));
      const auto i = static_cast<int>(std::lround(index[0]));
      const auto j = static_cast<int>(std::lround(index[1]));
      return QString("%1 HU, voxel %2,%3,%4, %5")
          .arg(QString::number(static_cast<double>(image->at(i, j, slice)), 'g', 5))
          .arg(i)
          .arg(j)
          .arg(slice)
          .arg(QString::fromStdString(placeText(axial->lpsAt(at))));
    };
    QCOMPARE(bar->text(), "Source " + saidAt(axial->slice()));
    // The slice goes on under a pointer that rests.
    QTest::keyClick(axial, Qt::Key_Up);
    QCOMPARE(bar->text(), "Source " + saidAt(axial->slice()));
    QVERIFY(corner(axial) != over);
    QTest::keyClick(axial, Qt::Key_Down);
    QVERIFY(corner(axial) == over);
    QTest::mouseClick(c.find<QWidget>("runToHere", "step:vesselness"), Qt::LeftButton);
    c.choose(c.find<QComboBox>("layer"), static_cast<int>(Layer::Vesselness));
    QVERIFY2(bar->text().startsWith("Vesselness ") && !bar->text().contains("HU"),
             qPrintable(bar->text()));
    c.choose(c.find<QComboBox>("layer"), static_cast<int>(Layer::Source));
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(axial, &leave);
    QVERIFY(bar->text().isEmpty());
    QVERIFY(corner(axial) == away);
  }

  void picturesDoNotTellWhereTheMouseIs() {
    WindowCase c;
    c.models().files.take(twoTubes());
    SliceView* axial = c.window->views().slice(2);
    const QImage away = axial->picture(1);
    hover(*axial, axial->rect().center());
    QVERIFY(!c.find<QLabel>("hover")->text().isEmpty());
    QVERIFY(axial->picture(1) == away);
    hover(*axial, axial->rect().center() + QPoint(1, 0));
    QVERIFY(!c.find<QLabel>("hover")->text().isEmpty());
  }

  void otherFilesHaveNoUnit() {
    WindowCase c;
    c.models().files.take(twoTubes());
    SliceView* axial = c.window->views().slice(2);
    hover(*axial, axial->rect().center());
    const QString text = c.find<QLabel>("hover")->text();
    QVERIFY2(text.startsWith("Source ") && !text.contains("HU"), qPrintable(text));
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestPanes>(argc, argv); }
#include "tst_panes.moc"
