// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/pipeline_panel.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "gui/model/case_models.h"
#include "gui/model/step_text.h"
#include "gui/panel/case_tables.h"
#include "gui/panel/field_editor.h"
#include "gui/panel/step_panel.h"
#include "gui/panel/surface_note.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

/// Of the notes, which keep this room whether there are any or not.
constexpr int kNoteLines = 3;
/// Of the chooser of presets, which cuts longer names.
constexpr int kPresetLetters = 6;
/// Left and right of the fields: of the panel, the steps and their frames, pixels.
constexpr int kStepMargins = 30;

}  // namespace

PipelinePanel::PipelinePanel(CaseModels& models, QWidget* parent)
    : QWidget(parent), models_(models), preview_(&models.live) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  auto* top = new QHBoxLayout;
  top->addWidget(new QLabel(tr("Preset"), this));
  preset_ = named(new QComboBox(this), "preset");
  preset_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  preset_->setMinimumContentsLength(kPresetLetters);
  top->addWidget(preset_, 1);
  presetMenu_ = named(new QToolButton(this), "presetMenuButton");
  presetMenu_->setText(QStringLiteral("…"));
  presetMenu_->setToolTip(tr("Save, remove, import and export presets"));
  presetMenu_->setPopupMode(QToolButton::InstantPopup);
  top->addWidget(presetMenu_);
  run_ = named(new QPushButton(tr("Run"), this), "run");
  run_->setToolTip(tr("Runs the whole pipeline; what is fresh is not computed again"));
  cancel_ = named(new QPushButton(tr("Cancel"), this), "cancel");
  top->addWidget(run_);
  top->addWidget(cancel_);
  column->addLayout(top);
  column->addWidget(buildLive());

  QScrollArea* scroll = columnScroll(this);
  // Always there, so that a longer list does not make the sliders shorter.
  scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  auto* list = new QWidget(scroll);
  auto* steps = new QVBoxLayout(list);
  steps->setContentsMargins(0, 0, 0, 0);
  steps->setSpacing(4);
  for (int i = static_cast<int>(Step::Preprocess); i < kStepCount; ++i) {
    const Step step = static_cast<Step>(i);
    auto* panel = new StepPanel(models_, step, list);
    if (step == Step::Seeds) {
      panel->addExtra(new SeedList(models_, panel));
    } else if (step == Step::Correct) {
      panel->addExtra(new CorrectionList(models_, panel));
    } else if (step == Step::Evolve) {
      panel->addExtra(new EvolutionControls(models_, panel));
    }
    steps->addWidget(panel);
  }
  // Below all sliders, since it comes and grows.
  steps->addWidget(new ComponentTable(models_, list));
  steps->addStretch(1);
  scroll->setWidget(list);
  column->addWidget(scroll, 1);
  column->addWidget(buildNotes());
  int widest = 0;
  for (const auto* editor : list->findChildren<FieldEditor*>())
    widest = std::max(widest, editor->minimumSizeHint().width());
  setMinimumWidth(widest + scroll->verticalScrollBar()->sizeHint().width() + kStepMargins);

  connect(preset_, &QComboBox::textActivated, &models_.presets, &PresetShelf::apply);
  connect(&models_.presets, &PresetShelf::changed, this, &PipelinePanel::listPresets);
  connect(run_, &QPushButton::clicked, this, [this] { models_.runs.run(); });
  connect(cancel_, &QPushButton::clicked, this, [this] { models_.cancel(); });
  connect(&models_.document, &CaseDocument::parametersChanged, this, &PipelinePanel::refreshPreset);
  connect(&models_.runs, &RunModel::statesChanged, this, &PipelinePanel::refreshButtons);
  connect(&models_.runs, &RunModel::statesChanged, this, &PipelinePanel::refreshFailure);
  listPresets();
  refreshFailure();
  refreshButtons();
}

QWidget* PipelinePanel::buildLive() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  live_ = named(new QCheckBox(tr("Live"), bar), "live");
  live_->setToolTip(
      tr("Tries what is changed below Seeds at once, in a box around the crosshair. The result "
         "stays as it is until you run."));
  liveSide_ = named(new QSpinBox(bar), "liveSide");
  liveSide_->setRange(LivePreview::kLeastSide, LivePreview::kGreatestSide);
  liveSide_->setSingleStep(8);
  liveSide_->setValue(models_.live.side());
  liveSide_->setKeyboardTracking(false);
  liveSide_->setToolTip(tr("Side of the box in voxels: a smaller one answers faster"));
  liveStatus_ = named(new QLabel(bar), "liveStatus");
  liveStatus_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(live_);
  row->addWidget(liveSide_);
  row->addWidget(liveStatus_, 1);
  connect(live_, &QCheckBox::toggled, &models_.live, &LivePreview::setOn);
  connect(liveSide_, &QSpinBox::valueChanged, &models_.live, &LivePreview::setSide);
  connect(&models_.live, &LivePreview::changed, this, &PipelinePanel::refreshLive);
  connect(&models_.document, &CaseDocument::parametersChanged, this, &PipelinePanel::refreshLive);
  connect(&models_.results, &ResultModel::resultsChanged, this, &PipelinePanel::refreshLive);
  connect(&models_.runs, &RunModel::statesChanged, this, &PipelinePanel::refreshLive);
  refreshLive();
  return bar;
}

void PipelinePanel::refreshLive() {
  const QSignalBlocker quiet(live_);
  live_->setChecked(models_.live.on());
  liveStatus_->setText(models_.live.status());
  liveStatus_->setToolTip(models_.live.status());
  liveStatus_->setEnabled(models_.live.phi() != nullptr);
}

void PipelinePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (preview_) preview_->setWatched(true);
}

void PipelinePanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (preview_) preview_->setWatched(false);
}

QWidget* PipelinePanel::buildNotes() {
  QScrollArea* scroll = columnScroll(this);
  scroll->setFixedHeight(kNoteLines * fontMetrics().lineSpacing() + 4);
  auto* notes = new QWidget(scroll);
  auto* column = new QVBoxLayout(notes);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(3);
  failure_ = named(new QLabel(notes), "failure");
  failure_->setWordWrap(true);
  column->addWidget(failure_);
  column->addWidget(new SurfaceNote(models_, notes));
  column->addStretch(1);
  scroll->setWidget(notes);
  return scroll;
}

void PipelinePanel::refreshFailure() {
  QStringList lines;
  for (int i = 0; i < kStepCount; ++i) {
    const Step step = static_cast<Step>(i);
    const QString reason = models_.runs.failure(step);
    if (!reason.isEmpty()) lines << tr("✕ %1 failed: %2").arg(stepTitle(step), reason);
  }
  failure_->setText(lines.join('\n'));
  failure_->setVisible(!lines.isEmpty());
}

void PipelinePanel::setPresetMenu(QMenu* menu) { presetMenu_->setMenu(menu); }

void PipelinePanel::listPresets() {
  const QSignalBlocker quiet(preset_);
  preset_->clear();
  bool own = false;
  for (const Preset& preset : models_.presets.all()) {
    const QString name = QString::fromStdString(preset.name);
    if (!std::exchange(own, models_.presets.isOwn(name)) && own)
      preset_->insertSeparator(preset_->count());
    preset_->addItem(name);
    preset_->setItemData(preset_->count() - 1, models_.presets.about(preset), Qt::ToolTipRole);
  }
  // Names that the box cuts are whole in its list.
  preset_->view()->setMinimumWidth(preset_->view()->sizeHintForColumn(0) + 24);
  refreshPreset();
}

void PipelinePanel::refreshPreset() {
  const QSignalBlocker quiet(preset_);
  const Preset& base = models_.presets.base();
  const QString name = QString::fromStdString(base.name);
  const bool changed = models_.presets.current().isEmpty();
  preset_->setPlaceholderText(tr("%1, changed").arg(name));
  preset_->setCurrentIndex(changed ? -1 : preset_->findText(name));
  preset_->setToolTip(models_.presets.about(base));
}

void PipelinePanel::refreshButtons() {
  run_->setEnabled(models_.document.hasCase() && !models_.runs.running());
  cancel_->setEnabled(models_.runs.running() || models_.files.loading());
}

}  // namespace angiomesh
