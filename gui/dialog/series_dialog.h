// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "gui/job/job_runner.h"
#include "gui/job/thumbnail_job.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace angiomesh {

/// The volumes of a DICOM folder, one row each, with the picture of the middle slice: one is chosen
/// by a double click, or by Enter. What cannot be a volume is listed with the reason.
class SeriesDialog : public QDialog {
  Q_OBJECT

 public:
  SeriesDialog(const std::vector<ImageSummary>& entries, const JobRunnerFactory& makeRunner,
               QWidget* parent = nullptr);
  ~SeriesDialog() override;

  /// The row that was chosen.
  [[nodiscard]] std::optional<std::size_t> chosen() const;

 private:
  void fillRow(int row);
  void refresh();
  void takeThumbnails();

  std::vector<ImageSummary> entries_;
  std::shared_ptr<ThumbnailJob> thumbnails_;
  std::unique_ptr<JobRunner> runner_;
  QTimer timer_;
  QTableWidget* table_;
  QLabel* note_;
  QPushButton* open_;
};

}  // namespace angiomesh
