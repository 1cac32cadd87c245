// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/step_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "core/parameters/field.h"
#include "gui/model/step_text.h"
#include "gui/panel/field_editor.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

constexpr std::array kStates{StepState::Empty,   StepState::NotNeeded, StepState::Fresh,
                             StepState::Running, StepState::Stale,     StepState::Failed};

/// A sign beside the word, so that the state does not rest on colour.
QString signOf(StepState state) {
  switch (state) {
    case StepState::Empty:
    case StepState::NotNeeded:
      return QStringLiteral("○");
    case StepState::Fresh:
      return QStringLiteral("●");
    case StepState::Running:
      return QStringLiteral("▶");
    case StepState::Stale:
      return QStringLiteral("◐");
    case StepState::Failed:
      return QStringLiteral("✕");
  }
  return {};
}

}  // namespace

StepPanel::StepPanel(CaseModels& models, Step step, QWidget* parent)
    : QFrame(parent), models_(models), step_(step) {
  setObjectName(QStringLiteral("step:") + QLatin1String(stepId(step)));
  setFrameShape(QFrame::StyledPanel);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 5, 8, 6);
  column->setSpacing(3);
  buildHeader(*column);
  buildFields(*column);
  connect(&models_.document, &CaseDocument::parametersChanged, this, &StepPanel::showParameters);
  connect(&models_.presets, &PresetShelf::changed, this, &StepPanel::showParameters);
  connect(&models_.results, &ResultModel::resultsChanged, this, &StepPanel::showParameters);
  connect(&models_.runs, &RunModel::statesChanged, this, &StepPanel::showState);
  connect(&models_.timer, &JobTimer::ticked, this, &StepPanel::showProgress);
  showParameters();
  showState();
}

void StepPanel::buildHeader(QVBoxLayout& column) {
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  dot_ = new QLabel(this);
  for (const StepState state : kStates)
    dot_->setMinimumWidth(
        std::max(dot_->minimumWidth(), dot_->fontMetrics().horizontalAdvance(signOf(state)) + 2));
  row->addWidget(dot_);
  auto* title = new QLabel(stepTitle(step_), this);
  QFont bold = title->font();
  bold.setBold(true);
  title->setFont(bold);
  row->addWidget(title);
  row->addStretch(1);
  state_ = named(new QLabel(this), "state");
  row->addWidget(state_);
  run_ = named(new QToolButton(this), "runToHere");
  run_->setText(tr("Run to here"));
  run_->setToolTip(tr("Runs the pipeline up to this step"));
  row->addWidget(run_);
  connect(run_, &QToolButton::clicked, this, [this] { models_.runs.run(step_); });
  column.addLayout(row);
  progress_ = named(new QProgressBar(this), "progress");
  progress_->setMaximumHeight(5);
  progress_->setTextVisible(false);
  progress_->setRange(0, 1000);
  column.addWidget(progress_);
  keepRoom(progress_);
}

void StepPanel::buildFields(QVBoxLayout& column) {
  rest_ = named(new QWidget(this), "rest");
  auto* restColumn = new QVBoxLayout(rest_);
  restColumn->setContentsMargins(0, 0, 0, 0);
  restColumn->setSpacing(3);
  for (const Field& field : parameterFields()) {
    if (field.step != step_) continue;
    auto* editor = new FieldEditor(field, field.main ? static_cast<QWidget*>(this) : rest_);
    editors_.push_back(editor);
    connect(editor, &FieldEditor::edited, &models_.document, &CaseDocument::setField);
    if (field.main)
      column.addWidget(editor);
    else
      restColumn->addWidget(editor);
  }
  extras_ = new QVBoxLayout;
  extras_->setSpacing(3);
  column.addLayout(extras_);
  if (restColumn->count() > 0) {
    more_ = named(new QToolButton(this), "more");
    more_->setCheckable(true);
    more_->setAutoRaise(true);
    more_->setArrowType(Qt::RightArrow);
    more_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    column.addWidget(more_);
    connect(more_, &QToolButton::toggled, this, [this](bool on) {
      rest_->setVisible(on);
      more_->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
      showMore();
    });
  }
  column.addWidget(rest_);
  rest_->hide();
}

void StepPanel::addExtra(QWidget* widget) { extras_->addWidget(widget); }

void StepPanel::showParameters() {
  const Parameters& params = models_.document.parameters();
  const FieldContext context = models_.results.fieldContext();
  const QString baseName = QString::fromStdString(models_.presets.base().name);
  Parameters base = models_.presets.base().params;
  copyPlaces(params, base);
  changedBelow_ = 0;
  for (FieldEditor* editor : editors_) {
    const Field& field = editor->field();
    editor->display(field.get(params), suggestedValue(field, params, context),
                    sliderRange(field, context));
    const FieldValue wanted = field.get(base);
    const bool changed = field.get(params) != wanted;
    editor->setBase(wanted, baseName, changed);
    if (changed && !field.main) ++changedBelow_;
    if (field.idle) {
      const std::string idle = field.idle(params);
      editor->setIdle(QString::fromStdString(idle));
      if (field.key == "segmentation.label") editor->setVisible(idle.empty());  // of few images
    }
  }
  showMore();
}

void StepPanel::showMore() {
  if (!more_) return;
  more_->setText(more_->isChecked()  ? tr("Less")
                 : changedBelow_ > 0 ? tr("More (changed: %1)").arg(changedBelow_)
                                     : tr("More"));
}

void StepPanel::showState() {
  const StepState state = models_.runs.state(step_);
  dot_->setText(signOf(state));
  QString text;
  switch (state) {
    case StepState::Empty:
      text = tr("not run");
      break;
    case StepState::NotNeeded:
      text = tr("not needed");
      break;
    case StepState::Fresh:
      text = models_.results.seconds(step_) < 0.0
                 ? tr("fresh")
                 : tr("fresh, %1 s").arg(models_.results.seconds(step_), 0, 'f', 1);
      break;
    case StepState::Running:
      text = models_.runs.paused() ? tr("paused") : tr("running");
      break;
    case StepState::Stale:
      text = tr("stale");
      break;
    case StepState::Failed:
      text = tr("failed");
      break;
  }
  state_->setText(text);
  state_->setToolTip(models_.runs.failure(step_));
  progress_->setVisible(state == StepState::Running);
  run_->setEnabled(models_.document.hasCase() && !models_.runs.running() &&
                   state != StepState::NotNeeded);
  showProgress();
}

void StepPanel::showProgress() {
  if (!progress_->isVisibleTo(this)) return;
  progress_->setValue(static_cast<int>(1000.0 * models_.runs.stepFraction()));
}

}  // namespace angiomesh
