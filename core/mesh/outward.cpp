// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/outward.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <unordered_map>
#include <utility>

#include "core/mesh/mesh_edges.h"
#include "core/mesh/predicates.h"

namespace angiomesh {
namespace {

struct Part {
  bool closed = true;
  bool met = false;
  bool turn = false;
  double sixfoldVolume = 0.0;
  Eigen::Vector3d point;  ///< one of its vertices
  Eigen::AlignedBox3d box;
};

std::vector<Part> measureParts(const TriMesh& mesh, const MeshComponents& components) {
  std::vector<Part> parts(components.count);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    Part& part = parts[components.label[i]];
    if (!part.met) part.point = mesh.points[t[0]];
    part.met = true;
    // About a point of the part: about the origin, the volume of a small one would drown.
    const Eigen::Vector3d a = mesh.points[t[0]] - part.point;
    const Eigen::Vector3d b = mesh.points[t[1]] - part.point;
    const Eigen::Vector3d c = mesh.points[t[2]] - part.point;
    part.sixfoldVolume += a.dot(b.cross(c));
    for (const std::uint32_t corner : t) part.box.extend(mesh.points[corner]);
  }
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  for (std::size_t i = 0; i < sides.size();) {
    const std::size_t end = edgeRunEnd(sides, i);
    const auto first = sides.begin() + static_cast<std::ptrdiff_t>(i);
    const auto last = sides.begin() + static_cast<std::ptrdiff_t>(end);
    const auto forward =
        std::count_if(first, last, [](const EdgeSide& side) { return side.forward; });
    if (2 * forward != last - first) parts[components.label[sides[i].triangle]].closed = false;
    i = end;
  }
  return parts;
}

/// Whether the ray from `q` along +z meets the triangle. A ray through an edge or a vertex meets an
/// odd number of the triangles around it exactly when it passes from one side of the surface to the
/// other there.
bool rayMeets(const Eigen::Vector3d& q, const TriMesh& mesh,
              const std::array<std::uint32_t, 3>& triangle) {
  const Eigen::Vector2d flat = q.head<2>();
  bool inside = false;
  for (std::size_t k = 0; k < 3; ++k) {
    Eigen::Vector2d low = mesh.points[triangle[k]].head<2>();
    Eigen::Vector2d high = mesh.points[triangle[(k + 1) % 3]].head<2>();
    if ((low.y() > flat.y()) == (high.y() > flat.y())) continue;
    if (low.y() > high.y()) std::swap(low, high);
    if (orient2d(low, high, flat) > 0) inside = !inside;
  }
  if (!inside) return false;
  const Eigen::Vector3d& a = mesh.points[triangle[0]];
  const Eigen::Vector3d& b = mesh.points[triangle[1]];
  const Eigen::Vector3d& c = mesh.points[triangle[2]];
  return orient3d(a, b, c, q) * orient2d(a.head<2>(), b.head<2>(), c.head<2>()) < 0;
}

/// Pairs (inner, outer) of closed parts. One sweep over the triangles asks for all points at once.
std::vector<std::pair<std::uint32_t, std::uint32_t>> nestedParts(const TriMesh& mesh,
                                                                 const MeshComponents& components,
                                                                 const std::vector<Part>& parts) {
  std::vector<std::uint32_t> byY;
  for (std::uint32_t p = 0; p < parts.size(); ++p)
    if (parts[p].closed) byY.push_back(p);
  const auto yOf = [&](std::uint32_t p) { return parts[p].point.y(); };
  std::sort(byY.begin(), byY.end(),
            [&](std::uint32_t a, std::uint32_t b) { return yOf(a) < yOf(b); });
  std::unordered_map<std::uint64_t, bool> odd;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t outer = components.label[i];
    if (!parts[outer].closed) continue;
    Eigen::AlignedBox3d box;
    for (const std::uint32_t corner : mesh.triangles[i]) box.extend(mesh.points[corner]);
    auto inner = std::lower_bound(byY.begin(), byY.end(), box.min().y(),
                                  [&](std::uint32_t p, double y) { return yOf(p) < y; });
    for (; inner != byY.end() && yOf(*inner) <= box.max().y(); ++inner) {
      const Eigen::Vector3d& q = parts[*inner].point;
      if (*inner == outer || q.x() < box.min().x() || q.x() > box.max().x() ||
          q.z() > box.max().z() || !parts[outer].box.contains(parts[*inner].box))
        continue;
      if (rayMeets(q, mesh, mesh.triangles[i])) {
        bool& state = odd[(std::uint64_t{*inner} << 32U) | outer];
        state = !state;
      }
    }
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const auto& [key, state] : odd)
    if (state)
      pairs.emplace_back(static_cast<std::uint32_t>(key >> 32U),
                         static_cast<std::uint32_t>(key & 0xffffffffU));
  return pairs;
}

}  // namespace

OutwardTurn turnOutward(TriMesh& mesh) {
  const MeshComponents components = meshComponents(mesh);
  std::vector<Part> parts = measureParts(mesh, components);
  OutwardTurn result;
  bool someInward = false;
  for (const Part& part : parts) {
    if (part.closed) ++result.closedParts;
    someInward = someInward || (part.closed && part.sixfoldVolume < 0.0);
  }
  if (!someInward) return result;
  const auto pairs = nestedParts(mesh, components, parts);
  std::vector<bool> outermost(parts.size(), true);
  for (const auto& [inner, outer] : pairs) outermost[inner] = false;
  for (std::size_t p = 0; p < parts.size(); ++p)
    parts[p].turn = parts[p].closed && outermost[p] && parts[p].sixfoldVolume < 0.0;
  for (const auto& [inner, outer] : pairs)
    if (outermost[outer] && parts[outer].turn) parts[inner].turn = true;
  for (const Part& part : parts)
    if (part.turn) ++result.turnedParts;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (parts[components.label[i]].turn) std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
  return result;
}

AlikeTurn turnAlike(TriMesh& mesh) {
  constexpr std::uint32_t kNone = 0xffffffffU;
  struct Neighbours {
    std::array<std::uint32_t, 3> triangle{kNone, kNone, kNone};
    std::array<bool, 3> agrees{};
  };
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  std::vector<Neighbours> around(mesh.triangles.size());
  bool alike = true;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    end = edgeRunEnd(sides, i);
    if (end != i + 2) continue;
    const EdgeSide &one = sides[i], &other = sides[i + 1];
    const bool agrees = one.forward != other.forward;
    alike = alike && agrees;
    around[one.triangle].triangle[one.side] = other.triangle;
    around[other.triangle].triangle[other.side] = one.triangle;
    around[one.triangle].agrees[one.side] = around[other.triangle].agrees[other.side] = agrees;
  }
  AlikeTurn result;
  if (alike) return result;
  enum : char { Unknown, Kept, Turned };
  std::vector<char> state(mesh.triangles.size(), Unknown);
  for (std::uint32_t first = 0; first < mesh.triangles.size(); ++first) {
    if (state[first] != Unknown) continue;
    std::vector<std::uint32_t> part{first};
    state[first] = Kept;
    bool oneSided = false;
    std::size_t turned = 0;
    for (std::size_t n = 0; n < part.size(); ++n)
      for (std::size_t side = 0; side < 3; ++side) {
        const std::uint32_t next = around[part[n]].triangle[side];
        if (next == kNone) continue;
        const char as = (state[part[n]] == Kept) == around[part[n]].agrees[side] ? Kept : Turned;
        if (state[next] == Unknown) {
          state[next] = as;
          part.push_back(next);
          turned += as == Turned ? 1 : 0;
        }
        oneSided = oneSided || state[next] != as;
      }
    if (oneSided) ++result.oneSided;
    if (oneSided) continue;
    const char less = 2 * turned > part.size() ? Kept : Turned;
    for (const std::uint32_t t : part) {
      if (state[t] != less) continue;
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
      ++result.turned;
    }
  }
  return result;
}

bool isClosed(const TriMesh& mesh) {
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  for (std::size_t i = 0; i < sides.size();) {
    const std::size_t end = edgeRunEnd(sides, i);
    if (end - i != 2) return false;
    i = end;
  }
  return !sides.empty();
}

}  // namespace angiomesh
