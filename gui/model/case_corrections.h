// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "core/corrections/replay.h"
#include "gui/model/result_model.h"

namespace angiomesh {

/// "Add", "Join two ends".
QString correctionTitle(CorrectionKind kind);

/// The corrections of the segmentation by hand. Each is an edit of the parameters; the run model
/// makes it at once. One that turns out to be impossible is taken back, and why is said.
class CaseCorrections : public QObject {
  Q_OBJECT

 public:
  CaseCorrections(CaseDocument& document, ResultModel& results, MessageLog& log,
                  QObject* parent = nullptr);

  /// Whether there is a segmentation of the present parameters that can be corrected.
  [[nodiscard]] bool ready() const;
  [[nodiscard]] const std::vector<std::string>& all() const;
  /// What came of one; null as long as it has not been made.
  [[nodiscard]] const CorrectionOutcome* outcome(std::size_t index) const;

  // The brush.
  static constexpr double kLeastRadiusMm = 0.1, kGreatestRadiusMm = 50.0;
  [[nodiscard]] double radiusMm() const { return radiusMm_; }
  void setRadius(double mm);
  /// By a step of a quarter, up (1) or down (-1).
  void stepRadius(int steps);
  /// Whether it stops at the edge in the image.
  [[nodiscard]] bool toEdge() const { return toEdge_; }
  void setToEdge(bool on);
  /// Paints along a line of places, mm LPS; of what is as good as the same line only some are kept.
  void paint(bool add, const std::vector<Eigen::Vector3d>& lineLps);

  /// Makes a correction that one place tells, or takes the first of two places.
  void pick(CorrectionKind kind, const Eigen::Vector3d& placeLps);
  /// The place that was picked first, and for what.
  struct Picked {
    CorrectionKind kind = CorrectionKind::Bridge;
    Eigen::Vector3d placeLps{0.0, 0.0, 0.0};
  };
  [[nodiscard]] const std::optional<Picked>& picked() const { return picked_; }
  void forgetPicked();

  void remove(std::size_t index);

 Q_SIGNALS:
  void changed();

 private:
  void make(const Correction& correction);
  void set(std::vector<std::string> texts, const QString& what);
  void look();

  CaseDocument& document_;
  ResultModel& results_;
  MessageLog& log_;
  double radiusMm_ = 1.5;
  bool radiusSet_ = false;
  bool toEdge_ = true;
  std::optional<Picked> picked_;
  int made_ = -1;  ///< the undo stack's index after the correction whose outcome is waited for
};

}  // namespace angiomesh
