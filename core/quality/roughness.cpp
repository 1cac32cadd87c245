// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/roughness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/base/parallel.h"
#include "core/mesh/triangle_shape.h"
#include "core/mesh/triangle_tree.h"
#include "core/quality/local_wall.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr double kReach = 0.5;  // radii; wider, side branches are in most windows of a tree
constexpr double kMostPlaces = 20000.0;
constexpr double kMostVisits = 4e5;  // vertices in all windows together
constexpr std::size_t kLeastVertices = 32, kMostFitted = 128;

/// A value and how much of the surface it stands for.
using Weighted = std::pair<double, double>;

/// The value below which `share` of the weight lies.
double quantile(std::vector<Weighted> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  double sum = 0.0;
  for (const auto& [value, weight] : values) sum += weight;
  double below = 0.0;
  for (const auto& [value, weight] : values) {
    below += weight;
    if (below >= share * sum) return value;
  }
  return values.back().first;
}

/// The angle between two triangles over the edge a - b, degrees, positive where it is a ridge seen
/// from outside.
double ridgeAngle(const Vector3d& a, const Vector3d& b, const Vector3d& left,
                  const Vector3d& right) {
  const Vector3d n1 = (b - a).cross(left - a);
  const Vector3d n2 = (right - a).cross(b - a);
  const Vector3d turn = n1.cross(n2);
  const double angle = angleDegrees(turn.norm(), n1.dot(n2));
  return turn.dot(b - a) < 0.0 ? angle : -angle;
}

class Measure {
 public:
  Measure(const TriMesh& mesh, std::vector<char> counts, const Progress& progress)
      : mesh_(mesh),
        rings_(mesh, counts),
        tree_(mesh, progress.sub(0.0, 0.2)),
        areas_(mesh.points.size(), 0.0) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (!counts.empty() && counts[t] == 0) continue;
      const auto& [a, b, c] = mesh.triangles[t];
      const double area =
          0.5 * (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm();
      for (const std::uint32_t v : mesh.triangles[t]) areas_[v] += area / 3.0;
      area_ += area;
    }
  }

  void measure(const Progress& progress) {
    choosePlaces(progress.sub(0.0, 0.2));
    measured_.assign(places_.size(), {});
    const double reachWithout = std::sqrt(area_ / (4.0 * std::numbers::pi));
    parallelFor(0, measured_.size(), 256, [&](std::size_t first, std::size_t last) {
      progress.check();
      std::vector<char> marks(mesh_.points.size(), 0);
      std::vector<std::uint32_t> found;
      for (std::size_t n = first; n < last; ++n) {
        const double radius = std::isfinite(radii_[n]) ? std::min(radii_[n], mostRadius_)
                              : mostRadius_ > 0.0      ? mostRadius_
                                                       : reachWithout;
        measureAt(places_[n], radius, marks, found, measured_[n]);
      }
    });
    progress.report(1.0);
  }

  [[nodiscard]] std::optional<Roughness> figures() const {
    std::vector<Weighted> spreads, angles;
    for (std::size_t n = 0; n < measured_.size(); ++n) {
      if (measured_[n].spread < 0.0) continue;
      const double weight = areas_[places_[n]];
      spreads.emplace_back(measured_[n].spread, weight);
      for (const double angle : measured_[n].angles)
        angles.emplace_back(angle, weight / static_cast<double>(measured_[n].angles.size()));
    }
    if (spreads.empty()) return std::nullopt;
    return Roughness{quantile(spreads, 0.5), quantile(spreads, 0.95), quantile(angles, 0.5),
                     spreads.size()};
  }

  /// Of each vertex; not a number where no place is near by edges.
  [[nodiscard]] std::vector<float> spreads() const {
    std::vector<float> spread(mesh_.points.size(), std::numeric_limits<float>::quiet_NaN());
    std::vector<std::uint32_t> reached;
    for (std::size_t n = 0; n < measured_.size(); ++n) {
      if (measured_[n].spread < 0.0) continue;
      spread[places_[n]] = static_cast<float>(measured_[n].spread);
      reached.push_back(places_[n]);
    }
    for (std::size_t n = 0; n < reached.size(); ++n)
      for (const std::uint32_t t : rings_.trianglesAt(reached[n]))
        for (const std::uint32_t other : mesh_.triangles[t]) {
          if (!std::isnan(spread[other])) continue;
          spread[other] = spread[reached[n]];
          reached.push_back(other);
        }
    return spread;
  }

 private:
  struct Place {
    double spread = -1.0;
    std::vector<double> angles;
  };

  /// Half the way through the vessel; infinity where there is no other side.
  [[nodiscard]] double radiusAt(std::uint32_t v) const {
    const Vector3d inwards = -rings_.normalAt(v);
    if (inwards.isZero()) return std::numeric_limits<double>::infinity();
    const double edge = std::sqrt(areas_[v]);
    return 0.5 * tree_.firstExit(mesh_.points[v], inwards, 1e-3 * edge);
  }

  void choosePlaces(const Progress& progress) {
    std::vector<std::uint32_t> used;
    for (std::uint32_t v = 0; v < areas_.size(); ++v)
      if (areas_[v] > 0.0) used.push_back(v);
    const auto count = static_cast<double>(used.size());
    auto every = static_cast<std::size_t>(std::ceil(std::max(1.0, count / kMostPlaces)));
    for (std::size_t n = 0; n < used.size(); n += every) places_.push_back(used[n]);
    radii_.resize(places_.size());
    parallelForEach(places_.size(), 512, progress,
                    [&](std::size_t n) { radii_[n] = radiusAt(places_[n]); });
    std::vector<Weighted> known;
    for (std::size_t n = 0; n < places_.size(); ++n)
      if (std::isfinite(radii_[n])) known.emplace_back(radii_[n], areas_[places_[n]]);
    // Against the normal of a branching the way through goes along a vessel.
    mostRadius_ = 2.0 * quantile(known, 0.75);
    double visits = 0.0;
    for (std::size_t n = 0; n < places_.size(); ++n) {
      const double radius = std::isfinite(radii_[n]) ? std::min(radii_[n], mostRadius_) : 0.0;
      const double reach = kReach * radius;
      visits += kLeastVertices + std::numbers::pi * reach * reach * count / std::max(area_, 1e-300);
    }
    every = static_cast<std::size_t>(std::ceil(std::max(1.0, visits / kMostVisits)));
    std::size_t kept = 0;
    for (std::size_t n = 0; n < places_.size(); n += every, ++kept) {
      places_[kept] = places_[n];
      radii_[kept] = radii_[n];
    }
    places_.resize(kept);
    radii_.resize(kept);
  }

  void measureAt(std::uint32_t v, double radius, std::vector<char>& marks,
                 std::vector<std::uint32_t>& found, Place& place) const {
    rings_.around(v, kReach * radius, kLeastVertices, 2, marks, found);
    if (found.size() > kMostFitted) {  // ring by ring, so every n-th of them covers the window
      const std::size_t every = (found.size() + kMostFitted - 1) / kMostFitted;
      std::size_t kept = 0;
      for (std::size_t n = 0; n < found.size(); n += every) found[kept++] = found[n];
      found.resize(kept);
    }
    const auto fitted = LocalWall::fit(mesh_, found, rings_.normalAt(v), false);
    if (!fitted) return;
    place.spread = fitted->spreadMm();
    const auto triangles = rings_.trianglesAt(v);
    for (const std::uint32_t left : triangles)
      for (const std::uint32_t right : triangles) {
        const std::array<std::uint32_t, 2> a = othersOf(left, v), b = othersOf(right, v);
        if (a[0] != b[1]) continue;  // the edge v - a[0] has `left` on its left
        const std::array<Vector3d, 4> corners{mesh_.points[v], mesh_.points[a[0]],
                                              mesh_.points[a[1]], mesh_.points[b[0]]};
        std::array<Vector3d, 4> moved;
        for (std::size_t i = 0; i < 4; ++i) moved[i] = fitted->foot(corners[i]);
        place.angles.push_back(
            std::fabs(ridgeAngle(corners[0], corners[1], corners[2], corners[3]) -
                      ridgeAngle(moved[0], moved[1], moved[2], moved[3])));
      }
  }

  /// The corners after v, in the triangle's order.
  [[nodiscard]] std::array<std::uint32_t, 2> othersOf(std::uint32_t triangle,
                                                      std::uint32_t v) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    if (a == v) return {b, c};
    if (b == v) return {c, a};
    return {a, b};
  }

  const TriMesh& mesh_;
  MeshRings rings_;
  TriangleTree tree_;
  std::vector<double> areas_;  ///< of each vertex: a third of its triangles'
  double area_ = 0.0;
  std::vector<std::uint32_t> places_;
  std::vector<double> radii_;
  std::vector<Place> measured_;  ///< at places_
  double mostRadius_ = 0.0;
};

/// Which triangles count, see measureRoughness(); empty: all.
std::vector<char> counted(const TriMesh& mesh, const std::vector<char>& wall) {
  std::vector<char> counts = wall;
  if (counts.empty() && !mesh.patch.empty())
    for (const std::uint16_t patch : mesh.patch) counts.push_back(patch == 0 ? 1 : 0);
  return counts;
}

}  // namespace

std::optional<Roughness> measureRoughness(const TriMesh& mesh, const std::vector<char>& wall,
                                          const Progress& progress) {
  checkMesh(mesh);
  if (mesh.triangles.empty()) return std::nullopt;
  Measure measure(mesh, counted(mesh, wall), progress.sub(0.0, 0.3));
  measure.measure(progress.sub(0.3, 1.0));
  return measure.figures();
}

std::vector<float> vertexSpreads(const TriMesh& mesh, const Progress& progress) {
  checkMesh(mesh);
  if (mesh.triangles.empty()) return {};
  Measure measure(mesh, counted(mesh, {}), progress.sub(0.0, 0.3));
  measure.measure(progress.sub(0.3, 1.0));
  return measure.spreads();
}

}  // namespace angiomesh
