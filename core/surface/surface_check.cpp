// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/surface_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "core/base/formatted.h"
#include "core/base/parallel.h"
#include "core/front/surface_cover.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_faults.h"
#include "core/mesh/triangle_tree.h"
#include "core/surface/facing_check.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

// The first reason against a component stays.
void doubtIt(SurfaceComponent& component, const std::string& why) {
  if (component.why.empty()) component.why = why;
}

void countRims(const PatchMesh& mesh, const std::vector<EdgeSide>& sides, SurfaceBorder border,
               SurfaceCheck& check) {
  DisjointSets rims(mesh.mesh.points.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> onRim;  // vertex, label
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    end = edgeRunEnd(sides, i);
    const std::size_t count = end - i;
    const std::uint32_t label = check.parts.label[sides[i].triangle];
    SurfaceComponent& component = check.components[label];
    --component.euler;
    // Where faces disagree in orientation or are more than two, the edge's ends are irregular.
    if (count > 1) continue;
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

void measureParts(const PatchMesh& mesh, const std::vector<EdgeSide>& sides, SurfaceBorder border,
                  SurfaceCheck& check) {
  const std::vector<char> irregular = irregularVertices(mesh.mesh, sides);
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
      if (irregular[v] != 0) doubtIt(component, "a vertex has more than one fan of faces");
      if (seen[v] == 0) ++component.euler;
      seen[v] = 1;
    }
  }
  countRims(mesh, sides, border, check);
  for (std::size_t i = 0; i < fromFront.size(); ++i)
    check.components[i].fromFrontPercent = 100.0 * static_cast<double>(fromFront[i]) /
                                           static_cast<double>(check.components[i].triangles);
}

// Says around how many triangles of each component the field turns away, or may, where and by how
// much at the worst.
void doubtTurned(const PatchMesh& mesh, const std::vector<TurnedFace>& turned,
                 SurfaceCheck& check) {
  struct Tally {
    std::size_t measured = 0, open = 0;
    const TurnedFace* worst = nullptr;
  };
  std::vector<Tally> tally(check.components.size());
  for (const TurnedFace& face : turned) {
    Tally& of = tally[check.parts.label[face.triangle]];
    ++(face.measured ? of.measured : of.open);
    if (of.worst == nullptr || face.degrees > of.worst->degrees) of.worst = &face;
  }
  for (std::size_t i = 0; i < tally.size(); ++i) {
    const Tally& of = tally[i];
    if (of.worst == nullptr) continue;
    const auto corners = cornersOf(mesh.mesh, of.worst->triangle);
    const std::string where = placeText((corners[0] + corners[1] + corners[2]) / 3.0);
    const std::string degrees = formatted("%.0f", of.worst->degrees);
    std::string why;
    if (of.measured > 0)
      why = "around " + std::to_string(of.measured) + " triangles the field's gradient turns away" +
            " from their normal, the farthest near " + where + " by " + degrees + " degrees";
    if (of.measured > 0 && of.open > 0) why += ", and ";
    if (of.open > 0)
      why += "around " + std::to_string(of.open) + " triangles" + (of.measured > 0 ? " more" : "") +
             " no bound shows that the field's gradient stays within 90 degrees of their normal";
    if (of.measured == 0)
      why += std::string(" (measured: at most ") + degrees + ", near " + where + ")";
    doubtIt(check.components[i], why);
  }
}

// Which part of the mesh reaches which component of the landmarks.
void matchLandmarks(const PatchMesh& mesh, const SplineField& field, const GuidanceField& size,
                    const Landmarks& landmarks, SurfaceCheck& check) {
  const std::size_t n = mesh.mesh.points.size();
  std::vector<FrontPoint> vertices(n);
  std::vector<std::uint32_t> labelOf(n, SurfaceCheck::none);
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.mesh.triangles[t]) labelOf[v] = check.parts.label[t];
  parallelForEach(n, 1024, [&](std::size_t v) {
    vertices[v].point = mesh.mesh.points[v];
    const Vector3d gradient = field.at(vertices[v].point).gradient;
    if (gradient.norm() > 1e-12) vertices[v].normal = gradient.normalized();
    vertices[v].length = size.at(vertices[v].point);
  });
  SurfaceCover cover(vertices, size.slope());
  cover.update();
  std::vector<std::uint32_t> by(landmarks.points.size(), SurfaceCheck::none);
  parallelForEach(by.size(), 1024, [&](std::size_t v) {
    if (landmarks.valid[v] == 0) return;
    const std::uint32_t near = cover.reach(landmarks.points[v]);
    if (near != SurfaceCover::none) by[v] = labelOf[near];
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
    check.reached.push_back(r);
  }
}

void doubtMissed(SurfaceCheck& check) {
  for (const SurfaceCheck::Reached& r : check.reached)
    if (r.part != SurfaceCheck::none && r.missed > 0)
      doubtIt(check.components[r.part], std::to_string(r.missed) +
                                            " places of the zero set are farther than an edge from "
                                            "its vertices");
}

}  // namespace

SurfaceCheck checkManifold(const PatchMesh& mesh, SurfaceBorder border) {
  SurfaceCheck check;
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh.mesh);
  check.parts = meshComponents(mesh.mesh, sides);
  check.components.resize(check.parts.count);
  measureParts(mesh, sides, border, check);
  return check;
}

void dropBroken(PatchMesh& mesh, SurfaceBorder border) {
  const SurfaceCheck check = checkManifold(mesh, border);
  if (std::all_of(check.components.begin(), check.components.end(),
                  [](const SurfaceComponent& c) { return c.why.empty(); }))
    return;
  mesh = selectTriangles(
      mesh, [&](std::uint32_t t) { return check.components[check.parts.label[t]].why.empty(); });
}

SurfaceCheck checkReach(const PatchMesh& mesh, const SplineField& field, const GuidanceField& size,
                        const Landmarks& landmarks, SurfaceBorder border) {
  SurfaceCheck check = checkManifold(mesh, border);
  matchLandmarks(mesh, field, size, landmarks, check);
  return check;
}

void finishCheck(SurfaceCheck& check, const PatchMesh& mesh, const SplineField& field,
                 const Progress& progress) {
  doubtTurned(mesh, turnedFaces(mesh, field, progress), check);
  doubtMissed(check);
  for (SurfaceComponent& component : check.components) component.verified = component.why.empty();
}

}  // namespace angiomesh
