// SPDX-License-Identifier: BSD-3-Clause
#include <QDockWidget>
#include <QPushButton>

#include "gui/model/result_text.h"
#include "gui/panel/evolution_panel.h"
#include "window_case.h"

using namespace angiomesh;
using angiomesh::test::twoTubes;
using angiomesh::test::WindowCase;

namespace {

/// A window with an evolution that has many fronts behind it.
struct Evolved : WindowCase {
  Evolved() {
    models().files.take(twoTubes());
    models().document.setField("levelset.start", std::string("seeds"));
    models().runs.run(Step::Evolve);
    find<QDockWidget>("convergenceDock")->show();
    find<QDockWidget>("convergenceDock")->raise();
  }

  ConvergencePlot* plot() { return find<ConvergencePlot>("convergencePlot"); }
  QPushButton* use() { return find<QPushButton>("useFront"); }
  QPushButton* back() { return find<QPushButton>("leaveFront"); }
  const std::vector<std::shared_ptr<const KeptFront>>& kept() { return models().runs.keptFronts(); }
  int iterations() { return models().results.evolveResult()->iterations; }
  QString caption() { return contourText(models().results, models().runs).text; }

  void clickAt(int iteration) {
    QTest::mouseClick(plot(), Qt::LeftButton, Qt::NoModifier,
                      QPoint(static_cast<int>(std::lround(plot()->xOf(iteration))), 40));
  }
};

std::size_t inside(const Volume<float>& phi) {
  return static_cast<std::size_t>(std::count_if(phi.voxels.begin(), phi.voxels.end(),
                                                [](float value) { return value < 0.0F; }));
}

}  // namespace

/// The plot of an evolution, and the way back to where its front was.
class TestEvolution : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void thePlotHasAPointForEachIteration() {
    Evolved c;
    QCOMPARE(static_cast<int>(c.models().runs.motions().size()), c.iterations());
    QVERIFY(c.kept().size() >= 3);
    QCOMPARE(c.kept().front()->iterations, 0);
    for (std::size_t i = 1; i < c.kept().size(); ++i)
      QVERIFY(c.kept()[i]->iterations > c.kept()[i - 1]->iterations);
    QVERIFY(c.plot()->xOf(0) < c.plot()->xOf(c.iterations()));
  }

  void aClickShowsTheFrontAsItWas() {
    Evolved c;
    const std::size_t last = inside(*c.models().results.phi());
    QVERIFY(!c.use()->isEnabled() && !c.back()->isEnabled());
    c.clickAt(0);
    QVERIFY2(c.caption().contains("Result 1, the front after iteration 0"),
             qPrintable(c.caption()));
    const std::size_t first = inside(*c.models().results.phi());
    QVERIFY(first > 0 && first < last / 2);
    QVERIFY(c.models().results.liveSurface() != nullptr);
    QTest::keyClick(c.plot(), Qt::Key_Right);
    const std::size_t second = inside(*c.models().results.phi());
    QVERIFY(second > first);
    QCOMPARE(c.models().results.frontShown(), std::optional(c.kept()[1]->iterations));
    QTest::keyClick(c.plot(), Qt::Key_Left);
    QCOMPARE(inside(*c.models().results.phi()), first);
    QTest::keyClick(c.plot(), Qt::Key_Left);
    QCOMPARE(inside(*c.models().results.phi()), first);
    QTest::mouseClick(c.back(), Qt::LeftButton);
    QCOMPARE(inside(*c.models().results.phi()), last);
    QVERIFY(!c.caption().contains("the front after"));
    QVERIFY(!c.use()->isEnabled());
  }

  void anEarlierFrontCanBeTheResult() {
    Evolved c;
    const int before = c.iterations();
    const std::size_t last = inside(*c.models().results.phi());
    const int wanted = c.kept()[1]->iterations;
    c.clickAt(wanted);
    QTest::mouseClick(c.use(), Qt::LeftButton);
    QCOMPARE(c.models().document.parameters().levelset.stopAfter, std::optional(wanted));
    QCOMPARE(c.iterations(), wanted);
    QVERIFY(c.models().results.fresh(Step::Evolve));
    QVERIFY(inside(*c.models().results.phi()) < last);
    QVERIFY2(c.caption().contains("Result 2"), qPrintable(c.caption()));
    QVERIFY(!c.caption().contains("front after"));
    QCOMPARE(static_cast<int>(c.models().runs.motions().size()), wanted);
    // It is in the pipeline's memory like any other result, and so is the one before.
    QVERIFY(c.models().document.pipeline()->has(Step::Evolve, c.models().document.parameters()));
    c.models().document.undoStack()->undo();
    QCOMPARE(c.iterations(), before);
    QVERIFY2(c.caption().contains("Result 1"), qPrintable(c.caption()));
    // Fronts of the other evolution are none of this one.
    QVERIFY(c.kept().empty() && c.models().runs.motions().empty());
  }

  void aNewEvolutionLeavesTheFrontOfTheOldOne() {
    Evolved c;
    c.clickAt(0);
    c.models().document.setField("levelset.xi", 25.0);
    c.models().runs.run(Step::Evolve);
    QVERIFY(!c.models().results.frontShown());
    QVERIFY2(c.caption().contains("Result 2"), qPrintable(c.caption()));
    c.clickAt(0);
    c.models().files.take(twoTubes(36));
    QVERIFY(!c.models().results.frontShown());
    QVERIFY(c.kept().empty());
  }

  void aNewEvolutionIsShownAsItGoesOn() {
    WindowCase c(makeThreadedJobRunner);
    c.models().files.take(test::slowTree());
    QTRY_VERIFY(c.models().document.hasCase());
    c.models().runs.run(Step::Evolve);
    QTRY_VERIFY_WITH_TIMEOUT(!c.models().busy(), test::kPatienceMs);
    c.models().results.showFront(c.models().runs.keptFronts().front());
    QTRY_VERIFY_WITH_TIMEOUT(c.models().results.frontShown(), test::kPatienceMs);
    test::evolveFor(c.models());
    c.models().runs.run(Step::Evolve);
    QTRY_VERIFY_WITH_TIMEOUT(c.models().results.live(), test::kPatienceMs);
    QVERIFY(!c.models().results.frontShown());
    c.models().runs.cancel();
    QTRY_VERIFY_WITH_TIMEOUT(!c.models().runs.running(), test::kPatienceMs);
  }

  void fromAWorkerTheLastFrontAskedForIsShown() {
    WindowCase c(makeThreadedJobRunner);
    c.models().files.take(twoTubes());
    QTRY_VERIFY(c.models().document.hasCase());
    c.models().document.setField("levelset.start", std::string("seeds"));
    c.models().runs.run(Step::Evolve);
    QTRY_VERIFY_WITH_TIMEOUT(!c.models().busy(), test::kPatienceMs);
    const auto& kept = c.models().runs.keptFronts();
    QVERIFY(kept.size() >= 2);
    for (const auto& front : kept) c.models().results.showFront(front);
    QTRY_COMPARE_WITH_TIMEOUT(c.models().results.frontShown(),
                              std::optional(kept.back()->iterations), test::kPatienceMs);
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestEvolution>(argc, argv); }
#include "tst_evolution.moc"
