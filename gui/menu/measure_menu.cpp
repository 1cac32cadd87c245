// SPDX-License-Identifier: BSD-3-Clause
#include "gui/menu/measure_menu.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <array>
#include <utility>

#include "gui/findings/measurement_text.h"
#include "gui/menu/window_actions.h"
#include "gui/view/slice_view.h"
#include "gui/view/surface_view.h"

namespace angiomesh {

namespace {

constexpr int kToolsPerRow = 4, kEditsPerRow = 2;

struct ToolEntry {
  MeasurementKind kind;
  const char* action;
  const char* title;
  Qt::Key key;
};

/// In the order of MeasurementKind.
constexpr std::array<ToolEntry, kMeasurementKinds> kTools{
    {{MeasurementKind::Distance, "toolDistance",
      QT_TRANSLATE_NOOP("angiomesh::MeasureMenu", "Distance"), Qt::Key_F2},
     {MeasurementKind::Section, "toolSection",
      QT_TRANSLATE_NOOP("angiomesh::MeasureMenu", "Section"), Qt::Key_F3},
     {MeasurementKind::Profile, "toolProfile",
      QT_TRANSLATE_NOOP("angiomesh::MeasureMenu", "Diameter along a branch"), Qt::Key_F4},
     {MeasurementKind::Stenosis, "toolStenosis",
      QT_TRANSLATE_NOOP("angiomesh::MeasureMenu", "Stenosis"), Qt::Key_F5}}};

void addSection(MeasureMark& mark, const CrossSection& section) {
  mark.outlines.push_back(section.outline);
  mark.diameters.push_back(section.narrowest);
  mark.diameters.push_back(section.widest);
}

/// @param taken its places are shown as points also where they are not what is measured
MeasureMark markOf(const Measurement& m, bool taken) {
  MeasureMark mark;
  mark.name = mark.label = m.name;
  mark.labelLps = m.places.back();
  if (m.kind == MeasurementKind::Distance) {
    mark.lines.push_back({m.places[0], m.places[1]});
    mark.label = measurementValue(m).toStdString();
  }
  if (taken || m.kind == MeasurementKind::Distance) mark.points = m.places;
  for (const CrossSection& section : m.sections) addSection(mark, section);
  for (std::size_t i = 1; i < m.profile.size(); ++i)
    mark.lines.push_back({m.profile[i - 1].pointLps, m.profile[i].pointLps});
  if (!m.sections.empty()) mark.labelLps = m.sections.front().widest[1];
  return mark;
}

/// Of all measurements, and of places picked so far.
std::vector<MeasureMark> measureMarks(const CaseMeasures& measures,
                                      const std::optional<MarkPoint>& dragged) {
  std::vector<MeasureMark> marks;
  for (const Measurement& m : measures.all()) {
    const bool selected = &m == measures.selected();
    Measurement seen = m;
    if (dragged && dragged->mark == m.name && dragged->point < seen.places.size())
      seen.places[dragged->point] = dragged->lps;
    marks.push_back(markOf(seen, selected));
    marks.back().selected = selected;
    marks.back().dimmed = measures.isEarlier(m);
  }
  if (!measures.picked().empty()) {
    marks.emplace_back();
    marks.back().points = measures.picked();
    marks.back().selected = true;
  }
  return marks;
}

}  // namespace

MeasureMenu::MeasureMenu(QMainWindow* window, CaseModels& models, ViewState& state,
                         CaseMeasures& measures, MeasurePanel& panel, ViewGrid& views,
                         PathChooser chooser)
    : QObject(window),
      window_(window),
      models_(models),
      state_(state),
      measures_(measures),
      panel_(panel),
      views_(views),
      chooser_(std::move(chooser)),
      menu_(window->menuBar()->addMenu(tr("M&easure"))) {
  buildTools();
  menu_->addSeparator();
  buildEdits();
  connectPanes();
  connect(&measures_, &CaseMeasures::changed, this, &MeasureMenu::refresh);
  connect(&models_.files, &CaseFiles::caseChanged, this, &MeasureMenu::refresh);
  connect(&state_, &ViewState::changed, this, &MeasureMenu::follow);
  refresh();
  follow();
}

void MeasureMenu::buildTools() {
  QActionGroup* tools = actionOf(window_, "toolNavigate")->actionGroup();
  QList<QAction*> buttons;
  for (const ToolEntry& entry : kTools) {
    const QKeySequence keys(Qt::SHIFT | entry.key);
    QAction* action =
        addMenuToggle(window_, menu_, entry.action, tr(entry.title), keys,
                      [this, kind = entry.kind](bool) { state_.setTool(toolFor(kind)); });
    action->setToolTip(QStringLiteral("%1 (%2)").arg(measurementHint(entry.kind, 0),
                                                     keys.toString(QKeySequence::NativeText)));
    action->setIconText(measurementTitle(entry.kind));
    tools->addAction(action);
    buttons << action;
  }
  panel_.addButtons(buttons, kToolsPerRow);
}

void MeasureMenu::buildEdits() {
  // A copy of the name: the edit makes the measurements anew.
  const auto onSelected = [this](auto edit) {
    return [this, edit] {
      if (const Measurement* m = measures_.selected()) edit(QString::fromStdString(m->name));
    };
  };
  QAction* again =
      addMenuAction(window_, menu_, "measureAgain", tr("Measure again"), {},
                    onSelected([this](const QString& name) { measures_.measureAgain(name); }));
  again->setToolTip(tr("At the same places, on the wall that is shown"));
  QAction* rename = addMenuAction(window_, menu_, "renameMeasurement", tr("Rename"), {},
                                  onSelected([this](const QString& name) { panel_.edit(name); }));
  QAction* remove =
      addMenuAction(window_, menu_, "deleteMeasurement", tr("Delete"), {},
                    onSelected([this](const QString& name) { measures_.remove(name); }));
  menu_->addSeparator();
  QAction* table = addMenuAction(window_, menu_, "exportMeasurements", tr("Export as CSV…"), {},
                                 [this] { exportTable(); });
  panel_.addButtons({again, rename, remove, table}, kEditsPerRow);
}

void MeasureMenu::addTo(QToolBar* bar) {
  addMenuButton(window_, bar, "measureMenu", tr("Measure"), menu_);
}

void MeasureMenu::connectPanes() {
  const auto link = [this](auto* view) {
    using View = std::remove_pointer_t<decltype(view)>;
    connect(view, &View::measurePicked, this, [this](double x, double y, double z) {
      if (const auto kind = measuredBy(state_.tool())) measures_.pick(*kind, {x, y, z});
    });
  };
  for (int plane = 0; plane < 3; ++plane) {
    link(views_.slice(plane));
    connect(views_.slice(plane), &SliceView::pointedAt, this,
            [this, plane](double x, double y, double z) {
              showBand(plane, {x, y, z});
            });
    connectDragging(views_.slice(plane));
  }
  link(views_.surface());
  connect(&measures_, &CaseMeasures::goTo, &views_, &ViewGrid::goTo);
  connect(&panel_, &MeasurePanel::placePicked, this, [this](double x, double y, double z) {
    views_.setCrosshair({x, y, z});
  });
}

void MeasureMenu::connectDragging(const SliceView* pane) {
  connect(pane, &SliceView::markPressed, this, [this](const QString& name) {
    if (!name.isEmpty()) measures_.select(name);
  });
  connect(pane, &SliceView::markDragged, this, [this](const MarkPoint& point) {
    if (point.mark.empty()) return;
    dragged_ = point;
    dropped_ = false;
    showMarks();
  });
  connect(pane, &SliceView::markDropped, this, [this] {
    if (!dragged_) return;
    // Shown there until it is measured, or cannot be.
    dropped_ = true;
    measures_.movePlace(QString::fromStdString(dragged_->mark), dragged_->point, dragged_->lps);
    refresh();
  });
}

void MeasureMenu::refresh() {
  if (dropped_ && !measures_.busy()) {
    dragged_.reset();
    dropped_ = false;
  }
  const bool any = models_.document.hasCase();
  const Measurement* selected = measures_.selected();
  enableActions(window_, {"toolDistance"}, any);
  enableActions(window_, {"toolSection", "toolProfile", "toolStenosis"}, measures_.ready());
  enableActions(window_, {"renameMeasurement", "deleteMeasurement"}, selected != nullptr);
  enableActions(window_, {"measureAgain"}, selected && !selected->key.empty() && measures_.ready());
  enableActions(window_, {"exportMeasurements"}, any && !measures_.all().empty());
  showMarks();
}

/// The tool of the panes, where it measures.
void MeasureMenu::follow() {
  for (const ToolEntry& entry : kTools)
    actionOf(window_, entry.action)->setChecked(state_.tool() == toolFor(entry.kind));
  if (std::exchange(tool_, state_.tool()) == state_.tool()) return;
  if (const auto kind = measuredBy(tool_)) {
    auto* dock = window_->findChild<QDockWidget*>("measureDock");
    dock->show();
    dock->raise();
    measures_.prepare(*kind);
  } else {
    measures_.forgetPicked();
  }
}

void MeasureMenu::showMarks() {
  std::vector<MeasureMark> marks = measureMarks(measures_, dragged_);
  if (marks == shown_) return;
  shown_ = std::move(marks);
  for (int plane = 0; plane < 3; ++plane) views_.slice(plane)->setMeasures(shown_);
  views_.surface()->setMeasures(shown_);
}

/// From the place picked last to the mouse, in the pane that it is over.
void MeasureMenu::showBand(int plane, const Eigen::Vector3d& to) {
  if (measures_.picked().empty() || !measuredBy(tool_)) return;
  const Eigen::Vector3d from = measures_.picked().back();
  MeasureMark band;
  band.lines.push_back({from, to});
  band.selected = true;
  if (*measuredBy(tool_) == MeasurementKind::Distance) {
    Measurement distance;
    distance.kind = MeasurementKind::Distance;
    distance.places = {from, to};
    band.label = measurementValue(distance).toStdString();
    band.labelLps = to;
  }
  std::vector<MeasureMark> marks = shown_;
  marks.push_back(std::move(band));
  views_.slice(plane)->setMeasures(marks);
}

void MeasureMenu::addTo(QMenu* menu, const std::optional<Eigen::Vector3d>& place) {
  QMenu* here = menu->addMenu(tr("Measure here"));
  here->setObjectName("measureHere");
  for (const ToolEntry& entry : kTools) {
    const bool more = placesOf(entry.kind) > 1;
    QAction* action =
        here->addAction(more ? tr("%1 from here").arg(tr(entry.title)) : tr(entry.title), this,
                        [this, entry, place] {
                          state_.setTool(toolFor(entry.kind));
                          measures_.pick(entry.kind, *place);
                        });
    action->setObjectName(QString(entry.action) + "Here");
    action->setEnabled(place && actionOf(window_, entry.action)->isEnabled());
  }
}

void MeasureMenu::exportTable() {
  QString path = chooser_.save(window_, QStringLiteral("measurements.csv"),
                               tr("Comma-separated values (*.csv)"));
  if (path.isEmpty()) return;
  if (!path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) path += QStringLiteral(".csv");
  measures_.exportTable(path);
}

}  // namespace angiomesh
