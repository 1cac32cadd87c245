// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace angiomesh {

/// A measurement as the panes show it, mm LPS.
struct MeasureMark {
  std::string name;  ///< of the measurement; empty: nothing takes hold of its points
  std::vector<std::array<Eigen::Vector3d, 2>> lines;
  std::vector<std::vector<Eigen::Vector3d>> outlines;  ///< closed and flat, of sections
  /// Of sections; a slice shows only those that lie in it from end to end.
  std::vector<std::array<Eigen::Vector3d, 2>> diameters;
  std::vector<Eigen::Vector3d> points;  ///< as picked
  std::string label;
  Eigen::Vector3d labelLps{0.0, 0.0, 0.0};
  bool selected = false;
  bool dimmed = false;  ///< of an earlier wall

  [[nodiscard]] bool operator==(const MeasureMark& other) const = default;
};

/// A point of a named mark; without a name the number of a seed by hand.
struct MarkPoint {
  std::string mark;
  std::size_t point = 0;
  Eigen::Vector3d lps{0.0, 0.0, 0.0};
};

/// What is drawn of a mark in a scene's own coordinates.
struct DrawnMeasure {
  std::vector<std::array<Eigen::Vector3d, 2>> lines;
  std::vector<Eigen::Vector3d> points;
  std::string label;
  Eigen::Vector3d labelAt{0.0, 0.0, 0.0};
  bool selected = false, dimmed = false;
};

}  // namespace angiomesh
