// SPDX-License-Identifier: BSD-3-Clause
#include "core/front/border_curves.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/parallel.h"
#include "core/contour/border_trace.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/point_grid.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t none = BorderTrace::none;
constexpr int kFine = 4;              // lattice steps per voxel that a curve is measured by
constexpr double kReach = 2.0;        // voxels; curves farther apart do not see one another
constexpr double kEdgePerRoom = 1.5;  // of the distance to the curve's next part
constexpr double kLeastRoom = 0.04;   // voxels
constexpr double kDetour =
    2.5;  // parts of a curve are apart if it takes so many times the distance

class Tracer {
 public:
  Tracer(const SplineField& field, const GuidanceField& size, const EndPlanes& ends,
         const CutAway& away)
      : field_(field),
        grid_(field.geometry()),
        size_(size),
        ends_(ends),
        away_(away),
        follow_(static_cast<std::size_t>(ends.count())) {
    curves_.caps.resize(follow_.size());
  }

  BorderCurves run(bool caps) {
    trace_ = traceBorder(field_, ends_, away_, kFine);
    measureRoom();
    std::vector<char> done(trace_.points.size(), 0);
    // Loops with corners first start at a corner, so that each piece lies in one plane.
    for (const bool corners : {true, false})
      for (std::uint32_t v = 0; v < trace_.next.size(); ++v)
        if (done[v] == 0 && (!corners || isCorner(v))) traceLoop(v, done);
    if (caps) {
      for (int first = 0; first < 6; ++first)
        for (int second = first + 1; second < 6; ++second)
          if (first / 2 != second / 2) volumeEdge(first, second);
      for (std::size_t plane = 0; plane < follow_.size(); ++plane)
        curves_.caps[plane] = closedLoops(std::move(follow_[plane]));
    }
    return std::move(curves_);
  }

 private:
  // Per point of the trace, the distance to the next part of the curves in its plane, as far as
  // kReach: edges longer than that would cross it.
  void measureRoom() {
    const std::size_t n = trace_.points.size();
    std::vector<std::uint32_t> loop(n, none);
    std::vector<double> along(n, 0.0), length;
    for (std::uint32_t v = 0; v < n; ++v) {
      if (loop[v] != none) continue;
      double sum = 0.0;
      for (std::uint32_t w = v; w != none && loop[w] == none; w = trace_.next[w]) {
        loop[w] = static_cast<std::uint32_t>(length.size());
        along[w] = sum;
        if (trace_.next[w] != none)
          sum += (trace_.points[trace_.next[w]] - trace_.points[w]).norm();
      }
      length.push_back(sum);
    }
    PointGrid near;
    const double step = grid_.voxelMm() / kFine;
    for (std::uint32_t v = 0; v < n; ++v) near.insert(v, trace_.points[v], step);
    room_.assign(n, std::numeric_limits<double>::infinity());
    parallelForEach(n, 256, [&](std::size_t i) {
      const Vector3d& p = trace_.points[i];
      const Place& planes = trace_.place[i];
      near.forEachNear(p, kReach * grid_.voxelMm(), 0.0, [&](std::uint32_t w) {
        if (trace_.place[w].shared(planes).planes() == 0) return;
        const double d = (trace_.points[w] - p).norm();
        if (d >= room_[i]) return;
        if (loop[w] == loop[i]) {
          const double way = std::fabs(along[w] - along[i]);
          if (std::min(way, length[loop[i]] - way) <= kDetour * d + 2.0 * step) return;
        }
        room_[i] = d;
      });
      room_[i] = std::max(room_[i], kLeastRoom * grid_.voxelMm());
    });
  }

  [[nodiscard]] bool isCorner(std::uint32_t v) const { return trace_.place[v].planes() > 1; }

  // Moves a point to phi = 0 along the planes it lies in; where that leads far away it stays.
  [[nodiscard]] Vector3d settled(const Vector3d& start, const Place& planes) const {
    Vector3d p = start;
    for (int n = 0; n < 20; ++n) {
      const SplineField::Jet jet = field_.at(p);
      const Vector3d g = ends_.along(planes, jet.gradient);
      const double slope = g.norm();
      if (!(slope > 1e-3 * jet.gradient.norm()) || !(slope > 1e-12)) return start;
      const double step = jet.value / slope;
      if (std::fabs(step) < 1e-9 * grid_.voxelMm()) break;
      p -= std::clamp(step, -0.3 * grid_.voxelMm(), 0.3 * grid_.voxelMm()) / slope * g;
      if ((p - start).norm() > 0.7 / kFine * grid_.voxelMm()) return start;
    }
    return kept(p, planes);
  }

  // The point in its planes, inside the grid.
  [[nodiscard]] Vector3d kept(const Vector3d& p, const Place& planes) const {
    Vector3d index = grid_.toIndex(p);
    for (int axis = 0; axis < 3; ++axis) {
      const double last = grid_.size[static_cast<std::size_t>(axis)] - 1;
      index[axis] = std::clamp(index[axis], 0.0, last);
      if (planes.liesIn(2 * axis)) index[axis] = 0.0;
      if (planes.liesIn(2 * axis + 1)) index[axis] = last;
    }
    Vector3d point = grid_.toPhysical(index);
    if (planes.cut != 0) ends_.snap(planes, point);
    return point;
  }

  std::uint32_t add(const Vector3d& p, const Place& place) {
    FrontPoint point;
    point.point = p;
    const Vector3d gradient = field_.at(p).gradient;
    if (gradient.norm() > 1e-12) point.normal = gradient.normalized();
    point.length = size_.at(p);
    curves_.points.push_back(point);
    curves_.place.push_back(place);
    return static_cast<std::uint32_t>(curves_.points.size() - 1);
  }

  void traceLoop(std::uint32_t start, std::vector<char>& done) {
    BorderCurves::Loop loop;
    std::uint32_t v = start;
    const bool corners = isCorner(start);
    const std::uint32_t firstCorner = corners ? cornerVertex(start) : none;
    std::uint32_t from = firstCorner;
    do {
      std::vector<std::uint32_t> piece{v};
      do {
        done[v] = 1;
        v = trace_.next[v];
        if (v == none) return;  // not a closed rim: nothing to start from
        piece.push_back(v);
      } while (v != start && !(corners && isCorner(v)));
      const Place plane = commonPlane(piece);
      if (!corners) {
        loop = divide(piece, plane, none, none);
      } else {
        const std::uint32_t to = v == start ? firstCorner : cornerVertex(v);
        loop.push_back(from);
        const BorderCurves::Loop inner = divide(piece, plane, from, to);
        loop.insert(loop.end(), inner.begin(), inner.end());
        segment(plane, from, inner, to);
        from = to;
      }
      if (!corners) closedSegment(plane, loop);
    } while (v != start);
    if (loop.size() >= 3) curves_.rims.push_back(loop);
  }

  std::uint32_t cornerVertex(std::uint32_t v) {
    Place planes = trace_.place[v];
    const Vector3d p = settled(trace_.points[v], planes);
    planes.wall = true;
    const std::uint32_t id = add(p, planes);
    corners_.push_back(id);
    return id;
  }

  [[nodiscard]] Place commonPlane(const std::vector<std::uint32_t>& piece) const {
    Place planes = trace_.place[piece.front()];
    for (const std::uint32_t v : piece) planes = planes.shared(trace_.place[v]);
    // A single segment along an edge of the volume: either plane will do.
    return planes.planes() > 1 ? Place::inPlane(planes.firstPlane()) : planes;
  }

  // Wanted edge length on the rim: the surface's, and the curve's own curvature.
  [[nodiscard]] double lengthOn(const Vector3d& p, const Vector3d& tangent,
                                const Place& plane) const {
    double length = size_.at(p);
    const SplineField::SecondJet jet = field_.secondAt(p);
    const double slope = ends_.along(plane, jet.gradient).norm();
    const double bend = std::fabs(tangent.dot(jet.hessian * tangent));
    return slope > 0.0 ? std::min(length, std::max(size_.idealLength(bend / slope), 0.7 * length))
                       : length;
  }

  // Divides a polyline of the trace evenly by the wanted length. Returns the new inner vertices; of
  // a closed one (no ends) all of them.
  BorderCurves::Loop divide(const std::vector<std::uint32_t>& piece, const Place& plane,
                            std::uint32_t from, std::uint32_t to) {
    const bool closed = from == none;
    std::vector<Vector3d> fine;
    for (const std::uint32_t v : piece) fine.push_back(trace_.points[v]);
    if (!closed) {
      fine.front() = curves_.points[from].point;
      fine.back() = curves_.points[to].point;
    }
    std::vector<double> wanted(fine.size(), 0.0);
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const std::size_t last = fine.size() - 1;
      const Vector3d& before = fine[i > 0 ? i - 1 : (closed ? last - 1 : 0)];
      const Vector3d& after = fine[i < last ? i + 1 : (closed ? 1 : last)];
      const Vector3d t = after - before;
      wanted[i] = std::min(lengthOn(fine[i], t.norm() > 0.0 ? t.normalized() : t, plane),
                           kEdgePerRoom * room_[piece[i]]);
    }
    grade(fine, wanted, closed);
    std::vector<double> along(fine.size(), 0.0);
    for (std::size_t i = 1; i < fine.size(); ++i)
      along[i] = along[i - 1] +
                 2.0 * (fine[i] - fine[i - 1]).norm() / std::max(wanted[i] + wanted[i - 1], 1e-12);
    const auto least = closed ? 5L : 2L;
    const long count = std::max(least, std::lround(along.back()));
    BorderCurves::Loop loop;
    std::size_t i = 1;
    for (long k = closed ? 0 : 1; k < count; ++k) {
      const double target = along.back() * static_cast<double>(k) / static_cast<double>(count);
      while (i + 1 < fine.size() && along[i] < target) ++i;
      const double step = along[i] - along[i - 1];
      const double t = step > 0.0 ? (target - along[i - 1]) / step : 0.0;
      const Vector3d p = settled(fine[i - 1] + t * (fine[i] - fine[i - 1]), plane);
      loop.push_back(add(p, {plane.borders, true, plane.cut}));
      curves_.points.back().length = wanted[i - 1] + t * (wanted[i] - wanted[i - 1]);
    }
    return loop;
  }

  // Lengths grow along the curve no faster than the guidance field does.
  void grade(const std::vector<Vector3d>& fine, std::vector<double>& wanted, bool closed) const {
    const double slope = std::max(size_.slope(), 0.05);
    const std::size_t n = fine.size();
    for (int round = 0; round < (closed ? 2 : 1); ++round) {
      for (std::size_t i = 1; i < n; ++i)
        wanted[i] = std::min(wanted[i], wanted[i - 1] + slope * (fine[i] - fine[i - 1]).norm());
      for (std::size_t i = n - 1; i > 0; --i)
        wanted[i - 1] = std::min(wanted[i - 1], wanted[i] + slope * (fine[i] - fine[i - 1]).norm());
      if (closed) wanted.front() = wanted.back() = std::min(wanted.front(), wanted.back());
    }
  }

  // The cap runs along a rim against the wall.
  void segment(const Place& planes, std::uint32_t from, const BorderCurves::Loop& inner,
               std::uint32_t to) {
    if (planes.planes() == 0) return;
    auto& follow = follow_[static_cast<std::size_t>(planes.firstPlane())];
    std::uint32_t last = from;
    for (const std::uint32_t v : inner) {
      follow[v] = last;
      last = v;
    }
    follow[to] = last;
  }

  void closedSegment(const Place& planes, const BorderCurves::Loop& loop) {
    if (planes.planes() == 0 || loop.size() < 3) return;
    auto& follow = follow_[static_cast<std::size_t>(planes.firstPlane())];
    for (std::size_t i = 0; i < loop.size(); ++i) follow[loop[(i + 1) % loop.size()]] = loop[i];
  }

  // The stretches of an edge of the volume that lie inside phi, shared by two caps.
  void volumeEdge(int first, int second) {
    const Place planes{static_cast<std::uint8_t>(1U << first | 1U << second), false, 0};
    const int axis = 3 - first / 2 - second / 2;
    std::vector<std::pair<double, std::uint32_t>> ends;
    for (const std::uint32_t c : corners_)
      if (curves_.place[c].within(planes))
        ends.emplace_back(grid_.toIndex(curves_.points[c].point)[axis], c);
    const double last = grid_.size[static_cast<std::size_t>(axis)] - 1;
    for (const double at : {0.0, last}) {
      Vector3d index = Vector3d::Zero();
      index[axis] = at;
      for (const int a : {first, second})
        if (a % 2 == 1) index[a / 2] = grid_.size[static_cast<std::size_t>(a / 2)] - 1;
      if (field_.atIndex(index).value >= 0.0 || away_.takenAt(grid_.toPhysical(index))) continue;
      const int end = 2 * axis + (at > 0.0 ? 1 : 0);
      ends.emplace_back(at,
                        volumeCorner(static_cast<std::uint8_t>(planes.borders | 1U << end), index));
    }
    std::sort(ends.begin(), ends.end());
    if (ends.size() % 2 != 0) return;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
      insideStretch(first, second, ends[i].second, ends[i + 1].second);
  }

  std::uint32_t volumeCorner(std::uint8_t planes, const Vector3d& index) {
    const auto found = volumeCorners_.find(planes);
    if (found != volumeCorners_.end()) return found->second;
    const std::uint32_t id = add(grid_.toPhysical(index), {planes, false, 0});
    volumeCorners_[planes] = id;
    return id;
  }

  void insideStretch(int first, int second, std::uint32_t from, std::uint32_t to) {
    const Vector3d a = curves_.points[from].point, b = curves_.points[to].point;
    const Place planes{static_cast<std::uint8_t>(1U << first | 1U << second), false, 0};
    const double wanted = 0.5 * (curves_.points[from].length + curves_.points[to].length);
    const long count = std::max(1L, std::lround((b - a).norm() / wanted));
    BorderCurves::Loop inner;
    for (long k = 1; k < count; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(count);
      inner.push_back(add(kept(a + t * (b - a), planes), planes));
      curves_.points.back().length = wanted;
    }
    // Seen from outside, the cap in plane `first` lies to the left of n_first x n_second.
    const Vector3d left = ends_.normal(first).cross(ends_.normal(second));
    const bool forward = left.dot(b - a) > 0.0;
    for (const int plane : {first, second}) {
      auto& follow = follow_[static_cast<std::size_t>(plane)];
      const bool along = forward == (plane == first);
      BorderCurves::Loop all{from};
      all.insert(all.end(), inner.begin(), inner.end());
      all.push_back(to);
      if (!along) std::reverse(all.begin(), all.end());
      for (std::size_t i = 0; i + 1 < all.size(); ++i) follow[all[i]] = all[i + 1];
    }
  }

  const SplineField& field_;
  const Geometry& grid_;
  const GuidanceField& size_;
  const EndPlanes& ends_;
  const CutAway& away_;
  BorderTrace trace_;
  std::vector<double> room_;  // per point of the trace, mm
  BorderCurves curves_;
  std::vector<std::uint32_t> corners_;
  std::map<std::uint8_t, std::uint32_t> volumeCorners_;
  std::vector<std::map<std::uint32_t, std::uint32_t>> follow_;  ///< per plane
};

}  // namespace

BorderCurves borderCurves(const SplineField& field, const GuidanceField& size,
                          const EndPlanes& ends, const CutAway& away, bool caps) {
  return Tracer(field, size, ends, away).run(caps);
}

}  // namespace angiomesh
