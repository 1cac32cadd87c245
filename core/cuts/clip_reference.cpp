// SPDX-License-Identifier: BSD-3-Clause
#include "core/cuts/clip_reference.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/error.h"
#include "core/contour/reference_surface.h"
#include "core/mesh/mesh_edges.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;
using Corners = std::array<std::uint32_t, 3>;

/// Vertices so near a section's plane are moved into it: they would leave slivers.
constexpr double kSnapVoxels = 0.08;
/// How far the reference's outline may be from the section's, in the mean and at most.
constexpr double kMeanOffVoxels = 0.6, kMostOffVoxels = 2.0;

class Clipper {
 public:
  Clipper(PatchMesh& mesh, const CutAway& away, double voxelMm)
      : mesh_(mesh),
        away_(away),
        voxel_(voxelMm),
        side_(mesh.mesh.triangles.size(), 0),
        cutOf_(mesh.mesh.triangles.size(), 0) {}

  void cut(std::size_t number) {
    number_ = number;
    section_ = &away_.sections[number];
    const std::vector<std::uint32_t> group = groupOf(passingTriangles());
    checkGroup(group, away_.nameOf(number));
    divide(group);
  }

  // That cut() could cut the mesh at the section.
  void check(const Section& section, const std::string& name) {
    section_ = &section;
    checkGroup(groupOf(passingTriangles()), name);
  }

  // Drops the parts beyond the sections.
  void drop() {
    DisjointSets sets(mesh_.mesh.triangles.size());
    const std::vector<EdgeSide> sides = sortedEdgeSides(mesh_.mesh);
    for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
      if (edgeRunEnd(sides, i) != i + 2) continue;
      const std::uint32_t a = sides[i].triangle, b = sides[i + 1].triangle;
      if (!parted(sides[i], a, b)) sets.join(a, b);
    }
    const std::vector<char> goes = partsThatGo(sets);
    mesh_ = selectTriangles(mesh_, [&](std::uint32_t t) { return goes[sets.find(t)] == 0; });
  }

 private:
  void measureHeights() {
    height_.assign(mesh_.mesh.points.size(), std::numeric_limits<double>::infinity());
    const double reach = section_->radiusMm + 3.0 * voxel_;
    for (std::size_t v = 0; v < height_.size(); ++v) {
      const Vector3d& p = mesh_.mesh.points[v];
      if ((p - section_->centreLps).norm() < reach) height_[v] = section_->height(p);
    }
  }

  [[nodiscard]] int sideOf(std::uint32_t v) const {
    return height_[v] > kSnapVoxels * voxel_ ? 1 : height_[v] < -kSnapVoxels * voxel_ ? -1 : 0;
  }

  std::vector<std::uint32_t> passingTriangles() {
    measureHeights();
    std::vector<std::uint32_t> passing;
    for (std::uint32_t t = 0; t < mesh_.mesh.triangles.size(); ++t) {
      const Corners& c = mesh_.mesh.triangles[t];
      bool near = mesh_.patch[t] == 0;
      for (const std::uint32_t v : c) near = near && std::isfinite(height_[v]);
      if (!near) continue;
      const int a = sideOf(c[0]), b = sideOf(c[1]), d = sideOf(c[2]);
      if (std::min({a, b, d}) <= 0 && std::max({a, b, d}) >= 0) passing.push_back(t);
    }
    return passing;
  }

  // Of the strips of triangles that pass the plane, those along the section's outline; none where
  // the plane passes them in other loops than the section has, as at a neck too thin for the mesh.
  [[nodiscard]] std::vector<std::uint32_t> groupOf(
      const std::vector<std::uint32_t>& passing) const {
    TriMesh strip;
    strip.points.resize(mesh_.mesh.points.size());
    for (const std::uint32_t t : passing) strip.triangles.push_back(mesh_.mesh.triangles[t]);
    const MeshComponents parts = meshComponents(strip);
    struct Off {
      double sum = 0.0, most = 0.0;
      std::size_t count = 0;
      bool passes = false;
    };
    std::vector<Off> off(parts.count);
    for (std::size_t i = 0; i < passing.size(); ++i) {
      Off& o = off[parts.label[i]];
      forEachCrossing(passing[i], [&](const Vector3d& p) {
        const double d = fromOutline(p);
        o.sum += d;
        o.most = std::max(o.most, d);
        ++o.count;
      });
      const Corners& c = mesh_.mesh.triangles[passing[i]];
      const int low = std::min({sideOf(c[0]), sideOf(c[1]), sideOf(c[2])});
      const int high = std::max({sideOf(c[0]), sideOf(c[1]), sideOf(c[2])});
      o.passes = o.passes || low * high < 0 || (low < 0 && high == 0);
    }
    const auto along = [&](const Off& o) {
      return o.passes && o.count > 2 &&
             o.sum < kMeanOffVoxels * voxel_ * static_cast<double>(o.count) &&
             o.most < kMostOffVoxels * voxel_;
    };
    std::vector<std::uint32_t> group;
    for (std::size_t i = 0; i < passing.size(); ++i)
      if (along(off[parts.label[i]])) group.push_back(passing[i]);
    if (loopsOf(group) != section_->loops.size()) group.clear();
    return group;
  }

  // In how many loops the plane passes the triangles; 0 where they are not closed or touch.
  [[nodiscard]] std::size_t loopsOf(const std::vector<std::uint32_t>& group) const {
    using Node = std::pair<std::uint32_t, std::uint32_t>;  // a side, or a corner twice
    std::map<Node, std::uint32_t> nodes;
    std::vector<std::array<std::uint32_t, 2>> pieces;
    std::map<Node, int> inPlane;  // sides in the plane: their triangles below less those not below
    const auto nodeOf = [&](std::uint32_t v, std::uint32_t w) {
      return nodes.try_emplace(std::minmax(v, w), static_cast<std::uint32_t>(nodes.size()))
          .first->second;
    };
    for (const std::uint32_t t : group) {
      const Corners& c = mesh_.mesh.triangles[t];
      std::vector<std::uint32_t> ends;
      const bool below = std::any_of(c.begin(), c.end(), [&](auto v) { return sideOf(v) < 0; });
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = c[k], w = c[(k + 1) % 3], opposite = c[(k + 2) % 3];
        if (sideOf(v) == 0 && sideOf(w) == 0) inPlane[std::minmax(v, w)] += below ? 1 : -1;
        if (sideOf(v) * sideOf(w) >= 0) continue;
        ends.push_back(nodeOf(v, w));
        if (sideOf(opposite) == 0) ends.push_back(nodeOf(opposite, opposite));
      }
      if (ends.size() == 2) pieces.push_back({ends[0], ends[1]});
    }
    for (const auto& [side, balance] : inPlane)
      if (balance == 0)
        pieces.push_back({nodeOf(side.first, side.first), nodeOf(side.second, side.second)});
    std::vector<int> degree(nodes.size(), 0);
    DisjointSets loops(nodes.size());
    for (const auto& [a, b] : pieces) {
      ++degree[a];
      ++degree[b];
      loops.join(a, b);
    }
    std::size_t count = 0;
    for (std::uint32_t n = 0; n < degree.size(); ++n) {
      if (degree[n] != 2) return 0;
      if (loops.find(n) == n) ++count;
    }
    return count;
  }

  // Where the plane passes a triangle's sides and corners.
  template <class Visit>
  void forEachCrossing(std::uint32_t t, Visit visit) const {
    const Corners& c = mesh_.mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = c[k], w = c[(k + 1) % 3];
      if (sideOf(v) == 0) visit(mesh_.mesh.points[v]);
      if (sideOf(v) * sideOf(w) < 0) visit(crossing(v, w));
    }
  }

  [[nodiscard]] Vector3d crossing(std::uint32_t v, std::uint32_t w) const {
    const Vector3d &p = mesh_.mesh.points[v], &q = mesh_.mesh.points[w];
    return p + height_[v] / (height_[v] - height_[w]) * (q - p);
  }

  [[nodiscard]] double fromOutline(const Vector3d& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::vector<Vector3d>& loop : section_->loops)
      for (const Vector3d& q : loop) least = std::min(least, (p - q).squaredNorm());
    return std::sqrt(least);
  }

  // Points of the border and of other cuts cannot be moved into the section's plane.
  void checkGroup(const std::vector<std::uint32_t>& group, const std::string& name) const {
    if (group.empty())
      throw InputError(name +
                           " lies where the vessel is thinner than a voxel, or all but touches "
                           "another",
                       "surface cuts", "move the cut along the vessel");
    for (const std::uint32_t t : group)
      for (const std::uint32_t v : mesh_.mesh.triangles[t])
        if (sideOf(v) == 0 && mesh_.place[v].planes() > 0)
          throw InputError(name + " touches the border or another cut", "surface cuts",
                           "move it by a voxel or more");
  }

  void divide(const std::vector<std::uint32_t>& group) {
    const auto cut = static_cast<std::uint16_t>(number_ + 1);
    for (const std::uint32_t t : group)
      for (const std::uint32_t v : mesh_.mesh.triangles[t]) {
        if (sideOf(v) != 0) continue;
        mesh_.place[v].cut = cut;
        Vector3d& p = mesh_.mesh.points[v];
        p -= section_->height(p) * section_->plane.normalLps;
      }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> made;
    const auto between = [&](std::uint32_t v, std::uint32_t w) {
      const auto [found, fresh] = made.try_emplace(std::minmax(v, w), 0U);
      if (fresh) {
        found->second = static_cast<std::uint32_t>(mesh_.mesh.points.size());
        Vector3d p = crossing(std::min(v, w), std::max(v, w));
        p -= section_->height(p) * section_->plane.normalLps;
        mesh_.mesh.points.push_back(p);
        mesh_.place.push_back({0, true, cut});
        height_.push_back(0.0);
      }
      return found->second;
    };
    for (const std::uint32_t t : group) divideTriangle(t, cut, between);
  }

  template <class Between>
  void divideTriangle(std::uint32_t t, std::uint16_t cut, const Between& between) {
    Corners c = mesh_.mesh.triangles[t];
    const std::array<int, 3> s{sideOf(c[0]), sideOf(c[1]), sideOf(c[2])};
    const int low = std::min({s[0], s[1], s[2]}), high = std::max({s[0], s[1], s[2]});
    cutOf_[t] = cut;
    if (low == 0 || high == 0) {
      // One that lies in the plane goes.
      side_[t] = static_cast<signed char>(low < 0 ? -1 : 1);
      return;
    }
    std::size_t lone = 3, on = 3;  // the corner alone on its side, a corner in the plane
    for (std::size_t k = 0; k < 3; ++k) {
      if (s[k] == 0) on = k;
      if (s[k] != 0 && s[k] != s[(k + 1) % 3] && s[k] != s[(k + 2) % 3]) lone = k;
    }
    if (on < 3) {
      const std::uint32_t v = c[on], a = c[(on + 1) % 3], b = c[(on + 2) % 3], m = between(a, b);
      set(t, {v, a, m}, s[(on + 1) % 3], cut);
      add(t, {v, m, b}, s[(on + 2) % 3], cut);
      return;
    }
    const std::uint32_t v = c[lone], a = c[(lone + 1) % 3], b = c[(lone + 2) % 3];
    const std::uint32_t ma = between(v, a), mb = between(v, b);
    set(t, {v, ma, mb}, s[lone], cut);
    add(t, {ma, a, b}, -s[lone], cut);
    add(t, {ma, b, mb}, -s[lone], cut);
  }

  void set(std::uint32_t t, const Corners& corners, int side, std::uint16_t cut) {
    mesh_.mesh.triangles[t] = corners;
    side_[t] = static_cast<signed char>(side);
    cutOf_[t] = cut;
  }

  void add(std::uint32_t like, const Corners& corners, int side, std::uint16_t cut) {
    mesh_.mesh.triangles.push_back(corners);
    mesh_.patch.push_back(mesh_.patch[like]);
    mesh_.origin.push_back(mesh_.origin[like]);
    side_.push_back(static_cast<signed char>(side));
    cutOf_.push_back(cut);
  }

  // An edge of a section's outline between the two sides.
  [[nodiscard]] bool parted(const EdgeSide& edge, std::uint32_t a, std::uint32_t b) const {
    const std::uint16_t cut = mesh_.place[edge.low].cut;
    return cut != 0 && cut == mesh_.place[edge.high].cut && cutOf_[a] == cut && cutOf_[b] == cut &&
           side_[a] != side_[b];
  }

  // Per triangle that stands for a part: whether it lies beyond a section, or on voxels taken.
  std::vector<char> partsThatGo(DisjointSets& sets) const {
    const std::size_t n = mesh_.mesh.triangles.size();
    std::vector<std::uint16_t> nearOf(n, 0), farOf(n, 0);
    std::vector<std::size_t> taken(n, 0), all(n, 0);
    for (std::uint32_t t = 0; t < n; ++t) {
      const std::uint32_t part = sets.find(t);
      if (cutOf_[t] != 0) (side_[t] < 0 ? nearOf : farOf)[part] = cutOf_[t];
      if (mesh_.patch[t] != 0) continue;
      ++all[part];
      const Corners& c = mesh_.mesh.triangles[t];
      const Vector3d middle =
          (mesh_.mesh.points[c[0]] + mesh_.mesh.points[c[1]] + mesh_.mesh.points[c[2]]) / 3.0;
      if (away_.takenAt(middle)) ++taken[part];
    }
    std::vector<char> goes(n, 0);
    for (std::uint32_t t = 0; t < n; ++t) {
      if (sets.find(t) != t) continue;
      if (nearOf[t] != 0 && farOf[t] != 0)
        throw InputError(
            away_.nameOf(nearOf[t] - 1U) + " ends no vessel: its two sides are connected elsewhere",
            "surface cuts", "cut the other way round the ring too, or move it");
      goes[t] = static_cast<char>(farOf[t] != 0 || (nearOf[t] == 0 && 2 * taken[t] > all[t]));
    }
    return goes;
  }

  PatchMesh& mesh_;
  const CutAway& away_;
  double voxel_;
  std::size_t number_ = 0;
  const Section* section_ = nullptr;
  std::vector<double> height_;        ///< per vertex over the section's plane; infinite far away
  std::vector<signed char> side_;     ///< per triangle at a section: -1 inside, 1 beyond
  std::vector<std::uint16_t> cutOf_;  ///< per triangle: 1 + the cut that it is at, 0 elsewhere
};

}  // namespace

void checkSection(const SplineField& field, const Section& section, const std::string& name) {
  const Geometry& g = field.geometry();
  const auto [first, last] = section.voxelsAround(g, 5.0 * g.voxelMm());
  const GridPart part{first, last, 1};
  PatchMesh local = referenceSurface(sampleField(field, part), EndPlanes(g), SurfaceBorder::Open);
  const CutAway none;
  Clipper(local, none, g.voxelMm()).check(section, name);
}

void clipReference(PatchMesh& reference, const CutAway& away, double voxelMm,
                   const Progress& progress) {
  if (away.empty()) return;
  Clipper clipper(reference, away, voxelMm);
  for (std::size_t n = 0; n < away.sections.size(); ++n) {
    progress.check();
    clipper.cut(n);
  }
  clipper.drop();
}

CutAway checkedCutAway(const SplineField& field, const Volume<float>& phi,
                       const std::vector<CutPlane>& cuts, const std::vector<std::string>& names,
                       const Progress& progress) {
  CutAway named;
  named.names = names;
  for (std::size_t n = 0; n < cuts.size(); ++n)
    checkSection(field, sectionOf(field, cuts[n], named.nameOf(n)), named.nameOf(n));
  return cutAway(field, phi, cuts, names, progress);
}

}  // namespace angiomesh
