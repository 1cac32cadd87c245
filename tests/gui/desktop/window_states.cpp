// SPDX-License-Identifier: BSD-3-Clause
// window-states FOLDER [LANGUAGE]: drives the window through what it can show, and takes a picture
// of the screen for each, FOLDER/NAME.png. In another language: of three states alone.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QScreen>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <cstdio>
#include <functional>
#include <utility>

#include "core/phantom/phantom.h"
#include "gui/findings/case_measures.h"
#include "gui/language.h"
#include "gui/main_window.h"
#include "gui/model/view_state.h"
#include "gui/theme.h"
#include "gui/view/open_gl.h"
#include "gui/view/slice_view.h"
#include "tests/gui/port_case.h"

using namespace angiomesh;

namespace {

constexpr int kPatienceMs = 300000;
const QSize kWindow(1280, 800);

/// Small, so that each state is there within seconds.
Source scan() {
  PhantomParams params;
  params.kind = PhantomKind::VesselTree;
  params.size = {96, 96, 96};
  params.spacingMm = {0.5, 0.5, 0.5};
  params.radius = 5.0;
  params.noiseSigma = 20.0;
  params.randomSeed = 5;
  return makeSource(makePhantom(params).image, "phantom");
}

class States {
 public:
  States(MainWindow& window, QString folder) : window_(window), folder_(std::move(folder)) {}

  CaseModels& models() { return window_.models(); }
  ViewState& state() { return window_.viewState(); }
  void trigger(const char* name) { window_.findChild<QAction*>(name)->trigger(); }
  void wait(const std::function<bool()>& done) {
    for (int waited = 0; !done() && waited < kPatienceMs; waited += 20) QTest::qWait(20);
  }
  void open() {
    models().files.take(scan());
    wait([this] { return models().document.hasCase(); });
  }
  void run() {
    models().runs.run();
    wait([this] { return !models().busy(); });
  }
  void take(const char* name) {
    QTest::qWait(1500);
    const QPixmap shot = window_.screen()->grabWindow(0, 0, 0, kWindow.width(), kWindow.height());
    const QString path = folder_ + '/' + name + ".png";
    if (!shot.save(path, "PNG", 0)) failed_ = true;
    std::printf("%s\n", qPrintable(path));
  }
  void closeDialogs() {
    for (QWidget* top : QApplication::topLevelWidgets())
      if (auto* dialog = qobject_cast<QDialog*>(top)) dialog->close();
  }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  MainWindow& window_;
  QString folder_;
  bool failed_ = false;
};

void showBeginning(States& s, MainWindow& window) {
  s.take("empty");
  window.open("no-such-scan.nii.gz");
  s.take("error");
  s.models().files.take(scan());
  s.open();
  s.take("review-before-a-run");
}

void showRun(States& s) {
  s.trigger("workspaceTune");
  s.models().runs.run();
  s.wait([&s] { return s.models().runs.evolving() || !s.models().busy(); });
  s.trigger("pauseRun");
  s.take("evolving-paused");
  s.trigger("finishRun");
  s.wait([&s] { return !s.models().busy(); });
  s.take("tune-after-a-run");
  s.models().document.setField("levelset.xi", 40.0);
  s.take("out-of-date");
  s.models().document.undoStack()->undo();
}

void showPanes(States& s) {
  s.trigger("workspaceReview");
  s.state().setOverlay(Layer::Vesselness);
  s.take("overlay");
  s.state().setOverlay(std::nullopt);
  s.trigger("patientAxes");
  s.state().setVolumeView(VolumeView::MrAngio);
  s.trigger("surface");
  s.take("shaded-volume");
  s.trigger("surface");
  s.trigger("resultBeside");
  s.take("result-beside-the-image");
  s.trigger("resultBeside");
  s.state().setVolumeView(VolumeView::None);
}

void showFindings(States& s, MainWindow& window) {
  window.measures().pick(MeasurementKind::Profile, test::insideOf(s.models(), 0.4));
  s.wait([&s] { return !s.models().busy(); });
  window.findChild<QWidget*>("measureDock")->show();
  window.findChild<QWidget*>("measureDock")->raise();
  s.take("measurements");
  s.trigger("openReview");
  s.trigger("nextDoubt");
  s.take("review-panel");
}

void showMesh(States& s, MainWindow& window) {
  s.trigger("workspaceMesh");
  s.trigger("edges");
  s.take("mesh");
  auto* tabs = window.findChild<QTabWidget*>("inspectorTabs");
  tabs->setCurrentIndex(1);
  s.take("gates");
  tabs->setCurrentIndex(2);
  window.findChild<QComboBox*>("meshColour")->setCurrentIndex(1);
  s.take("triangles");
  tabs->setCurrentIndex(0);
  s.trigger("edges");
}

void showDialogs(States& s) {
  s.trigger("export");
  s.take("export");
  s.closeDialogs();
  s.trigger("guide");
  s.take("guide");
  s.closeDialogs();
}

int drive(const QString& folder, const QString& language) {
  const QTemporaryDir home;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.path());
  QApplication::setOrganizationName("Angiomesh");
  applyLanguage(language);
  MainWindow window{MainWindowOptions()};
  window.move(0, 0);
  window.resize(kWindow);
  window.show();
  QApplication::setActiveWindow(&window);
  States s(window, folder);
  if (language != "en") {
    s.take(qPrintable("empty-" + language));
    s.models().files.take(scan());
    s.open();
    s.run();
    s.take(qPrintable("tune-" + language));
    s.trigger("workspaceMesh");
    s.take(qPrintable("mesh-" + language));
    return s.failed() ? 1 : 0;
  }
  showBeginning(s, window);
  showRun(s);
  showPanes(s);
  showFindings(s, window);
  showMesh(s, window);
  showDialogs(s);
  applyTheme(Theme::Dark);
  s.trigger("workspaceTune");
  s.take("dark");
  return s.failed() ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  prepareOpenGl();
  const QApplication application(argc, argv);
  const QStringList arguments = QApplication::arguments();
  if (arguments.size() < 2) {
    std::fprintf(stderr, "window-states FOLDER [LANGUAGE]: pictures of the window's states\n");
    return 2;
  }
  return drive(arguments[1], arguments.value(2, "en"));
}
