// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view_tools.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QToolBar>
#include <array>
#include <utility>

#include "gui/action_icon.h"
#include "gui/language.h"
#include "gui/menu/volume_menu.h"
#include "gui/menu/window_actions.h"
#include "gui/menu/window_menu.h"
#include "gui/model/step_text.h"
#include "gui/pane_tools.h"
#include "gui/theme.h"
#include "gui/view/named.h"
#include "gui/view/slice_view.h"

namespace angiomesh {

namespace {

constexpr int kIconSize = 18;

struct LayoutEntry {
  PaneLayout layout;
  const char* action;
  const char* title;
};

/// In the order of PaneLayout.
constexpr std::array<LayoutEntry, 3> kLayouts{
    {{PaneLayout::Four, "layoutFour", QT_TRANSLATE_NOOP("angiomesh::ViewTools", "Two by two")},
     {PaneLayout::OneAndThree, "layoutOneAndThree",
      QT_TRANSLATE_NOOP("angiomesh::ViewTools", "One large, three small")},
     {PaneLayout::Single, "layoutSingle", QT_TRANSLATE_NOOP("angiomesh::ViewTools", "One alone")}}};

/// The large pane, the layout of all panes, the present layout.
const QString kPanesKey = QStringLiteral("panes");

}  // namespace

ViewTools::ViewTools(QMainWindow* window, CaseModels& models, ViewState& state, ViewGrid& views)
    : QObject(window),
      window_(window),
      models_(models),
      state_(state),
      views_(views),
      panes_(new PaneTools(window, models, state)) {
  connect(&state_, &ViewState::changed, this, &ViewTools::refreshActions);
}

void ViewTools::buildToolMenu() {
  QMenu* menu = window_->menuBar()->addMenu(tr("&Tools"));
  auto* tools = new QActionGroup(this);
  const auto tool = [&](const char* name, const QString& text, Qt::Key key, Tool which) {
    tools->addAction(addMenuToggle(window_, menu, name, text, QKeySequence(key),
                                   [this, which](bool) { state_.setTool(which); }));
  };
  tool("toolNavigate", tr("Navigate"), Qt::Key_F2, Tool::Navigate);
  tool("toolSeed", tr("Pick seed"), Qt::Key_F3, Tool::PickSeed);
  tool("toolRoi", tr("Draw ROI"), Qt::Key_F4, Tool::DrawRoi);
  tool("toolCut", tr("Cut vessel"), Qt::Key_F9, Tool::CutVessel);
  menu->addSeparator();
  addMenuToggle(window_, menu, "engineering", tr("Left button moves the crosshair (Engineering)"),
                QKeySequence(tr("Ctrl+M")), [this](bool on) {
                  state_.setScheme(on ? MouseScheme::Engineering : MouseScheme::Radiology);
                });
}

void ViewTools::addTo(QMenu* view) {
  addMenuToggle(window_, view, "contours", tr("Contours"), QKeySequence(tr("Ctrl+L")),
                [this](bool on) { state_.setContours(on); });
  new VolumeMenu(window_, view, models_, state_);
  addMenuToggle(window_, view, "surface", tr("Surface"), QKeySequence(tr("Ctrl+U")),
                [this](bool on) { state_.setSurface(on); });
  addMenuToggle(window_, view, "edges", tr("Edges"), QKeySequence(tr("Ctrl+G")),
                [this](bool on) { state_.setEdges(on); });
  addMenuToggle(window_, view, "interpolate", tr("Interpolate slices"), QKeySequence(tr("Ctrl+T")),
                [this](bool on) { state_.setInterpolated(on); });
  view->addSeparator();
  panes_->addTo(view);
  new WindowMenu(window_, view, models_, state_);
  addMenuAction(window_, view, "resetViews", tr("Reset all panes"), QKeySequence(tr("Ctrl+R")),
                [this] { views_.resetViews(); });
  view->addSeparator();
  addPanes(view);
  addThemes(view);
  addLanguages(view);
  view->addSeparator();
  for (QDockWidget* dock : window_->findChildren<QDockWidget*>())
    view->addAction(dock->toggleViewAction());
  addMenuAction(window_, view, "showLog", tr("Show the log"), QKeySequence(tr("Ctrl+Shift+L")),
                [this] { window_->findChild<QDockWidget*>("logDock")->show(); });
}

void ViewTools::addPanes(QMenu* view) {
  const std::array<std::pair<const char*, QString>, 4> panes{{{"axial", tr("Only axial")},
                                                              {"sagittal", tr("Only sagittal")},
                                                              {"coronal", tr("Only coronal")},
                                                              {"surface3d", tr("Only 3D")}}};
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const QString name = QLatin1String(panes[i].first);
    addMenuAction(window_, view, qPrintable("maximise-" + name), panes[i].second,
                  QKeySequence(QStringLiteral("Ctrl+%1").arg(i + 1)),
                  [this, name] { views_.toggleMaximised(views_.findChild<QWidget*>(name)); });
  }
  QMenu* layouts = view->addMenu(tr("Layout"));
  auto* group = new QActionGroup(this);
  for (std::size_t i = 0; i < kLayouts.size(); ++i) {
    group->addAction(
        addMenuToggle(window_, layouts, kLayouts[i].action, tr(kLayouts[i].title),
                      QKeySequence(QStringLiteral("Ctrl+%1").arg(i + panes.size() + 1)),
                      [this, i](bool) { views_.setPaneLayout(kLayouts[i].layout); }));
  }
  recallPanes();
  connect(&views_, &ViewGrid::arranged, this, [this] {
    refreshActions();
    rememberPanes();
  });
}

void ViewTools::addThemes(QMenu* view) {
  QMenu* themes = view->addMenu(tr("Theme"));
  auto* group = new QActionGroup(this);
  const auto theme = [&](const char* name, const QString& text, Theme which) {
    QAction* action = addMenuToggle(window_, themes, name, text, {}, [which](bool) {
      applyTheme(which);
      rememberTheme(which);
    });
    action->setChecked(which == rememberedTheme());
    group->addAction(action);
  };
  theme("themeSystem", tr("As the system"), Theme::System);
  theme("themeLight", tr("Light"), Theme::Light);
  theme("themeDark", tr("Dark"), Theme::Dark);
}

void ViewTools::addLanguages(QMenu* view) {
  QMenu* menu = view->addMenu(tr("Language, from the next start"));
  auto* group = new QActionGroup(this);
  const auto language = [&](const QString& code, const QString& text) {
    const std::string name = "language_" + code.toStdString();
    QAction* action = addMenuToggle(window_, menu, name.c_str(), text, {},
                                    [code](bool) { rememberLanguage(code); });
    action->setChecked(code == rememberedLanguage());
    group->addAction(action);
  };
  language({}, tr("As the system"));
  for (const Language& known : languages()) language(known.code, known.name);
}

void ViewTools::addIcons() {
  for (auto& [bar, width] : bars_) {
    for (QAction* action : bar->actions()) {
      action->setIcon(actionIcon(action->objectName()));
      action->setIconVisibleInMenu(false);
    }
  }
  window_->installEventFilter(this);
}

bool ViewTools::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::Show) fitToolBars();
  return QObject::eventFilter(watched, event);
}

void ViewTools::fitToolBars() {
  for (auto& [bar, width] : bars_) {
    if (bar->toolButtonStyle() == Qt::ToolButtonTextBesideIcon) width = bar->sizeHint().width();
    // Rather no text, which the tooltips have too, than tools behind an arrow.
    bar->setToolButtonStyle(width > window_->width() ? Qt::ToolButtonIconOnly
                                                     : Qt::ToolButtonTextBesideIcon);
  }
}

void ViewTools::recallPanes() {
  const QStringList kept = QSettings().value(kPanesKey).toStringList();
  for (const QString& id : kept.mid(1))
    for (const LayoutEntry& entry : kLayouts)
      if (id == QLatin1String(entry.action)) views_.setPaneLayout(entry.layout);
  auto* large = kept.isEmpty() ? nullptr : views_.findChild<VtkView*>(kept.first());
  if (large) views_.setLargePane(large);
}

void ViewTools::rememberPanes() const {
  QStringList kept{views_.largePane()->objectName()};
  for (const PaneLayout layout : {views_.layoutOfAll(), views_.paneLayout()})
    kept << QLatin1String(kLayouts[static_cast<std::size_t>(layout)].action);
  QSettings().setValue(kPanesKey, kept);
}

QToolBar* ViewTools::addBar(const char* name, const QString& title) {
  auto* bar = named(new QToolBar(title, window_), name);
  bar->setMovable(false);
  bar->setIconSize({kIconSize, kIconSize});
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  window_->addToolBar(bar);
  bars_.emplace_back(bar, 0);
  return bar;
}

QToolBar* ViewTools::buildToolBars() {
  QToolBar* work = addBar("toolBar", tr("Work"));
  window_->addToolBarBreak();
  QToolBar* panes = addBar("paneBar", tr("Panes"));
  const auto add = [this](QToolBar* bar, std::initializer_list<const char*> names) {
    if (!bar->actions().isEmpty()) bar->addSeparator();
    for (const char* name : names) bar->addAction(actionOf(window_, name));
  };
  add(work, {"open", "saveCase", "export"});
  add(work, {"undo", "redo"});
  add(work, {"runAll", "cancelRun"});
  add(work, {"contours", "mip", "surface", "edges"});
  add(panes, {"toolNavigate", "toolSeed", "toolRoi", "toolCut"});
  panes->addSeparator();
  buildChoosers(panes);
  return work;
}

void ViewTools::buildChoosers(QToolBar* bar) {
  bar->addWidget(new QLabel(tr(" Layer "), bar));
  layer_ = named(new QComboBox(bar), "layer");
  for (int i = 0; i < kLayerCount; ++i) layer_->addItem(layerTitle(static_cast<Layer>(i)));
  bar->addWidget(layer_);
  panes_->addTo(bar);
  bar->addWidget(new QLabel(tr("  Slab "), bar));
  slab_ = named(new QComboBox(bar), "slab");
  slab_->addItems({tr("off"), tr("MIP"), tr("MinIP"), tr("mean")});
  slab_->setPlaceholderText(tr("by pane"));
  slab_->setToolTip(
      tr("Of all slice panes. The right-click menu of a pane, M and Alt with the "
         "wheel change one of them."));
  bar->addWidget(slab_);
  thickness_ = named(new QDoubleSpinBox(bar), "thickness");
  thickness_->setRange(0.1, kThickestSlabMm);
  thickness_->setDecimals(1);
  thickness_->setSuffix(tr(" mm"));
  thickness_->setKeyboardTracking(false);
  bar->addWidget(thickness_);
  connect(layer_, &QComboBox::activated, this,
          [this](int layer) { state_.setLayer(static_cast<Layer>(layer)); });
  connect(slab_, &QComboBox::activated, this, [this](int mode) {
    state_.setSlabs({static_cast<SlabMode>(mode), thickness_->value()});
  });
  connect(thickness_, &QDoubleSpinBox::valueChanged, this, [this](double mm) { setThickness(mm); });
}

bool ViewTools::anySlab() const {
  return state_.slab(0).mode != SlabMode::None || state_.slab(1).mode != SlabMode::None ||
         state_.slab(2).mode != SlabMode::None;
}

void ViewTools::setThickness(double mm) {
  for (const int plane : {0, 1, 2}) state_.setSlab(plane, {state_.slab(plane).mode, mm});
}

void ViewTools::refresh() {
  const bool any = models_.document.hasCase();
  layer_->setEnabled(any);
  panes_->refresh();
  slab_->setEnabled(any);
  thickness_->setEnabled(any && anySlab());
  const bool vesselness = models_.results.vesselnessResult() != nullptr;
  const std::array<bool, kLayerCount> there{
      any, models_.results.layer(Layer::Preprocessed) != nullptr, vesselness, vesselness};
  auto* items = qobject_cast<QStandardItemModel*>(layer_->model());
  for (int i = 0; i < kLayerCount; ++i)
    items->item(i)->setEnabled(there[static_cast<std::size_t>(i)]);
}

void ViewTools::refreshActions() {
  const auto check = [this](const char* name, bool on) { actionOf(window_, name)->setChecked(on); };
  const QSignalBlocker quietLayer(layer_);
  const QSignalBlocker quietSlab(slab_);
  const QSignalBlocker quietThickness(thickness_);
  layer_->setCurrentIndex(static_cast<int>(state_.layer()));
  const Slab& axial = state_.slab(2);
  const bool same = state_.slab(0).mode == axial.mode && state_.slab(1).mode == axial.mode;
  slab_->setCurrentIndex(same ? static_cast<int>(axial.mode) : -1);
  for (const int plane : {0, 1, 2})
    if (plane == 2 || state_.slab(plane).mode != SlabMode::None)
      thickness_->setValue(state_.slab(plane).thicknessMm);
  thickness_->setEnabled(models_.document.hasCase() && anySlab());
  check("contours", state_.contours());
  check("surface", state_.surface());
  check("edges", state_.edges());
  check("interpolate", state_.interpolated());
  check("toolNavigate", state_.tool() == Tool::Navigate);
  check("toolSeed", state_.tool() == Tool::PickSeed);
  check("toolRoi", state_.tool() == Tool::DrawRoi);
  check("toolCut", state_.tool() == Tool::CutVessel);
  for (const LayoutEntry& entry : kLayouts)
    check(entry.action, views_.paneLayout() == entry.layout);
  check("engineering", state_.scheme() == MouseScheme::Engineering);
}

}  // namespace angiomesh
