// SPDX-License-Identifier: BSD-3-Clause
#include <QLabel>
#include <QSlider>

#include "gui/model/result_text.h"
#include "tests/gui/window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// Pixels in warm and in cold colours.
struct Coloured {
  int warm = 0, cold = 0;

  explicit Coloured(const QImage& picture) {
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const QRgb p = picture.pixel(x, y);
        if (qRed(p) > qBlue(p) + 40) ++warm;
        if (qBlue(p) > qRed(p) + 40) ++cold;
      }
  }
};

QImage shown(SliceView* view) {
  view->setCrosshairVisible(false);
  const QImage frame = view->grabFramebuffer();
  return frame.copy(frame.rect().adjusted(60, 60, -60, -60));  // without letters and lines
}

}  // namespace

class TestOverlays : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void vesselnessLiesOverTheSource() {
    WindowCase c;
    c.models().files.take(twoTubes());
    c.state().setContours(false);
    SliceView* axial = c.window->views().slice(2);
    c.choose(c.find<QComboBox>("overlay"), 1);
    QVERIFY(c.state().overlay() == Layer::Vesselness);
    QCOMPARE(overlayText(c.models().results, Layer::Vesselness).text,
             QString("No vesselness yet to lay over it"));
    QCOMPARE(Coloured(shown(axial)).warm, 0);
    c.models().runs.run(Step::Vesselness);
    QVERIFY(Coloured(shown(axial)).warm > 100);
    QCOMPARE(overlayText(c.models().results, Layer::Vesselness).text,
             QString("Vesselness over it"));
    QVERIFY(c.state().layer() == Layer::Source);
    // The pointer tells both values.
    const auto image = c.models().results.layer(Layer::Vesselness);
    const QPoint at = axial->rect().center();
    sendMouse(*axial, QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
    const QString text = c.find<QLabel>("hover")->text();
    QVERIFY2(text.startsWith("Source ") && text.contains("(Vesselness "), qPrintable(text));
    QVERIFY(axial->scene().probe(axial->lpsAt(at))->overlay.has_value());
    // Another parameter: what is shown is of the earlier ones, and says so.
    c.models().document.setField("vesselness.sigmaMaxMm", 2.5);
    QVERIFY(overlayText(c.models().results, Layer::Vesselness).text.contains("out of date"));
  }

  void speedIsWarmInVesselsAndColdOutside() {
    WindowCase c;
    c.models().files.take(twoTubes());
    c.state().setContours(false);
    c.models().runs.run(Step::Vesselness);
    QTest::keyClick(c.window.get(), Qt::Key_V, Qt::ShiftModifier);
    QVERIFY(c.state().overlay() == Layer::Speed);
    SliceView* axial = c.window->views().slice(2);
    const Coloured found(shown(axial));
    QVERIFY2(found.warm > 50 && found.cold > 500,
             qPrintable(QString("%1 %2").arg(found.warm).arg(found.cold)));
    QTest::keyClick(c.window.get(), Qt::Key_V, Qt::ShiftModifier);
    QVERIFY(!c.state().overlay());
    QCOMPARE(Coloured(shown(axial)).cold, 0);
  }

  void theSliderSetsTheOpacity() {
    WindowCase c;
    c.models().files.take(twoTubes());
    c.models().runs.run(Step::Vesselness);
    c.state().setContours(false);
    SliceView* axial = c.window->views().slice(2);
    const QImage bare = shown(axial);
    c.choose(c.find<QComboBox>("overlay"), 1);
    auto* slider = c.find<QSlider>("overlayOpacity");
    QVERIFY(slider->isEnabled());
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Home);
    QCOMPARE(c.state().overlayOpacity(), 0.0);
    QVERIFY(shown(axial) == bare);
    QTest::keyClick(slider, Qt::Key_End);
    QCOMPARE(c.state().overlayOpacity(), 1.0);
    QVERIFY(shown(axial) != bare);
  }

  void theCaseKeepsIt() {
    WindowCase c;
    c.state().setOverlay(Layer::Speed);
    c.state().setOverlayOpacity(0.3);
    WindowCase next;
    next.state().take(c.state().caseView());
    QVERIFY(next.state().overlay() == Layer::Speed);
    QCOMPARE(next.state().overlayOpacity(), 0.3);
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestOverlays>(argc, argv); }
#include "tst_overlays.moc"
