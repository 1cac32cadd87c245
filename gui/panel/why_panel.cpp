// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/why_panel.h"

#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <utility>

#include "core/base/formatted.h"
#include "gui/model/case_models.h"
#include "gui/pane/view_grid.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

QString number(double value) { return QString::number(value, 'g', 4); }

QString percent(double share) { return QString::number(100.0 * share, 'f', 0) + " %"; }

}  // namespace

WhyPanel::WhyPanel(CaseModels& models, const ViewGrid& views, const JobRunnerFactory& makeRunner,
                   QWidget* parent)
    : QWidget(parent),
      models_(models),
      views_(views),
      slot_(models.timer, makeRunner,
            [this](const std::shared_ptr<ReasonJob>& job) { finish(*job); }) {
  // What is said of a voxel may be long, and takes no room from the panes.
  QScrollArea* scroll = columnScroll(this);
  auto* content = new QWidget(scroll);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(6, 4, 6, 4);
  sentence_ = named(new QLabel(this), "whySentence");
  sentence_->setWordWrap(true);
  column->addWidget(sentence_);
  auto* form = new QFormLayout;
  form->setVerticalSpacing(1);
  const std::array<std::pair<QString, QString>, kRows> rows{{
      {tr("Place"), tr("The voxel of the grid that the method works on, and where it lies")},
      {tr("Distance to the wall"), tr("Negative inside")},
      {tr("Brightness"), tr("Of the preprocessed image, and how far that is on the way from the "
                            "surroundings to the lumen nearby")},
      {tr("Vesselness v"), tr("The value of largest magnitude over all scales, and the thresholds "
                              "that it is compared with")},
      {tr("Best scale"), tr("The scale at which that value was found, of those searched")},
      {tr("Eigenvalues"), tr("Of the Hessian times σ² at that scale: in a bright vessel the first "
                             "is near 0, and both others are negative and alike")},
      {tr("Speed p"), tr("1 pulls the front outwards, −1 inwards")},
      {tr("Curvature term"), tr("(1 − γ) |d κ|: pushes the front on at thin vessels")},
      {tr("Speed F"), tr("γ p + (1 − γ) |d κ|: the front moves outwards where it is positive")},
  }};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto* name = new QLabel(rows[i].first, this);
    values_[i] = named(new QLabel(this), QStringLiteral("why%1").arg(i));
    values_[i]->setWordWrap(true);
    values_[i]->setTextInteractionFlags(Qt::TextSelectableByMouse);
    name->setToolTip(rows[i].second);
    values_[i]->setToolTip(rows[i].second);
    form->addRow(name, values_[i]);
  }
  column->addLayout(form);
  column->addStretch(1);
  scroll->setWidget(content);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scroll);
  connect(&views_, &ViewGrid::crosshairMoved, this, &WhyPanel::ask);
  connect(&models_.results, &ResultModel::resultsChanged, this, &WhyPanel::ask);
  connect(&models_.files, &CaseFiles::caseChanged, this, &WhyPanel::ask);
  ask();
}

void WhyPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  ask();
}

void WhyPanel::ask() {
  if (!isVisible()) return;
  if (slot_) {
    askAgain_ = true;
    return;
  }
  std::shared_ptr<ReasonJob> job = models_.results.groundsOfSegmentation();
  if (!job) {
    say(models_.document.hasCase()
            ? tr("Run to Evolve, by the level set, to see why the voxel under "
                 "the crosshair is vessel or not.")
            : tr("Open a volume first."));
    return;
  }
  job->pointLps = views_.crosshair();
  slot_.startAndPoll(std::move(job));
}

void WhyPanel::finish(const ReasonJob& job) {
  if (std::exchange(askAgain_, false)) {
    ask();
    return;
  }
  if (job.reason)
    tell(*job.reason, job);
  else
    say(QString::fromStdString(job.error));
}

void WhyPanel::say(const QString& sentence) {
  sentence_->setText(sentence);
  for (QLabel* value : values_) value->clear();
}

void WhyPanel::tell(const VoxelReason& reason, const ReasonJob& job) {
  say(QString::fromStdString(reason.text(job.params)));
  const VoxelAtScale& best = reason.scales[reason.best];
  QStringList texts;
  texts << tr("voxel %1,%2,%3, %4")
               .arg(reason.voxel[0])
               .arg(reason.voxel[1])
               .arg(reason.voxel[2])
               .arg(QString::fromStdString(placeText(job.pointLps)));
  texts << tr("%1 mm").arg(number(reason.phiMm));
  QString brightness = number(reason.value);
  if (const std::optional<double> share = reason.brightness()) {
    brightness += tr(", %1 of the way from %2 to %3")
                      .arg(percent(*share), number(*reason.surroundings), number(*reason.lumen));
  }
  texts << brightness;
  texts << tr("%1 (b = %2, a = %3)")
               .arg(number(best.vesselness), number(reason.thresholds.b),
                    number(reason.thresholds.a));
  texts << tr("σ = %1 mm of %2 to %3 mm")
               .arg(number(best.sigmaMm), number(reason.scales.front().sigmaMm),
                    number(reason.scales.back().sigmaMm));
  texts << tr("%1, %2, %3")
               .arg(number(best.eigenvalues[0]), number(best.eigenvalues[1]),
                    number(best.eigenvalues[2]));
  texts << number(reason.p);
  texts << tr("%1 (κ = %2 per voxel)").arg(number(reason.curvatureTerm), number(reason.curvature));
  texts << number(reason.speed);
  for (std::size_t i = 0; i < values_.size(); ++i)
    values_[i]->setText(texts[static_cast<qsizetype>(i)]);
}

}  // namespace angiomesh
