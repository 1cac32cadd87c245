// SPDX-License-Identifier: BSD-3-Clause
#include "core/smooth/wall_places.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/mesh/mesh_edges.h"
#include "core/openings/held_planes.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

/// Per patch: whether phi ends there, as that of a run with cuts does, and its wall goes on over
/// the cap.
std::vector<char> closedPatches(const TriMesh& mesh, const SplineField* phi) {
  std::size_t count = 0;
  for (const std::uint16_t patch : mesh.patch) count = std::max<std::size_t>(count, patch);
  std::vector<char> closed(count + 1, 0);
  if (phi == nullptr) return closed;
  const Geometry& g = phi->geometry();
  const std::vector<Port> patches = measurePatches(mesh, count);
  for (std::size_t n = 0; n < count; ++n) {
    const Vector3d beyond = patches[n].centreLps + g.voxelMm() * patches[n].normalLps;
    closed[n + 1] = static_cast<char>(g.holds(beyond) && phi->valueAt(beyond) >= 0.0);
  }
  return closed;
}

/// What is found out about the vertices before it is told as places.
class Finder {
 public:
  Finder(const TriMesh& mesh, WallPlaces& result)
      : mesh_(mesh), result_(result), rims_(rimEdges(mesh)), plane_(mesh.points.size(), kNone) {}

  void findPlanes(const Geometry& g);
  void holdPatches(const std::vector<Port>& ports);
  void freeRims(const SplineField* phi);
  void place();

 private:
  static constexpr std::uint16_t kNone = 0xffffU;

  std::uint16_t planeOf(const Vector3d& normal) {
    std::vector<Vector3d>& planes = result_.planes;
    const auto number = std::find(planes.begin(), planes.end(), normal) - planes.begin();
    if (number == std::ssize(planes)) planes.push_back(normal);
    return static_cast<std::uint16_t>(number);
  }
  void hold(std::uint32_t v, const Vector3d& normal) {
    // Where two planes meet, nothing is left to choose.
    if (plane_[v] != kNone) result_.fixed[v] = 1;
    plane_[v] = planeOf(normal);
  }
  /// The plane of the cap that a triangle lies in, or kNone.
  [[nodiscard]] std::uint16_t capOf(const std::array<std::uint32_t, 3>& t) const {
    const bool inOne = result_.offWall[t[0]] != 0 && result_.offWall[t[1]] != 0 &&
                       result_.offWall[t[2]] != 0 && plane_[t[0]] == plane_[t[1]] &&
                       plane_[t[0]] == plane_[t[2]];
    return inOne ? plane_[t[0]] : kNone;
  }

  const TriMesh& mesh_;
  WallPlaces& result_;
  const std::vector<RimEdge> rims_;
  std::vector<std::uint16_t> plane_;
  std::vector<char> lines_;  ///< per vertex: of a rim whose plane nothing tells
};

void Finder::findPlanes(const Geometry& g) {
  const EndPlanes borders(g);
  std::vector<char> onRim(mesh_.points.size(), 0);
  for (const RimEdge& edge : rims_)
    if (edge.open) onRim[edge.from] = onRim[edge.to] = 1;
  for (std::uint32_t v = 0; v < mesh_.points.size(); ++v) {
    const Vector3d index = g.toIndex(mesh_.points[v]);
    for (int axis = 0; axis < 3; ++axis) {
      const double last = g.size[static_cast<std::size_t>(axis)] - 1;
      const double beyond = std::max(-index[axis], index[axis] - last);
      const bool cap = beyond > 0.25;
      if (!cap && !(std::abs(beyond) < 1e-6 && onRim[v] != 0)) continue;
      if (cap) result_.offWall[v] = 1;
      hold(v, borders.normal(2 * axis + (index[axis] < 0.5 * last ? 0 : 1)));
    }
  }
}

void Finder::holdPatches(const std::vector<Port>& ports) {
  const HeldPlanes held(mesh_, nullptr, ports);
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
    for (const std::uint32_t v : mesh_.triangles[t])
      if (held.isCap(t)) result_.offWall[v] = 1;
  for (std::uint32_t v = 0; v < mesh_.points.size(); ++v) {
    if (held.count(v) == 0) continue;
    if (held.count(v) > 1) result_.fixed[v] = 1;
    plane_[v] = planeOf(held.normal(v));
  }
}

/// Where the wall goes on over a cap, or nothing is known of a plane, nothing tells where the rim
/// is.
void Finder::freeRims(const SplineField* phi) {
  lines_.assign(mesh_.points.size(), 0);
  const std::vector<char> closed = closedPatches(mesh_, phi);
  for (const RimEdge& edge : rims_) {
    const std::size_t patch = edge.open ? 0U : edge.otherPatch;
    const bool known = phi != nullptr && closed[patch] == 0;
    for (const std::uint32_t v : {edge.from, edge.to})
      if ((!known && !mesh_.patch.empty()) || plane_[v] == kNone) lines_[v] = 1;
  }
}

void Finder::place() {
  const std::size_t vertices = mesh_.points.size();
  std::vector<char> inside(vertices, 1), covered(vertices, 0), shared(vertices, 0);
  PatchMesh& out = result_.mesh;
  out.mesh.points = mesh_.points;
  out.mesh.triangles = mesh_.triangles;
  out.origin.assign(mesh_.triangles.size(), FaceOrigin::Contour);
  out.patch.assign(mesh_.triangles.size(), 0);
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
    const auto& t = mesh_.triangles[i];
    const std::uint16_t cap = capOf(t);
    if (cap != kNone) out.patch[i] = static_cast<std::uint16_t>(7 + cap);
    for (std::size_t k = 0; k < 3; ++k) {
      (cap != kNone ? covered : inside)[t[k]] = cap != kNone ? 1 : 0;
      const std::uint32_t u = t[(k + 1) % 3];
      const bool two =
          result_.offWall[t[k]] != 0 && result_.offWall[u] != 0 && plane_[t[k]] != plane_[u];
      if (two) shared[t[k]] = shared[u] = 1;
    }
  }
  const auto line = static_cast<std::uint16_t>(result_.planes.size());
  result_.planes.emplace_back(Vector3d::Zero());
  out.place.assign(vertices, Place::onWall());
  for (std::uint32_t v = 0; v < vertices; ++v) {
    // A cap of no triangle has no inside, and where two caps meet there is no wall to follow.
    if (result_.offWall[v] != 0 && (covered[v] == 0 || shared[v] != 0)) result_.fixed[v] = 1;
    if (lines_[v] != 0) plane_[v] = line;
    if (plane_[v] == kNone) continue;
    out.place[v] = Place::inPlane(6 + plane_[v]);
    out.place[v].wall = lines_[v] != 0 || inside[v] == 0 || result_.offWall[v] == 0;
    if (lines_[v] != 0) result_.offWall[v] = 1;
  }
}

}  // namespace

WallPlaces::WallPlaces(const TriMesh& whole, const SplineField* phi, const std::vector<Port>& ports,
                       const std::vector<char>& frozen)
    : fixed(frozen), offWall(whole.points.size(), 0) {
  Finder finder(whole, *this);
  if (phi != nullptr) finder.findPlanes(phi->geometry());
  if (!whole.patch.empty() || !ports.empty()) finder.holdPatches(ports);
  finder.freeRims(phi);
  finder.place();
}

}  // namespace angiomesh
