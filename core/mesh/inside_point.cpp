// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/inside_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/base/error.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/triangle_shape.h"
#include "core/mesh/triangle_tree.h"

namespace angiomesh {
namespace {

constexpr std::size_t kChords = 500;

/// The triangles of the component that encloses the largest volume.
std::vector<std::uint32_t> largestComponent(const TriMesh& mesh) {
  const MeshComponents components = meshComponents(mesh);
  std::vector<double> volume(components.count, 0.0);
  const Eigen::Vector3d about = mesh.points[mesh.triangles[0][0]];
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = cornersOf(mesh, t);
    volume[components.label[t]] += (a - about).dot((b - about).cross(c - about));
  }
  const auto largest = std::max_element(volume.begin(), volume.end()) - volume.begin();
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (components.label[t] == static_cast<std::size_t>(largest)) triangles.push_back(t);
  return triangles;
}

/// Where the line along axis `axis` through `at` meets the triangle.
std::optional<double> heightAt(const std::array<Eigen::Vector3d, 3>& triangle,
                               const Eigen::Vector3d& at, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::array<double, 3> weight{};
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d &p = triangle[(k + 1) % 3], &q = triangle[(k + 2) % 3];
    weight[k] = (p[u] - at[u]) * (q[v] - at[v]) - (p[v] - at[v]) * (q[u] - at[u]);
    sum += weight[k];
  }
  if (sum == 0.0) return {};
  double height = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (weight[k] / sum < 0.0) return {};
    height += weight[k] / sum * triangle[k][axis];
  }
  return height;
}

/// The middle of the chord from the centre of a triangle inward, along the axis that is closest to
/// its normal.
std::optional<Eigen::Vector3d> middleOfChord(const TriMesh& mesh, const TriangleTree& tree,
                                             std::uint32_t triangle) {
  const auto [a, b, c] = cornersOf(mesh, triangle);
  const Eigen::Vector3d centre = (a + b + c) / 3.0, normal = (b - a).cross(c - a);
  int axis = 0;
  if (!(normal.cwiseAbs().maxCoeff(&axis) > 0.0)) return {};
  const double inward = normal[axis] > 0.0 ? -1.0 : 1.0;
  Eigen::AlignedBox3d line(centre);
  line.max()[axis] = inward > 0.0 ? std::numeric_limits<double>::infinity() : centre[axis];
  line.min()[axis] = inward < 0.0 ? -std::numeric_limits<double>::infinity() : centre[axis];
  double shortest = std::numeric_limits<double>::infinity();
  tree.forEachMeeting(line, [&](std::uint32_t other) {
    if (other == triangle) return;
    const auto height = heightAt(cornersOf(mesh, other), centre, axis);
    if (!height) return;
    const double length = inward * (*height - centre[axis]);
    if (length > 0.0) shortest = std::min(shortest, length);
  });
  if (!std::isfinite(shortest)) return {};
  Eigen::Vector3d middle = centre;
  middle[axis] += 0.5 * inward * shortest;
  return middle;
}

/// How often the surface winds around the point: the sum of the solid angles over 4 pi.
double windingNumber(const TriMesh& mesh, const Eigen::Vector3d& point) {
  double sum = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    auto [a, b, c] = cornersOf(mesh, t);
    a -= point;
    b -= point;
    c -= point;
    const double na = a.norm(), nb = b.norm(), nc = c.norm();
    const double y = a.dot(b.cross(c));
    const double x = na * nb * nc + a.dot(b) * nc + b.dot(c) * na + c.dot(a) * nb;
    sum += std::copysign(angleDegrees(std::fabs(y), x), y);  // half the solid angle
  }
  return sum / 360.0;
}

}  // namespace

InsidePoint pointInside(const TriMesh& mesh) {
  checkMesh(mesh);
  if (mesh.triangles.empty())
    throw InputError("the surface has no triangles", "mesh", "give a closed surface");
  const TriangleTree tree(mesh);
  const std::vector<std::uint32_t> triangles = largestComponent(mesh);
  const std::size_t step = std::max<std::size_t>(1, triangles.size() / kChords);
  std::vector<InsidePoint> found;
  for (std::size_t i = 0; i < triangles.size(); i += step)
    if (const auto middle = middleOfChord(mesh, tree, triangles[i]))
      found.push_back({*middle, tree.closest(*middle).distance});
  std::stable_sort(found.begin(), found.end(), [](const InsidePoint& a, const InsidePoint& b) {
    return a.depthMm > b.depthMm;
  });
  // The deepest is inside unless the surface passes through itself there.
  constexpr std::size_t kTries = 20;
  for (std::size_t n = 0; n < std::min(found.size(), kTries); ++n)
    if (std::fabs(windingNumber(mesh, found[n].pointLps) - 1.0) < 0.1) return found[n];
  throw NumericError("no point was found inside the surface", "mesh",
                     "check that it is closed, faces outward and does not pass through itself");
}

}  // namespace angiomesh
