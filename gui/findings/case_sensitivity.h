// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QObject>
#include <QString>
#include <memory>
#include <string>
#include <vector>

#include "gui/job/job_slot.h"
#include "gui/job/sensitivity_job.h"
#include "gui/model/case_models.h"

namespace angiomesh {

/// How much the segmentation of the case depends on its parameters: tried on a worker when it is
/// asked for, and painted on the wall in 3D. The results of the case stay as they are.
class CaseSensitivity : public QObject {
  Q_OBJECT

 public:
  /// In place of a step: the largest move of all.
  static constexpr int kAll = -1;

  CaseSensitivity(CaseModels& models, const JobRunnerFactory& makeRunner,
                  QObject* parent = nullptr);
  /// Cancels what runs and waits for it.
  ~CaseSensitivity() override;

  /// Why it cannot be tried now; empty: it can.
  [[nodiscard]] QString whyNot() const;
  void start();
  void cancel();
  [[nodiscard]] bool busy() const { return static_cast<bool>(slot_); }
  [[nodiscard]] double fraction() const;
  /// What the last one came to where it came to nothing; a line.
  [[nodiscard]] QString error() const { return error_; }

  /// Null: none was made for this volume.
  [[nodiscard]] const std::shared_ptr<const DrawnSensitivity>& found() const { return found_; }
  /// It is of earlier parameters.
  [[nodiscard]] bool stale() const;
  [[nodiscard]] double seconds() const { return seconds_; }

  /// The step, or kAll, whose moves are painted. @pre there is such a wall
  void choose(int effect);
  [[nodiscard]] int chosen() const { return chosen_; }
  void setPainted(bool on);
  /// Whether the wall is shown in 3D.
  [[nodiscard]] bool painted() const { return painted_ && found_; }
  /// Of each triangle of the wall, mm. @pre found()
  [[nodiscard]] const std::vector<float>& values() const;
  /// The values that are drawn red and blue.
  [[nodiscard]] std::array<double, 2> scale() const;
  /// "ξ 20 → 25".
  [[nodiscard]] static QString stepText(const ParameterStep& step);
  /// What is painted, for the legend.
  [[nodiscard]] QString title() const;

  /// Has the panes go to the middle of a branch.
  void visit(int branch);

 Q_SIGNALS:
  void changed();     ///< all but fraction()
  void progressed();  ///< fraction()
  void goTo(double x, double y, double z, double radiusMm);

 private:
  void finish(const SensitivityJob& job);
  void forget();

  CaseModels& models_;
  std::shared_ptr<const DrawnSensitivity> found_;
  std::string key_, triedKey_;  ///< of the step correct
  QString error_;
  double seconds_ = 0.0;
  int chosen_ = kAll;
  bool painted_ = true;
  JobSlot<SensitivityJob> slot_;
};

}  // namespace angiomesh
