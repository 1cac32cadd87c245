// SPDX-License-Identifier: BSD-3-Clause
#include <QDockWidget>
#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>

#include "fresh_window.h"
#include "gui/workspaces.h"

using namespace angiomesh;
using angiomesh::test::evolveFor;
using angiomesh::test::FreshWindow;
using angiomesh::test::kPatienceMs;
using angiomesh::test::slowTree;
using angiomesh::test::twoTubes;

namespace {

const QStringList kTune{"convergenceDock", "pipelineDock"};
const QStringList kMesh{"inspectorDock", "logDock", "portsDock"};

}  // namespace

class TestWorkspaces : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void reviewLeavesTheRoomToTheImages_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("usual") << QSize(1560, 960);
    QTest::newRow("small") << QSize(1280, 800);
  }
  void reviewLeavesTheRoomToTheImages() {
    QFETCH(QSize, size);
    FreshWindow w(size);
    w.window->models().files.take(twoTubes());
    QVERIFY(w.window->workspaces().current() == Workspace::Review);
    QCOMPARE(w.window->size(), size);
    const QWidget& views = w.window->views();
    const auto share = [&] {
      return static_cast<double>(views.width()) * views.height() / (size.width() * size.height());
    };
    QTRY_VERIFY2(share() >= 0.75, qPrintable(QString::number(share())));
  }

  void theWindowComesBackAsLargeAsItWas() {
    {
      FreshWindow w({1111, 777});
      w.window->close();
    }
    const MainWindow window{MainWindowOptions()};
    QCOMPARE(window.size(), QSize(1111, 777));
  }

  void eachWorkspaceHasItsDocks() {
    FreshWindow w;
    QCOMPARE(w.docks(), QStringList());
    w.clickTool("workspaceTune");
    QCOMPARE(w.docks(), kTune);
    w.clickTool("workspaceMesh");
    QCOMPARE(w.docks(), kMesh);
    w.press(Qt::Key_F2);
    QTRY_COMPARE(w.docks(), kTune);
    w.press(Qt::Key_F3);
    QTRY_COMPARE(w.docks(), kMesh);
    w.press(Qt::Key_F1);
    QTRY_COMPARE(w.docks(), QStringList());
    QVERIFY(w.window->findChild<QAction*>("workspaceReview")->isChecked());
    QVERIFY(!w.window->findChild<QAction*>("workspaceMesh")->isChecked());
  }

  void theButtonsAreAtTheRightEnd() {
    FreshWindow w({1280, 800});
    int left = 0;
    for (const char* action : {"cancelRun", "workspaceReview", "workspaceTune", "workspaceMesh"}) {
      const QWidget* button = w.buttonOf(action);
      QVERIFY(button && button->isVisible() && button->x() > left);
      left = button->x();
    }
    QVERIFY(left > 1280 - 200);
  }

  void changesComeBackWithTheWorkspace() {
    FreshWindow w;
    w.clickTool("workspaceTune");
    auto* pipeline = w.window->findChild<QDockWidget*>("pipelineDock");
    const int before = pipeline->width();
    w.window->resizeDocks({pipeline}, {before + 90}, Qt::Horizontal);
    QTRY_VERIFY(pipeline->width() > before + 60);
    const int widened = pipeline->width();
    w.window->findChild<QDockWidget*>("convergenceDock")->close();
    w.window->findChild<QDockWidget*>("logDock")->show();
    w.clickTool("workspaceMesh");
    QCOMPARE(w.docks(), kMesh);
    w.clickTool("workspaceTune");
    QCOMPARE(w.docks(), QStringList({"logDock", "pipelineDock"}));
    QTRY_COMPARE(pipeline->width(), widened);
    w.window->findChild<QAction*>("resetWorkspace")->trigger();
    QCOMPARE(w.docks(), kTune);
    QTRY_COMPARE(pipeline->width(), before);
  }

  void theNextStartShowsTheSame() {
    {
      FreshWindow w;
      w.clickTool("workspaceMesh");
      w.window->findChild<QDockWidget*>("logDock")->close();
      QVERIFY(w.window->close());
    }
    FreshWindow w;
    QVERIFY(w.window->workspaces().current() == Workspace::Mesh);
    QVERIFY(w.window->findChild<QAction*>("workspaceMesh")->isChecked());
    QCOMPARE(w.docks(), QStringList({"inspectorDock", "portsDock"}));
    w.clickTool("workspaceReview");
    QCOMPARE(w.docks(), QStringList());
  }

  void aLayoutThatCannotBeReadIsTheFirstOne() {
    QSettings().setValue("workspace/current", "mesh");
    QSettings().setValue("workspace/layout/mesh", QByteArray("nonsense"));
    FreshWindow w;
    QCOMPARE(w.docks(), kMesh);
  }

  void aRunIsStartedWatchedAndCancelledInReview() {
    FreshWindow w({1280, 800}, makeThreadedJobRunner);
    w.window->models().files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(w.window->models().document.hasCase(), kPatienceMs);
    evolveFor(w.window->models());
    w.clickTool("runAll");
    const QLabel* work = w.work();
    const auto* progress = w.window->statusBar()->findChild<QProgressBar*>();
    QTRY_VERIFY_WITH_TIMEOUT(work->text().contains("iteration"), kPatienceMs);
    QVERIFY(work->isVisible() && progress->isVisible() && progress->value() > 0);
    w.clickTool("cancelRun");
    QTRY_VERIFY_WITH_TIMEOUT(!w.window->models().runs.running(), kPatienceMs);
    QTRY_VERIFY(work->text().isEmpty());
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestWorkspaces>(argc, argv); }
#include "tst_workspaces.moc"
