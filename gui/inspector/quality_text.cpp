// SPDX-License-Identifier: BSD-3-Clause
#include "gui/inspector/quality_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "core/quality/quality_table.h"
#include "gui/model/step_text.h"

namespace angiomesh {

namespace {

/// Of the surface, not of a mesh's quality.
constexpr const char* kVerifiedTitle = QT_TRANSLATE_NOOP("QualityMeasure", "Verified parts");

struct Quality {
  Q_DECLARE_TR_FUNCTIONS(Quality)
};

QString mark(bool good) { return good ? QStringLiteral("✓") : QStringLiteral("✕"); }

QString translated(const char* text) { return QCoreApplication::translate("QualityGate", text); }

/// As HTML, on one line.
QString unbroken(const QString& text) { return text.toHtmlEscaped().replace(' ', QChar::Nbsp); }

QString rowOf(const GateCheck& check) {
  const QualityMeasure& measure = *check.measure;
  const QString value = check.value ? QString::fromStdString(valueText(measure, *check.value)) +
                                          ' ' + unitText(measure.unit)
                                    : noFigure();
  const QString weight = check.passed ? QString() : QStringLiteral(" style='font-weight:600'");
  const QString asked =
      QString::fromStdString(limitText(check)).replace("deg", QStringLiteral("°"));
  return QStringLiteral(
             "<tr%1><td>%2\u00a0</td><td>%3\u00a0</td><td align='right'>%4\u00a0</td>"
             "<td>%5</td></tr>")
      .arg(weight, mark(check.passed),
           unbroken(QCoreApplication::translate("QualityMeasure", measure.label)), unbroken(value),
           unbroken(asked));
}

/// Why it matters that rows above miss their thresholds, and what to do.
QString reasonOf(const GateCheck& check, GateFix fix) {
  return QStringLiteral("<tr><td></td><td colspan='3'>%1 %2</td></tr>")
      .arg(translated(check.limit->why).toHtmlEscaped(), translated(fixText(fix)).toHtmlEscaped());
}

/// A limit belongs to the better side.
QString bandTitle(const TriangleMeasure& measure, const std::vector<BandLimit>& limits,
                  std::size_t band) {
  if (limits.empty()) return Quality::tr("all");
  const auto at = [&](std::size_t i) { return QString::number(limits[i].at, 'g', 4); };
  const bool less = measure.lessIsBetter();
  const bool oneNumber = measure.digits == 0 && band > 0 && band < limits.size() &&
                         limits[band].at - limits[band - 1].at == 1.0;
  QString range;
  if (band == 0)
    range = (less ? Quality::tr("up to %1") : Quality::tr("below %1")).arg(at(0));
  else if (band == limits.size())
    range = (less ? Quality::tr("above %1") : Quality::tr("from %1")).arg(at(band - 1));
  else
    range = oneNumber ? at(less ? band : band - 1)
                      : Quality::tr("%1 to %2").arg(at(band - 1), at(band));
  const QString unit = unitText(measure.unit);
  return unit.isEmpty() ? range : range + ' ' + unit;
}

}  // namespace

const std::vector<const QualityMeasure*>& qualityRows() {
  static const std::vector<const QualityMeasure*> table = [] {
    std::vector<const QualityMeasure*> all;
    for (const bool main : {true, false}) {
      for (const QualityMeasure& measure : qualityMeasures()) {
        if (measure.main == main) all.push_back(&measure);
        if (main && std::string(measure.key) == "components") all.push_back(nullptr);
      }
    }
    return all;
  }();
  return table;
}

QString qualityTitle(const QualityMeasure* measure) {
  if (!measure) return QCoreApplication::translate("QualityMeasure", kVerifiedTitle);
  const QString label = QCoreApplication::translate("QualityMeasure", measure->label);
  const QString unit = unitText(measure->unit);
  return unit.isEmpty() ? label : label + ", " + unit;
}

QString noFigure() { return QStringLiteral("–"); }

QString qualityValue(const QualityMeasure* measure, const MeshQuality* quality) {
  const std::optional<double> value =
      measure && quality ? measure->value(*quality) : std::optional<double>();
  if (!value) return noFigure();
  switch (measure->kind) {
    case MeasureKind::Count:
      return QLocale().toString(static_cast<qlonglong>(*value));
    case MeasureKind::YesNo:
      return *value != 0.0 ? QCoreApplication::translate("QualityMeasure", "yes")
                           : QCoreApplication::translate("QualityMeasure", "no");
    case MeasureKind::Fixed:
      return QLocale().toString(*value, 'f', measure->digits);
    case MeasureKind::Significant:
      break;
  }
  return QLocale().toString(*value, 'g', measure->digits);
}

std::vector<const QualityGate*> shownGates() {
  std::vector<const QualityGate*> gates;
  for (const QualityGate& gate : qualityGates())
    if (const std::string name = gate.name; name == "solver" || name == "print")
      gates.push_back(&gate);
  return gates;
}

QString gateHelp(const QualityGate& gate) { return translated(gate.help); }

QString gateVerdict(const QualityGate& gate, const MeshQuality& quality) {
  const std::vector<GateCheck> checks = checkGate(gate, quality);
  const auto failed = std::count_if(checks.begin(), checks.end(),
                                    [](const GateCheck& check) { return !check.passed; });
  const QString name = QLatin1String(gate.name);
  return mark(failed == 0) + ' ' +
         (failed == 0
              ? Quality::tr("<b>%1</b>: passes").arg(name)
              : Quality::tr("<b>%1</b>: fails, %2 of %3").arg(name).arg(failed).arg(checks.size()));
}

QString gateRows(const QualityGate& gate, const MeshQuality& quality,
                 const std::function<GateFix(const GateCheck&)>& fixOf) {
  const std::vector<GateCheck> checks = checkGate(gate, quality);
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
  return rows;
}

GateFix helpfulFix(const GateCheck& check, MeshKind kind, SurfaceMethod method) {
  if (kind == MeshKind::File) return GateFix::None;
  const bool cubes = kind == MeshKind::MarchingCubes || method == SurfaceMethod::MarchingCubes;
  // The triangles of marching cubes are as large as its cells, whatever rho is.
  return cubes && check.limit->fix == GateFix::SmallerRho ? GateFix::MeshAnew : check.limit->fix;
}

QString bandTable(const MeasuredMeshes& measured) {
  const std::vector<BandLimit> limits = bandLimits(*measured.measure);
  QString html = QStringLiteral("<table><tr><td></td>");
  for (int i = 0; i < kMeshKindCount; ++i)
    if (measured.of(static_cast<MeshKind>(i)).mesh)
      html += QStringLiteral("<td align='right'>\u00a0%1</td>")
                  .arg(meshTitle(static_cast<MeshKind>(i)).toHtmlEscaped().replace(' ', "<br/>"));
  html += QStringLiteral("</tr>");
  for (std::size_t band = 0; band <= limits.size(); ++band) {
    html += QStringLiteral("<tr><td>%1</td>")
                .arg(bandTitle(*measured.measure, limits, band).toHtmlEscaped());
    for (const MeasuredMeshes::Of& mesh : measured.meshes)
      if (mesh.mesh)
        html += QStringLiteral("<td align='right'>%1 %</td>").arg(mesh.bands[band], 0, 'f', 2);
    html += QStringLiteral("</tr>");
  }
  return html + QStringLiteral("</table>");
}

}  // namespace angiomesh
