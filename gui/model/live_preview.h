// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <string>

#include "gui/job/preview_job.h"
#include "gui/model/run_model.h"

namespace angiomesh {

/// The segmentation that the present parameters would give around the crosshair, tried as they are
/// edited. It starts from the vesselness at hand and computes nothing that comes before it; the
/// results of the case stay as they are until somebody runs.
class LivePreview : public QObject {
  Q_OBJECT

 public:
  static constexpr int kUsualSide = 40, kLeastSide = 16, kGreatestSide = 512;  ///< voxels

  LivePreview(CaseDocument& document, ResultModel& results, RunModel& runs, JobTimer& timer,
              const JobRunnerFactory& makeRunner, QObject* parent = nullptr);
  /// Cancels what is tried and waits for it.
  ~LivePreview() override;

  [[nodiscard]] bool on() const { return on_; }
  void setOn(bool on);
  /// Whether somebody tunes: else nothing is tried.
  void setWatched(bool watched);
  /// The middle of the box, mm LPS.
  void setFocus(const Eigen::Vector3d& lps);
  [[nodiscard]] int side() const { return side_; }
  void setSide(int voxels);

  /// phi on the voxels of the box, while it evolves also of some around it; null: nothing is tried,
  /// because it would be the result that is shown, or for want of anything to start from.
  [[nodiscard]] const std::shared_ptr<const Volume<float>>& phi() const { return phi_; }
  [[nodiscard]] bool working() const { return static_cast<bool>(slot_); }
  /// A few words on what is going on.
  [[nodiscard]] QString status() const;

 Q_SIGNALS:
  void changed();

 private:
  [[nodiscard]] QString whyNot() const;
  /// Around the focus, on the grid of the vesselness.
  [[nodiscard]] VoxelBox box() const;
  [[nodiscard]] std::string keyNow() const;
  void refresh();
  void start();
  void watch(PreviewJob& job);
  void finish(const PreviewJob& job);
  void giveWay();
  void forget();

  CaseDocument& document_;
  ResultModel& results_;
  RunModel& runs_;
  bool on_ = true, watched_ = false;
  Eigen::Vector3d focus_{0.0, 0.0, 0.0};
  int side_ = kUsualSide;
  std::shared_ptr<const Volume<float>> phi_;
  std::string shownKey_, triedKey_;
  bool frontSeen_ = false;  ///< of the job in work
  QString error_;
  double seconds_ = 0.0;  ///< of the preview shown
  JobSlot<PreviewJob> slot_;
};

}  // namespace angiomesh
