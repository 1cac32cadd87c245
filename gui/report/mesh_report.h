// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "gui/job/job_slot.h"
#include "gui/report/report_job.h"

namespace angiomesh {

struct CaseModels;
class CaseMeasures;
class CaseReviewModel;
class ViewGrid;
class ViewState;
class VtkView;

/// Writes a report on the meshes: one HTML file with pictures in it that says what they are worth,
/// how they were made and what was noted, and not whose they are.
class MeshReport : public QObject {
  Q_OBJECT

 public:
  MeshReport(CaseModels& models, ViewState& state, ViewGrid& views, const CaseMeasures& measures,
             const CaseReviewModel& review, const JobRunnerFactory& makeRunner, QObject* parent);
  ~MeshReport() override;

  /// What is shown now goes into it, whatever comes while it is written; messages say how it went.
  void write(const QString& path);
  [[nodiscard]] bool writing() const { return measuring_ || writing_; }

 Q_SIGNALS:
  void written(const QString& path);

 private:
  [[nodiscard]] ReportPage pictures();
  void addPicture(ReportPage& page, VtkView& view, double turned, const QString& title);
  void finishMeasuring(const ReportMeasuresJob& job);
  void finishWriting(const ReportFileJob& job);

  CaseModels& models_;
  ViewState& state_;
  ViewGrid& views_;
  const CaseMeasures& measures_;
  const CaseReviewModel& review_;
  QString path_;
  ReportPage before_, after_;  ///< what stands before and after the histograms
  JobSlot<ReportMeasuresJob> measuring_;
  JobSlot<ReportFileJob> writing_;
};

}  // namespace angiomesh
