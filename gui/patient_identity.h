// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "gui/job/job_slot.h"
#include "gui/model/case_models.h"
#include "io/scan/mask_file.h"

class QWidget;

namespace angiomesh {

/// Reads who a DICOM series is of.
struct IdentityJob {
  DicomOrigin origin;

  void execute() noexcept;

  // After execute():
  DicomIdentityTexts found;
  std::string error;
};

/// Shows whose scan is open when asked: read from the files each time, and kept nowhere.
class PatientIdentity : public QObject {
  Q_OBJECT

 public:
  PatientIdentity(QWidget* window, CaseModels& models, const JobRunnerFactory& makeRunner);

  void show();

 private:
  void finish(const IdentityJob& job);

  QWidget* window_;
  CaseModels& models_;
  JobSlot<IdentityJob> slot_;
};

}  // namespace angiomesh
