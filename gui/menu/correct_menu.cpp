// SPDX-License-Identifier: BSD-3-Clause
#include "gui/menu/correct_menu.h"

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <array>
#include <cmath>
#include <utility>

#include "gui/menu/window_actions.h"
#include "gui/view/slice_view.h"
#include "gui/view/surface_view.h"

namespace angiomesh {

namespace {

struct ToolEntry {
  Tool tool;
  const char* action;
  const char* title;
  const char* hint;
  Qt::Key key;  ///< with Shift
};
constexpr std::array kTools{
    ToolEntry{Tool::BrushAdd, "toolAdd", QT_TRANSLATE_NOOP("angiomesh::CorrectMenu", "Add"),
              QT_TRANSLATE_NOOP("angiomesh::CorrectMenu", "Paint what is missing of a vessel"),
              Qt::Key_F6},
    ToolEntry{Tool::BrushErase, "toolErase", QT_TRANSLATE_NOOP("angiomesh::CorrectMenu", "Erase"),
              QT_TRANSLATE_NOOP("angiomesh::CorrectMenu", "Paint over what is no vessel"),
              Qt::Key_F7},
    ToolEntry{Tool::JoinEnds, "toolJoin",
              QT_TRANSLATE_NOOP("angiomesh::CorrectMenu", "Join two ends"),
              QT_TRANSLATE_NOOP("angiomesh::CorrectMenu",
                                "Click the two ends of a gap: they are joined along the vessel "
                                "between them"),
              Qt::Key_F8},
    ToolEntry{Tool::SeparateVessels, "toolSeparate",
              QT_TRANSLATE_NOOP("angiomesh::CorrectMenu", "Separate two vessels"),
              QT_TRANSLATE_NOOP("angiomesh::CorrectMenu",
                                "Click each of two vessels that touch, beside the place"),
              Qt::Key_F9}};

struct HereEntry {
  CorrectionKind kind;
  const char* action;
  const char* title;
  const char* hint;
};
constexpr std::array kHere{
    HereEntry{CorrectionKind::CutOff, "cutOffHere",
              QT_TRANSLATE_NOOP("angiomesh::CorrectMenu", "Cut off the smaller side"),
              QT_TRANSLATE_NOOP("angiomesh::CorrectMenu",
                                "Ends the vessel at the crosshair; no port is made")},
    HereEntry{CorrectionKind::FillHole, "fillHole",
              QT_TRANSLATE_NOOP("angiomesh::CorrectMenu", "Fill the hole"),
              QT_TRANSLATE_NOOP("angiomesh::CorrectMenu",
                                "Fills the cavity, or the hole through a vessel, at the "
                                "crosshair")},
    HereEntry{CorrectionKind::OpenLoop, "openLoop",
              QT_TRANSLATE_NOOP("angiomesh::CorrectMenu", "Open the loop"),
              QT_TRANSLATE_NOOP("angiomesh::CorrectMenu",
                                "Cuts the loop whose thinnest place is nearest to the "
                                "crosshair")}};

constexpr int kCircleSides = 48;

/// Around a place in a plane, mm.
std::vector<Eigen::Vector3d> circle(const Eigen::Vector3d& middle, const Eigen::Matrix3d& axes,
                                    double radius) {
  std::vector<Eigen::Vector3d> points;
  for (int n = 0; n < kCircleSides; ++n) {
    const double angle = 2.0 * M_PI * n / kCircleSides;
    points.emplace_back(middle +
                        radius * (std::cos(angle) * axes.col(0) + std::sin(angle) * axes.col(1)));
  }
  return points;
}

/// The axes of a pane: to the right, upwards, and across.
Eigen::Matrix3d axesOf(const SliceView* pane) {
  const Eigen::Vector3d origin = pane->lpsAt({0.0, 0.0});
  Eigen::Matrix3d axes;
  axes.col(0) = (pane->lpsAt({100.0, 0.0}) - origin).normalized();
  axes.col(1) = (pane->lpsAt({0.0, 100.0}) - origin).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

}  // namespace

CorrectMenu::CorrectMenu(QMainWindow* window, CaseModels& models, ViewState& state, ViewGrid& views)
    : QObject(window),
      window_(window),
      models_(models),
      state_(state),
      views_(views),
      menu_(window->menuBar()->addMenu(tr("C&orrect"))) {
  buildTools();
  menu_->addSeparator();
  buildHere();
  connectPanes();
  connect(&models_.corrections, &CaseCorrections::changed, this, &CorrectMenu::refresh);
  connect(&models_.files, &CaseFiles::caseChanged, this, &CorrectMenu::refresh);
  connect(&state_, &ViewState::changed, this, &CorrectMenu::follow);
  refresh();
  follow();
}

void CorrectMenu::buildTools() {
  QActionGroup* tools = actionOf(window_, "toolNavigate")->actionGroup();
  for (const ToolEntry& entry : kTools) {
    const QKeySequence keys(Qt::SHIFT | entry.key);
    QAction* action = addMenuToggle(window_, menu_, entry.action, tr(entry.title), keys,
                                    [this, tool = entry.tool](bool) { state_.setTool(tool); });
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(tr(entry.hint), keys.toString(QKeySequence::NativeText)));
    tools->addAction(action);
  }
  menu_->addSeparator();
  CaseCorrections& corrections = models_.corrections;
  addMenuAction(window_, menu_, "brushSmaller", tr("Smaller brush"),
                QKeySequence(Qt::Key_BracketLeft), [&corrections] { corrections.stepRadius(-1); });
  addMenuAction(window_, menu_, "brushLarger", tr("Larger brush"),
                QKeySequence(Qt::Key_BracketRight), [&corrections] { corrections.stepRadius(1); });
  QAction* edge = addMenuToggle(window_, menu_, "brushToEdge", tr("Stop at the edge in the image"),
                                {}, [&corrections](bool on) { corrections.setToEdge(on); });
  edge->setToolTip(
      tr("The brush adds only what is as bright as a vessel, and erases only what is not"));
}

void CorrectMenu::buildHere() {
  for (const HereEntry& entry : kHere) {
    QAction* action =
        addMenuAction(window_, menu_, entry.action, tr(entry.title), {},
                      [this, entry] { models_.corrections.pick(entry.kind, views_.crosshair()); });
    action->setToolTip(tr(entry.hint));
  }
}

void CorrectMenu::addTo(QToolBar* bar) {
  addMenuButton(window_, bar, "correctMenu", tr("Correct"), menu_);
}

void CorrectMenu::addTo(QMenu* menu, const std::optional<Eigen::Vector3d>& place) {
  QMenu* here = menu->addMenu(tr("Correct here"));
  here->setObjectName("correctHere");
  here->setEnabled(place && models_.corrections.ready());
  CaseCorrections& corrections = models_.corrections;
  const auto add = [&](const char* name, const QString& text, auto slot) {
    here->addAction(text, this, [slot, place] { slot(*place); })->setObjectName(name);
  };
  add("addHere", tr("Add with the brush"),
      [&corrections](const Eigen::Vector3d& p) { corrections.paint(true, {p}); });
  add("eraseHere", tr("Erase with the brush"),
      [&corrections](const Eigen::Vector3d& p) { corrections.paint(false, {p}); });
  for (const ToolEntry& entry : kTools)
    if (const auto kind = correctedBy(entry.tool))
      add(entry.action, tr("%1, from here").arg(tr(entry.title)),
          [this, &corrections, kind, tool = entry.tool](const Eigen::Vector3d& p) {
            state_.setTool(tool);
            corrections.pick(*kind, p);
          });
  for (const HereEntry& entry : kHere)
    add(entry.action, tr(entry.title),
        [&corrections, kind = entry.kind](const Eigen::Vector3d& p) { corrections.pick(kind, p); });
}

void CorrectMenu::connectPanes() {
  const auto link = [this](auto* view) {
    using View = std::remove_pointer_t<decltype(view)>;
    connect(view, &View::correctPicked, this, [this](double x, double y, double z) {
      pick({x, y, z});
    });
  };
  for (int plane = 0; plane < 3; ++plane) {
    const SliceView* pane = views_.slice(plane);
    link(views_.slice(plane));
    connect(pane, &SliceView::pointedAt, this, [this, plane](double x, double y, double z) {
      if (!drawing_ && (isBrush(tool_) || models_.corrections.picked())) sketch(plane, {{x, y, z}});
    });
    connect(pane, &SliceView::strokeMoved, this,
            [this, plane](const std::vector<Eigen::Vector3d>& line) {
              drawing_ = true;
              sketch(plane, line);
            });
    connect(pane, &SliceView::strokeDrawn, this, [this](const std::vector<Eigen::Vector3d>& line) {
      drawing_ = false;
      clearSketch();
      models_.corrections.paint(tool_ == Tool::BrushAdd, line);
    });
  }
  link(views_.surface());
}

void CorrectMenu::pick(const Eigen::Vector3d& place) {
  if (isBrush(tool_))
    models_.corrections.paint(tool_ == Tool::BrushAdd, {place});
  else if (const auto kind = correctedBy(tool_))
    models_.corrections.pick(*kind, place);
}

void CorrectMenu::refresh() {
  const bool ready = models_.corrections.ready();
  enableActions(
      window_,
      {"toolAdd", "toolErase", "toolJoin", "toolSeparate", "cutOffHere", "fillHole", "openLoop"},
      ready);
  enableActions(window_, {"brushSmaller", "brushLarger", "brushToEdge"},
                models_.document.hasCase());
  actionOf(window_, "brushToEdge")->setChecked(models_.corrections.toEdge());
  if (!ready && (isBrush(tool_) || correctedBy(tool_))) state_.setTool(Tool::Navigate);
  if (!models_.corrections.picked() && !isBrush(tool_)) clearSketch();
}

/// The tool of the panes, where it corrects.
void CorrectMenu::follow() {
  for (const ToolEntry& entry : kTools)
    actionOf(window_, entry.action)->setChecked(state_.tool() == entry.tool);
  if (std::exchange(tool_, state_.tool()) == state_.tool()) return;
  drawing_ = false;
  clearSketch();
  if (!correctedBy(tool_)) models_.corrections.forgetPicked();
}

void CorrectMenu::sketch(int plane, const std::vector<Eigen::Vector3d>& line) {
  SliceView* pane = views_.slice(plane);
  MeasureMark mark;
  mark.selected = true;
  if (const auto& picked = models_.corrections.picked()) {
    mark.points = {picked->placeLps};
    mark.lines.push_back({picked->placeLps, line.back()});
  } else {
    const double radius = models_.corrections.radiusMm();
    const Eigen::Matrix3d axes = axesOf(pane);
    mark.outlines = {circle(line.back(), axes, radius)};
    if (line.size() > 1) mark.outlines.push_back(circle(line.front(), axes, radius));
    for (std::size_t n = 1; n < line.size(); ++n) mark.lines.push_back({line[n - 1], line[n]});
  }
  if (sketched_ != plane) clearSketch();
  sketched_ = plane;
  pane->setSketch({mark});
}

void CorrectMenu::clearSketch() {
  if (sketched_ != ViewGrid::kNoSlice) views_.slice(sketched_)->setSketch({});
  sketched_ = ViewGrid::kNoSlice;
}

}  // namespace angiomesh
