// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QMainWindow>
#include <filesystem>
#include <memory>

#include "gui/dialog/case_questions.h"
#include "gui/dialog/export_dialog.h"
#include "gui/dialog/open_questions.h"
#include "gui/job/job_runner.h"

class QLabel;
class QMenu;
class QProgressBar;

namespace angiomesh {

struct CaseModels;
class CaseDialogs;
class CaseMeasures;
class CasePorts;
class CaseReviewModel;
class CaseSensitivity;
class MeshFile;
class MeshInspection;
class MeshReport;
class CentralArea;
class CorrectMenu;
class MeasureMenu;
class MeasurePanel;
class Pictures;
class PortMenu;
class PortPanel;
class PresetMenu;
class RecipeActions;
class SeedMenu;
class ViewGrid;
class WhyPanel;
class ViewState;
class ViewTools;
class PatientIdentity;
class RecentCases;
class Workspaces;

/// What the window takes from outside, so that tests can answer for the user and run in line.
struct MainWindowOptions {
  JobRunnerFactory makeRunner = makeThreadedJobRunner;
  PathChooser chooser = dialogPathChooser();
  CaseQuestions questions = dialogCaseQuestions();
  OpenQuestions opening = dialogOpenQuestions();
  /// For the edits of cases that were never saved; empty: they are not kept.
  std::filesystem::path recovery = {};
};

/// The one window: four panes and, as the workspace chosen wants them, the pipeline on the left,
/// the mesh inspector and the ports on the right, log and convergence plot at the bottom.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(MainWindowOptions options = {}, QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] CaseModels& models() { return *models_; }
  [[nodiscard]] ViewState& viewState() { return *state_; }
  [[nodiscard]] CasePorts& ports() { return *ports_; }
  [[nodiscard]] CaseReviewModel& review() { return *review_; }
  [[nodiscard]] CaseMeasures& measures() { return *measures_; }
  [[nodiscard]] CaseSensitivity& sensitivity() { return *sensitivity_; }
  [[nodiscard]] ViewGrid& views() { return *views_; }
  [[nodiscard]] Workspaces& workspaces() { return *workspaces_; }

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
  void buildDocks();
  void buildMenus();
  void buildFileMenu();
  void buildStatusBar();
  void runOnceLoaded();
  void refreshTitle();
  void refreshActions();
  void refreshRecent();
  void chooseSeries(const QString& path, const std::vector<ImageSummary>& entries);
  void chooseLabel(const QString& path, const std::vector<Label>& labels, double voxelMm3);
  void askToResample(const QString& path, const ImageSummary& entry, const QString& reason);
  void showProgress();
  void showExport();

  MainWindowOptions options_;
  bool thenRun_ = false;  ///< what is being opened is to be run
  std::unique_ptr<CaseModels> models_;
  ViewState* state_;
  CasePorts* ports_;
  CaseReviewModel* review_;
  CaseMeasures* measures_;
  MeshInspection* inspection_;
  MeshFile* meshFile_;
  CaseSensitivity* sensitivity_;
  WhyPanel* why_ = nullptr;
  ViewGrid* views_;
  CentralArea* centre_;
  CaseDialogs* cases_;
  ViewTools* tools_;
  Pictures* pictures_;
  MeshReport* report_;
  PresetMenu* presets_;
  RecipeActions* recipes_;
  Workspaces* workspaces_;
  RecentCases* recents_;
  PatientIdentity* identity_;
  PortMenu* portMenu_ = nullptr;
  PortPanel* portPanel_ = nullptr;
  CorrectMenu* correctMenu_ = nullptr;
  SeedMenu* seedMenu_ = nullptr;
  MeasureMenu* measureMenu_ = nullptr;
  MeasurePanel* measurePanel_ = nullptr;
  QMenu* recent_ = nullptr;
  QLabel* hover_ = nullptr;
  QLabel* work_ = nullptr;
  QProgressBar* progress_ = nullptr;
};

}  // namespace angiomesh
