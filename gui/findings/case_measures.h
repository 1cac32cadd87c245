// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QObject>
#include <QString>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "gui/job/measure_job.h"
#include "gui/model/case_models.h"

namespace angiomesh {

/// The measurements of the case: what is picked becomes one of its notes, by an edit on the undo
/// stack. Measuring runs on a worker, on the wall that the last step evolve found.
class CaseMeasures : public QObject {
  Q_OBJECT

 public:
  explicit CaseMeasures(CaseModels& models,
                        const JobRunnerFactory& makeRunner = makeThreadedJobRunner,
                        QObject* parent = nullptr);
  /// Cancels what runs and waits for it.
  ~CaseMeasures() override;

  [[nodiscard]] const std::vector<Measurement>& all() const {
    return models_.document.notes().measurements;
  }
  [[nodiscard]] const Measurement* find(const QString& name) const;
  [[nodiscard]] const Measurement* selected() const { return find(selected_); }
  void select(const QString& name);
  /// selects, and has the panes go there: goTo() follows.
  void visit(const QString& name);
  /// Made on a wall that is not that of the present parameters.
  [[nodiscard]] bool isEarlier(const Measurement& measurement) const;

  /// Whether there are vessels to measure; distances need none.
  [[nodiscard]] bool ready() const { return ground_.phi != nullptr; }
  [[nodiscard]] bool busy() const { return slot_ || !queue_.empty() || fileSlot_; }
  /// What to do next, or what the last pick came to where it came to nothing; a line.
  [[nodiscard]] QString notice() const { return notice_; }

  /// A place for a measurement, mm LPS; the last one of its kind has it measured.
  void pick(MeasurementKind kind, const Eigen::Vector3d& lps);
  /// The places of a measurement that needs more of them.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& picked() const { return picked_; }
  void forgetPicked();
  /// Another kind is to be measured, and the notice says how; places of the last one are forgotten.
  void prepare(MeasurementKind kind);

  // Edits: each one is undoable.
  void remove(const QString& name);
  /// @returns why not; empty: done
  QString rename(const QString& name, const QString& wanted);
  /// At the same places, on the wall that is shown.
  void measureAgain(const QString& name);
  /// With one of its places elsewhere, mm LPS.
  void movePlace(const QString& name, std::size_t place, const Eigen::Vector3d& lps);

  /// All of them as a table of comma-separated values.
  void exportTable(const QString& path);

 Q_SIGNALS:
  void changed();  ///< measurements, their states, selection, places picked or notice
  void goTo(double x, double y, double z, double radiusMm);
  void exported(const QString& path);

 private:
  void refreshGround();
  void request(Measurement measurement, const QString& edit);
  void startNext();
  void finish(MeasureJob& job);
  void finishFile(const MeasurementsFileJob& job);
  void note(Measurement measurement, const QString& what);
  void tell(const QString& text);
  [[nodiscard]] QString freeName(MeasurementKind kind) const;

  CaseModels& models_;
  MeasureGround ground_;
  MeasurementKind pickedKind_ = MeasurementKind::Distance;
  std::vector<Eigen::Vector3d> picked_;
  QString selected_, notice_;
  std::deque<std::shared_ptr<MeasureJob>> queue_;
  JobSlot<MeasureJob> slot_;
  JobSlot<MeasurementsFileJob> fileSlot_;
};

}  // namespace angiomesh
