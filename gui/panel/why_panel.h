// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "gui/job/job_slot.h"
#include "gui/job/result_jobs.h"

class QLabel;

namespace angiomesh {

struct CaseModels;
class ViewGrid;

/// Why the voxel under the crosshair is vessel or not: a sentence, and the numbers behind it. It
/// follows the crosshair and the results as long as it is seen.
class WhyPanel : public QWidget {
  Q_OBJECT

 public:
  WhyPanel(CaseModels& models, const ViewGrid& views, const JobRunnerFactory& makeRunner,
           QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  static constexpr int kRows = 9;

  void ask();
  void finish(const ReasonJob& job);
  void say(const QString& sentence);
  void tell(const VoxelReason& reason, const ReasonJob& job);

  CaseModels& models_;
  const ViewGrid& views_;
  QLabel* sentence_;
  std::array<QLabel*, kRows> values_{};
  bool askAgain_ = false;  ///< the crosshair has moved on since the job was started
  JobSlot<ReasonJob> slot_;
};

}  // namespace angiomesh
