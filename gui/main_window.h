// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QMainWindow>
#include <filesystem>
#include <functional>
#include <optional>

#include "gui/job/job_runner.h"
#include "gui/panel/case_questions.h"
#include "gui/panel/export_dialog.h"
#include "gui/panel/open_questions.h"

class QActionGroup;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QMenu;
class QProgressBar;
class QToolBar;

namespace angiomesh {

struct CaseModels;
class CasePorts;
class PortPanel;
class ViewGrid;
class ViewState;

/// What the window takes from outside, so that tests can answer for the user and run in line.
struct MainWindowOptions {
  JobRunnerFactory makeRunner = makeThreadedJobRunner;
  PathChooser chooser = dialogPathChooser();
  CaseQuestions questions = dialogCaseQuestions();
  OpenQuestions opening = dialogOpenQuestions();
  /// For the edits of cases that were never saved; empty: they are not kept.
  std::filesystem::path recovery = {};
};

/// The one window: four panes, the pipeline on the left, the mesh inspector on the right, log and
/// convergence plot at the bottom.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(MainWindowOptions options = {}, QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] CaseModels& models() { return *models_; }
  [[nodiscard]] ViewState& viewState() { return *state_; }
  [[nodiscard]] CasePorts& ports() { return *ports_; }
  [[nodiscard]] ViewGrid& views() { return *views_; }

  /// Opens a file, a folder or a case and, with `thenRun`, runs the pipeline once it is loaded.
  void open(const QString& path, bool thenRun = false);
  void openSample(bool thenRun = false);

  /// Asks whether to restore what a crash left unsaved; true when something is being restored.
  bool offerRestore();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  QAction* addAction(QMenu* menu, const char* name, const QString& text,
                     const QKeySequence& shortcut, const std::function<void()>& slot);
  QAction* addToggle(QMenu* menu, const char* name, const QString& text,
                     const QKeySequence& shortcut, const std::function<void(bool)>& slot);
  void buildDocks();
  void buildMenus();
  void buildFileMenu();
  void buildRunMenu();
  void buildViewMenu();
  void buildToolMenu();
  void buildPortMenu();
  void buildToolBar();
  void buildStatusBar();
  void runOnceLoaded();
  void connectCases();
  void refreshModified();
  void openCase(const QString& path);
  void saveCase();
  void saveCaseAs();
  void saveCaseTo(const QString& folder);
  /// Whether the open case may go; asks about unsaved changes. With the answer "save" it may not
  /// yet: `onceSaved` is called when it may.
  bool mayLeave(const std::function<void()>& onceSaved);
  void askForSource(const QString& what, const QString& reason);
  void askToRestore(int count);
  bool offerUnfinished();
  void refreshTitle();
  void refreshActions();
  void refreshViewActions();
  void refreshRecent();
  void chooseSeries(const QString& path, const std::vector<ImageSummary>& entries);
  void chooseLabel(const QString& path, const std::vector<Label>& labels, double voxelMm3);
  void askToResample(const QString& path, const ImageSummary& entry, const QString& reason);
  void refreshPortActions();
  void showPortMenu(const QPoint& global, const std::optional<Eigen::Vector3d>& place,
                    const QString& port);
  void askForEnds();
  void importPorts();
  void exportPorts();
  void showProgress();
  void showExport();
  void showShortcuts();
  void showAbout();
  void remember(const QString& path);

  MainWindowOptions options_;
  bool thenRun_ = false;  ///< what is being opened is to be run
  std::unique_ptr<CaseModels> models_;
  ViewState* state_;
  CasePorts* ports_;
  ViewGrid* views_;
  PortPanel* portPanel_ = nullptr;
  std::function<void()> afterSave_;
  QString unfinished_;  ///< the case that the settings name as such for this window
  QMenu* recent_ = nullptr;
  QMenu* panels_ = nullptr;
  QComboBox* layer_ = nullptr;
  QComboBox* slab_ = nullptr;
  QDoubleSpinBox* thickness_ = nullptr;
  QLabel* hover_ = nullptr;
  QLabel* work_ = nullptr;
  QProgressBar* progress_ = nullptr;
};

}  // namespace angiomesh
