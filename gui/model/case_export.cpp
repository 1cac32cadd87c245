// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "gui/model/case_controller.h"
#include "gui/model/step_text.h"
#include "io/vessel/ports_file.h"

namespace angiomesh {

ExportRequest CaseController::exportRequest(MeshKind kind, const QString& path) const {
  ExportRequest request;
  request.path = path.toStdString();
  request.mesh = mesh(kind);
  request.ports = ports(kind);
  if (request.mesh && !request.mesh->patch.empty()) {
    request.options.patchNames = patchNamesOf(request.ports);
  }
  return request;
}

void CaseController::warnIfUnsound(MeshKind kind) {
  const SurfaceOrigin* origin = kind == MeshKind::MarchingCubes ? nullptr : surfaceOrigin();
  if (origin && !origin->fault().empty()) {
    say(Severity::Warning,
        tr("This surface is not fit for a solver: %1. Look at that place in the image, and smooth "
           "more or choose another surface method.")
            .arg(QString::fromStdString(origin->fault())));
  }
}

void CaseController::exportMesh(MeshKind kind, const QString& path, const MeshWriteOptions& options,
                                const ExportExtras& extras) {
  ExportRequest request = exportRequest(kind, path);
  const std::vector<std::string> names = std::move(request.options.patchNames);
  request.options = options;
  request.options.patchNames = names;
  request.extras = extras;
  const Step step = kind == MeshKind::Exported ? Step::Smooth : Step::Surface;
  for (const StageReport& stage : meshRun_ ? meshRun_->stages : std::vector<StageReport>()) {
    if (stage.step == step) {
      request.options.key = stage.key;
    }
  }
  if (extras.report) {
    request.report = meshRun_;
  }
  warnIfUnsound(kind);
  startExport(std::move(request));
}

void CaseController::exportOpenFoam(MeshKind kind, const QString& folder, bool replace) {
  ExportRequest request = exportRequest(kind, folder);
  request.kind = ExportKind::OpenFoam;
  request.replace = replace;
  warnIfUnsound(kind);
  startExport(std::move(request));
}

void CaseController::exportPorts(const QString& path) {
  ExportRequest request = exportRequest(MeshKind::Exported, path);
  request.kind = ExportKind::Ports;
  if (request.mesh && !meshFresh()) {
    say(Severity::Warning,
        tr("These ports belong to earlier parameters: run again for the present ones."));
  }
  startExport(std::move(request));
}

void CaseController::startExport(ExportRequest request) {
  if (export_) {
    say(Severity::Warning, tr("An export is being written: try again when it is done."));
    return;
  }
  if (!request.mesh) {
    say(Severity::Error, tr("There is no mesh to export: run the pipeline first."));
    return;
  }
  export_ = std::make_shared<ExportJob>(std::move(request));
  exportRunner_->start([job = export_] { job->execute(); });
  timer_.start();
  poll();
}

void CaseController::finishExport() {
  const std::shared_ptr<ExportJob> job = std::exchange(export_, nullptr);
  if (!job->error().empty()) {
    say(Severity::Error, tr("Cannot export: %1").arg(QString::fromStdString(job->error())));
    return;
  }
  for (const std::string& warning : job->warnings()) {
    say(Severity::Warning, QString::fromStdString(job->fileName() + ": " + warning));
  }
  sayExported(*job);
  Q_EMIT exported(QString::fromStdString(job->request().path.string()));
}

void CaseController::sayExported(const ExportJob& job) {
  const QString name = QString::fromStdString(job.fileName());
  switch (job.request().kind) {
    case ExportKind::Ports:
      say(Severity::Info, tr("Wrote %1: %2 openings.").arg(name).arg(job.request().ports.size()));
      return;
    case ExportKind::OpenFoam:
      say(Severity::Info, tr("Wrote the OpenFOAM case %1. Its script Allrun fills it.").arg(name));
      return;
    case ExportKind::Mesh:
      break;
  }
  QStringList beside;
  if (job.request().report) {
    beside << tr("its report");
  }
  if (job.request().extras.ports) {
    beside << tr("its ports");
  }
  if (job.patchFiles() > 0) {
    beside << tr("%1 files of single patches").arg(job.patchFiles());
  }
  const MeshFileFacts& facts = job.facts();
  say(Severity::Info,
      tr("Wrote %1%2. Read back: %3 vertices, %4 triangles, %5, %6 in %7.")
          .arg(name, beside.isEmpty() ? QString() : tr(" and ") + beside.join(tr(" and ")))
          .arg(facts.vertices)
          .arg(facts.triangles)
          .arg(facts.closed ? tr("closed") : tr("not closed"), boxSizeText(facts.size, facts.unit),
               QString::fromStdString(frameWord(facts.frame))));
}

}  // namespace angiomesh
