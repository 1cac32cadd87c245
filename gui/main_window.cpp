// SPDX-License-Identifier: BSD-3-Clause
#include "gui/main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QProgressBar>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QUrl>
#include <algorithm>

#include "gui/case_dialogs.h"
#include "gui/central_area.h"
#include "gui/dialog/guide.h"
#include "gui/dialog/help_dialogs.h"
#include "gui/dialog/recipe_actions.h"
#include "gui/findings/case_measures.h"
#include "gui/findings/case_ports.h"
#include "gui/findings/case_review.h"
#include "gui/findings/case_sensitivity.h"
#include "gui/findings/mesh_file.h"
#include "gui/findings/mesh_inspection.h"
#include "gui/inspector/inspector_panel.h"
#include "gui/menu/correct_menu.h"
#include "gui/menu/measure_menu.h"
#include "gui/menu/pane_menu.h"
#include "gui/menu/port_menu.h"
#include "gui/menu/preset_menu.h"
#include "gui/menu/review_menu.h"
#include "gui/menu/run_menu.h"
#include "gui/menu/seed_menu.h"
#include "gui/menu/window_actions.h"
#include "gui/model/step_text.h"
#include "gui/model/view_state.h"
#include "gui/pane/view_grid.h"
#include "gui/panel/evolution_panel.h"
#include "gui/panel/log_panel.h"
#include "gui/panel/measure_panel.h"
#include "gui/panel/pipeline_panel.h"
#include "gui/panel/port_panel.h"
#include "gui/panel/review_panel.h"
#include "gui/panel/sensitivity_panel.h"
#include "gui/panel/why_panel.h"
#include "gui/patient_identity.h"
#include "gui/pictures.h"
#include "gui/recent_cases.h"
#include "gui/report/mesh_report.h"
#include "gui/view/named.h"
#include "gui/view_tools.h"
#include "gui/workspaces.h"

namespace angiomesh {

namespace {

constexpr int kWidth = 1560, kHeight = 960;
constexpr int kPanelWidth = 400, kNarrowPanelWidth = 360;
constexpr int kInspectorHeight = 650, kPortsHeight = 250;

}  // namespace

MainWindow::MainWindow(MainWindowOptions options, QWidget* parent)
    : QMainWindow(parent),
      options_(std::move(options)),
      models_(std::make_unique<CaseModels>(options_.makeRunner, options_.recovery)),
      state_(new ViewState(*models_, this)),
      ports_(new CasePorts(*models_, options_.makeRunner, this)),
      review_(new CaseReviewModel(*models_, options_.makeRunner, this)),
      measures_(new CaseMeasures(*models_, options_.makeRunner, this)),
      inspection_(new MeshInspection(*models_, *state_, options_.makeRunner, this)),
      meshFile_(new MeshFile(*models_, *state_, options_.makeRunner, this)),
      sensitivity_(new CaseSensitivity(*models_, options_.makeRunner, this)),
      views_(new ViewGrid(*models_, *state_, *ports_, *inspection_, *sensitivity_,
                          options_.makeRunner, this)),
      centre_(new CentralArea(*models_, views_, this)),
      cases_(new CaseDialogs(this, *models_, *state_, *views_, options_.chooser, options_.questions,
                             options_.recovery)),
      tools_(new ViewTools(this, *models_, *state_, *views_)),
      pictures_(new Pictures(this, *models_, *views_, options_.chooser, options_.makeRunner)),
      report_(new MeshReport(*models_, *state_, *views_, *measures_, *review_, options_.makeRunner,
                             this)),
      presets_(new PresetMenu(this, *models_, options_.chooser, options_.questions,
                              options_.makeRunner)),
      recipes_(new RecipeActions(*models_, options_.chooser, options_.makeRunner, this)),
      workspaces_(new Workspaces(this)),
      recents_(new RecentCases(*models_, options_.makeRunner, this)),
      identity_(new PatientIdentity(this, *models_, options_.makeRunner)) {
  setObjectName("mainWindow");
  keepSettingsPrivate();
  setAcceptDrops(true);
  const QSize room = screen()->availableSize();
  resize(std::min(kWidth, room.width()), std::min(kHeight, room.height()));
  setCentralWidget(centre_);
  buildDocks();
  buildMenus();
  centre_->addActionsOf(this);
  workspaces_->addTo(tools_->buildToolBars());
  measureMenu_->addTo(findChild<QToolBar*>("paneBar"));
  correctMenu_->addTo(findChild<QToolBar*>("paneBar"));
  tools_->addIcons();
  buildStatusBar();
  connect(&models_->files, &CaseFiles::caseChanged, this, &MainWindow::refreshTitle);
  connect(&models_->runs, &RunModel::statesChanged, this, &MainWindow::refreshActions);
  connect(&models_->results, &ResultModel::resultsChanged, this, &MainWindow::refreshActions);
  connect(&models_->document, &CaseDocument::parametersChanged, this, &MainWindow::refreshActions);
  connect(&models_->runs, &RunModel::snapshotArrived, this, &MainWindow::refreshActions);
  connect(pictures_, &Pictures::turningChanged, this, &MainWindow::refreshActions);
  connect(sensitivity_, &CaseSensitivity::changed, this, &MainWindow::refreshActions);
  connect(&models_->timer, &JobTimer::ticked, this, &MainWindow::showProgress);
  connect(&models_->files, &CaseFiles::opened, recents_, &RecentCases::remember);
  connect(recents_, &RecentCases::changed, this, &MainWindow::refreshRecent);
  connect(recents_, &RecentCases::changed, this, &MainWindow::refreshTitle);
  // Asked once the loader is done with the job: a dialog runs a loop of its own.
  connect(&models_->files, &CaseFiles::seriesFound, this, &MainWindow::chooseSeries,
          Qt::QueuedConnection);
  connect(&models_->files, &CaseFiles::labelsFound, this, &MainWindow::chooseLabel,
          Qt::QueuedConnection);
  connect(&models_->files, &CaseFiles::unevenFound, this, &MainWindow::askToResample,
          Qt::QueuedConnection);
  connect(cases_, &CaseDialogs::saved, this, [this](const QString& folder) {
    refreshTitle();
    recents_->remember(folder);
  });
  connect(centre_, &CentralArea::openRequested, this, [this](const QString& path) { open(path); });
  connect(views_, &ViewGrid::hovered, hover_, &QLabel::setText);
  connect(views_, &ViewGrid::crosshairMoved, this,
          [this] { models_->live.setFocus(views_->crosshair()); });
  refreshTitle();
  refreshActions();
  portMenu_->refresh();
  tools_->refreshActions();
  refreshRecent();
  workspaces_->start();
}

MainWindow::~MainWindow() {
  // The panels listen to the ports and to the models: these go first, with their workers, and
  // say nothing more. Before them go the panes and what follows them, which have workers, too.
  const auto drop = [](auto*& object) {
    object->disconnect();
    delete object;
    object = nullptr;
  };
  drop(report_);
  drop(recipes_);
  drop(presets_);
  drop(why_);
  drop(views_);
  drop(sensitivity_);
  drop(inspection_);
  drop(meshFile_);
  drop(ports_);
  drop(review_);
  drop(measures_);
  drop(identity_);
  drop(recents_);
  drop(pictures_);
  models_->document.undoStack()->disconnect();
  models_.reset();
}

void MainWindow::buildDocks() {
  const auto dock = [this](const char* name, const QString& title, Qt::DockWidgetArea area,
                           QWidget* content) {
    auto* widget = named(new QDockWidget(title, this), QLatin1String(name));
    widget->setWidget(content);
    addDockWidget(area, widget);
    return widget;
  };
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  QDockWidget* pipeline = dock("pipelineDock", tr("Pipeline"), Qt::LeftDockWidgetArea,
                               new PipelinePanel(*models_, this));
  auto* meshes = new InspectorPanel(*models_, *state_, *inspection_, *meshFile_, this);
  connect(meshes, &InspectorPanel::openMeshRequested, this,
          [this] { actionOf(this, "openMesh")->trigger(); });
  QDockWidget* inspector =
      dock("inspectorDock", tr("Mesh inspector"), Qt::RightDockWidgetArea, meshes);
  portPanel_ = new PortPanel(*ports_, this);
  QDockWidget* ports = dock("portsDock", tr("Ports"), Qt::RightDockWidgetArea, portPanel_);
  splitDockWidget(inspector, ports, Qt::Vertical);
  QDockWidget* log =
      dock("logDock", tr("Log"), Qt::BottomDockWidgetArea, new LogPanel(*models_, this));
  QDockWidget* plot = dock("convergenceDock", tr("Convergence"), Qt::BottomDockWidgetArea,
                           new EvolutionPanel(*models_, this));
  splitDockWidget(log, plot, Qt::Horizontal);
  why_ = new WhyPanel(*models_, *views_, options_.makeRunner, this);
  QDockWidget* why = dock("whyDock", tr("Why here?"), Qt::RightDockWidgetArea, why_);
  measurePanel_ = new MeasurePanel(*measures_, this);
  QDockWidget* measures =
      dock("measureDock", tr("Measurements"), Qt::RightDockWidgetArea, measurePanel_);
  tabifyDockWidget(ports, measures);
  tabifyDockWidget(ports, why);
  tabifyDockWidget(ports, dock("reviewDock", tr("Review"), Qt::RightDockWidgetArea,
                               new ReviewPanel(*review_, *views_, this)));
  tabifyDockWidget(ports, dock("sensitivityDock", tr("Sensitivity"), Qt::RightDockWidgetArea,
                               new SensitivityPanel(*sensitivity_, this)));
  connect(review_, &CaseReviewModel::goTo, views_, &ViewGrid::goTo);
  ports->raise();
  resizeDocks({inspector, ports}, {kInspectorHeight, kPortsHeight}, Qt::Vertical);
  resizeDocks({log, plot}, {150, 150}, Qt::Vertical);
  const int side = width() < kWidth ? kNarrowPanelWidth : kPanelWidth;
  resizeDocks({pipeline, inspector}, {side, side}, Qt::Horizontal);
}

void MainWindow::buildMenus() {
  buildFileMenu();
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = models_->document.undoStack()->createUndoAction(this, tr("Undo"));
  undo->setObjectName("undo");
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = models_->document.undoStack()->createRedoAction(this, tr("Redo"));
  redo->setObjectName("redo");
  redo->setShortcut(QKeySequence::Redo);
  for (QAction* action : {undo, redo}) {
    // The text grows with the edit's name; a tool bar must not jump.
    action->setIconText(action == undo ? tr("Undo") : tr("Redo"));
    edit->addAction(action);
  }
  edit->addSeparator();
  addMenuAction(this, edit, "clearSeeds", tr("Remove all seeds by hand"), {},
                [this] { models_->document.setField("seeds.points", std::vector<double>()); });
  addMenuAction(this, edit, "clearRoi", tr("Clear region of interest"), {},
                [this] { models_->document.setRoi(std::nullopt); });
  edit->addSeparator();
  recipes_->addCopies(edit);
  presets_->addTo(edit);
  findChild<PipelinePanel*>()->setPresetMenu(presets_->menu());
  addRunMenu(this, *models_, *sensitivity_, [this] {
    models_->cancel();
    sensitivity_->cancel();
    pictures_->cancel();
  });
  tools_->buildToolMenu();
  portMenu_ = new PortMenu(this, *models_, *ports_, *portPanel_, *views_, options_.chooser);
  addReviewMenu(this, *review_);
  auto* parts = new PartEdits(*models_, options_.makeRunner, this);
  auto* paneMenu = new PaneMenu(this, *state_, *views_, *parts);
  connect(portMenu_, &PortMenu::menuMade, paneMenu,
          qOverload<QMenu*, const std::optional<Eigen::Vector3d>&, int>(&PaneMenu::addTo));
  measureMenu_ = new MeasureMenu(this, *models_, *state_, *measures_, *measurePanel_, *views_,
                                 options_.chooser);
  correctMenu_ = new CorrectMenu(this, *models_, *state_, *views_);
  seedMenu_ = new SeedMenu(*models_, this);
  connect(portMenu_, &PortMenu::menuMade, measureMenu_,
          [this](QMenu* menu, const std::optional<Eigen::Vector3d>& place) {
            measureMenu_->addTo(menu, place);
            correctMenu_->addTo(menu, place);
            seedMenu_->addTo(menu, place);
          });
  QMenu* view = menuBar()->addMenu(tr("&View"));
  workspaces_->addTo(view);
  view->addSeparator();
  paneMenu->addTo(view);
  tools_->addTo(view);
  view->addSeparator();
  addMenuAction(this, view, "showIdentity", tr("Patient of this scan…"), {},
                [this] { identity_->show(); });
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  addMenuAction(this, help, "guide", tr("Guide"), QKeySequence(Qt::Key_F1),
                [this] { showGuide(this, QStringLiteral("desktop")); });
  addMenuAction(this, help, "shortcuts", tr("Shortcuts"), QKeySequence(Qt::SHIFT | Qt::Key_F1),
                [this] { showGuide(this, {}); });
  addMenuAction(this, help, "about", tr("About Angiomesh"), {}, [this] { showAbout(this); });
}

void MainWindow::buildFileMenu() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  addMenuAction(this, file, "open", tr("Open…"), QKeySequence::Open, [this] {
    if (const QString path = options_.chooser.openFile(this); !path.isEmpty()) open(path);
  });
  addMenuAction(this, file, "openFolder", tr("Open folder or case…"),
                QKeySequence(tr("Ctrl+Shift+O")), [this] {
                  if (const QString path = options_.chooser.openFolder(this); !path.isEmpty()) {
                    open(path);
                  }
                });
  addMenuAction(this, file, "openSample", tr("Open the sample"), {}, [this] { openSample(); });
  addMenuAction(this, file, "openMesh", tr("Compare with a mesh…"), QKeySequence(tr("Ctrl+Alt+O")),
                [this] {
                  const QString path = options_.chooser.openMesh(this);
                  if (!path.isEmpty()) meshFile_->open(path);
                });
  recent_ = file->addMenu(tr("Recent"));
  file->addSeparator();
  addMenuAction(this, file, "saveCase", tr("Save case"), QKeySequence::Save,
                [this] { cases_->save(); });
  addMenuAction(this, file, "saveCaseAs", tr("Save case as…"), QKeySequence(tr("Ctrl+Shift+S")),
                [this] { cases_->saveAs(); });
  file->addSeparator();
  addMenuAction(this, file, "export", tr("Export…"), QKeySequence(tr("Ctrl+E")),
                [this] { showExport(); });
  addMenuAction(this, file, "exportReport", tr("Report on the mesh…"),
                QKeySequence(tr("Ctrl+Alt+E")), [this] {
                  const QString path =
                      options_.chooser.save(this, "report.html", tr("Web page (*.html)"));
                  if (!path.isEmpty()) report_->write(path);
                });
  recipes_->addExport(file);
  pictures_->addActions(file);
  file->addSeparator();
  addMenuAction(this, file, "quit", tr("Quit"), QKeySequence::Quit, [this] { close(); });
}

void MainWindow::buildStatusBar() {
  hover_ = named(new QLabel(this), "hover");
  work_ = named(new QLabel(this), "work");
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 1000);
  progress_->setMaximumWidth(180);
  progress_->setTextVisible(false);
  keepRoom(progress_);
  statusBar()->addWidget(hover_, 1);
  statusBar()->addPermanentWidget(work_);
  statusBar()->addPermanentWidget(progress_);
}

void MainWindow::open(const QString& path, bool thenRun) {
  if (!cases_->mayLeave([this, path, thenRun] { open(path, thenRun); })) return;
  thenRun_ = thenRun;
  if (thenRun) runOnceLoaded();
  if (isCase(caseFolder(path.toStdString())))
    cases_->open(path);
  else
    models_->files.open(path);
}

void MainWindow::openSample(bool thenRun) {
  if (!cases_->mayLeave([this, thenRun] { openSample(thenRun); })) return;
  if (thenRun) runOnceLoaded();
  models_->files.openSample();
}

void MainWindow::runOnceLoaded() {
  auto* once = new QObject(this);
  connect(&models_->files, &CaseFiles::caseChanged, once, [this, once] {
    once->deleteLater();
    QMetaObject::invokeMethod(
        this, [this] { models_->runs.run(); }, Qt::QueuedConnection);
  });
  // A file that cannot be opened must not make the next one run.
  connect(&models_->files, &CaseFiles::loadingChanged, once, [this, once] {
    if (!models_->files.loading()) {
      once->deleteLater();
      QObject::disconnect(&models_->files, nullptr, once, nullptr);
    }
  });
}

bool MainWindow::offerRestore() { return cases_->offerRestore(); }

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty() && urls.first().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.isEmpty() || !urls.first().isLocalFile()) return;
  event->acceptProposedAction();
  open(urls.first().toLocalFile());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!cases_->mayLeave([this] { close(); })) {
    event->ignore();
    return;
  }
  workspaces_->remember();
  models_->cancel();
  sensitivity_->cancel();
  pictures_->cancel();
  models_->files.leaveCase();
  cases_->refreshModified();
  event->accept();
}

void MainWindow::refreshTitle() {
  setWindowTitle(models_->document.hasCase()
                     ? tr("%1[*] — Angiomesh").arg(recents_->titleOf(models_->document.caseName()))
                     : tr("Angiomesh"));
  cases_->refreshModified();
}

void MainWindow::refreshActions() {
  const bool idle = !models_->runs.running();
  const bool evolving = models_->runs.evolving();
  const bool any = models_->document.hasCase();
  enableActions(this, {"runAll"}, any && idle);
  enableActions(this, {"cancelRun"},
                !idle || models_->files.loading() || pictures_->turning() || sensitivity_->busy());
  enableActions(this, {"pauseRun", "finishRun"}, evolving);
  enableActions(this, {"stepRun"}, evolving && models_->runs.paused());
  actionOf(this, "pauseRun")->setText(models_->runs.paused() ? tr("Resume") : tr("Pause"));
  const bool mesh =
      models_->results.mesh(MeshKind::Exported) || models_->results.mesh(MeshKind::Unsmoothed);
  enableActions(this, {"exportReport"}, mesh);
  enableActions(this, {"export"}, mesh || models_->results.segmentation());
  enableActions(this, {"showIdentity"}, models_->files.dicomOrigin().has_value());
  enableActions(this, {"saveCase", "saveCaseAs"}, any && !models_->files.loading());
  enableActions(this, {"surface", "edges"}, mesh || models_->results.phi());
  enableActions(this, {"contours"}, mesh || models_->results.phi());
  enableActions(this,
                {"openMesh", "toolNavigate", "toolSeed", "toolRoi", "resetViews", "savePicture",
                 "copyPicture"},
                any);
  enableActions(this, {"clearSeeds"}, !models_->document.seeds().empty());
  enableActions(this, {"clearRoi"}, models_->document.parameters().preprocess.roi.has_value());
  tools_->refresh();
  showProgress();
}

void MainWindow::showExport() {
  auto* dialog = new ExportDialog(*models_, options_.chooser, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void MainWindow::showProgress() {
  QString text;
  double fraction = -1.0;
  if (models_->files.loading()) {
    text = tr("Loading");
    fraction = models_->files.loadFraction();
  } else if (const std::optional<Step> step = models_->runs.stepInWork()) {
    text = *step == Step::Evolve
               ? tr("%1: iteration %2").arg(stepTitle(*step)).arg(models_->runs.iterations())
               : stepTitle(*step);
    fraction = models_->runs.runFraction();
    if (const std::optional<double> left = models_->runs.secondsLeft())
      text += tr(", %1 left").arg(durationText(*left));
  } else if (pictures_->turning()) {
    text = tr("Turntable: picture %1 of %2").arg(pictures_->done()).arg(pictures_->count());
    fraction = static_cast<double>(pictures_->done()) / pictures_->count();
  }
  work_->setText(text);
  progress_->setVisible(fraction >= 0.0);
  progress_->setValue(static_cast<int>(1000.0 * fraction));
}

void MainWindow::chooseSeries(const QString& path, const std::vector<ImageSummary>& entries) {
  if (const auto chosen = options_.opening.choose(this, entries, options_.makeRunner)) {
    if (thenRun_) runOnceLoaded();
    models_->files.openSeries(path, entries[*chosen], false);
  }
}

void MainWindow::askToResample(const QString& path, const ImageSummary& entry,
                               const QString& reason) {
  if (options_.opening.resample(this, reason)) {
    if (thenRun_) runOnceLoaded();
    models_->files.openSeries(path, entry, true);
  }
}

void MainWindow::chooseLabel(const QString& path, const std::vector<Label>& labels,
                             double voxelMm3) {
  if (const auto answer = options_.opening.label(this, labels, voxelMm3)) {
    if (thenRun_) runOnceLoaded();
    models_->files.openLabel(path, *answer ? std::optional(labels[**answer]) : std::nullopt);
  }
}

void MainWindow::refreshRecent() {
  recent_->clear();
  const QStringList paths = recents_->paths();
  for (const QString& path : paths)
    recent_->addAction(QIcon(RecentCases::pictureOf(path)), QFileInfo(path).fileName(), this,
                       [this, path] { open(path); });
  recent_->addSeparator();
  recent_->addAction(tr("Forget these"), recents_, &RecentCases::forgetAll)
      ->setObjectName("forgetRecent");
  recent_->menuAction()->setVisible(!paths.isEmpty());
  centre_->setRecent(paths);
}

}  // namespace angiomesh
