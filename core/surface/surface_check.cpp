// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/surface_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/parallel.h"
#include "core/surface/cell_bounds.h"
#include "core/surface/half_edges.h"
#include "core/surface/surface_cover.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

// The region around a triangle in which the gradient must not turn away from its normal.
struct Region {
  Vector3d centre, normal;
  double radius = 0.0;  // mm
  double along = 0.0;   // the gradient's part along the normal, at the centre
  Vector3d low, high;   // its box in index space, inside the grid
  Index3 first{}, last{};
};

class FacingCheck {
 public:
  FacingCheck(const PatchMesh& mesh, const SplineField& field) : mesh_(mesh), field_(field) {
    const Eigen::Matrix3d toIndex = field.geometry().physicalToIndexMatrix();
    for (int a = 0; a < 3; ++a) indexPerMm_[a] = toIndex.row(a).norm();
  }

  // Per triangle: 1 where the field may turn away.
  std::vector<char> run(const Progress& progress) {
    const std::size_t n = mesh_.mesh.triangles.size();
    std::vector<Region> regions(n);
    std::vector<char> doubt(n, 0);
    parallelFor(0, n, 1024, [&](std::size_t first, std::size_t last) {
      progress.check();
      for (std::size_t t = first; t < last; ++t)
        if (mesh_.patch[t] == 0) regions[t] = regionOf(t);
    });
    boundCells(regions, progress);
    parallelFor(0, n, 512, [&](std::size_t first, std::size_t last) {
      progress.check();
      for (std::size_t t = first; t < last; ++t)
        if (mesh_.patch[t] == 0) doubt[t] = static_cast<char>(!faces(regions[t]));
    });
    return doubt;
  }

 private:
  [[nodiscard]] Region regionOf(std::size_t t) const {
    const auto& corners = mesh_.mesh.triangles[t];
    const Vector3d& a = mesh_.mesh.points[corners[0]];
    const Vector3d& b = mesh_.mesh.points[corners[1]];
    const Vector3d& c = mesh_.mesh.points[corners[2]];
    Region r;
    r.centre = (a + b + c) / 3.0;
    const Vector3d normal = (b - a).cross(c - a);
    if (normal.norm() > 0.0)
      r.normal = normal.normalized();
    else
      r.normal.setZero();
    const SplineField::Jet jet = field_.at(r.centre);
    r.along = jet.gradient.dot(r.normal);
    const double slope = jet.gradient.norm();
    // Twice the distance to the foot, to first order, allows for the other points' feet.
    const double gap =
        slope > 1e-12 ? std::min(2.0 * std::fabs(jet.value) / slope, field_.geometry().voxelMm())
                      : 0.0;
    r.radius =
        gap + std::max({(a - r.centre).norm(), (b - r.centre).norm(), (c - r.centre).norm()});
    const Geometry& g = field_.geometry();
    const Vector3d i0 = g.toIndex(a), i1 = g.toIndex(b), i2 = g.toIndex(c);
    const Vector3d margin = gap * indexPerMm_;
    r.low = i0.cwiseMin(i1).cwiseMin(i2) - margin;
    r.high = i0.cwiseMax(i1).cwiseMax(i2) + margin;
    for (int axis = 0; axis < 3; ++axis) {
      const auto s = static_cast<std::size_t>(axis);
      r.low[axis] = std::clamp(r.low[axis], 0.0, g.size[s] - 1.0);
      r.high[axis] = std::clamp(r.high[axis], 0.0, g.size[s] - 1.0);
      r.first[s] = std::min(static_cast<int>(r.low[axis]), g.size[s] - 2);
      r.last[s] = std::min(static_cast<int>(r.high[axis]), g.size[s] - 2);
    }
    return r;
  }

  template <class Visit>
  static void forEachCell(const Region& r, Visit visit) {
    for (int k = r.first[2]; k <= r.last[2]; ++k)
      for (int j = r.first[1]; j <= r.last[1]; ++j)
        for (int i = r.first[0]; i <= r.last[0]; ++i) visit(Index3{i, j, k});
  }

  void boundCells(const std::vector<Region>& regions, const Progress& progress) {
    const Geometry& g = field_.geometry();
    for (std::size_t t = 0; t < regions.size(); ++t)
      if (mesh_.patch[t] == 0)
        forEachCell(regions[t],
                    [&](const Index3& c) { cells_.push_back(g.offset(c[0], c[1], c[2])); });
    std::sort(cells_.begin(), cells_.end());
    cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
    bounds_.resize(cells_.size());
    parallelFor(0, cells_.size(), 256, [&](std::size_t first, std::size_t last) {
      progress.check();
      for (std::size_t i = first; i < last; ++i)
        bounds_[i] = static_cast<float>(hessianBound(field_, g.indexOf(cells_[i])) * (1.0 + 1e-6));
    });
  }

  [[nodiscard]] bool faces(const Region& r) const {
    const Geometry& g = field_.geometry();
    if (!(r.along > 0.0)) return false;
    bool sure = true;
    forEachCell(r, [&](const Index3& c) {
      if (!sure) return;
      const auto at = std::lower_bound(cells_.begin(), cells_.end(), g.offset(c[0], c[1], c[2]));
      const double bound =
          static_cast<double>(bounds_[static_cast<std::size_t>(at - cells_.begin())]);
      if (bound * r.radius < r.along) return;
      sure = hessianBound(field_, c, r.low, r.high) * r.radius < r.along;
    });
    return sure;
  }

  const PatchMesh& mesh_;
  const SplineField& field_;
  Vector3d indexPerMm_;
  std::vector<std::size_t> cells_;
  std::vector<float> bounds_;
};

// The first reason against a component stays.
void doubtIt(SurfaceComponent& component, const std::string& why) {
  if (component.why.empty()) component.why = why;
}

void countRims(const PatchMesh& mesh, const std::vector<EdgeSide>& sides, SurfaceBorder border,
               SurfaceCheck& check) {
  DisjointSets rims(mesh.mesh.points.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> onRim;  // vertex, label
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
    const std::size_t count = edgeRunEnd(sides, i) - i;
    const std::uint32_t label = check.parts.label[sides[i].triangle];
    SurfaceComponent& component = check.components[label];
    --component.euler;
    if (count == 2) {
      if (sides[i].forward == sides[i + 1].forward)
        doubtIt(component, "faces disagree in orientation");
      continue;
    }
    if (count > 2) {
      doubtIt(component, "an edge has more than two faces");
      continue;
    }
    rims.join(sides[i].low, sides[i].high);
    onRim.emplace_back(sides[i].low, label);
    const bool inPlane = mesh.place[sides[i].low].shared(mesh.place[sides[i].high]).planes() > 0;
    if (border == SurfaceBorder::Cap || !inPlane) doubtIt(component, "it is not closed");
  }
  // A loop's representative, its lowest vertex, is the lower end of two of its edges.
  std::sort(onRim.begin(), onRim.end());
  onRim.erase(std::unique(onRim.begin(), onRim.end()), onRim.end());
  for (const auto& [v, label] : onRim)
    if (rims.find(v) == v) ++check.components[label].boundaryLoops;
}

void measureParts(const PatchMesh& mesh, SurfaceBorder border, SurfaceCheck& check) {
  const HalfEdges edges(mesh.mesh);
  std::vector<char> seen(mesh.mesh.points.size(), 0);
  std::vector<std::size_t> fromFront(check.components.size(), 0);
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
    const auto& corners = mesh.mesh.triangles[t];
    const std::uint32_t label = check.parts.label[t];
    SurfaceComponent& component = check.components[label];
    ++component.triangles;
    ++component.euler;
    if (mesh.origin[t] == FaceOrigin::Front) ++fromFront[label];
    const Eigen::Vector3d &a = mesh.mesh.points[corners[0]], &b = mesh.mesh.points[corners[1]],
                          &c = mesh.mesh.points[corners[2]];
    component.volumeMm3 += a.dot(b.cross(c)) / 6.0;
    component.areaMm2 += 0.5 * (b - a).cross(c - a).norm();
    for (const std::uint32_t v : corners) {
      if (edges.irregular(v)) doubtIt(component, "a vertex has more than one fan of faces");
      if (seen[v] == 0) ++component.euler;
      seen[v] = 1;
    }
  }
  countRims(mesh, sortedEdgeSides(mesh.mesh), border, check);
  for (std::size_t i = 0; i < fromFront.size(); ++i)
    check.components[i].fromFrontPercent = 100.0 * static_cast<double>(fromFront[i]) /
                                           static_cast<double>(check.components[i].triangles);
}

// Which part of the mesh reaches which component of the landmarks.
void matchLandmarks(const PatchMesh& mesh, const SplineField& field, const GuidanceField& size,
                    const Landmarks& landmarks, SurfaceCheck& check) {
  const std::size_t n = mesh.mesh.points.size();
  std::vector<FrontPoint> vertices(n);
  std::vector<std::uint32_t> labelOf(n, SurfaceCheck::none);
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.mesh.triangles[t]) labelOf[v] = check.parts.label[t];
  parallelFor(0, n, 1024, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      vertices[v].point = mesh.mesh.points[v];
      const Vector3d gradient = field.at(vertices[v].point).gradient;
      if (gradient.norm() > 1e-12) vertices[v].normal = gradient.normalized();
      vertices[v].length = size.at(vertices[v].point);
    }
  });
  SurfaceCover cover(size.slope());
  for (const FrontPoint& v : vertices) cover.add(v);
  std::vector<std::uint32_t> by(landmarks.points.size(), SurfaceCheck::none);
  parallelFor(0, by.size(), 1024, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      if (landmarks.valid[v] == 0) continue;
      const std::uint32_t near = cover.reach(landmarks.points[v]);
      if (near != SurfaceCover::none) by[v] = labelOf[near];
    }
  });
  std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> votes;
  for (std::size_t v = 0; v < by.size(); ++v)
    if (landmarks.valid[v] != 0) ++votes[landmarks.component[v]][by[v]];
  for (const auto& [component, parts] : votes) {
    SurfaceCheck::Reached r;
    r.component = component;
    r.part = SurfaceCheck::none;
    std::size_t most = 0;
    for (const auto& [part, count] : parts) {
      r.landmarks += count;
      if (part == SurfaceCheck::none)
        r.missed = count;
      else if (count > most) {
        most = count;
        r.part = part;
      }
    }
    for (const auto& [part, count] : parts)
      if (part != SurfaceCheck::none && 20 * count >= r.landmarks) r.parts.push_back(part);
    if (2 * r.missed > r.landmarks) r.part = SurfaceCheck::none;
    if (r.part != SurfaceCheck::none && r.missed > 0)
      doubtIt(check.components[r.part], std::to_string(r.missed) +
                                            " places of the zero set are farther than an edge from "
                                            "its vertices");
    check.reached.push_back(r);
  }
}

}  // namespace

SurfaceCheck checkManifold(const PatchMesh& mesh, SurfaceBorder border) {
  SurfaceCheck check;
  check.parts = meshComponents(mesh.mesh);
  check.components.resize(check.parts.count);
  measureParts(mesh, border, check);
  return check;
}

SurfaceCheck checkReach(const PatchMesh& mesh, const SplineField& field, const GuidanceField& size,
                        const Landmarks& landmarks, SurfaceBorder border) {
  SurfaceCheck check = checkManifold(mesh, border);
  matchLandmarks(mesh, field, size, landmarks, check);
  return check;
}

SurfaceCheck checkSurface(const PatchMesh& mesh, const SplineField& field,
                          const GuidanceField& size, const Landmarks& landmarks,
                          SurfaceBorder border, const Progress& progress) {
  SurfaceCheck check = checkManifold(mesh, border);
  const std::vector<char> doubt = FacingCheck(mesh, field).run(progress);
  std::vector<std::size_t> turned(check.components.size(), 0);
  for (std::size_t t = 0; t < doubt.size(); ++t)
    if (doubt[t] != 0) ++turned[check.parts.label[t]];
  for (std::size_t i = 0; i < turned.size(); ++i)
    if (turned[i] > 0)
      doubtIt(check.components[i], "around " + std::to_string(turned[i]) +
                                       " triangles the field may turn away from the surface");
  matchLandmarks(mesh, field, size, landmarks, check);
  for (SurfaceComponent& component : check.components) component.verified = component.why.empty();
  return check;
}

}  // namespace angiomesh
