// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/pipeline_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "gui/model/case_controller.h"
#include "gui/panel/case_tables.h"
#include "gui/panel/step_panel.h"
#include "gui/panel/surface_note.h"

namespace angiomesh {

PipelinePanel::PipelinePanel(CaseController& controller, QWidget* parent)
    : QWidget(parent), controller_(controller) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  auto* top = new QHBoxLayout;
  top->addWidget(new QLabel(tr("Preset"), this));
  preset_ = new QComboBox(this);
  preset_->setObjectName("preset");
  for (const std::string& name : presetNames()) {
    preset_->addItem(QString::fromStdString(name));
  }
  preset_->setPlaceholderText(tr("(changed)"));
  top->addWidget(preset_, 1);
  run_ = new QPushButton(tr("Run"), this);
  run_->setObjectName("run");
  run_->setToolTip(tr("Runs the whole pipeline; what is fresh is not computed again"));
  cancel_ = new QPushButton(tr("Cancel"), this);
  cancel_->setObjectName("cancel");
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
    auto* panel = new StepPanel(controller_, step, list);
    if (step == Step::Seeds) {
      panel->addExtra(new SeedList(controller_, panel));
    } else if (step == Step::Evolve) {
      panel->addExtra(new EvolutionControls(controller_, panel));
    } else if (step == Step::Surface) {
      panel->addExtra(new SurfaceNote(controller_, panel));
      panel->addExtra(new ComponentTable(controller_, panel));
    }
    steps->addWidget(panel);
  }
  steps->addStretch(1);
  scroll->setWidget(list);
  column->addWidget(scroll, 1);
  setMinimumWidth(360);

  connect(preset_, &QComboBox::textActivated, &controller_, &CaseController::applyPreset);
  connect(run_, &QPushButton::clicked, this, [this] { controller_.run(); });
  connect(cancel_, &QPushButton::clicked, &controller_, &CaseController::cancel);
  connect(&controller_, &CaseController::parametersChanged, this, &PipelinePanel::refreshPreset);
  connect(&controller_, &CaseController::statesChanged, this, &PipelinePanel::refreshButtons);
  refreshPreset();
  refreshButtons();
}

void PipelinePanel::refreshPreset() {
  const QSignalBlocker quiet(preset_);
  preset_->setCurrentIndex(preset_->findText(controller_.presetName()));
}

void PipelinePanel::refreshButtons() {
  run_->setEnabled(controller_.hasCase() && !controller_.running());
  cancel_->setEnabled(controller_.running() || controller_.loading());
}

}  // namespace angiomesh
