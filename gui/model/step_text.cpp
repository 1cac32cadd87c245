// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/step_text.h"

#include "core/parameters/field.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

namespace angiomesh {

QString stepTitle(Step step) { return QObject::tr(factsOf(step).title); }

QString layerTitle(Layer layer) {
  switch (layer) {
    case Layer::Source:
      return QObject::tr("Source");
    case Layer::Preprocessed:
      return QObject::tr("Preprocessed");
    case Layer::Vesselness:
      return QObject::tr("Vesselness");
    case Layer::Speed:
      return QObject::tr("Speed p");
  }
  return {};
}

QString meshTitle(MeshKind kind) {
  switch (kind) {
    case MeshKind::Exported:
      return QObject::tr("exported (smoothed)");
    case MeshKind::Unsmoothed:
      return QObject::tr("unsmoothed");
    case MeshKind::MarchingCubes:
      return QObject::tr("marching cubes");
    case MeshKind::File:
      return QObject::tr("from a file");
  }
  return {};
}

QString unitText(const char* unit) {
  return QString::fromLatin1(unit)
      .replace("deg", QStringLiteral("°"))
      .replace("mm2", QStringLiteral("mm²"))
      .replace("mm3", QStringLiteral("mm³"));
}

QString measureTitle(const TriangleMeasure& measure) {
  const QString label = QCoreApplication::translate("TriangleMeasure", measure.label);
  const QString unit = unitText(measure.unit);
  return unit.isEmpty() ? label : label + ", " + unit;
}

QString measureValue(const TriangleMeasure& measure, double value) {
  return QLocale().toString(value, 'f', measure.digits);
}

QString gridText(const Geometry& grid) {
  return QObject::tr("%1 × %2 × %3 voxels of %4 × %5 × %6 mm")
      .arg(grid.size[0])
      .arg(grid.size[1])
      .arg(grid.size[2])
      .arg(grid.spacing[0], 0, 'g', 4)
      .arg(grid.spacing[1], 0, 'g', 4)
      .arg(grid.spacing[2], 0, 'g', 4);
}

QString boxSizeText(const Eigen::Vector3d& size, LengthUnit unit) {
  const bool metres = unit == LengthUnit::Metre;
  const int decimals = metres ? 5 : 2;
  return QStringLiteral("%1 × %2 × %3 %4")
      .arg(size[0], 0, 'f', decimals)
      .arg(size[1], 0, 'f', decimals)
      .arg(size[2], 0, 'f', decimals)
      .arg(metres ? QStringLiteral("m") : QStringLiteral("mm"));
}

QString durationText(double seconds) {
  if (seconds < 7.5) return QObject::tr("a few seconds");
  if (seconds < 90.0)
    return QObject::tr("about %1 s")
        .arg(seconds < 55.0 ? 5 * std::lround(seconds / 5.0) : 10 * std::lround(seconds / 10.0));
  return QObject::tr("about %1 min").arg(std::lround(seconds / 60.0));
}

QString labelOf(const Field& field) {
  return QCoreApplication::translate("Parameter", field.label.c_str());
}

}  // namespace angiomesh
