// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "gui/job/part_job.h"
#include "gui/model/case_models.h"

namespace angiomesh {

/// Ticks parts of the segmentation off by a place on their surface.
class PartEdits : public QObject {
  Q_OBJECT

 public:
  PartEdits(CaseModels& models, const JobRunnerFactory& makeRunner, QObject* parent = nullptr);

  /// Whether there are parts to be told apart.
  [[nodiscard]] bool ready() const;
  void remove(const Eigen::Vector3d& placeLps) { start(placeLps, false); }
  /// Ticks all others off, in one step of undo.
  void keepOnly(const Eigen::Vector3d& placeLps) { start(placeLps, true); }

 private:
  void start(const Eigen::Vector3d& placeLps, bool keep);
  void finish(const PartJob& job);

  CaseModels& models_;
  bool keep_ = false;
  JobSlot<PartJob> slot_;
};

}  // namespace angiomesh
