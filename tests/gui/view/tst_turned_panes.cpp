// SPDX-License-Identifier: BSD-3-Clause
#include <QLabel>
#include <cmath>
#include <numbers>

#include "core/base/formatted.h"
#include "tests/gui/window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

using Eigen::Vector3d;

const Vector3d kSlope(2.0, -3.0, 5.0);

/// Rises linearly, in an oblique frame and with voxels that are no cubes.
Source rampSource() {
  Geometry g;
  g.size = {40, 36, 24};
  g.spacing = {0.7, 0.8, 1.6};
  g.direction = Eigen::AngleAxisd(0.3, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  g.origin = {-12.0, 20.0, 75.0};
  Volume<float> image(g);
  for (std::size_t p = 0; p < image.voxels.size(); ++p) {
    const Index3 v = g.indexOf(p);
    image.voxels[p] = static_cast<float>(kSlope.dot(g.toPhysical(Vector3d(v[0], v[1], v[2]))));
  }
  return makeSource(image, "ramp");
}

/// Drags a knob of the crosshair anticlockwise about its spot.
void turnBy(SliceView* pane, double degrees) {
  pane->grabFramebuffer();
  const QPointF centre = pane->positionOf(pane->cursor());
  const QPointF knob = pane->knobs().front();
  const double angle = degrees * std::numbers::pi / 180.0;
  const auto at = [&](double share) {
    const QPointF way = knob - centre;
    const double c = std::cos(share * angle), s = std::sin(share * angle);
    return (centre + QPointF(way.x() * c + way.y() * s, way.y() * c - way.x() * s)).toPoint();
  };
  sendMouse(*pane, QEvent::MouseButtonPress, at(0.0), Qt::LeftButton, Qt::LeftButton);
  for (const double share : {0.25, 0.5, 0.75, 1.0})
    sendMouse(*pane, QEvent::MouseMove, at(share), Qt::NoButton, Qt::LeftButton);
  sendMouse(*pane, QEvent::MouseButtonRelease, at(1.0), Qt::LeftButton, Qt::NoButton);
}

Vector3d normalOf(SliceView* pane) {
  const PaneAxes& axes = pane->scene().axes();
  return axes.rightLps.cross(axes.upLps);
}

double degreesBetween(const Vector3d& a, const Vector3d& b) {
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

}  // namespace

class TestTurnedPanes : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void aKnobTurnsTheOtherPlanesAboutTheCrosshair() {
    WindowCase c;
    c.models().files.take(rampSource());
    ViewGrid& views = c.window->views();
    std::array<Vector3d, 3> before;
    for (int plane = 0; plane < 3; ++plane)
      before[static_cast<std::size_t>(plane)] = normalOf(views.slice(plane));
    const Vector3d crosshair = views.crosshair();
    const QPointF seen = views.slice(0)->positionOf(crosshair);
    const double window = views.slice(2)->windowWidth();
    turnBy(views.slice(2), 30.0);
    QCOMPARE(views.slice(2)->windowWidth(), window);
    QVERIFY((views.crosshair() - crosshair).norm() < 1e-9);
    QVERIFY(degreesBetween(normalOf(views.slice(2)), before[2]) < 1e-3);
    for (const int plane : {0, 1}) {
      const double degrees =
          degreesBetween(normalOf(views.slice(plane)), before[static_cast<std::size_t>(plane)]);
      QVERIFY2(std::abs(degrees - 30.0) < 1.5, qPrintable(QString::number(degrees)));
    }
    QVERIFY(std::abs(normalOf(views.slice(0)).dot(normalOf(views.slice(1)))) < 1e-9);
    // The crosshair is seen where it was.
    QVERIFY(QLineF(views.slice(0)->positionOf(crosshair), seen).length() < 1.0);
    // The arms follow the pointer: a knob lies where it was let go.
    views.slice(2)->grabFramebuffer();
    const QPointF centre = views.slice(2)->positionOf(crosshair);
    bool found = false;
    for (const QPointF& knob : views.slice(2)->knobs()) {
      const double angle = std::fmod(QLineF(centre, knob).angle() + 360.0, 90.0);
      found = found || std::abs(angle - 30.0) < 1.5;
    }
    QVERIFY(found);
    QTest::keyClick(views.slice(0), Qt::Key_T);
    QVERIFY(!c.state().turn().turned());
    for (int plane = 0; plane < 3; ++plane)
      QVERIFY(degreesBetween(normalOf(views.slice(plane)),
                             before[static_cast<std::size_t>(plane)]) < 1e-3);
  }

  void valuesPlacesAndClicksAreTrueInTurnedPlanes() {
    WindowCase c;
    c.models().files.take(rampSource());
    ViewGrid& views = c.window->views();
    turnBy(views.slice(2), 25.0);
    turnBy(views.slice(0), -20.0);
    auto* bar = c.find<QLabel>("hover");
    const Geometry& g = c.models().document.image()->geometry;
    for (int plane = 0; plane < 3; ++plane) {
      SliceView* pane = views.slice(plane);
      for (const QPoint& off : {QPoint(9, 14), QPoint(-21, 6)}) {
        const QPoint at = pane->positionOf(views.crosshair()).toPoint() + off;
        const Vector3d lps = pane->lpsAt(at);
        const auto probe = pane->scene().probe(lps);
        QVERIFY(probe && g.holds(lps, -1.0));
        // A pixel has the value of its middle.
        const double pixel = g.voxelMm() * kSlope.norm();
        QVERIFY(std::abs(probe->value - kSlope.dot(lps)) < pixel);
        const Vector3d index = g.toIndex(lps);
        for (int a = 0; a < 3; ++a)
          QVERIFY(std::abs(index[a] - probe->voxel[static_cast<std::size_t>(a)]) < 0.51);
        sendMouse(*pane, QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
        QVERIFY2(bar->text().contains(QString::fromStdString(placeText(lps))),
                 qPrintable(bar->text()));
      }
      const QPoint at = pane->positionOf(views.crosshair()).toPoint() + QPoint(13, -11);
      const Vector3d lps = pane->lpsAt(at);
      sendMouse(*pane, QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
      sendMouse(*pane, QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton);
      QVERIFY2((views.crosshair() - lps).norm() < 1e-6,
               qPrintable(QString::number((views.crosshair() - lps).norm())));
      for (int other = 0; other < 3; ++other) {
        const SliceScene& scene = views.slice(other)->scene();
        QVERIFY(std::abs(scene.plane().fromLps(lps)[2]) < 0.501);
      }
    }
  }

  void patientAxesAreSwitched() {
    WindowCase c;
    c.models().files.take(rampSource());
    SliceView* axial = c.window->views().slice(2);
    QVERIFY(degreesBetween(normalOf(axial), Vector3d(0, 0, -1)) > 5.0);
    QTest::keyClick(c.window.get(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY((axial->scene().axes().rightLps - Vector3d(1, 0, 0)).norm() < 1e-9);
    QVERIFY((axial->scene().axes().upLps - Vector3d(0, -1, 0)).norm() < 1e-9);
    const int slice = axial->slice();
    const double before = axial->cursor()[2];
    QTest::keyClick(axial, Qt::Key_Up);
    QCOMPARE(axial->slice(), slice + 1);
    QVERIFY(axial->cursor()[2] > before);
    QTest::keyClick(c.window.get(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(degreesBetween(normalOf(axial), Vector3d(0, 0, -1)) > 5.0);
  }

  void theCaseKeepsHowTheyLie() {
    WindowCase c;
    c.models().files.take(rampSource());
    c.state().setPatientAxes(true);
    turnBy(c.window->views().slice(1), 15.0);
    QVERIFY(c.state().turn().turned());
    const CaseView view = c.state().caseView();
    WindowCase next;
    next.models().files.take(rampSource());
    next.state().take(view);
    QVERIFY(next.state().turn() == c.state().turn());
    for (int plane = 0; plane < 3; ++plane)
      QVERIFY(
          (normalOf(next.window->views().slice(plane)) - normalOf(c.window->views().slice(plane)))
              .norm() < 1e-9);
    // The next volume lies as it was taken.
    next.models().files.take(twoTubes());
    QVERIFY(next.state().turn() == PlaneTurn());
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestTurnedPanes>(argc, argv); }
#include "tst_turned_panes.moc"
