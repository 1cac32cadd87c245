// SPDX-License-Identifier: BSD-3-Clause
#include "core/contour/reference_surface.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/parallel.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

// Points of the outside layer, moved onto the outermost voxel centres. Those of one voxel become
// one point.
class Flattener {
 public:
  explicit Flattener(const Geometry& grid) : grid_(grid) {}

  // Border plane (0..5) that a triangle of the outside layer belongs to; -1 for the wall.
  [[nodiscard]] int capOf(const TriMesh& mesh, const std::array<std::uint32_t, 3>& t) const {
    Vector3d centre = Vector3d::Zero();
    for (const std::uint32_t v : t) centre += grid_.toIndex(mesh.points[v]) / 3.0;
    for (int axis = 0; axis < 3; ++axis) {
      if (centre[axis] < -1e-9) return 2 * axis;
      if (centre[axis] > grid_.size[static_cast<std::size_t>(axis)] - 1 + 1e-9) return 2 * axis + 1;
    }
    return -1;
  }

  // The new number of a vertex, its place moved into the grid.
  std::uint32_t flatten(std::uint32_t v, Vector3d& point) {
    Vector3d index = grid_.toIndex(point);
    Vector3d inside = index;
    for (int axis = 0; axis < 3; ++axis)
      inside[axis] =
          std::clamp(index[axis], 0.0, 1.0 * (grid_.size[static_cast<std::size_t>(axis)] - 1));
    if ((inside - index).cwiseAbs().maxCoeff() < 1e-6) return v;
    Index3 voxel{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      voxel[a] = std::clamp(static_cast<int>(std::lround(inside[axis])), 0, grid_.size[a] - 1);
      inside[axis] = voxel[a];
    }
    point = grid_.toPhysical(inside);
    return voxels_.emplace(grid_.offset(voxel[0], voxel[1], voxel[2]), v).first->second;
  }

 private:
  const Geometry& grid_;
  std::unordered_map<std::size_t, std::uint32_t> voxels_;
};

void dropUnusedPoints(PatchMesh& patch) {
  constexpr std::uint32_t none = 0xffffffffU;
  std::vector<std::uint32_t> number(patch.mesh.points.size(), none);
  for (const auto& t : patch.mesh.triangles)
    for (const std::uint32_t v : t) number[v] = 0;
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < number.size(); ++v) {
    if (number[v] == none) continue;
    patch.mesh.points[count] = patch.mesh.points[v];
    number[v] = count++;
  }
  patch.mesh.points.resize(count);
  for (auto& t : patch.mesh.triangles)
    for (std::uint32_t& v : t) v = number[v];
}

}  // namespace

GridPart wholeGrid(const Geometry& grid) {
  return {{0, 0, 0}, {grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1}, 1};
}

Volume<float> sampleField(const SplineField& field, const GridPart& part,
                          const Progress& progress) {
  Geometry g = field.geometry();
  Vector3d first;
  for (std::size_t a = 0; a < 3; ++a) {
    g.size[a] = (part.last[a] - part.first[a]) * part.finer + 1;
    first[static_cast<Eigen::Index>(a)] = part.first[a];
  }
  g.spacing /= part.finer;
  g.origin = field.geometry().toPhysical(first);
  Volume<float> out(g);
  parallelFor(0, static_cast<std::size_t>(g.size[2]), 1, [&](std::size_t slice, std::size_t) {
    progress.check();
    const int k = static_cast<int>(slice);
    for (int j = 0; j < g.size[1]; ++j) {
      if (part.finer == 1) {
        field.atVoxels(part.first[0], part.last[0], part.first[1] + j, part.first[2] + k,
                       &out.at(0, j, k));
        continue;
      }
      for (int i = 0; i < g.size[0]; ++i)
        out.at(i, j, k) =
            static_cast<float>(field.atIndex(first + Vector3d(i, j, k) / part.finer).value);
    }
  });
  return out;
}

PatchMesh referenceSurface(const Volume<float>& values, const EndPlanes& ends, SurfaceBorder border,
                           const Progress& progress) {
  PatchMesh out;
  const TriMesh mesh = marchingCubes(values, border, progress);
  out.mesh.points = mesh.points;
  std::vector<std::uint32_t> number(mesh.points.size());
  Flattener flattener(values.geometry);
  for (std::uint32_t v = 0; v < number.size(); ++v)
    number[v] = flattener.flatten(v, out.mesh.points[v]);
  for (const auto& t : mesh.triangles) {
    const std::array<std::uint32_t, 3> flat{number[t[0]], number[t[1]], number[t[2]]};
    if (flat[0] == flat[1] || flat[1] == flat[2] || flat[2] == flat[0]) continue;
    const int cap = flattener.capOf(mesh, t);
    if (cap >= 0 && !ends.borders(out.mesh.points[flat[0]]).liesIn(cap)) continue;
    out.mesh.triangles.push_back(flat);
    out.patch.push_back(static_cast<std::uint16_t>(cap + 1));
  }
  dropUnusedPoints(out);
  out.origin.assign(out.patch.size(), FaceOrigin::Remesh);
  for (const Vector3d& p : out.mesh.points) out.place.push_back(ends.borders(p));
  for (std::size_t t = 0; t < out.patch.size(); ++t)
    for (const std::uint32_t v : out.mesh.triangles[t])
      if (out.patch[t] == 0) out.place[v].wall = true;
  return out;
}

TriMesh wallOf(const PatchMesh& patch) {
  TriMesh wall;
  wall.points = patch.mesh.points;
  for (std::size_t t = 0; t < patch.patch.size(); ++t)
    if (patch.patch[t] == 0) wall.triangles.push_back(patch.mesh.triangles[t]);
  return wall;
}

}  // namespace angiomesh
