// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "gui/job/job_slot.h"
#include "gui/job/mesh_file_job.h"
#include "gui/model/view_state.h"

namespace angiomesh {

/// A mesh from a file beside those of the case, measured against their wall as often as that
/// changes. It goes with the case, and no file of ours mentions it.
class MeshFile : public QObject {
  Q_OBJECT

 public:
  MeshFile(CaseModels& models, ViewState& state, const JobRunnerFactory& makeRunner,
           QObject* parent = nullptr);
  ~MeshFile() override;

  /// Shown once it is there; messages say why not.
  void open(const QString& path);
  /// Without its folder; empty without a mesh.
  [[nodiscard]] QString name() const { return name_; }
  /// A sentence where it is measured only in part; else empty.
  [[nodiscard]] QString limits() const { return limits_; }
  [[nodiscard]] bool busy() const { return static_cast<bool>(slot_); }

 Q_SIGNALS:
  void changed();

 private:
  void leave();
  void refresh();
  void start(std::shared_ptr<MeshFileJob> job);
  void finish(const MeshFileJob& job);

  CaseModels& models_;
  ViewState& state_;
  QString name_, limits_;
  std::shared_ptr<const TriMesh> mesh_;
  std::shared_ptr<const SurfaceResult> against_;  ///< what it was measured against
  std::shared_ptr<MeshFileJob> next_;             ///< once the slot is free
  JobSlot<MeshFileJob> slot_;
};

}  // namespace angiomesh
