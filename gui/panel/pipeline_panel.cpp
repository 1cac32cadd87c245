// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/pipeline_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "gui/model/case_models.h"
#include "gui/panel/case_tables.h"
#include "gui/panel/named.h"
#include "gui/panel/step_panel.h"
#include "gui/panel/surface_note.h"

namespace angiomesh {

PipelinePanel::PipelinePanel(CaseModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  auto* top = new QHBoxLayout;
  top->addWidget(new QLabel(tr("Preset"), this));
  preset_ = named(new QComboBox(this), "preset");
  for (const std::string& name : presetNames()) preset_->addItem(QString::fromStdString(name));
  preset_->setPlaceholderText(tr("(changed)"));
  top->addWidget(preset_, 1);
  run_ = named(new QPushButton(tr("Run"), this), "run");
  run_->setToolTip(tr("Runs the whole pipeline; what is fresh is not computed again"));
  cancel_ = named(new QPushButton(tr("Cancel"), this), "cancel");
  top->addWidget(run_);
  top->addWidget(cancel_);
  column->addLayout(top);

  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* list = new QWidget(scroll);
  auto* steps = new QVBoxLayout(list);
  steps->setContentsMargins(0, 0, 0, 0);
  steps->setSpacing(4);
  for (int i = static_cast<int>(Step::Preprocess); i < kStepCount; ++i) {
    const Step step = static_cast<Step>(i);
    auto* panel = new StepPanel(models_, step, list);
    if (step == Step::Seeds) {
      panel->addExtra(new SeedList(models_, panel));
    } else if (step == Step::Evolve) {
      panel->addExtra(new EvolutionControls(models_, panel));
    } else if (step == Step::Surface) {
      panel->addExtra(new SurfaceNote(models_, panel));
      panel->addExtra(new ComponentTable(models_, panel));
    }
    steps->addWidget(panel);
  }
  steps->addStretch(1);
  scroll->setWidget(list);
  column->addWidget(scroll, 1);
  setMinimumWidth(360);

  connect(preset_, &QComboBox::textActivated, &models_.document, &CaseDocument::applyPreset);
  connect(run_, &QPushButton::clicked, this, [this] { models_.runs.run(); });
  connect(cancel_, &QPushButton::clicked, this, [this] { models_.cancel(); });
  connect(&models_.document, &CaseDocument::parametersChanged, this, &PipelinePanel::refreshPreset);
  connect(&models_.runs, &RunModel::statesChanged, this, &PipelinePanel::refreshButtons);
  refreshPreset();
  refreshButtons();
}

void PipelinePanel::refreshPreset() {
  const QSignalBlocker quiet(preset_);
  preset_->setCurrentIndex(preset_->findText(models_.document.presetName()));
}

void PipelinePanel::refreshButtons() {
  run_->setEnabled(models_.document.hasCase() && !models_.runs.running());
  cancel_->setEnabled(models_.runs.running() || models_.files.loading());
}

}  // namespace angiomesh
