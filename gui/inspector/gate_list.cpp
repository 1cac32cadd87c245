// SPDX-License-Identifier: BSD-3-Clause
#include "gui/inspector/gate_list.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/inspector/quality_text.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

/// Of rho, by the button.
constexpr double kFiner = 0.7;

}  // namespace

GateList::GateList(CaseModels& models, ViewState& state, QWidget* parent)
    : QWidget(parent), models_(models), state_(state) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  for (const QualityGate* gate : shownGates()) {
    const QString name = QLatin1String(gate->name);
    Part part{gate, named(new QLabel(this), "gate:" + name),
              named(new QLabel(this), "limits:" + name)};
    part.heading->setToolTip(gateHelp(*gate));
    part.rows->setWordWrap(true);
    part.rows->setTextFormat(Qt::RichText);
    column->addWidget(part.heading);
    parts_.push_back(part);
  }
  loops_ = named(new QLabel(this), "loops");
  loops_->setWordWrap(true);
  column->addWidget(loops_);
  addFixes(column);
  for (const Part& part : parts_) column->addWidget(part.rows);
  column->addStretch(1);
  connect(&models_.results, &ResultModel::resultsChanged, this, &GateList::refresh);
  connect(&models_.document, &CaseDocument::parametersChanged, this, &GateList::refresh);
  connect(&state_, &ViewState::changed, this, &GateList::refresh);
  refresh();
}

void GateList::addFixes(QVBoxLayout* column) {
  const auto add = [&](const char* name, const QString& text, const QString& tip) {
    auto* button = named(new QPushButton(text, this), QLatin1String(name));
    button->setToolTip(tip);
    column->addWidget(button, 0, Qt::AlignLeft);
    return button;
  };
  const auto addFix = [&](GateFix fix, const char* name, const QString& text, const QString& tip) {
    QPushButton* button = add(name, text, tip);
    connect(button, &QPushButton::clicked, this, [this, fix] { apply(fix); });
    fixes_.push_back({fix, button});
  };
  addFix(GateFix::SmallerRho, "fixRho", tr("Smaller ρ (× 0.7)"),
         tr("Sets surface.rho: more triangles, which follow the wall more closely"));
  addFix(GateFix::RemoveParts, "fixParts", tr("Keep the largest part only"),
         tr("Sets segmentation.keep; single parts are unticked in the table of parts"));
  addFix(GateFix::CapEnds, "fixCaps", tr("Close the ends"), tr("Sets surface.border to cap"));
  addFix(GateFix::MeshAnew, "fixMesher", tr("Use the advancing front"),
         tr("Sets surface.method to advancing-front"));
  closeLoops_ = add("fixLoops", tr("Close thin loops"),
                    tr("Sets wall.smooth: holes and handles that noise explains are closed"));
  connect(closeLoops_, &QPushButton::clicked, this,
          [this] { models_.document.setField("wall.smooth", true); });
  then_ = named(new QLabel(tr("A parameter has changed: run again."), this), "fixThen");
  column->addWidget(then_);
}

GateFix GateList::fixOf(const GateCheck& check) const {
  const Parameters* made = models_.results.meshParameters();
  return helpfulFix(check, state_.meshKind(), made ? made->surface.method : SurfaceMethod());
}

bool GateList::canApply(GateFix fix) const {
  const Parameters& params = models_.document.parameters();
  switch (fix) {
    case GateFix::None:
      return false;
    case GateFix::MeshAnew:
      return params.surface.method != SurfaceMethod::AdvancingFront;
    case GateFix::SmallerRho:
      return params.surface.method != SurfaceMethod::MarchingCubes;
    case GateFix::RemoveParts:
      return params.segmentation.keep != KeepComponents::Largest;
    case GateFix::CapEnds:
      return params.surface.border != SurfaceBorder::Cap;
  }
  return false;
}

void GateList::apply(GateFix fix) {
  CaseDocument& document = models_.document;
  switch (fix) {
    case GateFix::None:
      break;
    case GateFix::MeshAnew:
      document.setField("surface.method", std::string("advancing-front"));
      break;
    case GateFix::SmallerRho:
      document.setField("surface.rho",
                        std::max(0.02, kFiner * document.parameters().surface.sizing.rho));
      break;
    case GateFix::RemoveParts:
      document.setField("segmentation.keep", std::string("largest"));
      break;
    case GateFix::CapEnds:
      document.setField("surface.border", std::string("cap"));
      break;
  }
}

void GateList::refresh() {
  const MeshQuality* quality = models_.results.quality(state_.meshKind());
  for (const Part& part : parts_) {
    const QString name = QLatin1String(part.gate->name);
    part.rows->setVisible(quality != nullptr);
    if (!quality) {
      part.heading->setText(tr("<b>%1</b>: not measured yet").arg(name));
      continue;
    }
    part.heading->setText(gateVerdict(*part.gate, *quality));
    part.rows->setText(
        "<b>" + name + "</b><table>" +
        gateRows(*part.gate, *quality, [this](const GateCheck& check) { return fixOf(check); }) +
        "</table>");
  }
  refreshFixes(quality);
}

void GateList::refreshFixes(const MeshQuality* quality) {
  for (const Fix& fix : fixes_) {
    bool helps = false;
    for (const Part& part : parts_)
      if (quality)
        for (const GateCheck& check : checkGate(*part.gate, *quality))
          helps = helps || (!check.passed && fixOf(check) == fix.fix);
    fix.button->setVisible(helps);
    fix.button->setEnabled(canApply(fix.fix));
  }
  const bool loops = quality && quality->genus > 0;
  loops_->setVisible(loops);
  closeLoops_->setVisible(loops);
  closeLoops_->setEnabled(!models_.document.parameters().wall.enabled);
  if (loops)
    loops_->setText(tr("Loops: %1. Vessels may join in rings; or two that touch have grown "
                       "together. A smooth wall closes thin loops, and Cut vessel parts two "
                       "vessels.")
                        .arg(quality->genus));
  then_->setVisible(quality && !models_.results.meshFresh());
}

}  // namespace angiomesh
