// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>

#include "gui/job/file_jobs.h"
#include "gui/model/result_model.h"

namespace angiomesh {

/// Writes what the results hold, reads it back and says what the files hold.
class Exports : public QObject {
  Q_OBJECT

 public:
  Exports(ResultModel& results, MessageLog& log, JobTimer& timer,
          const JobRunnerFactory& makeRunner, QObject* parent = nullptr);

  /// The pipeline's key and the names of the patches are filled in.
  void exportMesh(MeshKind kind, const QString& path, const MeshWriteOptions& options,
                  const ExportExtras& extras);
  /// A folder that OpenFOAM fills; `replace`: it holds a case already.
  void exportOpenFoam(MeshKind kind, const QString& folder, bool replace);
  /// The mask of the segmentation shown, on the grid of the scan; with an origin, as a DICOM
  /// segmentation.
  void exportMask(const QString& path, std::optional<DicomOrigin> origin = {});
  /// Only the openings of the exported mesh.
  void exportPorts(const QString& path);
  [[nodiscard]] bool writing() const { return static_cast<bool>(slot_); }

 Q_SIGNALS:
  void exported(const QString& path);

 private:
  [[nodiscard]] ExportRequest request(MeshKind kind, const QString& path) const;
  /// Where it meets itself a surface is exported all the same: the user sees it, and may repair it
  /// elsewhere.
  void warnIfUnsound(MeshKind kind);
  void start(ExportRequest request);
  void finish(const ExportJob& job);
  void sayExported(const ExportJob& job);

  ResultModel& results_;
  MessageLog& log_;
  JobTimer& timer_;
  JobSlot<ExportJob> slot_;
};

}  // namespace angiomesh
