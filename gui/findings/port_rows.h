// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QString>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gui/job/port_job.h"
#include "gui/model/case_models.h"

namespace angiomesh {

/// A row of the list of ports.
struct PortRow {
  /// Unknown: nothing is there to look at, or it is being looked at.
  enum class State { Unknown, Good, Advised, Impossible };

  QString name;
  bool cut = false;  ///< one of ports.cuts; else an opening that the last run found or made itself
  State state = State::Unknown;
  QString note;  ///< the state in words
  CutPlane plane;
  double radiusMm = 0.0;
  double areaMm2 = 0.0;  ///< 0: not known
  std::array<double, 3> colour{};
  std::vector<Eigen::Vector3d> path;
  /// Of an opening that slices its vessel: the cut across it just inside.
  std::optional<CutPlane> across;

  [[nodiscard]] double diameterMm() const;  ///< of the circle of the same area
};

/// The plane as it is known, or as it was asked for.
CutPlane planeOf(const std::string& cut, const CutFinding* finding);

/// The row of a cut as ports.cuts has it, of which `finding` is known, or nothing yet.
PortRow cutRow(const std::string& cut, const CutFinding* finding, const CaseModels& models);

/// Of the last mesh the openings that are no cuts, neither then nor now.
std::vector<PortRow> openingRows(const CaseModels& models);

}  // namespace angiomesh
