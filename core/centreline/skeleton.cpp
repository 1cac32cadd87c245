// SPDX-License-Identifier: BSD-3-Clause
#include "core/centreline/skeleton.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/base/parallel.h"
#include "core/centreline/branch_line.h"
#include "core/centreline/centre_lines.h"
#include "core/centreline/lumen_probe.h"
#include "core/centreline/skeleton_graph.h"
#include "core/centreline/vessel_at.h"
#include "core/centreline/voxel_set.h"
#include "core/image/voxels.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kSmoothVoxels = 3;

/// A chain with its voxels' places, smoothed, and the distances of the voxels to the wall.
struct Draft {
  Polyline line;
  std::vector<double> wallMm;
  std::array<int, 2> nodes{0, 0};
  std::array<BranchLine::End, 2> ends;

  /// The n-th point from end 0 or 1.
  [[nodiscard]] std::size_t from(std::size_t end, std::size_t n) const {
    return end == 0 ? n : line.size() - 1 - n;
  }
};

struct Part {
  ChainGraph graph;
  int component = 0;
};

std::vector<Draft> draftsOf(const ChainGraph& graph, const CentreLines& lines,
                            const VoxelSet& set) {
  std::vector<Draft> drafts;
  for (const Chain& chain : graph.chains) {
    Draft draft;
    draft.nodes = {chain.from, chain.to};
    for (const std::uint32_t n : chain.voxels) {
      draft.line.push_back(voxelCentre(set.geometry(), set.voxel(n)));
      draft.wallMm.push_back(lines.wallMm(n));
    }
    draft.line = smoothed(smoothed(draft.line, kSmoothVoxels), kSmoothVoxels);
    for (std::size_t end = 0; end < 2; ++end)
      draft.ends[end].kind = graph.nodes[static_cast<std::size_t>(draft.nodes[end])].kind;
    drafts.push_back(std::move(draft));
  }
  return drafts;
}

/// Whether the straight way between two points stays inside the vessel.
bool sees(const LumenProbe& probe, const Vector3d& from, const Vector3d& to) {
  const double length = (to - from).norm();
  if (!probe.isInside(from) || length == 0.0) return length == 0.0;
  return probe.cast(from, (to - from) / length).lengthMm >= length - 1e-3 * probe.voxelMm();
}

/// Points of `draft` from an end on that lie in the balls along another branch of the junction.
std::size_t pointsInside(const Draft& draft, std::size_t end, const Draft& other,
                         std::size_t otherEnd) {
  const double reach = 6.0 * draft.wallMm[draft.from(end, 0)];
  for (std::size_t n = 0; n < draft.line.size(); ++n) {
    const Vector3d& point = draft.line[draft.from(end, n)];
    bool inside = false;
    double gone = 0.0;
    for (std::size_t m = 0; m < other.line.size() && gone < reach && !inside; ++m) {
      const std::size_t at = other.from(otherEnd, m);
      if (m > 0) gone += (other.line[at] - other.line[other.from(otherEnd, m - 1)]).norm();
      inside = (other.line[at] - point).norm() < other.wallMm[at];
    }
    if (!inside) return n;
  }
  return draft.line.size();
}

void findJunctionZones(std::vector<Draft>& drafts) {
  for (std::size_t a = 0; a < drafts.size(); ++a)
    for (std::size_t end = 0; end < 2; ++end) {
      BranchLine::End& here = drafts[a].ends[end];
      if (here.kind != NodeKind::Junction) continue;
      for (std::size_t b = 0; b < drafts.size(); ++b)
        for (std::size_t other = 0; other < 2; ++other) {
          if ((a == b && end == other) || drafts[b].nodes[other] != drafts[a].nodes[end]) continue;
          here.inJunction =
              std::max(here.inJunction, pointsInside(drafts[a], end, drafts[b], other));
        }
    }
}

/// Where the lines of the branches come closest to each other, thick ones counting most: the least
/// sum of squares of the distances to them.
class JunctionPlace {
 public:
  explicit JunctionPlace(const Vector3d& voxel) : voxel_(voxel) {}

  void add(const BranchLine::Entry& entry) {
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - entry.direction * entry.direction.transpose();
    sum_ += entry.radiusMm * across;
    right_ += entry.radiusMm * (across * (entry.point - voxel_));
    weight_ += entry.radiusMm;
    entries_.push_back(entry.point);
  }

  /// At most `reachMm` from the voxel and with a clear view of the branches; the voxel's place
  /// counts the more the less the lines tell.
  [[nodiscard]] Vector3d place(const LumenProbe& probe, double reachMm) const {
    for (const double share : {0.003, 0.03, 0.3}) {
      const Eigen::Matrix3d matrix = sum_ + share * weight_ * Eigen::Matrix3d::Identity();
      const Vector3d shift = matrix.ldlt().solve(right_);
      if (shift.norm() < reachMm && seesAll(probe, voxel_ + shift)) return voxel_ + shift;
    }
    return voxel_;
  }

 private:
  [[nodiscard]] bool seesAll(const LumenProbe& probe, const Vector3d& place) const {
    if ((probe.intoVolume(place) - place).norm() > 1e-6 * probe.voxelMm()) return false;
    return std::all_of(entries_.begin(), entries_.end(),
                       [&](const Vector3d& point) { return sees(probe, place, point); });
  }

  Vector3d voxel_;
  std::vector<Vector3d> entries_;
  Eigen::Matrix3d sum_ = Eigen::Matrix3d::Zero();
  Vector3d right_ = Vector3d::Zero();
  double weight_ = 0.0;
};

/// Adds the branches of one part of the vessels.
void addPart(Skeleton& skeleton, const Part& part, const CentreLines& lines, const VoxelSet& set,
             const LumenProbe& probe, const Progress& progress) {
  std::vector<Draft> drafts = draftsOf(part.graph, lines, set);
  findJunctionZones(drafts);
  std::vector<std::optional<BranchLine>> shaped(drafts.size());
  parallelFor(0, drafts.size(), 1, [&](std::size_t n, std::size_t) {
    progress.check();
    shaped[n].emplace(probe, drafts[n].line, drafts[n].ends);
  });
  std::vector<Vector3d> places;
  for (std::size_t n = 0; n < part.graph.nodes.size(); ++n) {
    const ChainGraph::Node& node = part.graph.nodes[n];
    JunctionPlace junction(voxelCentre(set.geometry(), set.voxel(node.voxel)));
    for (std::size_t b = 0; b < drafts.size(); ++b)
      for (std::size_t end = 0; end < 2; ++end)
        if (drafts[b].nodes[end] == static_cast<int>(n)) junction.add(shaped[b]->entry(end));
    places.push_back(junction.place(probe, 2.5 * lines.wallMm(node.voxel) + 2.0 * probe.voxelMm()));
  }
  std::vector<SkeletonBranch> branches(drafts.size());
  parallelFor(0, drafts.size(), 1, [&](std::size_t n, std::size_t) {
    progress.check();
    const auto& nodes = drafts[n].nodes;
    branches[n] = shaped[n]->finished(
        {places[static_cast<std::size_t>(nodes[0])], places[static_cast<std::size_t>(nodes[1])]});
  });
  const int base = static_cast<int>(skeleton.nodes.size());
  for (const ChainGraph::Node& node : part.graph.nodes)
    skeleton.nodes.push_back({node.kind, Vector3d::Zero(), part.component, 0.0});
  for (std::size_t n = 0; n < branches.size(); ++n) {
    SkeletonBranch& branch = branches[n];
    branch.component = part.component;
    branch.from = base + drafts[n].nodes[0];
    branch.to = base + drafts[n].nodes[1];
    for (const auto& [number, point] : {std::pair{branch.from, &branch.points.front()},
                                        std::pair{branch.to, &branch.points.back()}}) {
      SkeletonNode& node = skeleton.nodes[static_cast<std::size_t>(number)];
      node.pointLps = point->pointLps;
      node.radiusMm = std::max(node.radiusMm, point->radiusMm);
    }
    skeleton.branches.push_back(std::move(branch));
  }
}

}  // namespace

Skeleton skeletonOf(const Volume<float>& phi, const Progress& progress) {
  Skeleton skeleton;
  const Components found = connectedComponents(insideMask(phi));
  const std::size_t count = found.sizes.size();
  const VoxelSet set(found.labels, static_cast<std::int32_t>(count));
  CentreLines lines(phi, set);
  std::vector<Part> parts(count);
  std::vector<std::uint32_t> visited;
  for (std::size_t n = 0; n < set.size(); ++n) {
    const std::int32_t label = found.labels.voxels[set.voxel(n)];
    Part& part = parts[static_cast<std::size_t>(label - 1)];
    if (part.component > 0) continue;
    part.component = label;
    part.graph = chainsOf(lines, set, lines.find(static_cast<std::uint32_t>(n), visited, progress));
    progress.report(0.5 * static_cast<double>(n + 1) / static_cast<double>(set.size()));
  }
  const SplineField field(phi, SplineKind::InterpolatingBspline);
  const LumenProbe probe(field);
  for (std::size_t n = 0; n < count; ++n) {
    addPart(skeleton, parts[n], lines, set, probe, progress);
    progress.report(0.5 + 0.5 * static_cast<double>(n + 1) / static_cast<double>(count));
  }
  return skeleton;
}

std::optional<SkeletonPlace> placeOnSkeleton(const Skeleton& skeleton, const SplineField& phi,
                                             const Vector3d& pointLps) {
  const std::optional<LocalVessel> vessel = vesselAt(phi, pointLps);
  if (!vessel) return std::nullopt;
  const LumenProbe probe(phi);
  struct Candidate {
    double distance;
    SkeletonPlace place;
  };
  std::vector<Candidate> candidates;
  for (std::size_t b = 0; b < skeleton.branches.size(); ++b) {
    const auto& points = skeleton.branches[b].points;
    for (std::size_t n = 0; n < points.size(); ++n)
      candidates.push_back({(points[n].pointLps - vessel->centreLps).squaredNorm(),
                            {static_cast<int>(b), static_cast<int>(n)}});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  for (const Candidate& candidate : candidates) {
    const auto& branch = skeleton.branches[static_cast<std::size_t>(candidate.place.branch)];
    const auto& points = branch.points;
    if (sees(probe, vessel->centreLps,
             points[static_cast<std::size_t>(candidate.place.point)].pointLps))
      return candidate.place;
  }
  return std::nullopt;
}

}  // namespace angiomesh
