// SPDX-License-Identifier: BSD-3-Clause
#include "gui/inspector/gate_list.h"

#include <QCoreApplication>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/model/step_text.h"
#include "gui/panel/named.h"

namespace angiomesh {

namespace {

/// Of rho, by the button.
constexpr double kFiner = 0.7;

QString mark(bool good) { return good ? QStringLiteral("✓") : QStringLiteral("✕"); }

QString translated(const char* text) { return QCoreApplication::translate("QualityGate", text); }

/// A row of the table: passed or not, what, how much, how much it is to be.
QString rowOf(const GateCheck& check) {
  const QualityMeasure& measure = *check.measure;
  const QString value = check.value ? QString::fromStdString(valueText(measure, *check.value)) +
                                          ' ' + unitText(measure.unit)
                                    : QStringLiteral("–");
  const QString weight = check.passed ? QString() : QStringLiteral(" style='font-weight:600'");
  const QString asked = QString::fromStdString(limitText(check))
                            .replace("deg", QStringLiteral("°"))
                            .replace(' ', QStringLiteral("&nbsp;"));
  return QStringLiteral(
             "<tr%1><td>%2&nbsp;</td><td>%3&nbsp;</td><td align='right'>%4&nbsp;</td>"
             "<td>%5</td></tr>")
      .arg(weight, mark(check.passed),
           QCoreApplication::translate("QualityMeasure", measure.label)
               .toHtmlEscaped()
               .replace(' ', QStringLiteral("&nbsp;")),
           value.toHtmlEscaped().replace(' ', QStringLiteral("&nbsp;")), asked);
}

/// Why it matters that rows above miss their thresholds, and what to do.
QString reasonOf(const GateCheck& check, GateFix fix) {
  return QStringLiteral("<tr><td></td><td colspan='3'>%1 %2</td></tr>")
      .arg(translated(check.limit->why).toHtmlEscaped(), translated(fixText(fix)).toHtmlEscaped());
}

}  // namespace

GateList::GateList(CaseModels& models, ViewState& state, QWidget* parent)
    : QWidget(parent), models_(models), state_(state) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  for (const QualityGate& gate : qualityGates()) {
    const QString name = QLatin1String(gate.name);
    if (name != "solver" && name != "print") continue;
    Part part{&gate, named(new QLabel(this), "gate:" + name),
              named(new QLabel(this), "limits:" + name)};
    part.heading->setToolTip(translated(gate.help));
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
  const bool cubes = state_.meshKind() == MeshKind::MarchingCubes ||
                     (made && made->surface.method == SurfaceMethod::MarchingCubes);
  // The triangles of marching cubes are as large as its cells, whatever rho is.
  return cubes && check.limit->fix == GateFix::SmallerRho ? GateFix::MeshAnew : check.limit->fix;
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
    const std::vector<GateCheck> checks = checkGate(*part.gate, *quality);
    const auto failed = std::count_if(checks.begin(), checks.end(),
                                      [](const GateCheck& check) { return !check.passed; });
    part.heading->setText(
        mark(failed == 0) + ' ' +
        (failed == 0 ? tr("<b>%1</b>: passes").arg(name)
                     : tr("<b>%1</b>: fails, %2 of %3").arg(name).arg(failed).arg(checks.size())));
    QString rows;
    const GateCheck* missed = nullptr;
    for (const GateCheck& check : checks) {
      if (check.passed) continue;
      // One reason for all that share it.
      if (missed && QLatin1String(missed->limit->why) != QLatin1String(check.limit->why))
        rows += reasonOf(*missed, fixOf(*missed));
      rows += rowOf(check);
      missed = &check;
    }
    if (missed) rows += reasonOf(*missed, fixOf(*missed));
    for (const GateCheck& check : checks)
      if (check.passed) rows += rowOf(check);
    part.rows->setText("<b>" + name + "</b><table>" + rows + "</table>");
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
