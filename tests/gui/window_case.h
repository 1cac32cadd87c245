// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QDockWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <utility>

#include "gui/main_window.h"
#include "gui/model/view_state.h"
#include "gui/pane/view_grid.h"
#include "gui/view/slice_view.h"
#include "gui/view/surface_view.h"
#include "small_case.h"
#include "window_events.h"

namespace angiomesh::test {

constexpr int kPatienceMs = 60000;

/// The answers to questions about cases, and what was asked.
struct CaseAnswers {
  CaseQuestions questions() {
    CaseQuestions q;
    q.saveCaseAs = [this](QWidget*, const QString& suggested) {
      asked << "saveCaseAs " + suggested;
      return savePath;
    };
    q.replaceCase = [this](QWidget*, const QString& name) {
      asked << "replace " + name;
      return replace;
    };
    q.saveChanges = [this](QWidget*, const QString& name) {
      asked << "saveChanges " + name;
      return save;
    };
    q.restore = [this](QWidget*, const QString& what, bool later) {
      asked << (later ? "restoreAtStart " : "restore ") + what;
      return restore;
    };
    q.findSource = [this](QWidget*, const QString& what, const QString& reason) {
      asked << "findSource " + what + reason;
      return source.isEmpty() ? SourceAnswer::Cancel : source.takeFirst();
    };
    q.replacePreset = [this](QWidget*, const QString& name) {
      asked << "replacePreset " + name;
      return replace;
    };
    q.removePreset = [this](QWidget*, const QString& name) {
      asked << "removePreset " + name;
      return replace;
    };
    return q;
  }

  QString savePath;
  bool replace = false;
  SaveAnswer save = SaveAnswer::Discard;
  RestoreAnswer restore = RestoreAnswer::Later;
  QList<SourceAnswer> source;  ///< one after the other, then Cancel
  QStringList asked;
};

/// A window on the screen whose questions are answered at once.
struct WindowCase {
  explicit WindowCase(const JobRunnerFactory& makeRunner = makeInlineJobRunner,
                      const std::filesystem::path& recovery = {}) {
    MainWindowOptions options;
    options.makeRunner = makeRunner;
    options.chooser.openFile = [this](QWidget*) { return openPath; };
    options.chooser.openPorts = [this](QWidget*) { return openPath; };
    options.chooser.openPreset = [this](QWidget*) { return openPath; };
    options.chooser.openMesh = [this](QWidget*) { return openPath; };
    options.chooser.openFolder = [this](QWidget*) { return openPath; };
    options.chooser.save = [this](QWidget*, const QString&, const QString&) { return savePath; };
    options.questions = answers.questions();
    options.recovery = recovery;
    options.opening.choose = [this](QWidget*, const std::vector<ImageSummary>& entries,
                                    const JobRunnerFactory&) {
      seriesShown = entries;
      return seriesChosen;
    };
    options.opening.resample = [this](QWidget*, const QString& reason) {
      unevenReason = reason;
      return resample;
    };
    options.opening.label = [this](QWidget*, const std::vector<Label>& labels, double) {
      labelsShown = labels;
      return labelChosen;
    };
    window = std::make_unique<MainWindow>(std::move(options));
    // Tests work in all panels, whatever workspace has them.
    for (auto* dock : window->findChildren<QDockWidget*>()) dock->show();
    window->resize(1240, 860);
    window->show();
    QApplication::setActiveWindow(window.get());
    [[maybe_unused]] const bool shown = QTest::qWaitForWindowExposed(window.get());
  }

  CaseModels& models() { return window->models(); }
  ViewState& state() { return window->viewState(); }

  /// The widget with this name, anywhere or inside the step's panel.
  template <class T>
  T* find(const QString& name, const QString& inside = {}) {
    QWidget* from = window.get();
    if (!inside.isEmpty()) {
      from = window->findChild<QWidget*>(inside);
    }
    return from ? from->findChild<T*>(name) : nullptr;
  }
  void click(QWidget* widget) {
    QTest::mouseClick(widget, Qt::LeftButton, Qt::NoModifier, widget->rect().center());
  }
  /// Clicks the tool bar's button of an action.
  void clickTool(const char* action) {
    for (const auto* bar : window->findChildren<QToolBar*>())
      if (QWidget* button =
              bar->widgetForAction(window->findChild<QAction*>(QLatin1String(action))))
        click(button);
  }
  /// Chooses an entry as the arrow keys do.
  void choose(QComboBox* combo, int index) {
    for (int i = 0; i < combo->count() && combo->currentIndex() != index; ++i) {
      QTest::keyClick(combo, combo->currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
    }
  }
  void drag(QWidget* widget, const QPoint& from, const QPoint& to) {
    test::drag(*widget, Qt::LeftButton, from, to);
  }

  QTemporaryDir folder;
  QString openPath, savePath;
  std::vector<ImageSummary> seriesShown;
  std::optional<std::size_t> seriesChosen;
  std::vector<Label> labelsShown;
  std::optional<LabelAnswer> labelChosen;
  QString unevenReason;
  bool resample = false;
  CaseAnswers answers;
  std::unique_ptr<MainWindow> window;
};

}  // namespace angiomesh::test
