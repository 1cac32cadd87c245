// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "io/dicom/dicom_series.h"

namespace angiomesh {

/// Unit normal of a frame's plane, row x column.
inline Eigen::Vector3d sliceNormal(const DicomFrame& frame) {
  return frame.alongRow.cross(frame.alongColumn).stableNormalized();
}

/// "axial", "coronal" or "sagittal" by the plane's normal, "oblique" before it when the normal is
/// off the axis by more than 10 degrees.
inline std::string orientationText(const Eigen::Vector3d& alongRow,
                                   const Eigen::Vector3d& alongColumn) {
  const Eigen::Vector3d normal = alongRow.cross(alongColumn).stableNormalized();
  Eigen::Index axis = 0;
  const double cosine = normal.cwiseAbs().maxCoeff(&axis);
  const char* const names[] = {"sagittal", "coronal", "axial"};
  constexpr double kCosTenDegrees = 0.984807753;
  return (cosine < kCosTenDegrees ? "oblique " : "") + std::string(names[axis]);
}

}  // namespace angiomesh
