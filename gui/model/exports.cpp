// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/exports.h"

#include <utility>

#include "gui/model/step_text.h"
#include "io/vessel/ports_file.h"

namespace angiomesh {

namespace {

constexpr double kMm3PerMl = 1000.0;

}  // namespace

Exports::Exports(ResultModel& results, MessageLog& log, JobTimer& timer,
                 const JobRunnerFactory& makeRunner, QObject* parent)
    : QObject(parent),
      results_(results),
      log_(log),
      timer_(timer),
      slot_(timer, makeRunner, [this](const std::shared_ptr<ExportJob>& job) { finish(*job); }) {}

ExportRequest Exports::request(MeshKind kind, const QString& path) const {
  ExportRequest request;
  request.path = path.toStdString();
  request.mesh = results_.mesh(kind);
  request.ports = results_.ports(kind);
  if (request.mesh && !request.mesh->patch.empty())
    request.options.patchNames = patchNamesOf(request.ports);
  return request;
}

void Exports::warnIfUnsound(MeshKind kind) {
  const SurfaceOrigin* origin = isOurs(kind) ? results_.surfaceOrigin() : nullptr;
  if (origin && !origin->fault().empty()) {
    log_.say(
        Severity::Warning,
        tr("This surface is not fit for a solver: %1. Look at that place in the image, and smooth "
           "more or choose another surface method.")
            .arg(QString::fromStdString(origin->fault())));
  }
}

void Exports::exportMesh(MeshKind kind, const QString& path, const MeshWriteOptions& options,
                         const ExportExtras& extras) {
  ExportRequest request = this->request(kind, path);
  const std::vector<std::string> names = std::move(request.options.patchNames);
  request.options = options;
  request.options.patchNames = names;
  request.extras = extras;
  const Step step = kind == MeshKind::Exported ? Step::Smooth : Step::Surface;
  request.options.key = results_.key(step);
  if (extras.report) request.report = results_.meshRun();
  warnIfUnsound(kind);
  start(std::move(request));
}

void Exports::exportOpenFoam(MeshKind kind, const QString& folder, bool replace) {
  ExportRequest request = this->request(kind, folder);
  request.kind = ExportKind::OpenFoam;
  request.replace = replace;
  warnIfUnsound(kind);
  start(std::move(request));
}

void Exports::exportMask(const QString& path, std::optional<DicomOrigin> origin) {
  ExportRequest request;
  request.origin = std::move(origin);
  request.kind = ExportKind::Mask;
  request.path = path.toStdString();
  request.segmentation = results_.segmentationRun();
  if (request.segmentation && !results_.segmentationFresh()) {
    log_.say(
        Severity::Warning,
        tr("This segmentation belongs to earlier parameters: run again for the present ones."));
  }
  start(std::move(request));
}

void Exports::exportPorts(const QString& path) {
  ExportRequest request = this->request(MeshKind::Exported, path);
  request.kind = ExportKind::Ports;
  if (request.mesh && !results_.meshFresh()) {
    log_.say(Severity::Warning,
             tr("These ports belong to earlier parameters: run again for the present ones."));
  }
  start(std::move(request));
}

void Exports::start(ExportRequest request) {
  if (slot_) {
    log_.say(Severity::Warning, tr("An export is being written: try again when it is done."));
    return;
  }
  if (!request.mesh && !request.segmentation) {
    log_.say(Severity::Error,
             request.kind == ExportKind::Mask
                 ? tr("There is no segmentation to export: run the pipeline first.")
                 : tr("There is no mesh to export: run the pipeline first."));
    return;
  }
  slot_.start(std::make_shared<ExportJob>(std::move(request)));
  timer_.poll();
}

void Exports::finish(const ExportJob& job) {
  if (!job.error().empty()) {
    log_.say(Severity::Error, tr("Cannot export: %1").arg(QString::fromStdString(job.error())));
    return;
  }
  for (const std::string& warning : job.warnings())
    log_.say(Severity::Warning, job.fileName() + ": " + warning);
  sayExported(job);
  Q_EMIT exported(QString::fromStdString(job.request().path.string()));
}

void Exports::sayExported(const ExportJob& job) {
  const QString name = QString::fromStdString(job.fileName());
  switch (job.request().kind) {
    case ExportKind::Ports:
      log_.say(Severity::Info,
               tr("Wrote %1: %2 openings.").arg(name).arg(job.request().ports.size()));
      return;
    case ExportKind::OpenFoam:
      log_.say(Severity::Info,
               tr("Wrote the OpenFOAM case %1. Its script Allrun fills it.").arg(name));
      return;
    case ExportKind::Mask: {
      const Geometry& grid = job.request().segmentation->source.image->geometry;
      log_.say(Severity::Info,
               tr("Wrote %1. Read back: a mask of %2 voxels (%3 ml) in %4.")
                   .arg(name)
                   .arg(job.maskVoxels())
                   .arg(static_cast<double>(job.maskVoxels()) * grid.voxelVolumeMm3() / kMm3PerMl,
                        0, 'f', 2)
                   .arg(gridText(grid)));
      return;
    }
    case ExportKind::Mesh:
      break;
  }
  QStringList beside;
  if (job.request().report) beside << tr("its report");
  if (job.request().extras.ports) beside << tr("its ports");
  if (job.patchFiles() > 0) beside << tr("%1 files of single patches").arg(job.patchFiles());
  const MeshFileFacts& facts = job.facts();
  log_.say(
      Severity::Info,
      tr("Wrote %1%2. Read back: %3 vertices, %4 triangles, %5, %6 in %7.")
          .arg(name, beside.isEmpty() ? QString() : tr(" and ") + beside.join(tr(" and ")))
          .arg(facts.vertices)
          .arg(facts.triangles)
          .arg(facts.closed ? tr("closed") : tr("not closed"), boxSizeText(facts.size, facts.unit),
               QString::fromStdString(frameWord(facts.frame))));
}

}  // namespace angiomesh
