// SPDX-License-Identifier: BSD-3-Clause
#include <QMenu>
#include <QUndoStack>

#include "core/mesh/mesh_edges.h"
#include "gui/pane/surface_feed.h"
#include "tests/gui/window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

using Eigen::Vector3d;

int lit(const QImage& picture) {
  int red = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QRgb p = picture.pixel(x, y);
      if (qRed(p) > 90 && qRed(p) > 2 * qBlue(p)) ++red;
    }
  return red;
}

/// Two tubes, meshed and seen from the front.
struct Tubes : WindowCase {
  Tubes() {
    models().files.take(twoTubes());
    models().runs.run(Step::Smooth);
    state().setVolumeView(VolumeView::None);
    surface = window->views().surface();
    mesh = window->views().surfaceFeed()->shown();
    const MeshComponents parts = meshComponents(*mesh);
    // A place of each part that faces the eye, which looks from above or from the front at tubes
    // that lie across.
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < mesh->triangles.size(); ++i)
      if (parts.label[i] == 0)
        for (const std::uint32_t v : mesh->triangles[i]) box.extend(mesh->points[v]);
    const bool above = box.sizes().z() < box.sizes().y();
    surface->viewFrom(above ? 'S' : 'A');
    const Vector3d toEye = above ? Vector3d(0, 0, 1) : Vector3d(0, -1, 0);
    front.resize(parts.count);
    std::vector<double> best(parts.count, 0.0);
    for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
      const auto& t = mesh->triangles[i];
      const Vector3d &a = mesh->points[t[0]], &b = mesh->points[t[1]], &c = mesh->points[t[2]];
      const double facing = (b - a).cross(c - a).normalized().dot(toEye);
      const Vector3d place = (a + b + c) / 3.0;
      const double middle = (place - box.center()).dot(box.sizes().normalized());
      const double score = facing - 0.02 * std::abs(middle);
      if (score < best[parts.label[i]]) continue;
      best[parts.label[i]] = score;
      front[parts.label[i]] = place;
    }
    surface->grabFramebuffer();
  }

  QMenu* menuAt(const Vector3d& place) {
    const QPoint at = surface->positionOf(place).toPoint();
    sendMouse(*surface, QEvent::MouseButtonPress, at, Qt::RightButton, Qt::RightButton);
    sendMouse(*surface, QEvent::MouseButtonRelease, at, Qt::RightButton, Qt::NoButton);
    QMenu* menu = nullptr;
    for (auto* shown : window->findChildren<QMenu*>("portMenu"))
      if (shown->isVisible()) menu = shown;
    return menu;
  }
  void choose(const Vector3d& place, const char* entry) {
    QMenu* menu = menuAt(place);
    QVERIFY(menu && menu->findChild<QAction*>(entry));
    QVERIFY(menu->findChild<QAction*>(entry)->isEnabled());
    menu->findChild<QAction*>(entry)->trigger();
    menu->close();
  }
  /// The row of the table whose inner point lies nearest to a place.
  std::size_t rowAt(const Vector3d& place) {
    const std::vector<Vector3d> inner = models().results.innerPoints();
    std::size_t best = 0;
    for (std::size_t i = 0; i < inner.size(); ++i)
      if ((inner[i] - place).norm() < (inner[best] - place).norm()) best = i;
    return best;
  }

  SurfaceView* surface = nullptr;
  std::shared_ptr<const TriMesh> mesh;
  std::vector<Vector3d> front;
};

}  // namespace

class TestParts : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void aPartIsHiddenAndComesBack() {
    Tubes c;
    QCOMPARE(c.front.size(), std::size_t{2});
    QVERIFY(!c.find<QAction>("showParts")->isEnabled());
    const int all = lit(c.surface->grabFramebuffer());
    c.choose(c.front[0], "hidePart");
    const int left = lit(c.surface->grabFramebuffer());
    QVERIFY2(left > all / 4 && left < 3 * all / 4, qPrintable(QString("%1 %2").arg(left).arg(all)));
    // Nothing is there any more, neither to see nor to click; the ticks are as they were.
    QMenu* menu = c.menuAt(c.front[0]);
    QVERIFY(!menu->findChild<QAction*>("hidePart")->isEnabled());
    menu->close();
    for (const ComponentRow& row : c.models().results.components()) QVERIFY(row.ticked);
    c.choose(c.front[1], "hidePart");
    QCOMPARE(lit(c.surface->grabFramebuffer()), 0);
    QTest::keyClick(c.window.get(), Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(std::abs(lit(c.surface->grabFramebuffer()) - all) < all / 50);
    QVERIFY(!c.find<QAction>("showParts")->isEnabled());
  }

  void removingTicksTheClickedPartOff() {
    for (const std::size_t part : {0, 1}) {
      Tubes c;
      c.choose(c.front[part], "removePart");
      const std::vector<ComponentRow> rows = c.models().results.components();
      const std::size_t row = c.rowAt(c.front[part]);
      for (std::size_t i = 0; i < rows.size(); ++i) QCOMPARE(rows[i].ticked, i != row);
      c.models().document.undoStack()->undo();
      for (const ComponentRow& r : c.models().results.components()) QVERIFY(r.ticked);
    }
  }

  void keepingOnlyOneTicksTheOthersOffInOneStep() {
    Tubes c;
    const int steps = c.models().document.undoStack()->index();
    c.choose(c.front[1], "keepPart");
    const std::vector<ComponentRow> rows = c.models().results.components();
    const std::size_t row = c.rowAt(c.front[1]);
    for (std::size_t i = 0; i < rows.size(); ++i) QCOMPARE(rows[i].ticked, i == row);
    QCOMPARE(c.models().document.undoStack()->index(), steps + 1);
  }

  void withoutAMeshNothingIsOffered() {
    WindowCase c;
    c.models().files.take(twoTubes());
    SurfaceView* surface = c.window->views().surface();
    sendMouse(*surface, QEvent::MouseButtonPress, {60, 60}, Qt::RightButton, Qt::RightButton);
    sendMouse(*surface, QEvent::MouseButtonRelease, {60, 60}, Qt::RightButton, Qt::NoButton);
    for (const char* entry : {"hidePart", "keepPart", "removePart"})
      QVERIFY(!c.find<QAction>(entry, "portMenu")->isEnabled());
  }

  void slicesLieWhereTheyBelong() {
    WindowCase c;
    const auto image = makeImage();  // a bright ball
    c.models().files.take(makeSource(*image, "ball"));
    c.state().setVolumeView(VolumeView::None);
    c.state().setContours(false);
    ViewGrid& views = c.window->views();
    const Vector3d ball = image->geometry.toPhysical(Vector3d(20, 22, 18));
    views.setCrosshair(ball);
    SurfaceView* surface = views.surface();
    const auto white = [&] {
      const QImage frame = surface->grabFramebuffer();
      double x = 0.0, y = 0.0, n = 0.0;
      for (int row = 0; row < frame.height(); ++row)
        for (int column = 0; column < frame.width(); ++column)
          // The cube of directions in the corner has white letters.
          if ((column > 120 || row < frame.height() - 120) &&
              qGray(frame.pixel(column, row)) > 240) {
            x += column;
            y += row;
            n += 1.0;
          }
      return std::pair(n > 0.0 ? QPointF(x / n, y / n) : QPointF(-1e3, -1e3), n);
    };
    surface->viewFrom('S');
    QVERIFY(white().second < 200.0);  // letters alone
    QTest::keyClick(c.window.get(), Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
    for (const char side : {'S', 'A', 'L', 'P'}) {
      surface->viewFrom(side);
      const auto [middle, count] = white();
      QVERIFY(count > 500.0);
      const double off = QLineF(middle, surface->positionOf(ball)).length();
      // The nearer half of an oblique disc looks larger.
      QVERIFY2(off < 0.35 * std::sqrt(count / 3.14),
               qPrintable(QString("%1 %2").arg(side).arg(off)));
    }
    // They follow the panes: away from the ball there is nothing white.
    surface->viewFrom('S');
    const double before = white().second;
    views.slice(2)->setSlice(2);
    views.slice(0)->setSlice(1);
    views.slice(1)->setSlice(1);
    QVERIFY(white().second < 0.3 * before);
    // The case keeps it.
    WindowCase next;
    next.state().take(c.state().caseView());
    QVERIFY(next.state().slices3d());
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestParts>(argc, argv); }
#include "tst_parts.moc"
