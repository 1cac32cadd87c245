// SPDX-License-Identifier: BSD-3-Clause
#include "core/centreline/centre_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace angiomesh {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;
constexpr double kFar = std::numeric_limits<double>::max();

}  // namespace

CentreLines::CentreLines(const Volume<float>& phi, const VoxelSet& set)
    : set_(set),
      voxelMm_(set.geometry().voxelMm()),
      wall_(set.size(), kFar),
      cost_(set.size(), kFar),
      along_(set.size(), 0.0),
      parent_(set.size(), kNone),
      coveredBy_(set.size(), kNone),
      pathOf_(set.size(), kNone) {
  findWallDistances(phi);
}

/// phi tells it near the wall; where phi is clamped it grows on from there by steps.
void CentreLines::findWallDistances(const Volume<float>& phi) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const double known = 4.5 * voxelMm_;
  for (std::size_t n = 0; n < set_.size(); ++n) {
    const double depth = -static_cast<double>(phi.voxels[set_.voxel(n)]);
    if (depth > known) continue;
    wall_[n] = std::max(depth, 0.2 * voxelMm_);
    if (depth > 3.0 * voxelMm_) queue.push({wall_[n], static_cast<std::uint32_t>(n)});
  }
  while (!queue.empty()) {
    const auto [distance, n] = queue.top();
    queue.pop();
    if (distance > wall_[n]) continue;
    set_.forNeighbours(n, [&, from = distance](std::size_t next, double length) {
      if (wall_[next] <= known || from + length >= wall_[next]) return;
      wall_[next] = from + length;
      queue.push({wall_[next], static_cast<std::uint32_t>(next)});
    });
  }
  for (double& distance : wall_) distance = std::min(distance, 1e3 * voxelMm_);
}

/// Cheapest paths from `root` over its part. Returns the voxel whose path is the longest.
std::uint32_t CentreLines::spread(std::uint32_t root, std::vector<std::uint32_t>& visited,
                                  const Progress& progress) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::uint32_t n : visited) cost_[n] = kFar;
  visited.clear();
  cost_[root] = along_[root] = 0.0;
  parent_[root] = kNone;
  queue.push({0.0, root});
  std::uint32_t farthest = root;
  while (!queue.empty()) {
    const auto [cost, n] = queue.top();
    queue.pop();
    if (cost > cost_[n]) continue;
    visited.push_back(n);
    if (visited.size() % 4096 == 0) progress.check();
    if (along_[n] > along_[farthest]) farthest = n;
    set_.forNeighbours(n, [&, from = n, before = cost](std::size_t next, double length) {
      const double d = 0.5 * (wall_[from] + wall_[next]) / voxelMm_;
      const double total = before + length / (d * d);
      if (total >= cost_[next]) return;
      cost_[next] = total;
      along_[next] = along_[from] + length;
      parent_[next] = from;
      queue.push({total, static_cast<std::uint32_t>(next)});
    });
  }
  return farthest;
}

/// Notes that a path joins another at `point`.
void CentreLines::attach(std::uint32_t point) {
  Path& path = paths_[pathOf_[point]];
  const auto at = std::find(path.points.begin(), path.points.end(), point);
  const auto before = static_cast<std::size_t>(at - path.points.begin());
  const std::size_t behind = path.points.size() - 1 - before;
  PathEnd& end = before < behind ? path.front : path.back;
  end.attached =
      end.isAttached ? std::min(end.attached, std::min(before, behind)) : std::min(before, behind);
  end.isAttached = true;
}

void CentreLines::addPath(std::uint32_t tip) {
  Path path;
  std::uint32_t n = tip;
  while (n != kNone && pathOf_[n] == kNone) {
    path.points.push_back(n);
    n = parent_[n];
  }
  const auto number = static_cast<std::uint32_t>(paths_.size());
  if (n != kNone) {
    path.points.push_back(n);
    path.back.joins = true;
    attach(n);
    closeRing(path);
  }
  for (const std::uint32_t point : path.points)
    if (pathOf_[point] == kNone) pathOf_[point] = number;
  paths_.push_back(std::move(path));
  cover(number);
}

/// Where the tip of a new path lies beside what another one covers, far from where it joins, it is
/// no tip: there two ways around a ring meet.
void CentreLines::closeRing(Path& path) {
  const std::uint32_t tip = path.points.front();
  const std::uint32_t joint = path.points.back();
  std::uint32_t other = kNone;
  double nearest = kFar;
  set_.forNeighbours(tip, [&](std::size_t next, double) {
    const std::uint32_t by = coveredBy_[next];
    if (by == kNone) return;
    const double away = (set_.position(by) - set_.position(joint)).norm();
    const double d = (set_.position(by) - set_.position(tip)).norm();
    if (away < reach(by) + reach(joint) || d >= nearest || !straightInside(tip, by)) return;
    nearest = d;
    other = by;
  });
  if (other == kNone) return;
  path.points.insert(path.points.begin(), other);
  path.front.joins = true;
  attach(other);
}

double CentreLines::toFace(std::uint32_t n) const {
  const Index3 p = set_.indexOf(n);
  const Geometry& g = set_.geometry();
  double least = kFar;
  for (std::size_t a = 0; a < 3; ++a)
    least = std::min(
        least, std::min(p[a], g.size[a] - 1 - p[a]) * g.spacing[static_cast<Eigen::Index>(a)]);
  return least;
}

bool CentreLines::isSliced(std::uint32_t n) const {
  return toFace(n) < std::max(wall_[n], 1.5 * voxelMm_) - 0.5 * voxelMm_;
}

/// Where the border slices a vessel lengthwise, one line leads into the opening: whether all of the
/// way from a tip to another path lies in it.
bool CentreLines::inOpening(std::uint32_t tip) const {
  std::uint32_t n = tip;
  while (n != kNone && pathOf_[n] == kNone && isSliced(n)) n = parent_[n];
  return n != kNone && pathOf_[n] != kNone && isSliced(n);
}

bool CentreLines::straightInside(std::uint32_t from, std::uint32_t to) const {
  const Eigen::Vector3d way = set_.position(to) - set_.position(from);
  const int steps = static_cast<int>(2.0 * way.norm() / voxelMm_) + 1;
  for (int n = 1; n < steps; ++n)
    if (!set_.numberAt(set_.position(from) + way * (1.0 * n / steps))) return false;
  return true;
}

void CentreLines::cover(std::uint32_t number) {
  const Eigen::Vector3d& spacing = set_.geometry().spacing;
  for (const std::uint32_t point : paths_[number].points) {
    if (pathOf_[point] != number) continue;
    const Index3 p = set_.indexOf(point);
    const double radius = reach(point);
    const int rk = static_cast<int>(radius / spacing[2]);
    const int rj = static_cast<int>(radius / spacing[1]);
    for (int dk = -rk; dk <= rk; ++dk)
      for (int dj = -rj; dj <= rj; ++dj) {
        const double y = dj * spacing[1], z = dk * spacing[2];
        const double rest = radius * radius - z * z - y * y;
        if (rest < 0.0) continue;
        const int ri = static_cast<int>(std::sqrt(rest) / spacing[0]);
        set_.forRow(p[0] - ri, p[0] + ri, p[1] + dj, p[2] + dk, [&](std::size_t n, int) {
          if (coveredBy_[n] == kNone) coveredBy_[n] = point;
        });
      }
  }
}

/// Length from points[from] straight on, away from the path, to the face of the volume; nothing
/// where the part ends before.
std::optional<double> CentreLines::toBorder(const std::vector<std::uint32_t>& points,
                                            std::size_t from) const {
  const auto span = static_cast<std::size_t>(6.0 + 2.0 * wall_[points[from]] / voxelMm_);
  const std::size_t to = std::min(from + span, points.size());
  const std::size_t middle = (from + to) / 2;
  if (middle == from) return std::nullopt;
  const auto mean = [&](std::size_t first, std::size_t last) -> Eigen::Vector3d {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = first; i < last; ++i) sum += set_.position(points[i]);
    return sum / static_cast<double>(last - first);
  };
  const Eigen::Vector3d direction = (mean(from, middle) - mean(middle, to)).normalized();
  const Eigen::Vector3d here = set_.position(points[from]);
  const Geometry& g = set_.geometry();
  double face = kFar;
  for (int a = 0; a < 3; ++a) {
    if (std::fabs(direction[a]) < 1e-9) continue;
    const double at = (direction[a] > 0.0 ? g.size[a] - 0.5 : -0.5) * g.spacing[a];
    face = std::min(face, (at - here[a]) / direction[a]);
  }
  for (double gone = 0.5 * voxelMm_; gone < face; gone += 0.5 * voxelMm_)
    if (!set_.numberAt(here + gone * direction)) return std::nullopt;
  return face;
}

CentreLines::LineEnd CentreLines::endOf(const std::vector<std::uint32_t>& points,
                                        const PathEnd& end) const {
  LineEnd line;
  if (end.joins) return line;
  const Eigen::Vector3d tip = set_.position(points.front());
  double radius = wall_[points.front()];
  double gone = 0.0;
  // A path out of a ball's end goes along its radius, but for the steps of the grid.
  while (line.at + 1 < points.size() && gone <= 1.15 * radius + 1.5 * voxelMm_) {
    ++line.at;
    gone = (set_.position(points[line.at]) - tip).norm();
    radius = std::max(radius, wall_[points[line.at]]);
  }
  if (end.isAttached && end.attached <= line.at) {
    line.at = end.attached;
  } else if (const auto face = toBorder(points, line.at)) {
    line.kind = LineEnd::Kind::Border;
    line.extraMm = *face;
  } else if (isSliced(points[line.at])) {
    line.kind = LineEnd::Kind::Border;
    line.extraMm = toFace(points[line.at]);
  } else {
    line.kind = LineEnd::Kind::Tip;
    line.extraMm = gone + wall_[points.front()] - radius;
  }
  return line;
}

const std::vector<CentreLines::Path>& CentreLines::find(std::uint32_t start,
                                                        std::vector<std::uint32_t>& visited,
                                                        const Progress& progress) {
  visited.clear();
  const std::uint32_t root = spread(start, visited, progress);
  spread(root, visited, progress);
  std::vector<std::uint32_t> order = visited;
  std::sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
    return along_[a] != along_[b] ? along_[a] > along_[b] : a < b;
  });
  paths_.clear();
  for (const std::uint32_t tip : order) {
    if (coveredBy_[tip] != kNone || inOpening(tip)) continue;
    progress.check();
    addPath(tip);
  }
  return paths_;
}

}  // namespace angiomesh
