// SPDX-License-Identifier: BSD-3-Clause
#include "core/lumen/wall_cells.h"

#include <Eigen/Eigenvalues>

#include "core/base/parallel.h"
#include "core/field/spline_field.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr std::size_t kGrain = 512;

Vector3f stepOf(const Geometry& g) { return (g.spacing / g.voxelMm()).cast<float>(); }

/// How far phi falls inwards from the wall, working voxels.
float depthBehind(const Volume<float>& phi, const WallCell& cell) {
  const Vector3f step = stepOf(phi.geometry);
  const auto voxel = static_cast<float>(phi.geometry.voxelMm());
  constexpr float stride = 0.5F, farthest = 6.0F, clamped = 4.5F;
  float deepest = 0.0F;
  for (float t = stride; t <= farthest; t += stride) {
    const Vector3f at = (cell.foot - t * cell.normal).cwiseQuotient(step);
    const auto depth = static_cast<float>(-interpolateLinear(phi, at.cast<double>())) / voxel;
    if (depth <= deepest + 0.2F * stride) break;
    deepest = depth;
  }
  return deepest >= clamped ? VesselFrame::kThick : std::max(deepest, stride);
}

/// The eigenvector of least eigenvalue of the normals' second moments, and how sure it is: 0 where
/// the wall is as flat along it as across.
VesselFrame frameOf(const Eigen::Matrix3f& normals, float stretch) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver(normals);
  const Vector3f e = solver.eigenvalues();
  const float sure = std::clamp(2.0F * (e[1] - e[0]) / (e[1] + e[0] + 0.05F) - 0.6F, 0.0F, 1.0F);
  VesselFrame frame;
  frame.axis = solver.eigenvectors().col(0);
  frame.stretch = 1.0F + (stretch - 1.0F) * sure;
  return frame;
}

}  // namespace

WallCells::WallCells(const Volume<float>& phi, double reachVoxels)
    : grid_(phi.geometry.size),
      step_(stepOf(phi.geometry)),
      voxelMm_(static_cast<float>(phi.geometry.voxelMm())) {
  const float reach = static_cast<float>(reachVoxels) * voxelMm_;
  const auto columns = static_cast<std::size_t>(grid_[0]);
  rows_.assign(phi.voxels.size() / columns + 1, 0);
  for (std::size_t row = 0; row + 1 < rows_.size(); ++row) {
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t voxel = row * columns + i;
      if (!(std::fabs(phi.voxels[voxel]) < reach)) continue;
      WallCell cell;
      cell.voxel = static_cast<std::uint32_t>(voxel);
      cells_.push_back(cell);
      columns_.push_back(static_cast<std::uint16_t>(i));
    }
    rows_[row + 1] = static_cast<std::uint32_t>(cells_.size());
  }
}

void WallCells::place(const SplineField& phi, const Progress& progress) {
  const Vector3d step = step_.cast<double>();
  parallelForEach(cells_.size(), kGrain, progress, [&](std::size_t n) {
    WallCell& cell = cells_[n];
    const Index3 p = phi.geometry().indexOf(cell.voxel);
    const Vector3d x = step.cwiseProduct(Vector3d(p[0], p[1], p[2]));
    Vector3d at = x, normal = Vector3d::Zero();
    for (int i = 0; i < 6; ++i) {
      const SplineField::Jet jet = phi.atIndex(at.cwiseQuotient(step));
      const Vector3d slope = jet.gradient.cwiseQuotient(step);
      const double square = slope.squaredNorm();
      if (square < 1e-12) break;
      normal = slope / std::sqrt(square);
      Vector3d move = -jet.value / square * slope;
      const double length = move.norm();
      if (length > 0.7) move *= 0.7 / length;
      at += move;
      if (length < 1e-3) break;
    }
    cell.foot = at.cast<float>();
    cell.normal = normal.cast<float>();
    cell.distance = static_cast<float>((x - at).dot(normal));
  });
}

std::vector<VesselFrame> vesselFrames(const Volume<float>& phi, const WallCells& cells,
                                      double reachVoxels, double stretch,
                                      const Progress& progress) {
  const auto reach = static_cast<float>(reachVoxels);
  std::vector<float> depth(cells.size(), 0.0F);
  parallelForEach(cells.size(), kGrain, progress, [&](std::size_t n) {
    if (std::fabs(cells[n].distance) <= reach) depth[n] = depthBehind(phi, cells[n]);
  });
  std::vector<VesselFrame> frames(cells.size());
  parallelForEach(cells.size(), kGrain, progress, [&](std::size_t n) {
    const WallCell& cell = cells[n];
    if (std::fabs(cell.distance) > reach) return;
    float sum = 0.0F, count = 0.0F;
    cells.forBox(cell.foot, Vector3f::Constant(2.5F), [&](std::size_t m) {
      if (depth[m] == 0.0F || cells[m].normal.dot(cell.normal) < 0.5F) return;
      sum += depth[m];
      count += 1.0F;
    });
    const float radius = count > 0.0F ? sum / count : depth[n];
    const float window = std::clamp(1.5F * radius + 1.0F, 3.0F, 8.0F);
    Eigen::Matrix3f normals = Eigen::Matrix3f::Zero();
    float weights = 0.0F;
    cells.forBox(cell.foot, Vector3f::Constant(window), [&](std::size_t m) {
      const WallCell& other = cells[m];
      if (depth[m] == 0.0F) return;
      const float t = 1.0F - (other.foot - cell.foot).squaredNorm() / (window * window);
      if (t <= 0.0F || !onOneWall(cell, other)) return;
      const float w = t * t * t;
      normals += w * other.normal * other.normal.transpose();
      weights += w;
    });
    if (weights > 0.0F) frames[n] = frameOf(normals / weights, static_cast<float>(stretch));
    frames[n].radius = radius;
  });
  return frames;
}

}  // namespace angiomesh
