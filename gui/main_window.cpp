// SPDX-License-Identifier: BSD-3-Clause
#include "gui/main_window.h"

#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QProgressBar>
#include <QScreen>
#include <QSettings>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStatusBar>
#include <QToolBar>
#include <QUrl>
#include <algorithm>

#include "gui/job/known_sources.h"
#include "gui/model/case_ports.h"
#include "gui/model/step_text.h"
#include "gui/model/view_state.h"
#include "gui/panel/inspector_panel.h"
#include "gui/panel/log_panel.h"
#include "gui/panel/pipeline_panel.h"
#include "gui/panel/plot_widget.h"
#include "gui/panel/port_panel.h"
#include "gui/panel/view_grid.h"

namespace angiomesh {

namespace {

constexpr int kWidth = 1560, kHeight = 960;
constexpr int kPanelWidth = 400, kNarrowPanelWidth = 360;
constexpr int kInspectorHeight = 650, kPortsHeight = 250;
constexpr int kMostRecent = 10;
constexpr double kThickestSlabMm = 200.0;

QAction* actionOf(const QObject* parent, const char* name) {
  return parent->findChild<QAction*>(QLatin1String(name));
}

void enable(const QObject* parent, std::initializer_list<const char*> names, bool on) {
  for (const char* name : names) {
    actionOf(parent, name)->setEnabled(on);
  }
}

void check(const QObject* parent, const char* name, bool on) {
  actionOf(parent, name)->setChecked(on);
}

}  // namespace

MainWindow::MainWindow(MainWindowOptions options, QWidget* parent)
    : QMainWindow(parent),
      options_(std::move(options)),
      models_(std::make_unique<CaseModels>(options_.makeRunner, options_.recovery)),
      state_(new ViewState(*models_, this)),
      ports_(new CasePorts(*models_, options_.makeRunner, this)),
      views_(new ViewGrid(*models_, *state_, *ports_, this)) {
  setObjectName("mainWindow");
  keepSettingsPrivate();
  setAcceptDrops(true);
  const QSize room = screen()->availableSize();
  resize(std::min(kWidth, room.width()), std::min(kHeight, room.height()));
  setCentralWidget(views_);
  buildDocks();
  buildMenus();
  buildToolBar();
  buildStatusBar();
  connect(&models_->files, &CaseFiles::caseChanged, this, &MainWindow::refreshTitle);
  connect(&models_->runs, &RunModel::statesChanged, this, &MainWindow::refreshActions);
  connect(&models_->results, &ResultModel::resultsChanged, this, &MainWindow::refreshActions);
  connect(&models_->document, &CaseDocument::parametersChanged, this, &MainWindow::refreshActions);
  connect(&models_->runs, &RunModel::snapshotArrived, this, &MainWindow::refreshActions);
  connect(&models_->timer, &JobTimer::ticked, this, &MainWindow::showProgress);
  connect(&models_->files, &CaseFiles::opened, this, &MainWindow::remember);
  // Asked once the loader is done with the job: a dialog runs a loop of its own.
  connect(&models_->files, &CaseFiles::seriesFound, this, &MainWindow::chooseSeries,
          Qt::QueuedConnection);
  connect(&models_->files, &CaseFiles::labelsFound, this, &MainWindow::chooseLabel,
          Qt::QueuedConnection);
  connect(&models_->files, &CaseFiles::unevenFound, this, &MainWindow::askToResample,
          Qt::QueuedConnection);
  connect(state_, &ViewState::changed, this, &MainWindow::refreshViewActions);
  connectCases();
  connect(views_, &ViewGrid::hovered, hover_, &QLabel::setText);
  refreshTitle();
  refreshActions();
  refreshPortActions();
  refreshViewActions();
  refreshRecent();
}

MainWindow::~MainWindow() {
  // The panels listen to the ports and to the models: these go first, with their workers, and
  // say nothing more.
  ports_->disconnect();
  delete ports_;
  ports_ = nullptr;
  models_->document.undoStack()->disconnect(this);
  models_.reset();
}

void MainWindow::buildDocks() {
  const auto dock = [this](const char* name, const QString& title, Qt::DockWidgetArea area,
                           QWidget* content) {
    auto* widget = new QDockWidget(title, this);
    widget->setObjectName(QLatin1String(name));
    widget->setWidget(content);
    addDockWidget(area, widget);
    return widget;
  };
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  QDockWidget* pipeline = dock("pipelineDock", tr("Pipeline"), Qt::LeftDockWidgetArea,
                               new PipelinePanel(*models_, this));
  QDockWidget* inspector = dock("inspectorDock", tr("Mesh inspector"), Qt::RightDockWidgetArea,
                                new InspectorPanel(*models_, *state_, this));
  portPanel_ = new PortPanel(*ports_, this);
  QDockWidget* ports = dock("portsDock", tr("Ports"), Qt::RightDockWidgetArea, portPanel_);
  splitDockWidget(inspector, ports, Qt::Vertical);
  QDockWidget* log =
      dock("logDock", tr("Log"), Qt::BottomDockWidgetArea, new LogPanel(*models_, this));
  QDockWidget* plot = dock("convergenceDock", tr("Convergence"), Qt::BottomDockWidgetArea,
                           new ConvergencePlot(*models_, this));
  splitDockWidget(log, plot, Qt::Horizontal);
  resizeDocks({inspector, ports}, {kInspectorHeight, kPortsHeight}, Qt::Vertical);
  resizeDocks({log, plot}, {150, 150}, Qt::Vertical);
  const int side = width() < kWidth ? kNarrowPanelWidth : kPanelWidth;
  resizeDocks({pipeline, inspector}, {side, side}, Qt::Horizontal);
}

void MainWindow::buildToolBar() {
  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName("toolBar");
  bar->setMovable(false);
  const auto add = [&](std::initializer_list<const char*> names) {
    for (const char* name : names) {
      bar->addAction(actionOf(this, name));
    }
    bar->addSeparator();
  };
  add({"open", "saveCase", "export"});
  add({"undo", "redo"});
  add({"runAll", "cancelRun"});
  add({"toolNavigate", "toolSeed", "toolRoi", "toolCut"});
  bar->addWidget(new QLabel(tr(" Layer "), bar));
  layer_ = new QComboBox(bar);
  layer_->setObjectName("layer");
  for (int i = 0; i < kLayerCount; ++i) {
    layer_->addItem(layerTitle(static_cast<Layer>(i)));
  }
  bar->addWidget(layer_);
  bar->addWidget(new QLabel(tr("  Slab "), bar));
  slab_ = new QComboBox(bar);
  slab_->setObjectName("slab");
  slab_->addItems({tr("off"), tr("MIP"), tr("MinIP"), tr("mean")});
  bar->addWidget(slab_);
  thickness_ = new QDoubleSpinBox(bar);
  thickness_->setObjectName("thickness");
  thickness_->setRange(0.1, kThickestSlabMm);
  thickness_->setDecimals(1);
  thickness_->setSuffix(tr(" mm"));
  thickness_->setKeyboardTracking(false);
  bar->addWidget(thickness_);
  bar->addSeparator();
  for (const char* name : {"contours", "mip", "surface", "edges"}) {
    bar->addAction(actionOf(this, name));
  }
  connect(layer_, &QComboBox::activated, this,
          [this](int layer) { state_->setLayer(static_cast<Layer>(layer)); });
  connect(slab_, &QComboBox::activated, this, [this](int mode) {
    state_->setSlab(static_cast<SlabMode>(mode), state_->slabThicknessMm());
  });
  connect(thickness_, &QDoubleSpinBox::valueChanged, this,
          [this](double mm) { state_->setSlab(state_->slabMode(), mm); });
}

void MainWindow::buildStatusBar() {
  hover_ = new QLabel(this);
  hover_->setObjectName("hover");
  work_ = new QLabel(this);
  work_->setObjectName("work");
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 1000);
  progress_->setMaximumWidth(180);
  progress_->setTextVisible(false);
  statusBar()->addWidget(hover_, 1);
  statusBar()->addPermanentWidget(work_);
  statusBar()->addPermanentWidget(progress_);
}

void MainWindow::open(const QString& path, bool thenRun) {
  if (!mayLeave([this, path, thenRun] { open(path, thenRun); })) {
    return;
  }
  thenRun_ = thenRun;
  if (thenRun) {
    runOnceLoaded();
  }
  if (isCase(caseFolder(path.toStdString()))) {
    openCase(path);
  } else {
    models_->files.open(path);
  }
}

void MainWindow::openSample(bool thenRun) {
  if (!mayLeave([this, thenRun] { openSample(thenRun); })) {
    return;
  }
  if (thenRun) {
    runOnceLoaded();
  }
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

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty() && urls.first().isLocalFile()) {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.isEmpty() || !urls.first().isLocalFile()) {
    return;
  }
  event->acceptProposedAction();
  open(urls.first().toLocalFile());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayLeave([this] { close(); })) {
    event->ignore();
    return;
  }
  models_->cancel();
  models_->files.leaveCase();
  refreshModified();
  event->accept();
}

void MainWindow::refreshTitle() {
  setWindowTitle(models_->document.hasCase()
                     ? tr("%1[*] — Angiomesh").arg(models_->document.caseName())
                     : tr("Angiomesh"));
  refreshModified();
}

void MainWindow::refreshActions() {
  const bool idle = !models_->runs.running();
  const bool evolving = models_->runs.evolving();
  const bool any = models_->document.hasCase();
  enable(this, {"runAll"}, any && idle);
  enable(this, {"cancelRun"}, !idle || models_->files.loading());
  enable(this, {"pauseRun", "finishRun"}, evolving);
  enable(this, {"stepRun"}, evolving && models_->runs.paused());
  actionOf(this, "pauseRun")->setText(models_->runs.paused() ? tr("Resume") : tr("Pause"));
  const bool mesh =
      models_->results.mesh(MeshKind::Exported) || models_->results.mesh(MeshKind::Unsmoothed);
  enable(this, {"export"}, mesh);
  enable(this, {"saveCase", "saveCaseAs"}, any && !models_->files.loading());
  enable(this, {"surface", "edges"}, mesh || models_->results.liveSurface());
  enable(this, {"contours"}, mesh || models_->results.phi());
  enable(this, {"toolNavigate", "toolSeed", "toolRoi", "mip", "resetViews", "resetWindow"}, any);
  enable(this, {"clearSeeds"}, !models_->document.seeds().empty());
  enable(this, {"clearRoi"}, models_->document.parameters().preprocess.roi.has_value());
  layer_->setEnabled(any);
  slab_->setEnabled(any);
  thickness_->setEnabled(any && state_->slabMode() != SlabMode::None);
  const bool vesselness = models_->results.vesselnessResult() != nullptr;
  const std::array<bool, kLayerCount> there{
      any, models_->results.layer(Layer::Preprocessed) != nullptr, vesselness, vesselness};
  auto* items = qobject_cast<QStandardItemModel*>(layer_->model());
  for (int i = 0; i < kLayerCount; ++i) {
    items->item(i)->setEnabled(there[static_cast<std::size_t>(i)]);
  }
  showProgress();
}

void MainWindow::refreshViewActions() {
  const QSignalBlocker quietLayer(layer_);
  const QSignalBlocker quietSlab(slab_);
  const QSignalBlocker quietThickness(thickness_);
  layer_->setCurrentIndex(static_cast<int>(state_->layer()));
  slab_->setCurrentIndex(static_cast<int>(state_->slabMode()));
  thickness_->setValue(state_->slabThicknessMm());
  thickness_->setEnabled(models_->document.hasCase() && state_->slabMode() != SlabMode::None);
  check(this, "contours", state_->contours());
  check(this, "mip", state_->mip());
  check(this, "surface", state_->surface());
  check(this, "edges", state_->edges());
  check(this, "toolNavigate", state_->tool() == Tool::Navigate);
  check(this, "toolSeed", state_->tool() == Tool::PickSeed);
  check(this, "toolRoi", state_->tool() == Tool::DrawRoi);
  check(this, "toolCut", state_->tool() == Tool::CutVessel);
  check(this, "engineering", state_->scheme() == MouseScheme::Engineering);
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
  }
  work_->setText(text);
  progress_->setVisible(fraction >= 0.0);
  progress_->setValue(static_cast<int>(1000.0 * fraction));
}

void MainWindow::chooseSeries(const QString& path, const std::vector<ImageSummary>& entries) {
  if (const auto chosen = options_.opening.choose(this, entries, options_.makeRunner)) {
    if (thenRun_) {
      runOnceLoaded();
    }
    models_->files.openSeries(path, entries[*chosen], false);
  }
}

void MainWindow::askToResample(const QString& path, const ImageSummary& entry,
                               const QString& reason) {
  if (options_.opening.resample(this, reason)) {
    if (thenRun_) {
      runOnceLoaded();
    }
    models_->files.openSeries(path, entry, true);
  }
}

void MainWindow::chooseLabel(const QString& path, const std::vector<Label>& labels,
                             double voxelMm3) {
  if (const auto answer = options_.opening.label(this, labels, voxelMm3)) {
    if (thenRun_) {
      runOnceLoaded();
    }
    models_->files.openLabel(path, *answer ? std::optional(labels[**answer]) : std::nullopt);
  }
}

void MainWindow::remember(const QString& path) {
  QSettings settings;
  QStringList paths = settings.value("recent").toStringList();
  paths.removeAll(path);
  paths.prepend(path);
  settings.setValue("recent", QStringList(paths.mid(0, kMostRecent)));
  refreshRecent();
}

void MainWindow::refreshRecent() {
  recent_->clear();
  const QStringList paths = QSettings().value("recent").toStringList();
  for (const QString& path : paths) {
    recent_->addAction(QFileInfo(path).fileName(), this, [this, path] { open(path); });
  }
  recent_->menuAction()->setVisible(!paths.isEmpty());
}

}  // namespace angiomesh
