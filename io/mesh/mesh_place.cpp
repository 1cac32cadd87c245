// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh/mesh_place.h"

#include "io/file/text_scanner.h"

namespace angiomesh {
namespace {

void scale(std::vector<Eigen::Vector3d>& points, Frame frame, double factor) {
  const double flip = frame == Frame::Ras ? -factor : factor;
  for (Eigen::Vector3d& p : points) p = Eigen::Vector3d(flip * p.x(), flip * p.y(), factor * p.z());
}

}  // namespace

std::string meshExtension(const std::filesystem::path& path) {
  return inSmall(path.extension().string());
}

void toFilePlace(std::vector<Eigen::Vector3d>& points, Frame frame, LengthUnit unit) {
  scale(points, frame, unit == LengthUnit::Metre ? 1e-3 : 1.0);
}

void toPatientPlace(std::vector<Eigen::Vector3d>& points, Frame frame, LengthUnit unit) {
  scale(points, frame, unit == LengthUnit::Metre ? 1e3 : 1.0);
}

}  // namespace angiomesh
