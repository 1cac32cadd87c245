// SPDX-License-Identifier: BSD-3-Clause
#include "core/centreline/branch_line.h"

#include <algorithm>
#include <cmath>

namespace angiomesh {
namespace {

using Eigen::Vector3d;

/// Points of a ring that its line needs beyond where it closes.
constexpr std::size_t kWrap = 12;
constexpr std::size_t kSmoothPoints = 2;
constexpr int kCentrePasses = 3;
/// A vessel has left a junction where it is at most so much thicker than farther on.
constexpr double kSettled = 1.06;
/// A line that leaves a junction by more than 45 degrees from the way to its place is not bent.
constexpr double kLeastCosine = 0.7;
/// A section tells a radius where the volume cuts it in at most this share of the directions.
constexpr double kMostCut = 0.3;

/// The line at equal steps of about `stepMm`, its ends kept.
Polyline resampled(const Polyline& line, double stepMm) {
  const double length = lengthOf(line);
  const auto steps =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::floor(length / stepMm + 0.5)));
  Polyline result{line.front()};
  std::size_t at = 1;
  double before = 0.0;
  for (std::size_t n = 1; n < steps; ++n) {
    const double wanted = length * static_cast<double>(n) / static_cast<double>(steps);
    while (at + 1 < line.size() && before + (line[at] - line[at - 1]).norm() < wanted) {
      before += (line[at] - line[at - 1]).norm();
      ++at;
    }
    const Vector3d step = line[at] - line[at - 1];
    const double share = step.norm() > 0.0 ? (wanted - before) / step.norm() : 0.0;
    result.push_back(line[at - 1] + std::min(share, 1.0) * step);
  }
  if (line.size() > 1) result.push_back(line.back());
  return result;
}

}  // namespace

Polyline smoothed(const Polyline& line, std::size_t half) {
  Polyline result = line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::size_t window = std::min({half, i, line.size() - 1 - i});
    Vector3d sum = Vector3d::Zero();
    for (std::size_t j = i - window; j <= i + window; ++j) sum += line[j];
    result[i] = sum / static_cast<double>(2 * window + 1);
  }
  return result;
}

Vector3d tangentAt(const Polyline& line, std::size_t n, std::size_t reach) {
  const std::size_t from = n - std::min(n, reach);
  const std::size_t to = std::min(n + reach, line.size() - 1);
  const Vector3d chord = line[to] - line[from];
  const double length = chord.norm();
  return length > 0.0 ? Vector3d(chord / length) : Vector3d::Zero();
}

double lengthOf(const Polyline& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

BranchLine::BranchLine(const LumenProbe& probe, const Polyline& line,
                       const std::array<End, 2>& ends)
    : probe_(probe), ends_(ends) {
  const std::size_t cut = ends[0].inJunction + ends[1].inJunction;
  isOutside_ = cut < line.size();
  if (isOutside_) {
    line_.assign(line.begin() + static_cast<std::ptrdiff_t>(ends[0].inJunction),
                 line.end() - static_cast<std::ptrdiff_t>(ends[1].inJunction));
    line_ = resampled(line_, probe.voxelMm());
  } else {
    line_ = {line[line.size() / 2]};
  }
  if (!isOutside_) {
    const Vector3d chord = (line.back() - line.front()).normalized();
    const auto section = probe.section(line_.front(), chord);
    radius_ = {section ? section->radiusMm : 0.0};
    return;
  }
  if (ends[0].kind == NodeKind::Ring) wrapRing();
  radius_.assign(line_.size(), 0.0);
  for (int pass = 0; pass < kCentrePasses; ++pass) centre();
  if (ends[0].kind == NodeKind::Ring) unwrapRing();
  for (std::size_t end = 0; end < 2; ++end) {
    leaveJunction(end);
    extend(end);
  }
}

/// Where vessels part, sections are larger than a little farther on: such points go.
void BranchLine::leaveJunction(std::size_t end) {
  if (ends_[end].kind != NodeKind::Junction) return;
  if (end == 1) std::reverse(radius_.begin(), radius_.end());
  const auto least = [&](std::size_t from) {
    const auto span = static_cast<std::size_t>(1.0 + 1.5 * radius_[from] / probe_.voxelMm());
    const auto begin = radius_.begin() + static_cast<std::ptrdiff_t>(from);
    return *std::min_element(
        begin, begin + static_cast<std::ptrdiff_t>(std::min(span, radius_.size() - from)));
  };
  const auto most = static_cast<std::size_t>(2.0 * radius_.front() / probe_.voxelMm());
  std::size_t gone = 0;
  while (gone < most && gone + 2 < radius_.size() && radius_[gone] > kSettled * least(gone)) ++gone;
  // The next ones still lean towards the other vessels.
  const double voxels = radius_[gone] / probe_.voxelMm();
  gone += std::min(static_cast<std::size_t>(1.0 + 0.5 * voxels), (radius_.size() - 1 - gone) / 3);
  radius_.erase(radius_.begin(), radius_.begin() + static_cast<std::ptrdiff_t>(gone));
  if (end == 1) std::reverse(radius_.begin(), radius_.end());
  if (end == 0)
    line_.erase(line_.begin(), line_.begin() + static_cast<std::ptrdiff_t>(gone));
  else
    line_.erase(line_.end() - static_cast<std::ptrdiff_t>(gone), line_.end());
}

void BranchLine::extend(std::size_t end) {
  const NodeKind kind = ends_[end].kind;
  if ((kind != NodeKind::Tip && kind != NodeKind::Border) || line_.size() < 2) return;
  const auto turn = [&] {
    if (end == 1) return;
    std::reverse(line_.begin(), line_.end());
    std::reverse(radius_.begin(), radius_.end());
  };
  turn();
  if (kind == NodeKind::Border)
    extendToBorder();
  else
    extendToTip();
  turn();
}

/// From section to section while they are whole, then straight on to the border.
void BranchLine::extendToBorder() {
  const double step = probe_.voxelMm();
  const auto axis = [&] {
    return tangentAt(line_, line_.size() - 1,
                     static_cast<std::size_t>(3.0 + radius_.back() / step));
  };
  while (line_.size() > 3) {
    const auto section = probe_.section(line_.back(), tangentAt(line_, line_.size() - 1, 3));
    if (section && section->cutShare == 0.0) break;
    line_.pop_back();
    radius_.pop_back();
  }
  for (int n = 0; n < 1000 && probe_.toBorder(line_.back(), axis()) > step; ++n) {
    const auto section = probe_.section(line_.back() + step * axis(), axis());
    if (!section || section->cutShare > 0.0) break;
    // Half-way, as for tips.
    line_.push_back(0.5 * (line_.back() + step * axis() + section->centreLps));
    radius_.push_back(section->radiusMm);
  }
  const double more = probe_.toBorder(line_.back(), axis());
  const int steps = static_cast<int>(std::ceil(more / step));
  const Vector3d from = line_.back();
  const Vector3d straight = axis();
  for (int n = 1; n <= steps; ++n) {
    const Vector3d next = from + more * n / steps * straight;
    if (!probe_.isInside(next)) break;  // of a vessel that the border slices lengthwise
    line_.push_back(next);
    radius_.push_back(radius_.back());
  }
}

/// From section to section to where a ball in the vessel's end has its centre.
void BranchLine::extendToTip() {
  const double step = probe_.voxelMm();
  const auto steps = static_cast<int>(3.0 + 2.0 * radius_.back() / step);
  for (int n = 0; n < steps; ++n) {
    const auto reach = static_cast<std::size_t>(3.0 + 0.5 * radius_.back() / step);
    const Vector3d axis = tangentAt(line_, line_.size() - 1, reach);
    const Vector3d from = line_.back();
    const double more = probe_.cast(from, axis).lengthMm - radius_.back();
    if (!(more > 0.1 * step)) return;
    const Vector3d next = from + std::min(more, step) * axis;
    const auto section = probe_.section(next, axis);
    if (!section) return;
    // Half-way, so that a line of points does not swing.
    line_.push_back(0.5 * (next + section->centreLps));
    radius_.push_back(section->radiusMm);
  }
}

void BranchLine::wrapRing() {
  wrapped_ = std::min(kWrap, std::max<std::size_t>(line_.size(), 2) - 2);
  Polyline whole(line_.end() - 1 - static_cast<std::ptrdiff_t>(wrapped_), line_.end() - 1);
  whole.insert(whole.end(), line_.begin(), line_.end());
  whole.insert(whole.end(), line_.begin() + 1,
               line_.begin() + 1 + static_cast<std::ptrdiff_t>(wrapped_));
  line_ = std::move(whole);
}

void BranchLine::unwrapRing() {
  line_ = Polyline(line_.begin() + static_cast<std::ptrdiff_t>(wrapped_),
                   line_.end() - static_cast<std::ptrdiff_t>(wrapped_));
  line_.front() = line_.back() = 0.5 * (line_.front() + line_.back());
  radius_ = std::vector<double>(radius_.begin() + static_cast<std::ptrdiff_t>(wrapped_),
                                radius_.end() - static_cast<std::ptrdiff_t>(wrapped_));
}

/// Each point to the centre of the section there, then a moving mean.
void BranchLine::centre() {
  Polyline moved = line_;
  for (std::size_t n = 0; n < line_.size(); ++n) {
    const auto reach = static_cast<std::size_t>(2.0 + 0.5 * radius_[n] / probe_.voxelMm());
    const auto section = probe_.section(line_[n], tangentAt(line_, n, reach));
    if (!section) {
      radius_[n] = n > 0 ? radius_[n - 1] : 0.0;
      continue;
    }
    radius_[n] = section->radiusMm;
    if ((section->centreLps - line_[n]).norm() < section->radiusMm + probe_.voxelMm())
      moved[n] = section->centreLps;
  }
  line_ = smoothed(moved, kSmoothPoints);
}

BranchLine::Entry BranchLine::entry(std::size_t end) const {
  Entry entry;
  entry.point = end == 0 ? line_.front() : line_.back();
  entry.radiusMm = end == 0 ? radius_.front() : radius_.back();
  const auto reach = static_cast<std::size_t>(3.0 + entry.radiusMm / probe_.voxelMm());
  entry.direction =
      (end == 0 ? -1.0 : 1.0) * tangentAt(line_, end == 0 ? 0 : line_.size() - 1, reach);
  return entry;
}

/// From the place of the junction up to the line: Hermite's cubic that goes on as the line does, or
/// straight where the line comes from aside.
Polyline BranchLine::throughJunction(std::size_t end, const Vector3d& place) const {
  const Entry out = entry(end);
  const Vector3d chord = out.point - place;
  const double length = chord.norm();
  Vector3d slope = -length * out.direction;
  if (slope.dot(chord) < kLeastCosine * length * length) slope = chord;
  const int steps = static_cast<int>(std::ceil(length / probe_.voxelMm()));
  Polyline line;
  for (int n = 0; n < steps; ++n) {
    const double t = static_cast<double>(n) / steps;
    line.push_back(place + t * chord + t * t * (t - 1.0) * (slope - chord));
  }
  return line;
}

/// Takes the points that lie beyond the place of the junction, seen from the branch.
void BranchLine::cutAt(std::size_t end, const Vector3d& place) {
  const Vector3d inward = entry(end).direction;
  const double reach = 4.0 * entry(end).radiusMm;
  const auto last = [&]() -> const Vector3d& { return end == 0 ? line_.front() : line_.back(); };
  while (line_.size() > 1 && (last() - place).norm() < reach &&
         (last() - place).dot(inward) > -0.5 * probe_.voxelMm()) {
    line_.erase(end == 0 ? line_.begin() : line_.end() - 1);
    radius_.erase(end == 0 ? radius_.begin() : radius_.end() - 1);
  }
}

SkeletonBranch BranchLine::finished(const std::array<Vector3d, 2>& junctions) {
  Polyline front, back;
  for (std::size_t end = 0; end < 2; ++end)
    if (ends_[end].kind == NodeKind::Junction) cutAt(end, junctions[end]);
  if (ends_[0].kind == NodeKind::Junction) front = throughJunction(0, junctions[0]);
  if (ends_[1].kind == NodeKind::Junction) back = throughJunction(1, junctions[1]);
  Polyline whole = front;
  whole.insert(whole.end(), line_.begin(), line_.end());
  whole.insert(whole.end(), back.rbegin(), back.rend());
  front.push_back(line_.front());
  const double from = lengthOf(front);
  const double to = isOutside_ ? from + lengthOf(line_) : -1.0;
  SkeletonBranch branch;
  branch.lengthMm = lengthOf(whole);
  whole = resampled(whole, probe_.voxelMm());
  for (const Vector3d& point : whole) branch.points.push_back({point, 0.0, 0.0});
  measure(branch, from, to);
  return branch;
}

/// Radii of the sections between two lengths along the branch; elsewhere those of the nearest one.
void BranchLine::measure(SkeletonBranch& branch, double from, double to) const {
  std::vector<SkeletonPoint>& points = branch.points;
  Polyline line;
  for (const SkeletonPoint& point : points) line.push_back(point.pointLps);
  const double step =
      branch.lengthMm / static_cast<double>(std::max<std::size_t>(line.size() - 1, 1));
  std::vector<std::size_t> measured;
  for (std::size_t n = 0; n < line.size(); ++n) {
    const double at = step * static_cast<double>(n);
    if (at < from - 0.5 * step || at > to + 0.5 * step) continue;
    const double near = measured.empty() ? radius_.front() : points[measured.back()].radiusMm;
    const auto reach = static_cast<std::size_t>(2.0 + 0.5 * near / probe_.voxelMm());
    const auto section = probe_.section(line[n], tangentAt(line, n, reach));
    if (!section || section->cutShare > kMostCut) continue;
    points[n].radiusMm = section->radiusMm;
    points[n].inscribedMm = section->inscribedMm;
    measured.push_back(n);
  }
  if (measured.empty()) {
    for (SkeletonPoint& point : points) point.radiusMm = point.inscribedMm = radius_.front();
    branch.meanRadiusMm = branch.minRadiusMm = branch.maxRadiusMm = radius_.front();
    return;
  }
  branch.minRadiusMm = branch.maxRadiusMm = points[measured.front()].radiusMm;
  for (const std::size_t n : measured) {
    branch.meanRadiusMm += points[n].radiusMm / static_cast<double>(measured.size());
    branch.minRadiusMm = std::min(branch.minRadiusMm, points[n].radiusMm);
    branch.maxRadiusMm = std::max(branch.maxRadiusMm, points[n].radiusMm);
  }
  std::size_t next = 0;  // the first one measured at or after n
  for (std::size_t n = 0; n < points.size(); ++n) {
    while (next < measured.size() && measured[next] < n) ++next;
    std::size_t nearest = next < measured.size() ? measured[next] : measured.back();
    if (next > 0 && nearest > n && n - measured[next - 1] < nearest - n)
      nearest = measured[next - 1];
    points[n].radiusMm = points[nearest].radiusMm;
    points[n].inscribedMm = points[nearest].inscribedMm;
  }
}

}  // namespace angiomesh
