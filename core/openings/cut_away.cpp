// SPDX-License-Identifier: BSD-3-Clause
#include "core/openings/cut_away.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "core/base/error.h"
#include "core/distance/redistance.h"
#include "core/image/voxels.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr double kSlabVoxels = 2.0;
constexpr int kThinVesselCells = 3;
/// How far beside a section's rim voxels of the same wall may be joined.
constexpr double kBesideVoxels = 1.0;
/// Rims closer than this would leave no room for triangles between them.
constexpr double kLeastGapVoxels = 1.5;

/// Calls visit(index) for the voxels around a section, as far as `mm` from its rim.
template <class Visit>
void forEachAround(const Geometry& g, const Section& section, double mm, Visit visit) {
  const auto [low, high] = section.voxelsAround(g, mm);
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i) visit(Index3{i, j, k});
}

class Cutter {
 public:
  Cutter(const SplineField& field, const Volume<float>& phi, std::vector<std::string> names,
         const Progress& progress)
      : field_(field), phi_(phi), grid_(phi.geometry), progress_(progress) {
    away_.names = std::move(names);
  }

  CutAway run(const std::vector<CutPlane>& cuts) {
    for (const CutPlane& cut : cuts) {
      away_.sections.push_back(sectionOf(field_, cut, away_.nameOf(away_.sections.size())));
    }
    if (away_.sections.empty()) return std::move(away_);
    checkApart();
    away_.voxels = Volume<std::uint8_t>(grid_);
    for (std::size_t i = 0; i < phi_.voxels.size(); ++i)
      away_.voxels.voxels[i] = inside(i) ? CutAway::kLeft : CutAway::kOutside;
    visited_.assign(phi_.voxels.size(), 0);
    for (std::size_t n = 0; n < away_.sections.size(); ++n) findLinks(n);
    for (std::size_t n = 0; n < away_.sections.size(); ++n) flood(n);
    for (std::uint8_t& label : away_.voxels.voxels)
      label = static_cast<std::uint8_t>(label & ~kLinked);
    return std::move(away_);
  }

 private:
  static constexpr std::uint8_t kLinked = 4;

  // Where a section parts two voxels.
  struct Link {
    std::size_t near, far;
  };
  struct Way : Link {
    bool joined;
  };

  [[nodiscard]] std::string nameOf(std::size_t n) const { return away_.nameOf(n); }

  [[nodiscard]] bool inside(std::size_t voxel) const { return phi_.voxels[voxel] < 0.0F; }
  [[nodiscard]] std::size_t offset(const Index3& p) const { return grid_.offset(p[0], p[1], p[2]); }

  void checkApart() const {
    const double least = kLeastGapVoxels * grid_.voxelMm();
    for (std::size_t m = 0; m < away_.sections.size(); ++m)
      for (std::size_t n = m + 1; n < away_.sections.size(); ++n) {
        const Section &a = away_.sections[m], &b = away_.sections[n];
        if ((a.centreLps - b.centreLps).norm() > a.radiusMm + b.radiusMm + least) continue;
        if (rimsApart(a, b, least)) continue;
        throw InputError(nameOf(m) + " and " + nameOf(n) + " touch", "surface cuts",
                         "move them apart");
      }
  }

  // Sections that pass through each other do so up to the wall, where their rims meet.
  static bool rimsApart(const Section& a, const Section& b, double least) {
    for (const auto& one : a.loops)
      for (const Vector3d& p : one)
        for (const auto& other : b.loops)
          for (const Vector3d& q : other)
            if ((p - q).squaredNorm() < least * least) return false;
    return true;
  }

  // Voxels inside phi are joined along the axes, and across where phi < 0 half-way, as for a vessel
  // one voxel wide that runs diagonally.
  [[nodiscard]] bool joined(const Index3& p, const Index3& step) const {
    if (std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]) == 1) return true;
    return field_.atIndex({p[0] + 0.5 * step[0], p[1] + 0.5 * step[1], p[2] + 0.5 * step[2]})
               .value < 0.0;
  }

  // Where the way between two voxels on different sides of the plane passes it.
  static Vector3d crossing(const Section& section, const Vector3d& p, const Vector3d& q) {
    const double hp = section.height(p), hq = section.height(q);
    return p + hp / (hp - hq) * (q - p);
  }

  // The ways between voxels that the section parts: those through it, and those beside its rim that
  // run along them. Neighbours inside phi count as joined wherever phi passes 0 between them, as on
  // a rough wall, and the section's outline is that of phi: without the latter the two sides would
  // be joined by such a way around the rim.
  void findLinks(std::size_t n) {
    const Section& section = away_.sections[n];
    links_.emplace_back();
    std::vector<Way> beside;
    std::unordered_set<std::size_t> near, far;  // ends of those through the section
    forEachAround(grid_, section, 2.0 * grid_.spacing.maxCoeff(), [&](const Index3& p) {
      const std::size_t from = offset(p);
      const Vector3d here = voxelCentre(grid_, p);
      if (!inside(from) || section.height(here) > 0.0) return;
      forNeighbours(grid_, from, [&](std::size_t number, std::size_t to) {
        if (!inside(to)) return;
        const Vector3d there = voxelCentre(grid_, to);
        if (section.height(there) <= 0.0) return;
        const Vector3d at = crossing(section, here, there);
        const Way way{from, to, joined(p, kSteps27[number])};
        if (section.covers(at)) {
          part(n, way);
          near.insert(way.near);
          far.insert(way.far);
        } else if (way.joined && section.covers(at, kBesideVoxels * grid_.voxelMm())) {
          beside.push_back(way);
        }
      });
    });
    for (const Way& way : beside)
      if (touches(way.near, near) || touches(way.far, far)) part(n, way);
  }

  void part(std::size_t n, const Way& way) {
    away_.voxels.voxels[way.near] |= kLinked;
    away_.voxels.voxels[way.far] |= kLinked;
    parted_.insert(keyOf(way.near, way.far));
    if (way.joined) links_[n].push_back({way.near, way.far});
  }

  // Whether the voxel, or one that it is joined with, is among them.
  [[nodiscard]] bool touches(std::size_t voxel, const std::unordered_set<std::size_t>& ends) const {
    if (ends.count(voxel) != 0) return true;
    const Index3 p = grid_.indexOf(voxel);
    bool found = false;
    forNeighbours(grid_, voxel, [&](std::size_t number, std::size_t next) {
      found = found || (ends.count(next) != 0 && joined(p, kSteps27[number]));
    });
    return found;
  }

  [[nodiscard]] std::uint64_t keyOf(std::size_t a, std::size_t b) const {
    return std::min(a, b) * phi_.voxels.size() + std::max(a, b);
  }

  void flood(std::size_t n) {
    std::vector<std::size_t> found;
    const auto take = [&](std::size_t voxel) {
      if (visited_[voxel] != 0) return;
      visited_[voxel] = 1;
      found.push_back(voxel);
    };
    for (const Link& link : links_[n]) take(link.far);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (i % 4096 == 0) progress_.check();
      const Index3 p = grid_.indexOf(found[i]);
      const bool linked = (away_.voxels.voxels[found[i]] & kLinked) != 0;
      forNeighbours(grid_, found[i], [&, from = found[i]](std::size_t number, std::size_t next) {
        if (!inside(next) || visited_[next] != 0) return;
        if (linked && parted_.count(keyOf(from, next)) != 0) return;
        if (joined(p, kSteps27[number])) take(next);
      });
    }
    checkFlood(n);
    for (const std::size_t voxel : found) {
      visited_[voxel] = 0;
      std::uint8_t& label = away_.voxels.voxels[voxel];
      label = static_cast<std::uint8_t>(CutAway::kTaken | (label & kLinked));
    }
    away_.taken.push_back(found.size());
  }

  void checkFlood(std::size_t n) const {
    for (std::size_t m = 0; m < links_.size(); ++m)
      for (const Link& link : links_[m]) {
        if (visited_[link.near] == 0) continue;
        if (m == n)
          throw InputError(nameOf(n) + " ends no vessel: its two sides are connected elsewhere",
                           "surface cuts", "cut the other way round the ring too, or move it");
        throw InputError(nameOf(m) + " lies in what " + nameOf(n) + " takes away", "surface cuts",
                         "leave one of them out, or turn a normal round");
      }
  }

  const SplineField& field_;
  const Volume<float>& phi_;
  const Geometry& grid_;
  const Progress& progress_;
  CutAway away_;
  std::vector<std::vector<Link>> links_;
  std::unordered_set<std::uint64_t> parted_;
  std::vector<std::uint8_t> visited_;
};

}  // namespace

std::vector<CutPlane> CutAway::planes() const {
  std::vector<CutPlane> all;
  for (const Section& section : sections) all.push_back(section.plane);
  return all;
}

std::string CutAway::nameOf(std::size_t cut) const {
  const bool named = cut < names.size() && !names[cut].empty();
  return "the cut " + (named ? "'" + names[cut] + "'" : std::to_string(cut + 1));
}

bool CutAway::takenAt(const Vector3d& pointLps) const {
  if (empty()) return false;
  const Geometry& g = voxels.geometry;
  const Vector3d index = g.toIndex(pointLps);
  Index3 cell{};
  for (std::size_t a = 0; a < 3; ++a)
    cell[a] = std::clamp(static_cast<int>(std::floor(index[static_cast<Eigen::Index>(a)])), 0,
                         std::max(g.size[a] - 2, 0));
  // The corners of the cell; a thin vessel may run through cells of which none is inside.
  for (int around = 0; around <= kThinVesselCells; ++around) {
    double least = std::numeric_limits<double>::max();
    bool is = false;
    for (int k = cell[2] - around; k <= cell[2] + 1 + around; ++k)
      for (int j = cell[1] - around; j <= cell[1] + 1 + around; ++j)
        for (int i = cell[0] - around; i <= cell[0] + 1 + around; ++i) {
          if (!g.contains(i, j, k) || voxels.at(i, j, k) == kOutside) continue;
          const double d = (Vector3d(i, j, k) - index).cwiseProduct(g.spacing).squaredNorm();
          if (d >= least) continue;
          least = d;
          is = voxels.at(i, j, k) == kTaken;
        }
    if (least < std::numeric_limits<double>::max()) return is;
  }
  return false;
}

bool CutAway::beyond(const Vector3d& pointLps) const {
  const double voxel = voxels.geometry.voxelMm();
  for (const Section& section : sections) {
    const double height = section.height(pointLps);
    if (height <= 1e-9 * voxel || height > kSlabVoxels * voxel) continue;
    const Vector3d foot = pointLps - height * section.plane.normalLps;
    if ((foot - section.centreLps).norm() < section.radiusMm + kSlabVoxels * voxel) return true;
  }
  return takenAt(pointLps);
}

CutAway cutAway(const SplineField& field, const Volume<float>& phi,
                const std::vector<CutPlane>& cuts, const std::vector<std::string>& names,
                const Progress& progress) {
  return Cutter(field, phi, names, progress).run(cuts);
}

Volume<float> phiWithout(const Volume<float>& phi, const CutAway& away, const Progress& progress) {
  if (away.empty()) return phi;
  const Geometry& g = phi.geometry;
  const double far = 5.0 * g.voxelMm();
  Volume<float> left = phi;
  for (std::size_t i = 0; i < left.voxels.size(); ++i)
    if (away.voxels.voxels[i] == CutAway::kTaken) left.voxels[i] = static_cast<float>(far);
  // Both sides of a section take the distance from it, as far as they are joined to it along lines
  // across the plane.
  for (const Section& section : away.sections)
    forEachAround(g, section, far, [&](const Index3& p) {
      const std::size_t voxel = g.offset(p[0], p[1], p[2]);
      const Vector3d here = voxelCentre(g, p);
      const double height = section.height(here);
      if (std::fabs(height) >= far || phi.voxels[voxel] >= 0.0F) return;
      if (!section.covers(here - height * section.plane.normalLps)) return;
      const int steps =
          std::max(1, static_cast<int>(std::ceil(2.0 * std::fabs(height) / g.voxelMm())));
      for (int n = 1; n < steps; ++n) {
        const Vector3d between = here - height * n / steps * section.plane.normalLps;
        if (interpolateLinear(phi, g.toIndex(between)) >= 0.0) return;
      }
      float& value = left.voxels[voxel];
      if (away.voxels.voxels[voxel] == CutAway::kTaken)
        value = std::min(value, static_cast<float>(std::max(height, 1e-3 * g.voxelMm())));
      else if (height <= 0.0)
        value = std::max(value, static_cast<float>(std::min(height, -1e-3 * g.voxelMm())));
    });
  return redistance(std::move(left), 5.0, progress);
}

}  // namespace angiomesh
