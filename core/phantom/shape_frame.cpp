// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/shape_frame.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/formatted.h"

namespace angiomesh {
ShapeFrame makeShapeFrame(const PhantomParams& params, const Geometry& g) {
  const double norm = std::sqrt(params.axis.dot(params.axis));
  if (!std::isfinite(norm) || norm < 1e-9)
    throw InputError("the axis has no direction", "phantom axis",
                     "give three numbers that are not all 0");
  if (!params.offset.allFinite() || params.offset.cwiseAbs().maxCoeff() > 4.0)
    throw InputError("the shift is too large", "phantom offset", "give at most 4 voxels");
  if (!std::isfinite(params.radius) || params.radius < 0.5)
    throw InputError(
        "a vessel radius of " + formatted("%.3g", params.radius) + " voxels cannot be drawn",
        "phantom radius", "give at least 0.5 voxel");
  ShapeFrame frame;
  frame.unit = g.voxelMm();
  frame.radius = params.radius * frame.unit;
  frame.axis = params.axis / norm;
  const Eigen::Vector3d magnitude = frame.axis.cwiseAbs();
  int least = 0;
  for (int a = 1; a < 3; ++a)
    if (magnitude[a] < magnitude[least]) least = a;
  Eigen::Vector3d side = Eigen::Vector3d::Unit(least);
  side -= side.dot(frame.axis) * frame.axis;
  frame.first = side / std::sqrt(side.dot(side));
  frame.second = Eigen::Vector3d(frame.axis[1] * frame.first[2] - frame.axis[2] * frame.first[1],
                                 frame.axis[2] * frame.first[0] - frame.axis[0] * frame.first[2],
                                 frame.axis[0] * frame.first[1] - frame.axis[1] * frame.first[0]);
  const Eigen::Vector3d size(g.size[0], g.size[1], g.size[2]);
  frame.low = -0.5 * g.spacing;
  frame.high = (size - Eigen::Vector3d::Constant(0.5)).cwiseProduct(g.spacing);
  frame.centre = 0.5 * (frame.low + frame.high) + params.offset * frame.unit;
  const Eigen::Vector3d extent = frame.high - frame.low;
  frame.halfSide = 0.5 * extent.minCoeff();
  frame.through = std::sqrt(extent.dot(extent));
  return frame;
}

void requireRoom(const ShapeFrame& frame, double halfWidth, const char* kind) {
  const double room = frame.halfSide - frame.unit;
  if (halfWidth <= room) return;
  const double radius = frame.radius / frame.unit;
  throw InputError(
      "a " + std::string(kind) + " of radius " + formatted("%.3g", radius) + " voxels does not fit",
      "phantom of " + formatted("%.3g", 2.0 * frame.halfSide / frame.unit) +
          " voxels in its shortest side",
      "give a radius of about " + formatted("%.3g", std::max(0.5, radius * room / halfWidth)) +
          " voxels or a size of " +
          formatted("%.3g", std::ceil(2.0 * (halfWidth / frame.unit + 1.0))));
}

std::optional<std::array<double, 2>> clipToVolume(const ShapeFrame& frame,
                                                  const Eigen::Vector3d& from,
                                                  const Eigen::Vector3d& to) {
  double enter = 0.0;
  double leave = 1.0;
  for (int a = 0; a < 3; ++a) {
    const double step = to[a] - from[a];
    if (step == 0.0) {
      if (from[a] < frame.low[a] || from[a] > frame.high[a]) return std::nullopt;
      continue;
    }
    const double t0 = (frame.low[a] - from[a]) / step;
    const double t1 = (frame.high[a] - from[a]) / step;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  if (enter >= leave) return std::nullopt;
  return std::array<double, 2>{enter, leave};
}

int addCentreLine(Shape& shape, const ShapeFrame& frame, const std::vector<Eigen::Vector3d>& points,
                  const std::vector<double>& radii, int parent) {
  int last = parent;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto part = clipToVolume(frame, points[i - 1], points[i]);
    if (!part) {
      last = -1;
      continue;
    }
    const Eigen::Vector3d step = points[i] - points[i - 1];
    const double grow = radii[i] - radii[i - 1];
    const auto [enter, leave] = *part;
    shape.centreLines.push_back({points[i - 1] + enter * step, points[i - 1] + leave * step,
                                 radii[i - 1] + enter * grow, radii[i - 1] + leave * grow,
                                 enter > 0.0 ? -1 : last});
    last = static_cast<int>(shape.centreLines.size()) - 1;
  }
  return last;
}

Geometry phantomGeometry(const PhantomParams& params) {
  Geometry g;
  g.size = params.size;
  g.spacing = params.spacingMm;
  double voxels = 1.0;
  for (int a = 0; a < 3; ++a) {
    if (g.size[a] < 8 || g.size[a] > 4096)
      throw InputError("a side of " + std::to_string(g.size[a]) + " voxels makes no phantom",
                       "phantom size", "give 8 to 4096 voxels in each direction");
    if (!std::isfinite(g.spacing[a]) || g.spacing[a] < 1e-3 || g.spacing[a] > 1e3)
      throw InputError("a spacing of " + formatted("%.3g", g.spacing[a]) + " mm makes no phantom",
                       "phantom spacing", "give 0.001 to 1000 mm in each direction");
    voxels *= g.size[a];
  }
  if (voxels > 1024.0 * 1024.0 * 1024.0)
    throw InputError("a phantom of " + formatted("%.3g", voxels) + " voxels is too large",
                     "phantom size", "give at most 1024 x 1024 x 1024 voxels");
  if (g.spacing.maxCoeff() > 20.0 * g.spacing.minCoeff())
    throw InputError("the spacing differs by more than 20 times between the axes",
                     "phantom spacing", "give spacings that are closer to one another");
  return g;
}

}  // namespace angiomesh
