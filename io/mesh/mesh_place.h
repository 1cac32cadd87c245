// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "io/mesh/mesh_io.h"

namespace angiomesh {

/// The name's extension with its dot, in small letters.
std::string meshExtension(const std::filesystem::path& path);

/// LPS mm to the file's frame and unit. A turn by 180 degrees about z: faces keep their
/// orientation.
void toFilePlace(std::vector<Eigen::Vector3d>& points, Frame frame, LengthUnit unit);

/// The file's frame and unit to LPS mm.
void toPatientPlace(std::vector<Eigen::Vector3d>& points, Frame frame, LengthUnit unit);

/// The nearest single precision numbers, as a binary STL file holds them.
inline Eigen::Vector3d inSinglePrecision(const Eigen::Vector3d& p) {
  return p.cast<float>().cast<double>();
}

}  // namespace angiomesh
