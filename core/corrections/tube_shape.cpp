// SPDX-License-Identifier: BSD-3-Clause
#include "core/corrections/tube_shape.h"

#include <algorithm>
#include <cmath>

#include "core/image/growing_box.h"
#include "core/image/voxels.h"

namespace angiomesh {
namespace {

/// Beyond the surface, working voxels: as far as phi of a segmentation is told apart.
constexpr double kBeyond = 5.0;
/// Of the fillet between two surfaces that meet at a right angle, working voxels.
constexpr double kFillet = 1.0;

/// Unit, or 0 where phi is flat, by central differences.
Eigen::Vector3f slopeAt(const Volume<float>& phi, const Index3& p) {
  const Geometry& g = phi.geometry;
  Eigen::Vector3f slope = Eigen::Vector3f::Zero();
  for (std::size_t a = 0; a < 3; ++a) {
    Index3 low = p, high = p;
    low[a] = std::max(p[a] - 1, 0);
    high[a] = std::min(p[a] + 1, g.size[a] - 1);
    const auto axis = static_cast<Eigen::Index>(a);
    const auto run = static_cast<float>((high[a] - low[a]) * g.spacing[axis]);
    if (run > 0.0F)
      slope[axis] = (phi.at(high[0], high[1], high[2]) - phi.at(low[0], low[1], low[2])) / run;
  }
  const float size = slope.norm();
  return size > 1e-3F ? Eigen::Vector3f(slope / size) : Eigen::Vector3f::Zero();
}

/// min(a, b), lower by up to `width` / 4 where they are about equal.
float smoothLeast(float a, float b, float width) {
  const float near = std::max(width - std::fabs(a - b), 0.0F);
  const float dip = width > 0.0F ? near * near / (4.0F * width) : 0.0F;
  return std::min(a, b) - dip;
}

/// sign 1: the union of phi and the shape; -1: phi without the shape.
std::optional<VoxelBox> combine(Volume<float>& phi, const Shape& shape, float sign) {
  if (shape.phi.voxels.empty()) return std::nullopt;
  const Volume<float> before = cropped(phi, shape.box);
  const auto fillet = static_cast<float>(kFillet * phi.geometry.voxelMm());
  const Index3& size = shape.phi.geometry.size;
  const Index3& low = shape.box.low;
  GrowingBox changed;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const float a = sign * before.at(i, j, k), b = shape.phi.at(i, j, k);
        float width = 0.0F;
        if (std::fabs(a) < fillet && std::fabs(b) < fillet) {
          const float along = slopeAt(before, {i, j, k}).dot(slopeAt(shape.phi, {i, j, k}));
          width = fillet * (1.0F - along * along);
        }
        const float now = sign * smoothLeast(a, b, width);
        if (now == sign * a) continue;
        const Index3 p{low[0] + i, low[1] + j, low[2] + k};
        phi.at(p[0], p[1], p[2]) = now;
        changed.add(p);
      }
  return changed.box();
}

}  // namespace

Shape tubeShape(const Geometry& grid, const std::vector<Eigen::Vector3d>& pointsLps,
                const std::vector<double>& radiiMm) {
  const double beyond = kBeyond * grid.voxelMm();
  const double widest = *std::max_element(radiiMm.begin(), radiiMm.end());
  const auto box = boxOf(grid, pointsLps, widest + beyond);
  if (!box) return {};
  Shape shape{*box, Volume<float>(croppedGrid(grid, *box), static_cast<float>(beyond))};
  const Geometry& part = shape.phi.geometry;
  for (std::size_t n = 0; n < pointsLps.size(); ++n) {
    const std::size_t next = std::min(n + 1, pointsLps.size() - 1);
    if (next == n && n > 0) break;
    const Eigen::Vector3d &from = pointsLps[n], way = pointsLps[next] - from;
    const double square = way.squaredNorm();
    const double reach = std::max(radiiMm[n], radiiMm[next]) + beyond;
    const auto near = boxOf(part, {from, pointsLps[next]}, reach);
    if (!near) continue;
    for (int k = near->low[2]; k <= near->high[2]; ++k)
      for (int j = near->low[1]; j <= near->high[1]; ++j)
        for (int i = near->low[0]; i <= near->high[0]; ++i) {
          const Eigen::Vector3d x = voxelCentre(part, Index3{i, j, k}) - from;
          const double t = square > 0.0 ? std::clamp(x.dot(way) / square, 0.0, 1.0) : 0.0;
          const double radius = radiiMm[n] + t * (radiiMm[next] - radiiMm[n]);
          float& value = shape.phi.at(i, j, k);
          value = std::min(value, static_cast<float>((x - t * way).norm() - radius));
        }
  }
  return shape;
}

std::optional<VoxelBox> addShape(Volume<float>& phi, const Shape& shape) {
  return combine(phi, shape, 1.0F);
}

std::optional<VoxelBox> takeShape(Volume<float>& phi, const Shape& shape) {
  return combine(phi, shape, -1.0F);
}

}  // namespace angiomesh
