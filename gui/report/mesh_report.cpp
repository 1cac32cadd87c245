// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/mesh_report.h"

#include <QPalette>
#include <QScopeGuard>
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "gui/inspector/histogram_widget.h"
#include "gui/inspector/quality_text.h"
#include "gui/model/case_models.h"
#include "gui/model/step_text.h"
#include "gui/model/view_state.h"
#include "gui/pane/view_grid.h"
#include "gui/report/report_sections.h"
#include "gui/view/slice_view.h"
#include "gui/view/surface_view.h"

namespace angiomesh {

namespace {

constexpr QSize kPictureSize(420, 360), kHistogramSize(520, 240);
constexpr double kTurnedDegrees = 90.0;

/// In every report, beside the measure that is chosen.
constexpr std::array<const char*, 2> kAlways{"min-angle", "radius-ratio"};

std::vector<const TriangleMeasure*> measuresWith(const TriangleMeasure* chosen) {
  std::vector<const TriangleMeasure*> list;
  for (const TriangleMeasure& measure : triangleMeasures()) {
    const bool always =
        std::find(kAlways.begin(), kAlways.end(), std::string(measure.key)) != kAlways.end();
    if (always || &measure == chosen) list.push_back(&measure);
  }
  return list;
}

/// Dark on white, whatever theme the window has.
QPalette paper() {
  QPalette palette(QColor(0xf0, 0xf0, 0xf0));
  palette.setColor(QPalette::Base, Qt::white);
  palette.setColor(QPalette::Text, Qt::black);
  palette.setColor(QPalette::Highlight, QColor(0x2f, 0x6f, 0xb0));
  return palette;
}

QImage histogramOf(const std::shared_ptr<const MeasuredMeshes>& measured, MeshKind selected) {
  HistogramWidget widget;
  widget.setPalette(paper());
  widget.setMeasured(measured);
  widget.setSelected(selected);
  widget.resize(kHistogramSize);
  QImage picture(kHistogramSize, QImage::Format_RGB32);
  widget.render(&picture);
  return picture;
}

QString figure(const QString& title) {
  return QStringLiteral("<figcaption>%1</figcaption></figure>\n").arg(title.toHtmlEscaped());
}

}  // namespace

MeshReport::MeshReport(CaseModels& models, ViewState& state, ViewGrid& views,
                       const CaseMeasures& measures, const CaseReviewModel& review,
                       const JobRunnerFactory& makeRunner, QObject* parent)
    : QObject(parent),
      models_(models),
      state_(state),
      views_(views),
      measures_(measures),
      review_(review),
      measuring_(models.timer, makeRunner,
                 [this](const std::shared_ptr<ReportMeasuresJob>& job) { finishMeasuring(*job); }),
      writing_(models.timer, makeRunner,
               [this](const std::shared_ptr<ReportFileJob>& job) { finishWriting(*job); }) {}

MeshReport::~MeshReport() {
  if (measuring_) measuring_.job()->progress.cancel();
}

void MeshReport::write(const QString& path) {
  if (writing()) {
    models_.log.say(Severity::Warning, tr("A report is being written: try again when it is done."));
    return;
  }
  if (!models_.results.meshRun()) {
    models_.log.say(Severity::Error, tr("There is no mesh to report on: run the pipeline first."));
    return;
  }
  path_ = path.endsWith(QLatin1String(".html"), Qt::CaseInsensitive)
              ? path
              : path + QStringLiteral(".html");
  before_ = {};
  before_.add(reportHead(models_));
  before_.append(pictures());
  before_.add(sectionTitle(tr("Quality")) + qualitySection(models_));
  before_.add(sectionTitle(tr("Gates")) + gateSection(models_));
  before_.add(sectionTitle(tr("Triangles")));
  after_ = {};
  after_.add(measurementSection(measures_) + reviewSection(review_) + methodsSection(models_) +
             runSection(models_) + reportEnd());
  auto job = std::make_shared<ReportMeasuresJob>();
  job->measures = measuresWith(state_.meshColour());
  for (int i = 0; i < kMeshKindCount; ++i)
    job->meshes[static_cast<std::size_t>(i)] = models_.results.mesh(static_cast<MeshKind>(i));
  measuring_.startAndPoll(std::move(job));
}

void MeshReport::addPicture(ReportPage& page, VtkView& view, double turned, const QString& title) {
  auto* surface = qobject_cast<SurfaceView*>(&view);
  page.add(QStringLiteral("<figure>"));
  try {
    page.addPicture(
        surface ? surface->pictureTurned(turned, 1, kPictureSize) : view.picture(1, kPictureSize),
        title);
  } catch (const Error&) {
    page.add(QStringLiteral("<p>%1</p>").arg(tr("This pane was never drawn.").toHtmlEscaped()));
  }
  page.add(figure(title));
}

ReportPage MeshReport::pictures() {
  ReportPage page;
  page.add(sectionTitle(tr("Pictures")) + QStringLiteral("<div class=\"pictures\">\n"));
  const auto restore = qScopeGuard([this, contours = state_.contours(),
                                    volume = state_.volumeView(), surface = state_.surface()] {
    state_.setContours(contours);
    state_.setVolumeView(volume);
    state_.setSurface(surface);
  });
  state_.setContours(true);
  for (const int plane : {2, 0, 1}) {
    SliceView* view = views_.slice(plane);
    addPicture(page, *view, 0.0, tr("%1, through the crosshair").arg(views_.titleOf(view)));
  }
  SurfaceView& view3d = *views_.surface();
  state_.setSurface(false);
  state_.setVolumeView(VolumeView::Mip);
  addPicture(page, view3d, 0.0, tr("Projection of the image, as the 3D pane looks"));
  state_.setVolumeView(VolumeView::None);
  state_.setSurface(true);
  addPicture(page, view3d, 0.0, tr("Surface, from the same side"));
  addPicture(page, view3d, kTurnedDegrees, tr("Surface, turned by %1°").arg(kTurnedDegrees));
  page.add(QStringLiteral("</div>\n"));
  return page;
}

void MeshReport::finishMeasuring(const ReportMeasuresJob& job) {
  if (job.progress.cancelled()) return;
  auto file = std::make_shared<ReportFileJob>();
  file->path = path_.toStdString();
  file->page = before_;
  const MeshKind selected = job.meshes.front() ? MeshKind::Exported : MeshKind::Unsmoothed;
  for (const std::shared_ptr<const MeasuredMeshes>& measured : job.measured) {
    const QString title = measureTitle(*measured->measure);
    file->page.add(QStringLiteral("<h3>%1</h3>\n<figure>").arg(title.toHtmlEscaped()));
    file->page.addPicture(histogramOf(measured, selected), title);
    file->page.add(figure(tr("Per cent of the triangles, and in bands")) + bandTable(*measured));
  }
  file->page.append(after_);
  before_ = {};
  after_ = {};
  writing_.startAndPoll(std::move(file));
}

void MeshReport::finishWriting(const ReportFileJob& job) {
  const QString name = QString::fromStdString(job.path.filename().string());
  if (!job.error.empty()) {
    models_.log.say(Severity::Error,
                    tr("Cannot write the report: %1").arg(QString::fromStdString(job.error)));
    return;
  }
  models_.log.say(Severity::Info, tr("Wrote the report %1.").arg(name));
  Q_EMIT written(QString::fromStdString(job.path.string()));
}

}  // namespace angiomesh
