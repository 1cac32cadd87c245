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

SurfaceNote::SurfaceNote(CaseController& controller, QWidget* parent)
    : QLabel(parent), controller_(controller) {
  setObjectName("surfaceNote");
  setWordWrap(true);
  connect(&controller_, &CaseController::parametersChanged, this, &SurfaceNote::refresh);
  connect(&controller_, &CaseController::resultsChanged, this, &SurfaceNote::refresh);
  connect(&controller_, &CaseController::statesChanged, this, &SurfaceNote::refresh);
  refresh();
}

void SurfaceNote::refresh() {
  QStringList parts;
  const std::optional<double> estimate = controller_.estimatedTriangles();
  const bool fresh = controller_.state(Step::Surface) == StepState::Fresh;
  const SurfaceOrigin* origin = fresh ? controller_.surfaceOrigin() : nullptr;
  if (const auto mesh = origin ? controller_.mesh(MeshKind::Unsmoothed) : nullptr) {
    parts << tr("%1 triangles")
                 .arg(QLocale().toString(static_cast<qulonglong>(mesh->triangles.size())));
  }
  if (estimate) {
    parts << tr("%1 expected")
                 .arg(parts.isEmpty() ? tr("about %1 triangles").arg(rounded(*estimate))
                                      : rounded(*estimate));
  }
  if (origin && origin->fromFrontPercent) {
    parts << tr("%1 % from the front").arg(*origin->fromFrontPercent, 0, 'f', 1);
  }
  if (origin && !origin->components.empty()) {
    parts << tr("%1 components verified").arg(verifiedText(*origin));
  }
  QStringList lines{parts.join(QStringLiteral(", "))};
  if (origin && !origin->fault().empty()) {
    lines << tr("Not fit for a solver: %1").arg(QString::fromStdString(origin->fault()));
  }
  lines << controller_.expectationWarnings();
  setText(lines.join('\n'));
  setToolTip(origin ? verifiedReasons(*origin) : QString());
  setVisible(!parts.isEmpty());
}

QString verifiedText(const SurfaceOrigin& origin) {
  if (origin.components.empty()) {
    return {};
  }
  return SurfaceNote::tr("%1 of %2")
      .arg(origin.components.size() - origin.unverified())
      .arg(origin.components.size());
}

QString verifiedReasons(const SurfaceOrigin& origin) {
  QStringList lines;
  for (const std::string& warning : origin.warnings()) {
    lines << QString::fromStdString(warning);
  }
  return lines.join('\n');
}

}  // namespace angiomesh
