// SPDX-License-Identifier: BSD-3-Clause
#include "gui/inspector/quality_grid.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <algorithm>

#include "gui/inspector/quality_text.h"
#include "gui/model/step_text.h"
#include "gui/panel/surface_note.h"

namespace angiomesh {

namespace {

const QString kStar = QStringLiteral("★ ");

}  // namespace

QualityGrid::QualityGrid(CaseModels& models, QWidget* parent)
    : QTableWidget(static_cast<int>(qualityRows().size()), kMeshKindCount, parent),
      models_(models) {
  setObjectName("quality");
  build();
  connect(&models_.results, &ResultModel::resultsChanged, this, &QualityGrid::refresh);
  refresh();
}

void QualityGrid::build() {
  QStringList kinds, titles;
  for (int kind = 0; kind < kMeshKindCount; ++kind) {
    kinds << meshTitle(static_cast<MeshKind>(kind))
                 .replace(' ', '\n')
                 .replace("unsmoothed", "un-\nsmoothed")
                 .remove('(')
                 .remove(')');
  }
  for (const QualityMeasure* measure : qualityRows()) titles << qualityTitle(measure);
  setHorizontalHeaderLabels(kinds);
  setVerticalHeaderLabels(titles);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  QFont small = font();
  small.setPointSizeF(0.85 * small.pointSizeF());
  setFont(small);
  horizontalHeader()->setFont(small);
  verticalHeader()->setFont(small);
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  horizontalHeader()->setMinimumSectionSize(
      QFontMetrics(small).horizontalAdvance(QStringLiteral("smoothed")) + 8);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setAlternatingRowColors(true);
  for (int row = 0; row < rowCount(); ++row) {
    const QualityMeasure* measure = qualityRows()[static_cast<std::size_t>(row)];
    if (measure)
      verticalHeaderItem(row)->setToolTip(
          QCoreApplication::translate("QualityMeasure", measure->meaning));
    for (int kind = 0; kind < kMeshKindCount; ++kind) {
      auto* item = new QTableWidgetItem;
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      setItem(row, kind, item);
    }
  }
}

void QualityGrid::refresh() {
  setColumnHidden(static_cast<int>(MeshKind::File), !models_.results.mesh(MeshKind::File));
  std::vector<const MeshQuality*> meshes;
  for (int kind = 0; kind < kMeshKindCount; ++kind)
    meshes.push_back(models_.results.quality(static_cast<MeshKind>(kind)));
  for (int row = 0; row < rowCount(); ++row) {
    const QualityMeasure* measure = qualityRows()[static_cast<std::size_t>(row)];
    const std::vector<std::size_t> best =
        measure ? betterOnes(*measure, meshes) : std::vector<std::size_t>();
    for (int kind = 0; kind < kMeshKindCount; ++kind) {
      const auto i = static_cast<std::size_t>(kind);
      const bool better = std::find(best.begin(), best.end(), i) != best.end();
      const QString value = qualityValue(measure, meshes[i]);
      QTableWidgetItem* cell = item(row, kind);
      cell->setText(better ? kStar + value : value);
      QFont weight = font();
      weight.setBold(better);
      cell->setFont(weight);
      cell->setToolTip(better ? tr("The best of the meshes compared") : QString());
    }
  }
  refreshVerified();
}

void QualityGrid::refreshVerified() {
  const auto row = static_cast<int>(std::find(qualityRows().begin(), qualityRows().end(), nullptr) -
                                    qualityRows().begin());
  const SurfaceOrigin* origin = models_.results.surfaceOrigin();
  const QString text = origin ? verifiedText(*origin) : QString();
  const QString why = origin ? verifiedReasons(*origin) : QString();
  // Smoothing keeps what was verified: it neither cuts nor joins. Marching cubes is not checked.
  for (const MeshKind kind : {MeshKind::Exported, MeshKind::Unsmoothed}) {
    QTableWidgetItem* cell = item(row, static_cast<int>(kind));
    cell->setText(text.isEmpty() ? noFigure() : text);
    cell->setToolTip(why);
  }
}

}  // namespace angiomesh
