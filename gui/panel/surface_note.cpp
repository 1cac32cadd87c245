// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/surface_note.h"

#include <QLocale>
#include <cmath>

namespace angiomesh {

namespace {

/// An estimate, with no more digits than it is worth.
QString rounded(double triangles) {
  const double unit =
      triangles < 100.0 ? 1.0 : std::pow(10.0, std::floor(std::log10(triangles)) - 2.0);
  return QLocale().toString(static_cast<qlonglong>(std::llround(triangles / unit) * unit));
}

}  // namespace

SurfaceNote::SurfaceNote(CaseModels& models, QWidget* parent) : QLabel(parent), models_(models) {
  setObjectName("surfaceNote");
  setWordWrap(true);
  connect(&models_.document, &CaseDocument::parametersChanged, this, &SurfaceNote::refresh);
  connect(&models_.results, &ResultModel::resultsChanged, this, &SurfaceNote::refresh);
  connect(&models_.runs, &RunModel::statesChanged, this, &SurfaceNote::refresh);
  refresh();
}

void SurfaceNote::refresh() {
  QStringList parts;
  const std::optional<double> estimate = models_.results.estimatedTriangles();
  const bool fresh = models_.runs.state(Step::Surface) == StepState::Fresh;
  const SurfaceOrigin* origin = fresh ? models_.results.surfaceOrigin() : nullptr;
  if (const auto mesh = origin ? models_.results.mesh(MeshKind::Unsmoothed) : nullptr) {
    parts << tr("%1 triangles")
                 .arg(QLocale().toString(static_cast<qulonglong>(mesh->triangles.size())));
  }
  if (estimate) {
    parts << tr("%1 expected")
                 .arg(parts.isEmpty() ? tr("about %1 triangles").arg(rounded(*estimate))
                                      : rounded(*estimate));
  }
  if (origin && origin->fromFrontPercent)
    parts << tr("%1 % from the front").arg(*origin->fromFrontPercent, 0, 'f', 1);
  if (origin && !origin->components.empty())
    parts << tr("%1 components verified").arg(verifiedText(*origin));
  QStringList lines{parts.join(QStringLiteral(", "))};
  if (origin && !origin->fault().empty())
    lines << tr("Not fit for a solver: %1").arg(QString::fromStdString(origin->fault()));
  lines << models_.results.expectationWarnings();
  setText(lines.join('\n'));
  setToolTip(origin ? verifiedReasons(*origin) : QString());
  setVisible(!parts.isEmpty());
}

QString verifiedText(const SurfaceOrigin& origin) {
  if (origin.components.empty()) return {};
  return SurfaceNote::tr("%1 of %2")
      .arg(origin.components.size() - origin.unverified())
      .arg(origin.components.size());
}

QString verifiedReasons(const SurfaceOrigin& origin) {
  QStringList lines;
  for (const std::string& warning : origin.warnings()) lines << QString::fromStdString(warning);
  return lines.join('\n');
}

}  // namespace angiomesh
