// SPDX-License-Identifier: BSD-3-Clause
#include <QSet>

#include "tests/gui/window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// How many shades of grey a picture has.
int shades(const QImage& picture) {
  QSet<int> found;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) found.insert(qGray(picture.pixel(x, y)));
  return static_cast<int>(found.size());
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
};

int main(int argc, char** argv) { return test::runWindowTests<TestPanes>(argc, argv); }
#include "tst_panes.moc"
