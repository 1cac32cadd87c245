// SPDX-License-Identifier: BSD-3-Clause
#include "core/openings/section.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <string>
#include <unordered_map>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/field/root.h"
#include "core/mesh/flat_area.h"
#include "core/openings/marching_square.h"

namespace angiomesh {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

class SectionTracer {
 public:
  SectionTracer(const SplineField& field, const CutPlane& plane, const std::string& name, int finer)
      : field_(field),
        grid_(field.geometry()),
        name_(name.empty() ? "the cut" : name),
        step_(grid_.voxelMm() / finer) {
    section_.plane = {plane.pointLps, plane.normalLps.normalized()};
    // Any two directions in the plane will do, as long as u x v points outwards.
    const Vector3d& n = section_.plane.normalLps;
    section_.lattice.u = step_ * n.unitOrthogonal();
    section_.lattice.v = n.cross(section_.lattice.u);
  }

  Section run() {
    if (!section_.plane.normalLps.allFinite() || !section_.plane.pointLps.allFinite() ||
        !(std::fabs(section_.plane.normalLps.norm() - 1.0) < 1e-6))
      throw InputError("the normal of " + name_ + " has no direction",
                       "at " + placeText(section_.plane.pointLps),
                       "give a normal that is not 0, or none");
    flood();
    outline();
    measure();
    return std::move(section_);
  }

 private:
  using Node = std::array<int, 2>;

  [[nodiscard]] Vector3d at(const Vector2d& node) const {
    return section_.plane.pointLps + node.x() * section_.lattice.u + node.y() * section_.lattice.v;
  }
  [[nodiscard]] Vector3d at(const Node& node) const { return at(Vector2d(node[0], node[1])); }

  static std::uint64_t keyOf(const Node& n) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(n[0])) << 32U |
           static_cast<std::uint32_t>(n[1]);
  }

  [[nodiscard]] bool insideGrid(const Vector3d& p) const {
    const Vector3d index = grid_.toIndex(p);
    for (int a = 0; a < 3; ++a)
      if (!(index[a] > 0.0 && index[a] < grid_.size[static_cast<std::size_t>(a)] - 1.0))
        return false;
    return true;
  }

  double valueAt(const Node& n) {
    const auto [found, fresh] = values_.try_emplace(keyOf(n), 0.0);
    if (fresh) found->second = field_.valueAt(at(n));
    return found->second;
  }

  // Nodes joined along the lattice's lines, and across squares whose centre is inside.
  void flood() {
    const Node start{0, 0};
    if (!insideGrid(at(start)) || !(valueAt(start) < 0.0))
      throw InputError(name_ + " does not lie in a vessel",
                       "at " + placeText(section_.plane.pointLps),
                       "give a point inside the segmentation, in mm LPS");
    std::deque<Node> open{start};
    region_[keyOf(start)] = start;
    while (!open.empty()) {
      const Node n = open.front();
      open.pop_front();
      for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di) {
          const Node next{n[0] + di, n[1] + dj};
          if ((di == 0 && dj == 0) || region_.count(keyOf(next)) != 0) continue;
          if (!(valueAt(next) < 0.0)) continue;
          if (di != 0 && dj != 0 && !joinedAcross(n, next)) continue;
          if (!insideGrid(at(next)))
            throw InputError(name_ + " reaches the border of the volume",
                             "at " + placeText(section_.plane.pointLps),
                             "move it inwards, or take the opening at the border as the port");
          region_[keyOf(next)] = next;
          open.push_back(next);
        }
    }
  }

  bool joinedAcross(const Node& a, const Node& b) {
    const Vector2d middle(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]));
    return field_.valueAt(at(middle)) < 0.0;
  }

  void outline() {
    Node low{0, 0}, high{0, 0};
    for (const auto& [key, n] : region_)
      for (const std::size_t a : {0, 1}) {
        low[a] = std::min(low[a], n[a]);
        high[a] = std::max(high[a], n[a]);
      }
    Section::Lattice& lattice = section_.lattice;
    lattice.columns = high[0] - low[0] + 1;
    lattice.rows = high[1] - low[1] + 1;
    lattice.origin = at(low);
    lattice.inside.assign(
        static_cast<std::size_t>(lattice.columns) * static_cast<std::size_t>(lattice.rows), 0);
    for (const auto& [key, n] : region_)
      lattice.inside[static_cast<std::size_t>(n[0] - low[0]) +
                     static_cast<std::size_t>(lattice.columns) *
                         static_cast<std::size_t>(n[1] - low[1])] = 1;
    for (int j = low[1] - 1; j <= high[1]; ++j)
      for (int i = low[0] - 1; i <= high[0]; ++i) square({i, j});
    chain();
  }

  // The outline's pieces in one square: the inside lies to their right.
  void square(const Node& low) {
    const std::array<Node, 4> corner{
        {low, {low[0] + 1, low[1]}, {low[0] + 1, low[1] + 1}, {low[0], low[1] + 1}}};
    std::array<bool, 4> in{};
    for (std::size_t k = 0; k < 4; ++k) in[k] = region_.count(keyOf(corner[k])) != 0;
    forEachPiece(
        in, [&] { return joinedAcross(corner[0], corner[2]); },
        [&](std::size_t from, std::size_t to) {
          const std::uint32_t a = onSide(corner[from], corner[(from + 1) % 4]);
          const std::uint32_t b = onSide(corner[to], corner[(to + 1) % 4]);
          next_[a] = b;
        });
  }

  // The crossing between two neighbouring nodes, one of the section and one that is not.
  std::uint32_t onSide(const Node& a, const Node& b) {
    const Node& low = a < b ? a : b;
    const std::uint64_t key = keyOf({2 * low[0] + (a[0] != b[0] ? 1 : 0), low[1]});
    const auto [found, fresh] =
        crossings_.try_emplace(key, static_cast<std::uint32_t>(points_.size()));
    if (!fresh) return found->second;
    const bool aInside = region_.count(keyOf(a)) != 0;
    points_.push_back(rootBetween(aInside ? a : b, aInside ? b : a));
    next_.push_back(none);
    return found->second;
  }

  Vector3d rootBetween(const Node& inside, const Node& outside) {
    const Vector3d from = at(inside), way = at(outside) - from;
    const auto value = [&](double t) { return field_.valueAt(from + t * way); };
    return from + falsePosition(value, valueAt(inside), valueAt(outside)) * way;
  }

  void chain() {
    std::vector<char> done(points_.size(), 0);
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      std::vector<Vector3d> loop;
      for (std::uint32_t w = v; done[w] == 0; w = next_[w]) {
        done[w] = 1;
        loop.push_back(points_[w]);
      }
      if (loop.size() >= 3) section_.loops.push_back(std::move(loop));
    }
  }

  // The point between two of the outline, moved onto phi = 0 within the plane.
  [[nodiscard]] Vector3d between(const Vector3d& a, const Vector3d& b) const {
    const Vector3d middle = 0.5 * (a + b), &n = section_.plane.normalLps;
    Vector3d p = middle;
    for (int k = 0; k < 10; ++k) {
      const SplineField::Jet jet = field_.at(p);
      const Vector3d g = jet.gradient - jet.gradient.dot(n) * n;
      const double square = g.squaredNorm();
      if (!(square > 1e-6 * jet.gradient.squaredNorm())) return middle;
      p -= jet.value / square * g;
      if ((p - middle).norm() > 0.5 * step_) return middle;
      if (std::fabs(jet.value) < 1e-10 * step_ * std::sqrt(square)) break;
    }
    return p;
  }

  struct Moments {
    double area = 0.0;
    Vector2d first = Vector2d::Zero();
    void add(const Vector2d& a, const Vector2d& b) {
      const double twice = a.y() * b.x() - a.x() * b.y();  // clockwise outlines count positive
      area += 0.5 * twice;
      first += twice / 6.0 * (a + b);
    }
  };

  // Chords miss an area that falls with the square of their length: from two lengths the error is
  // of fourth order.
  void measure() {
    const Vector3d u = section_.lattice.u / step_, v = section_.lattice.v / step_;
    const Vector3d about = section_.loops.front().front();
    const auto flat = [&](const Vector3d& p) {
      return Vector2d((p - about).dot(u), (p - about).dot(v));
    };
    Moments coarse, fine;
    for (const std::vector<Vector3d>& loop : section_.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vector3d &a = loop[i], &b = loop[(i + 1) % loop.size()];
        const Vector2d m = flat(between(a, b));
        coarse.add(flat(a), flat(b));
        fine.add(flat(a), m);
        fine.add(m, flat(b));
      }
    section_.areaMm2 = (4.0 * fine.area - coarse.area) / 3.0;
    const Vector2d centre = (4.0 * fine.first - coarse.first) / 3.0 / section_.areaMm2;
    section_.centreLps = about + centre.x() * u + centre.y() * v;
    for (const std::vector<Vector3d>& loop : section_.loops)
      for (const Vector3d& p : loop)
        section_.radiusMm = std::max(section_.radiusMm, (p - section_.centreLps).norm());
  }

  static constexpr std::uint32_t none = 0xffffffffU;

  const SplineField& field_;
  const Geometry& grid_;
  std::string name_;
  double step_;
  Section section_;
  std::unordered_map<std::uint64_t, double> values_;
  std::unordered_map<std::uint64_t, Node> region_;
  std::unordered_map<std::uint64_t, std::uint32_t> crossings_;
  std::vector<Vector3d> points_;
  std::vector<std::uint32_t> next_;
};

}  // namespace

bool Section::covers(const Eigen::Vector3d& pointLps, double mm) const {
  const double square = lattice.u.squaredNorm();
  const Eigen::Vector3d d = pointLps - lattice.origin;
  const double x = d.dot(lattice.u) / square, y = d.dot(lattice.v) / square;
  const int i0 = static_cast<int>(std::floor(x)), j0 = static_cast<int>(std::floor(y));
  const int around = static_cast<int>(std::ceil(mm / std::sqrt(square)));
  for (int j = j0 - around; j <= j0 + 1 + around; ++j)
    for (int i = i0 - around; i <= i0 + 1 + around; ++i)
      if (i >= 0 && j >= 0 && i < lattice.columns && j < lattice.rows &&
          lattice.inside[static_cast<std::size_t>(i) + static_cast<std::size_t>(lattice.columns) *
                                                           static_cast<std::size_t>(j)] != 0)
        return true;
  return false;
}

std::array<Index3, 2> Section::voxelsAround(const Geometry& grid, double mm) const {
  const Eigen::Vector3d centre = grid.toIndex(centreLps);
  const Eigen::Matrix3d toIndex = grid.physicalToIndexMatrix();
  std::array<Index3, 2> box{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    const double reach = (radiusMm + mm) * toIndex.row(axis).norm();
    box[0][a] = std::max(0, static_cast<int>(std::floor(centre[axis] - reach)));
    box[1][a] = std::min(grid.size[a] - 1, static_cast<int>(std::ceil(centre[axis] + reach)));
  }
  return box;
}

double Section::equivalentDiameterMm() const { return angiomesh::equivalentDiameterMm(areaMm2); }

bool Section::isAboutRound() const {
  constexpr double mostLong = 1.6;  // of the circle of the same area
  return radiusMm <= mostLong * 0.5 * equivalentDiameterMm();
}

Section sectionOf(const SplineField& field, const CutPlane& plane, const std::string& name,
                  int finer) {
  return SectionTracer(field, plane, name, finer).run();
}

}  // namespace angiomesh
