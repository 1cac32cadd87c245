// SPDX-License-Identifier: BSD-3-Clause
#include "core/contour/border_trace.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "core/field/root.h"
#include "core/openings/marching_square.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

class PlaneTracer {
 public:
  PlaneTracer(const SplineField& field, int finer)
      : field_(field), grid_(field.geometry()), finer_(finer) {
    for (std::size_t a = 0; a < 3; ++a) fineSize_[a] = (grid_.size[a] - 1) * finer + 1;
  }

  BorderTrace run() {
    for (int a = 0; a < 3; ++a)
      if (grid_.size[static_cast<std::size_t>(a)] < 2) return {};
    for (int plane = 0; plane < 6; ++plane) tracePlane(plane);
    return std::move(trace_);
  }

 private:
  using Fine = std::array<int, 3>;  // a point of the fine lattice

  [[nodiscard]] double valueAt(const Fine& p) const {
    return field_.atIndex(Vector3d(p[0], p[1], p[2]) / finer_).value;
  }

  void tracePlane(int plane) {
    const auto axis = static_cast<std::size_t>(plane / 2);
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int layer = plane % 2 == 0 ? 0 : grid_.size[axis] - 1;
    // Whether u x v points outwards, in patient space: directions may be left-handed.
    const bool outwards = (plane % 2 == 1) == (grid_.direction.determinant() > 0.0);
    Index3 first{}, last{};
    first[axis] = std::max(layer - 1, 0);
    last[axis] = first[axis] + 1;
    const auto side = static_cast<std::size_t>(finer_) + 1;
    std::vector<double> values(side * side);
    for (int j = 0; j + 1 < grid_.size[v]; ++j)
      for (int i = 0; i + 1 < grid_.size[u]; ++i) {
        first[u] = i;
        first[v] = j;
        last[u] = i + 1;
        last[v] = j + 1;
        const std::array<double, 2> bounds = field_.bounds(first, last);
        if (bounds[0] > 0.0 || bounds[1] < 0.0) continue;
        Fine corner{};
        corner[axis] = layer * finer_;
        for (std::size_t b = 0; b < side; ++b)
          for (std::size_t a = 0; a < side; ++a) {
            corner[u] = i * finer_ + static_cast<int>(a);
            corner[v] = j * finer_ + static_cast<int>(b);
            values[a + side * b] = valueAt(corner);
          }
        for (std::size_t b = 0; b + 1 < side; ++b)
          for (std::size_t a = 0; a + 1 < side; ++a) {
            corner[u] = i * finer_ + static_cast<int>(a);
            corner[v] = j * finer_ + static_cast<int>(b);
            square(corner, u, v,
                   {values[a + side * b], values[a + 1 + side * b], values[a + 1 + side * (b + 1)],
                    values[a + side * (b + 1)]},
                   outwards);
          }
      }
  }

  // The curve's pieces in one square; `value` counter-clockwise from the corner at `low`.
  void square(const Fine& low, std::size_t u, std::size_t v, const std::array<double, 4>& value,
              bool outwards) {
    const auto joined = [&] {
      Vector3d centre(low[0], low[1], low[2]);
      centre[static_cast<Eigen::Index>(u)] += 0.5;
      centre[static_cast<Eigen::Index>(v)] += 0.5;
      return field_.atIndex(centre / finer_).value < 0.0;
    };
    const auto join = [&](std::size_t from, std::size_t to) {
      const std::uint32_t a = onSide(low, u, v, from, value), b = onSide(low, u, v, to, value);
      trace_.next[outwards ? a : b] = outwards ? b : a;
    };
    forEachPiece({value[0] < 0.0, value[1] < 0.0, value[2] < 0.0, value[3] < 0.0}, joined, join);
  }

  // The vertex on side k of a square.
  std::uint32_t onSide(const Fine& low, std::size_t u, std::size_t v, std::size_t k,
                       const std::array<double, 4>& value) {
    Fine p = low;
    if (k == 1) ++p[u];
    if (k == 2) ++p[v];
    const std::size_t axis = k % 2 == 0 ? u : v;
    const std::uint64_t at =
        static_cast<std::uint64_t>(p[0]) +
        static_cast<std::uint64_t>(fineSize_[0]) *
            (static_cast<std::uint64_t>(p[1]) +
             static_cast<std::uint64_t>(fineSize_[1]) * static_cast<std::uint64_t>(p[2]));
    const auto [found, fresh] =
        vertices_.try_emplace(3 * at + axis, static_cast<std::uint32_t>(trace_.points.size()));
    if (!fresh) return found->second;
    // Sides 2 and 3 run against their axis.
    const bool against = k > 1;
    const double f0 = value[against ? (k + 1) % 4 : k], f1 = value[against ? k : (k + 1) % 4];
    trace_.points.push_back(rootOn(p, axis, f0, f1));
    trace_.next.push_back(BorderTrace::none);
    return found->second;
  }

  // Between two neighbouring lattice points of different sign.
  [[nodiscard]] Vector3d rootOn(const Fine& p, std::size_t axis, double f0, double f1) const {
    const Vector3d start(p[0], p[1], p[2]);
    const auto at = [&](double t) {
      Vector3d x = start;
      x[static_cast<Eigen::Index>(axis)] += t;
      return Vector3d(x / finer_);
    };
    const auto value = [&](double t) { return field_.atIndex(at(t)).value; };
    // A vertex at the end of its lattice edge could be taken for one of another border plane.
    return grid_.toPhysical(at(falsePosition(value, f0, f1)));
  }

  const SplineField& field_;
  const Geometry& grid_;
  int finer_;
  std::array<int, 3> fineSize_{};
  std::unordered_map<std::uint64_t, std::uint32_t> vertices_;
  BorderTrace trace_;
};

// Keeps the curves that lie, for the greater part, on what is left.
void dropTaken(BorderTrace& trace, const CutAway& away) {
  const std::size_t n = trace.points.size();
  std::vector<char> done(n, 0);
  BorderTrace kept;
  for (std::uint32_t v = 0; v < n; ++v) {
    std::vector<std::uint32_t> curve;
    std::size_t taken = 0;
    std::uint32_t w = v;
    for (; w != BorderTrace::none && done[w] == 0; w = trace.next[w]) {
      done[w] = 1;
      curve.push_back(w);
      if (away.takenAt(trace.points[w])) ++taken;
    }
    // One that does not close, and so starts no front.
    if (curve.empty() || w != v || 2 * taken > curve.size()) continue;
    const auto first = static_cast<std::uint32_t>(kept.points.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
      kept.points.push_back(trace.points[curve[i]]);
      kept.place.push_back(trace.place[curve[i]]);
      kept.next.push_back(first + static_cast<std::uint32_t>((i + 1) % curve.size()));
    }
  }
  trace = std::move(kept);
}

void addSection(BorderTrace& trace, const Section& section, const Place& place) {
  for (const std::vector<Vector3d>& loop : section.loops) {
    const auto first = static_cast<std::uint32_t>(trace.points.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      trace.points.push_back(loop[i]);
      trace.place.push_back(place);
      trace.next.push_back(first + static_cast<std::uint32_t>((i + 1) % loop.size()));
    }
  }
}

}  // namespace

BorderTrace traceBorder(const SplineField& field, const EndPlanes& ends, const CutAway& away,
                        int finer) {
  BorderTrace trace = PlaneTracer(field, finer).run();
  for (const Vector3d& p : trace.points) trace.place.push_back(ends.borders(p));
  if (away.empty()) return trace;
  dropTaken(trace, away);
  for (std::size_t n = 0; n < away.sections.size(); ++n)
    addSection(trace, away.sections[n], Place::inPlane(static_cast<int>(6 + n)));
  return trace;
}

}  // namespace angiomesh
