// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/report_sections.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "core/base/formatted.h"
#include "core/parameters/field.h"
#include "core/pipeline/report.h"
#include "gui/findings/case_measures.h"
#include "gui/findings/case_review.h"
#include "gui/findings/measurement_text.h"
#include "gui/inspector/quality_text.h"
#include "gui/model/case_models.h"
#include "gui/model/case_recipe.h"
#include "gui/model/result_text.h"
#include "gui/model/step_text.h"
#include "gui/panel/surface_note.h"

namespace angiomesh {

namespace {

struct Report {
  Q_DECLARE_TR_FUNCTIONS(Report)
};

constexpr const char* kStyle =
    "body{font:15px/1.45 sans-serif;color:#1a1d21;background:#fff;max-width:1100px;margin:2em "
    "auto;padding:0 1em}"
    "h1{font-size:1.6em;margin:0}h2{font-size:1.2em;margin:1.8em 0 .5em;border-bottom:1px solid "
    "#c8cdd4}h3{font-size:1em;margin:1em 0 .3em}"
    "table{border-collapse:collapse;margin:.4em 0}td,th{padding:.15em .7em .15em 0;text-align:left;"
    "vertical-align:top}tr{border-bottom:1px solid #eceff3}"
    ".n{text-align:right;font-variant-numeric:tabular-nums}.best{font-weight:600}"
    ".stale{color:#8a4b00}.pictures{display:flex;flex-wrap:wrap;gap:.8em}"
    "figure{margin:0}figure img{display:block;max-width:100%;height:auto}"
    "figcaption{font-size:.85em;color:#555}.own{font-weight:600}"
    "@media print{body{margin:0;max-width:none}h2{break-after:avoid}figure,tr{break-inside:avoid}}";

QString escaped(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

QString cell(const QString& text, const char* kind = nullptr) {
  const QString html = text.toHtmlEscaped();
  return kind ? QStringLiteral("<td class=\"%1\">%2</td>").arg(QLatin1String(kind), html)
              : QStringLiteral("<td>%1</td>").arg(html);
}

QString headRow(const QStringList& titles) {
  QString row = QStringLiteral("<tr>");
  for (const QString& title : titles)
    row += QStringLiteral("<th>%1</th>").arg(title.toHtmlEscaped());
  return row + QStringLiteral("</tr>\n");
}

QString table(const QString& rows) { return QStringLiteral("<table>\n%1</table>\n").arg(rows); }

QString paragraph(const QString& text, const char* kind = "") {
  return QStringLiteral("<p class=\"%1\">%2</p>\n").arg(QLatin1String(kind), text.toHtmlEscaped());
}

std::vector<MeshKind> kindsAtHand(const ResultModel& results) {
  std::vector<MeshKind> kinds;
  for (int i = 0; i < kMeshKindCount; ++i)
    if (results.quality(static_cast<MeshKind>(i))) kinds.push_back(static_cast<MeshKind>(i));
  return kinds;
}

QString parameterTable(const Parameters& params) {
  const Parameters usual;
  QString rows =
      headRow({Report::tr("Parameter"), Report::tr("Value"), QString(), Report::tr("Key")});
  for (const Field& field : parameterFields()) {
    const FieldValue value = field.get(params);
    const char* own = value == field.get(usual) ? nullptr : "own";
    rows += QStringLiteral("<tr>") + cell(labelOf(field), own) +
            cell(QString::fromStdString(fieldText(value, field)), own) +
            cell(unitText(field.unit.c_str())) + cell(QString::fromStdString(field.key)) +
            QStringLiteral("</tr>\n");
  }
  return table(rows);
}

QString warningList(const RunResult& run) {
  QString items;
  for (const StageReport& stage : run.stages)
    for (const std::string& warning : stage.warnings)
      items += QStringLiteral("<li>%1: %2</li>\n")
                   .arg(stepTitle(stage.step).toHtmlEscaped(), escaped(warning));
  return items.isEmpty() ? paragraph(Report::tr("None."))
                         : QStringLiteral("<ul>\n%1</ul>\n").arg(items);
}

}  // namespace

QString reportHead(CaseModels& models) {
  const ShownText shown = meshText(models.results);
  QString html =
      QStringLiteral(
          "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>"
          "<meta charset=\"utf-8\"/>\n<title>%1</title>\n<style>%2</style>\n</head>\n"
          "<body>\n<h1>%1</h1>\n")
          .arg(Report::tr("Report on a vessel mesh").toHtmlEscaped(), QLatin1String(kStyle));
  html += paragraph(shown.text, shown.stale ? "stale" : "");
  const std::string& modality = models.document.display().modality;
  QString grid = gridText(models.document.image()->geometry);
  if (!modality.empty()) grid = QString::fromStdString(modality) + ", " + grid;
  html += paragraph(Report::tr("Scan: %1").arg(grid));
  html += paragraph(Report::tr("Angiomesh %1. Not a medical device: research use only.")
                        .arg(QLatin1String(versionText())));
  return html + paragraph(Report::tr("No patient, date or file is named here; remarks and names of "
                                     "measurements and openings stand as they were typed."));
}

QString reportEnd() { return QStringLiteral("</body>\n</html>\n"); }

QString sectionTitle(const QString& title) {
  return QStringLiteral("<h2>%1</h2>\n").arg(title.toHtmlEscaped());
}

QString qualitySection(const CaseModels& models) {
  const ResultModel& results = models.results;
  const std::vector<MeshKind> kinds = kindsAtHand(results);
  if (kinds.empty()) return paragraph(Report::tr("Not measured: run to the end."));
  std::vector<const MeshQuality*> meshes;
  QString rows = QStringLiteral("<tr><th></th>");
  for (const MeshKind kind : kinds) {
    meshes.push_back(results.quality(kind));
    rows += QStringLiteral("<th class=\"n\">%1</th>").arg(meshTitle(kind).toHtmlEscaped());
  }
  rows += QStringLiteral("</tr>\n");
  const SurfaceOrigin* origin = results.surfaceOrigin();
  for (const QualityMeasure* measure : qualityRows()) {
    rows += QStringLiteral("<tr>") + cell(qualityTitle(measure));
    const std::vector<std::size_t> best =
        measure ? betterOnes(*measure, meshes) : std::vector<std::size_t>();
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      const bool better = std::find(best.begin(), best.end(), i) != best.end();
      QString value = qualityValue(measure, meshes[i]);
      // Smoothing keeps what was verified; nothing else is.
      if (!measure && origin && isOurs(kinds[i]) && !verifiedText(*origin).isEmpty())
        value = verifiedText(*origin);
      rows += cell(better ? QStringLiteral("★ ") + value : value, better ? "n best" : "n");
    }
    rows += QStringLiteral("</tr>\n");
  }
  return paragraph(Report::tr("★ marks what is better than in the other meshes.")) + table(rows);
}

QString gateSection(const CaseModels& models) {
  const ResultModel& results = models.results;
  const Parameters* made = results.meshParameters();
  const SurfaceMethod method = made ? made->surface.method : SurfaceMethod();
  QString html;
  for (const QualityGate* gate : shownGates()) {
    html += paragraph(Report::tr("%1: %2").arg(QLatin1String(gate->name), gateHelp(*gate)));
    for (const MeshKind kind : kindsAtHand(results)) {
      const MeshQuality& quality = *results.quality(kind);
      html += QStringLiteral("<h3>%1: %2</h3>\n")
                  .arg(meshTitle(kind).toHtmlEscaped(), gateVerdict(*gate, quality));
      html += table(gateRows(*gate, quality, [kind, method](const GateCheck& check) {
        return helpfulFix(check, kind, method);
      }));
    }
  }
  return html;
}

QString measurementSection(const CaseMeasures& measures) {
  if (measures.all().empty()) return {};
  QString rows = headRow({Report::tr("Name"), Report::tr("What"), Report::tr("Value")});
  for (const Measurement& m : measures.all()) {
    QString value = measurementValue(m);
    if (measures.isEarlier(m)) value += ' ' + Report::tr("(on an earlier wall)");
    rows += QStringLiteral("<tr>") + cell(QString::fromStdString(m.name)) +
            cell(measurementTitle(m.kind)) + cell(value) + QStringLiteral("</tr>\n");
  }
  return sectionTitle(Report::tr("Measurements")) + table(rows);
}

QString reviewSection(const CaseReviewModel& model) {
  const CaseReview& review = model.review();
  if (review.empty()) return {};
  QString html = sectionTitle(Report::tr("Review"));
  QStringList judged;
  if (review.verdict == Verdict::Accepted) judged << Report::tr("accepted");
  if (review.verdict == Verdict::Rejected) judged << Report::tr("rejected");
  if (review.score > 0) judged << Report::tr("score %1 of %2").arg(review.score).arg(kBestScore);
  if (!judged.isEmpty()) {
    const bool stale = model.verdictStale();
    if (stale) judged << Report::tr("given to an earlier segmentation");
    html += paragraph(judged.join(", "), stale ? "stale" : "");
  }
  if (!review.seen.empty())
    html += paragraph(Report::tr("Doubtful places looked at: %1").arg(review.seen.size()));
  QString rows;
  for (const ReviewRemark& remark : review.remarks)
    rows += QStringLiteral("<tr>") + cell(QString::fromStdString(placeText(remark.pointLps))) +
            cell(remark.score > 0 ? QString::number(remark.score) : noFigure()) +
            cell(QString::fromStdString(remark.text)) + QStringLiteral("</tr>\n");
  if (!rows.isEmpty())
    html += table(headRow({Report::tr("Where"), Report::tr("Score"), Report::tr("Remark")}) + rows);
  return html;
}

QString methodsSection(const CaseModels& models) {
  QString html = sectionTitle(Report::tr("Methods"));
  for (const QString& line :
       QString::fromStdString(caseMethods(models)).split('\n', Qt::SkipEmptyParts))
    html += paragraph(line);
  return html;
}

QString runSection(const CaseModels& models) {
  const RunResult& run = *models.results.meshRun();
  QString steps = headRow({Report::tr("Step"), Report::tr("Time, s")});
  for (const StageReport& stage : run.stages)
    steps += QStringLiteral("<tr>") + cell(stepTitle(stage.step)) +
             cell(QLocale().toString(stage.seconds, 'f', 2), "n") + QStringLiteral("</tr>\n");
  return sectionTitle(Report::tr("Warnings")) + warningList(run) +
         sectionTitle(Report::tr("Steps")) + table(steps) + sectionTitle(Report::tr("Parameters")) +
         paragraph(Report::tr("Those that differ from the program's own are bold.")) +
         parameterTable(run.params);
}

}  // namespace angiomesh
