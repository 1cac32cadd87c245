// SPDX-License-Identifier: BSD-3-Clause
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/base/formatted.h"
#include "core/quality/quality_gates.h"
#include "gui/inspector/histogram_widget.h"
#include "gui/inspector/quality_grid.h"
#include "gui/inspector/worst_list.h"
#include "tests/gui/window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// In the colour of triangles that are lit up.
int litPixels(const QImage& picture) {
  int lit = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor c = picture.pixelColor(x, y);
      if (c.red() < 60 && c.green() > 230 && c.blue() > 180 && c.blue() < 245) ++lit;
    }
  return lit;
}

/// A window after a run of two tubes, with nothing but the surface in its 3D pane.
struct Inspected : WindowCase {
  Inspected() {
    models().files.take(twoTubes());
    click(find<QPushButton>("run"));
    state().setVolumeView(VolumeView::None);
  }
  /// Another scan in place of the tubes.
  void scan(PhantomKind kind) {
    PhantomParams params;
    params.kind = kind;
    params.size = {40, 40, 40};
    params.radius = 3.0;
    models().files.take(makeSource(makePhantom(params).image, "phantom"));
  }
  void openTab(int index) {
    auto* bar = find<QTabWidget>("inspectorTabs")->tabBar();
    QTest::mouseClick(bar, Qt::LeftButton, Qt::NoModifier, bar->tabRect(index).center());
  }
  void show(MeshKind kind) { choose(find<QComboBox>("meshShown"), static_cast<int>(kind)); }
  QImage picture3d() { return window->views().surface()->grabFramebuffer(); }
  QString text(const char* label) { return find<QLabel>(label)->text(); }
};

int rowOf(const QTableWidget& table, const QString& title) {
  for (int row = 0; row < table.rowCount(); ++row)
    if (table.verticalHeaderItem(row)->text() == title) return row;
  return -1;
}

}  // namespace

class TestInspector : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theBetterValueOfARowIsMarked() {
    Inspected c;
    auto* grid = c.find<QualityGrid>("quality");
    const auto marked = [&](const QString& title, MeshKind kind) {
      const QTableWidgetItem* cell = grid->item(rowOf(*grid, title), static_cast<int>(kind));
      const bool star = cell->text().startsWith(QStringLiteral("★"));
      return star == cell->font().bold() && star;
    };
    // Two tubes: neither mesh smooths angles away, and marching cubes has needles.
    for (const char* title : {"Min angle, mean, °", "Skewness, mean", "Aspect ratio, most"}) {
      QVERIFY2(marked(title, MeshKind::Exported) || marked(title, MeshKind::Unsmoothed), title);
      QVERIFY2(!marked(title, MeshKind::MarchingCubes), title);
    }
    for (const char* title : {"Triangles", "Area, mm²", "Closed"})
      for (int kind = 0; kind < kMeshKindCount; ++kind)
        QVERIFY2(!marked(title, static_cast<MeshKind>(kind)), title);
  }

  void gatesSayWhyAndWhatHelps() {
    Inspected c;
    c.openTab(1);
    QVERIFY2(c.text("gate:solver").contains("passes"), qPrintable(c.text("gate:solver")));
    QVERIFY2(c.text("gate:print").contains("fails, 1 of"), qPrintable(c.text("gate:print")));
    QVERIFY(c.text("limits:print").contains("Parts that do not hang together fall apart."));
    QVERIFY(c.text("limits:print").contains(QStringLiteral("at\u00a0most\u00a01<")));
    QVERIFY(c.text("limits:print").contains("untick them"));
    QVERIFY(!c.text("limits:solver").contains("Flat triangles"));
    QVERIFY(c.find<QPushButton>("fixRho")->isHidden());
    c.show(MeshKind::MarchingCubes);
    QVERIFY(c.text("gate:solver").contains("fails"));
    QVERIFY(c.text("limits:solver").contains("Flat triangles make flat cells"));
    // A smaller rho does not change marching cubes; our mesher is in use already. One reason is
    // given once.
    QCOMPARE(c.text("limits:solver").count("Flat triangles"), qsizetype(1));
    QVERIFY(c.find<QPushButton>("fixRho")->isHidden());
    QVERIFY(!c.find<QPushButton>("fixMesher")->isEnabled());
    c.show(MeshKind::Exported);

    auto* parts = c.find<QPushButton>("fixParts");
    QVERIFY(parts->isVisible() && parts->isEnabled() && c.find<QLabel>("fixThen")->isHidden());
    QTRY_VERIFY(!parts->visibleRegion().isEmpty());
    c.click(parts);
    QVERIFY(c.models().document.parameters().segmentation.keep == KeepComponents::Largest);
    QVERIFY(!parts->isEnabled() && !c.find<QLabel>("fixThen")->isHidden());
    c.click(c.find<QPushButton>("run"));
    QVERIFY2(c.text("gate:print").contains("passes"), qPrintable(c.text("gate:print")));
    QVERIFY(parts->isHidden() && c.find<QLabel>("fixThen")->isHidden());
    c.clickTool("undo");
    QVERIFY(c.models().document.parameters().segmentation.keep == KeepComponents::All);
  }

  void theMesherIsProposedForMarchingCubes() {
    Inspected c;
    c.models().document.setField("surface.method", std::string("marching-cubes"));
    c.click(c.find<QPushButton>("run"));
    c.openTab(1);
    c.show(MeshKind::Unsmoothed);
    QVERIFY2(c.text("gate:solver").contains("fails"), qPrintable(c.text("gate:solver")));
    auto* mesher = c.find<QPushButton>("fixMesher");
    QVERIFY(mesher->isVisible() && mesher->isEnabled());
    QVERIFY(c.find<QPushButton>("fixRho")->isHidden());
    c.click(mesher);
    QVERIFY(c.models().document.parameters().surface.method == SurfaceMethod::AdvancingFront);
    c.click(c.find<QPushButton>("run"));
    QVERIFY(c.text("gate:solver").contains("passes"));
  }

  void theEndsAreClosed() {
    Inspected c;
    // Not the tubes, whose mesh with caps is known.
    c.scan(PhantomKind::Bifurcation);
    c.models().document.setField("surface.border", std::string("open"));
    c.click(c.find<QPushButton>("run"));
    c.openTab(1);
    QVERIFY2(c.text("gate:solver").contains("fails"), qPrintable(c.text("gate:solver")));
    QVERIFY(c.text("limits:solver").contains("Close the ends"));
    auto* caps = c.find<QPushButton>("fixCaps");
    QVERIFY(caps->isVisible() && caps->isEnabled());
    c.click(caps);
    QVERIFY(c.models().document.parameters().surface.border == SurfaceBorder::Cap);
    QVERIFY(!caps->isEnabled());
    QVERIFY(!c.find<QLabel>("fixThen")->isHidden());
    c.click(c.find<QPushButton>("run"));
    QVERIFY2(c.text("gate:solver").contains("passes"), qPrintable(c.text("gate:solver")));
    QVERIFY(caps->isHidden());
    c.clickTool("undo");
    QVERIFY(c.models().document.parameters().surface.border == SurfaceBorder::Open);
  }

  void aSmallerRhoMakesTheMeshFiner() {
    Inspected c;
    // A fork of so few triangles that some are flat.
    c.scan(PhantomKind::Bifurcation);
    c.models().document.setField("surface.edgesAround", FieldValue());
    c.models().document.setField("surface.rho", 2.0);
    c.click(c.find<QPushButton>("run"));
    c.openTab(1);
    QVERIFY2(c.text("gate:solver").contains("fails"), qPrintable(c.text("limits:solver")));
    QVERIFY(c.text("limits:solver").contains("Make surface.rho smaller"));
    auto* smaller = c.find<QPushButton>("fixRho");
    QVERIFY(smaller->isVisible() && smaller->isEnabled());
    const auto rho = [&c] { return c.models().document.parameters().surface.sizing.rho; };
    const auto triangles = [&c] {
      return c.models().results.mesh(MeshKind::Exported)->triangles.size();
    };
    const double before = rho();
    const std::size_t coarse = triangles();
    c.click(smaller);
    QVERIFY(std::abs(rho() - 0.7 * before) < 1e-9 && c.find<QLabel>("fixThen")->isVisible());
    c.click(c.find<QPushButton>("run"));
    QVERIFY(triangles() > coarse);
    // As often as it takes.
    for (int n = 0; n < 8 && !smaller->isHidden(); ++n) {
      c.click(smaller);
      c.click(c.find<QPushButton>("run"));
    }
    QVERIFY2(c.text("gate:solver").contains("passes"), qPrintable(c.text("limits:solver")));
  }

  void thinLoopsAreClosed() {
    Inspected c;
    QVERIFY(c.find<QLabel>("loops")->isHidden() && c.find<QPushButton>("fixLoops")->isHidden());
    c.scan(PhantomKind::Torus);
    c.models().document.setField("wall.smooth", false);
    c.click(c.find<QPushButton>("run"));
    c.openTab(1);
    auto* close = c.find<QPushButton>("fixLoops");
    QVERIFY2(c.text("loops").contains("Loops: 1."), qPrintable(c.text("loops")));
    QVERIFY(close->isVisible() && close->isEnabled());
    c.click(close);
    QVERIFY(c.models().document.parameters().wall.enabled);
    QVERIFY(!close->isEnabled() && c.find<QLabel>("fixThen")->isVisible());
    // A ring is not thin: what no noise explains stays.
    c.click(c.find<QPushButton>("run"));
    QVERIFY(c.text("loops").contains("Loops: 1.") && c.find<QLabel>("fixThen")->isHidden());
    c.clickTool("undo");
    QVERIFY(close->isEnabled());
  }

  void aBarLightsItsTrianglesUp() {
    Inspected c;
    c.openTab(2);
    c.show(MeshKind::MarchingCubes);
    auto* histogram = c.find<HistogramWidget>("histogram");
    QTRY_VERIFY(histogram->isVisible() && histogram->width() > 100);
    const auto& shares = histogram->shares(MeshKind::MarchingCubes);
    const auto bar =
        static_cast<int>(std::max_element(shares.begin(), shares.end()) - shares.begin());
    const QImage before = c.picture3d();
    QCOMPARE(litPixels(before), 0);
    const auto placeOf = [&](int i) { return histogram->barArea(i).center().toPoint(); };
    QTest::mouseClick(histogram, Qt::LeftButton, Qt::NoModifier, placeOf(bar));
    const int some = litPixels(c.picture3d());
    QVERIFY2(some > 50, qPrintable(QString::number(some)));
    // A drag takes all.
    c.drag(histogram, placeOf(0), placeOf(59));
    const int all = litPixels(c.picture3d());
    QVERIFY2(all > some, qPrintable(QString::number(all)));
    QTest::mouseClick(histogram, Qt::LeftButton, Qt::NoModifier, placeOf(bar));
    QVERIFY(c.picture3d() == before);
    // Another measure has other bars.
    QTest::mouseClick(histogram, Qt::LeftButton, Qt::NoModifier, placeOf(bar));
    QVERIFY(litPixels(c.picture3d()) > 50);
    c.choose(c.find<QComboBox>("meshColour"), 4);
    QCOMPARE(litPixels(c.picture3d()), 0);
  }

  void bandsAddUp() {
    Inspected c;
    c.openTab(2);
    for (const TriangleMeasure& measure : triangleMeasures()) {
      c.choose(c.find<QComboBox>("meshColour"),
               1 + static_cast<int>(&measure - triangleMeasures().data()));
      QVERIFY(c.state().meshColour() == &measure);
      const QString text = c.text("bands");
      QCOMPARE(text.count("%"), 3 * static_cast<qsizetype>(bandLimits(measure).size() + 1));
    }
    // The numbers of the whole mesh: of 6 and one more or fewer, of two, and of all others.
    c.choose(c.find<QComboBox>("meshColour"), 6);
    for (const char* band : {">up to 1<", ">2<", ">above 2<"})
      QVERIFY2(c.text("bands").contains(band), band);
    c.choose(c.find<QComboBox>("meshColour"), 1);
    QVERIFY2(c.text("bands").contains("15 to 30 °"), qPrintable(c.text("bands")));
  }

  void theWorstListGoesThere() {
    Inspected c;
    c.openTab(2);
    c.show(MeshKind::MarchingCubes);
    auto* worst = c.find<WorstList>("worst");
    QTRY_VERIFY(worst->isVisible());
    const TriangleMeasure& angle = triangleMeasures().front();
    const TriMesh& mesh = *c.models().results.mesh(MeshKind::MarchingCubes);
    const std::vector<float> values = angle.values(mesh, {});
    const auto expected = worstTriangles(angle, mesh, values, 20);
    QCOMPARE(worst->rowCount(), static_cast<int>(expected.size()));
    QCOMPARE(worst->item(0, 0)->text(),
             QLocale().toString(*std::min_element(values.begin(), values.end()), 'f', 1));
    SurfaceView* view = c.window->views().surface();
    const auto goTo = [&](int row) {
      const auto& [i, j, k] = mesh.triangles[expected[static_cast<std::size_t>(row)]];
      const Eigen::Vector3d centre = (mesh.points[i] + mesh.points[j] + mesh.points[k]) / 3.0;
      QCOMPARE(worst->item(row, 1)->text(), QString::fromStdString(placeText(centre)));
      QVERIFY((c.window->views().crosshair() - centre).norm() < 1e-4);
      const QPointF middle = view->positionOf(centre) - QRectF(view->rect()).center();
      QVERIFY(std::hypot(middle.x(), middle.y()) < 3.0);
      QVERIFY(litPixels(c.picture3d()) > 5);
    };
    QTest::mouseClick(worst->viewport(), Qt::LeftButton, Qt::NoModifier,
                      worst->visualItemRect(worst->item(0, 0)).center());
    goTo(0);
    QTest::keyClick(worst, Qt::Key_Down);
    goTo(1);
    // Back there after a look elsewhere.
    c.window->views().resetViews();
    QTest::mouseClick(worst->viewport(), Qt::LeftButton, Qt::NoModifier,
                      worst->visualItemRect(worst->item(1, 0)).center());
    goTo(1);
  }

  void coloursAreThoseOfTheMeasureChosen() {
    Inspected c;
    std::vector<QImage> pictures{c.picture3d()};
    auto* colour = c.find<QComboBox>("meshColour");
    for (int i = 1; i <= static_cast<int>(triangleMeasures().size()); ++i) {
      c.choose(colour, i);
      pictures.push_back(c.picture3d());
      QVERIFY2(pictures[pictures.size() - 2] != pictures.back(), qPrintable(colour->itemText(i)));
    }
    // A case knows it by its key.
    const CaseView kept = c.state().caseView();
    QCOMPARE(kept.colour, std::string(triangleMeasures().back().key));
    c.choose(colour, 0);
    QVERIFY(c.picture3d() == pictures.front());
    c.state().take(kept);
    QVERIFY(c.state().meshColour() == &triangleMeasures().back());
  }
};

int main(int argc, char** argv) { return runWindowTests<TestInspector>(argc, argv); }
#include "tst_inspector.moc"
