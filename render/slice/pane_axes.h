// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "core/image/volume.h"

namespace angiomesh {

/// How a slice along one grid axis lies on the screen. Each grid axis is paired with the patient
/// axis (0: right-left, 1: anterior-posterior, 2: inferior-superior) that it is nearest to, one to
/// one, so that every plane has its own grid axis however the volume is turned.
struct PaneAxes {
  int plane = 2;               ///< 0 sagittal, 1 coronal, 2 axial
  int across = 2;              ///< grid axis that the slices are stacked along
  int right = 0, up = 1;       ///< grid axes shown to the right and upwards
  bool rightFlipped = false;   ///< the screen's right is the axis' falling index
  bool upFlipped = false;      ///< the screen's top is the axis' falling index
  bool acrossFlipped = false;  ///< rising index goes against the patient axis (to R, A or I)
  Eigen::Vector3d rightLps{1.0, 0.0, 0.0};  ///< unit vector to the screen's right, LPS
  Eigen::Vector3d upLps{0.0, -1.0, 0.0};    ///< unit vector to the screen's top, LPS
};

/// Radiological convention: patient's right on the left; sagittal with anterior on the left; head
/// up, anterior up in axial slices.
PaneAxes paneAxes(const Geometry& geometry, int plane);

/// "L", "R", "P", "A", "S" or "I"; two letters ("LP") when `directionLps` is more than 10 degrees
/// off the nearest axis.
std::string orientationLetters(const Eigen::Vector3d& directionLps);

}  // namespace angiomesh
