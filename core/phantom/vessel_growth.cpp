// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/vessel_growth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/exact_math.h"
#include "core/base/random.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr double kWallGap = 1.5;          // voxels left between vessels that do not join
constexpr double kSharpestCosine = 0.85;  // vessels that join meet at 32 degrees or more
constexpr int kDemandSamples = 10;
constexpr int kNearestVessels = 24;
constexpr int kFailuresUntilFull = 400;

double pointToSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d d = b - a;
  const double t = std::clamp((p - a).dot(d) / std::max(d.dot(d), 1e-12), 0.0, 1.0);
  return (p - a - t * d).norm();
}

/// Distance of two segments: the smaller of an inner solution and the four end point distances.
double segmentToSegment(const Vector3d& a, const Vector3d& b, const Vector3d& c,
                        const Vector3d& d) {
  const Vector3d u = b - a;
  const Vector3d v = d - c;
  const Vector3d w = a - c;
  const double uu = u.dot(u);
  const double uv = u.dot(v);
  const double vv = v.dot(v);
  const double determinant = uu * vv - uv * uv;
  if (determinant > 1e-9 * uu * vv) {
    const double uw = u.dot(w);
    const double vw = v.dot(w);
    const double s = (uv * vw - vv * uw) / determinant;
    const double t = (uu * vw - uv * uw) / determinant;
    if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) return (w + s * u - t * v).norm();
  }
  return std::min({pointToSegment(a, c, d), pointToSegment(b, c, d), pointToSegment(c, a, b),
                   pointToSegment(d, a, b)});
}

/// Material of a vessel per length, by Murray's law: r^2 ~ flow^(2/3).
double weightOf(double flow) {
  const double root = portableCubeRoot(flow);
  return root * root;
}

/// The point with the least weighted sum of distances to three others (Weiszfeld 1937).
Vector3d leastVolumePoint(const std::array<Vector3d, 3>& points,
                          const std::array<double, 3>& weights) {
  Vector3d at = (weights[0] * points[0] + weights[1] * points[1] + weights[2] * points[2]) /
                (weights[0] + weights[1] + weights[2]);
  for (int iteration = 0; iteration < 40; ++iteration) {
    Vector3d sum = Vector3d::Zero();
    double total = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double pull = weights[i] / std::max((points[i] - at).norm(), 1e-6);
      sum += pull * points[i];
      total += pull;
    }
    const Vector3d next = sum / total;
    const double moved = (next - at).norm();
    at = next;
    if (moved < 1e-3) break;
  }
  return at;
}

class Growth {
 public:
  explicit Growth(const GrowthParams& params) : params_(params), random_(params.seed) {}

  std::vector<VesselNode> run(const Progress& progress) {
    for (int n = 0; n < params_.roots; ++n) plantRoot();
    int failures = 0;
    int nextRelaxation = 4;
    while (!finished() && !allSaturated() && failures < kFailuresUntilFull) {
      progress.check();
      if (!addTerminal()) {
        ++failures;
        continue;
      }
      failures = 0;
      ++terminals_;
      if (terminals_ >= nextRelaxation) {
        relax(2, progress);
        nextRelaxation = terminals_ + std::max(2, terminals_ / 4);
      }
    }
    relax(3, progress);
    return std::move(nodes_);
  }

 private:
  struct Joint {
    int vessel = -1;
    Vector3d position;
    double cost = 0.0;
  };

  double uniform() { return randomUniform(random_, counter_++); }

  [[nodiscard]] const VesselNode& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
  [[nodiscard]] VesselNode& node(int n) { return nodes_[static_cast<std::size_t>(n)]; }
  [[nodiscard]] int count() const { return static_cast<int>(nodes_.size()); }

  [[nodiscard]] bool finished() const {
    if (params_.terminals > 0) return terminals_ >= params_.terminals;
    return vesselVolume(nodes_, params_.radiusOfUnitFlow) >= params_.volume;
  }

  [[nodiscard]] int rootOf(int n) const { return rootOf_[static_cast<std::size_t>(n)]; }

  [[nodiscard]] bool saturated(int root) const { return node(root).flow >= params_.maximumFlow; }

  [[nodiscard]] bool allSaturated() const {
    return std::all_of(roots_.begin(), roots_.end(), [&](int r) { return saturated(r); });
  }

  /// The radius that a vessel with this share of its tree's flow will have at the end.
  [[nodiscard]] double finalRadius(double flow, double rootFlow) const {
    const double growth = std::max(1.0, params_.expectedFlow / std::max(rootFlow, 1.0));
    return params_.radiusOfUnitFlow * portableCubeRoot(std::max(flow, 1.0) * growth);
  }

  [[nodiscard]] bool insideTissue(const Vector3d& p, double margin) const {
    for (int a = 0; a < 3; ++a) {
      const double room = std::min(margin, 0.2 * params_.extent[a]);
      if (p[a] < room || p[a] > params_.extent[a] - room) return false;
    }
    return true;
  }

  [[nodiscard]] double distanceToVessels(const Vector3d& p) const {
    double least = std::numeric_limits<double>::max();
    for (const VesselNode& n : nodes_) {
      const double d = n.parent < 0 ? (p - n.position).norm()
                                    : pointToSegment(p, n.position, node(n.parent).position);
      least = std::min(least, d);
    }
    return least;
  }

  /// The first root is in the middle of the lowest face; others on faces in turn, far from vessels.
  void plantRoot() {
    static constexpr int faces[6] = {4, 0, 3, 5, 1, 2};  // 2 axis + (far side)
    const int face = faces[roots_.size() % 6];
    const int axis = face / 2;
    Vector3d best = Vector3d::Zero();
    double farthest = -1.0;
    for (int attempt = 0; attempt < (roots_.empty() ? 1 : 30); ++attempt) {
      Vector3d p;
      for (int a = 0; a < 3; ++a) p[a] = params_.extent[a] * (0.4 + 0.2 * uniform());
      if (!roots_.empty())
        for (int a = 0; a < 3; ++a) p[a] = params_.extent[a] * (0.2 + 0.6 * uniform());
      p[axis] = face % 2 == 0 ? 0.0 : params_.extent[axis];
      const double d = roots_.empty() ? 0.0 : distanceToVessels(p);
      if (d > farthest) {
        farthest = d;
        best = p;
      }
    }
    VesselNode root;
    root.position = best;
    roots_.push_back(count());
    nodes_.push_back(root);
  }

  /// Oxygen reaches a point from the vessels around it, so the demand grows with the distance.
  Vector3d pointOfDemand() {
    Vector3d best = 0.5 * params_.extent;
    double most = -1.0;
    for (int sample = 0; sample < kDemandSamples; ++sample) {
      Vector3d p;
      do {
        for (int a = 0; a < 3; ++a) p[a] = params_.extent[a] * uniform();
      } while (!insideTissue(p, 4.0));
      const double demand = distanceToVessels(p) * (0.6 + 0.4 * uniform());
      if (demand > most) {
        most = demand;
        best = p;
      }
    }
    return best;
  }

  double terminalFlow() {
    const double u = uniform();
    return 1.0 + 3.0 * (params_.meanFlow - 1.0) * u * u;
  }

  /// Whether a vessel from a to b with this radius keeps clear of all others; those that end at one
  /// of the nodes in `joined` are left out, as is vessel `replaced`.
  [[nodiscard]] bool clear(const Vector3d& a, const Vector3d& b, double radius,
                           const std::array<int, 3>& joined, int replaced) const {
    const auto isJoined = [&](int n) {
      return n >= 0 && (n == joined[0] || n == joined[1] || n == joined[2]);
    };
    const double half = 0.5 * (b - a).norm();
    for (int n = 0; n < count(); ++n) {
      const VesselNode& other = node(n);
      if (other.parent < 0 || n == replaced || isJoined(n) || isJoined(other.parent)) continue;
      const double needed = radius + finalRadius_[static_cast<std::size_t>(n)] + kWallGap;
      const Vector3d between = 0.5 * (other.position + node(other.parent).position - a - b);
      const double reach = needed + half + 0.5 * other.length;
      if (between.dot(between) > reach * reach) continue;
      if (segmentToSegment(a, b, other.position, node(other.parent).position) < needed)
        return false;
    }
    return true;
  }

  static bool tooSharp(const Vector3d& joint, const Vector3d& a, const Vector3d& b) {
    const Vector3d u = a - joint;
    const Vector3d v = b - joint;
    return u.dot(v) > kSharpestCosine * u.norm() * v.norm();
  }

  /// Whether the vessels at a bifurcation are long enough, meet at wide angles, also with what
  /// follows at their far ends, and keep clear of the rest.
  [[nodiscard]] bool fits(const Vector3d& joint, const std::array<Vector3d, 3>& ends,
                          const std::array<double, 3>& radii, const std::array<int, 3>& endNodes,
                          int self) const {
    if (!insideTissue(joint, 3.0 + radii[0])) return false;
    for (std::size_t i = 0; i < 3; ++i)
      if ((ends[i] - joint).norm() < 1.5 + 1.2 * radii[0]) return false;
    if (tooSharp(joint, ends[0], ends[1]) || tooSharp(joint, ends[0], ends[2]) ||
        tooSharp(joint, ends[1], ends[2]))
      return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const int end = endNodes[i];
      if (end < 0) continue;
      const VesselNode& far = node(end);
      for (const int next : {far.children[0], far.children[1], far.parent}) {
        if (next < 0 || next == self || next == endNodes[0] || next == endNodes[1]) continue;
        if (tooSharp(ends[i], joint, node(next).position)) return false;
      }
    }
    const int replaced = endNodes[1];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<int, 3> joined{endNodes[i], self, self};
      if (!clear(joint, ends[i], radii[i], joined, replaced)) return false;
    }
    return true;
  }

  [[nodiscard]] Joint bestJointOn(int vessel, const Vector3d& terminal, double flow) const {
    const VesselNode& n = node(vessel);
    const std::array<Vector3d, 3> ends{node(n.parent).position, n.position, terminal};
    const std::array<double, 3> weights{weightOf(n.flow + flow), weightOf(n.flow), weightOf(flow)};
    Joint joint{vessel, leastVolumePoint(ends, weights), 0.0};
    for (std::size_t i = 0; i < 3; ++i)
      joint.cost += weights[i] * (ends[i] - joint.position).norm();
    joint.cost -= weights[1] * n.length;
    for (int a = n.parent; a >= 0 && node(a).parent >= 0; a = node(a).parent)
      joint.cost += node(a).length * (weightOf(node(a).flow + flow) - weightOf(node(a).flow));
    return joint;
  }

  void updateRootsAndFinalRadii() {
    finalRadius_.resize(nodes_.size());
    rootOf_.resize(nodes_.size());
    for (const int root : roots_) {
      const double rootFlow = node(root).flow;
      std::vector<int> stack{root};
      while (!stack.empty()) {
        const int n = stack.back();
        stack.pop_back();
        rootOf_[static_cast<std::size_t>(n)] = root;
        finalRadius_[static_cast<std::size_t>(n)] = finalRadius(node(n).flow, rootFlow);
        for (const int c : node(n).children)
          if (c >= 0) stack.push_back(c);
      }
    }
  }

  bool addTerminal() {
    updateRootsAndFinalRadii();
    for (const int root : roots_)
      if (node(root).children[0] < 0) return startTree(root);
    const Vector3d terminal = pointOfDemand();
    const double flow = terminalFlow();
    std::vector<std::pair<double, int>> nearest;
    for (int n = 0; n < count(); ++n)
      if (node(n).parent >= 0 && !saturated(rootOf(n)))
        nearest.emplace_back(
            pointToSegment(terminal, node(n).position, node(node(n).parent).position), n);
    const std::size_t kept = std::min<std::size_t>(nearest.size(), kNearestVessels);
    std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(kept),
                      nearest.end());
    std::vector<Joint> joints;
    for (std::size_t i = 0; i < kept; ++i)
      joints.push_back(bestJointOn(nearest[i].second, terminal, flow));
    std::stable_sort(joints.begin(), joints.end(),
                     [](const Joint& a, const Joint& b) { return a.cost < b.cost; });
    for (const Joint& joint : joints) {
      const VesselNode& n = node(joint.vessel);
      const double rootFlow = node(rootOf(joint.vessel)).flow;
      const std::array<double, 3> radii{finalRadius(n.flow + flow, rootFlow),
                                        finalRadius(n.flow, rootFlow), finalRadius(flow, rootFlow)};
      if (!fits(joint.position, {node(n.parent).position, n.position, terminal}, radii,
                {n.parent, joint.vessel, -1}, -1))
        continue;
      insert(joint, terminal, flow);
      return true;
    }
    return false;
  }

  /// The shortest of several vessels that lead from the root to where there is demand; a root from
  /// which none has room is given up.
  bool startTree(int root) {
    const Vector3d from = node(root).position;
    const double flow = terminalFlow();
    const double radius = finalRadius(flow, flow);
    const double shortest = 0.2 * params_.extent.minCoeff();
    VesselNode end;
    end.parent = root;
    end.flow = flow;
    for (int attempt = 0; attempt < 40; ++attempt) {
      const Vector3d to = pointOfDemand();
      const double length = (to - from).norm();
      if (length < shortest || (end.length > 0.0 && length > end.length)) continue;
      if (!clear(from, to, radius, {root, root, root}, -1)) continue;
      end.position = to;
      end.length = length;
      if (attempt > 4) break;
    }
    if (end.length == 0.0) {
      roots_.erase(std::find(roots_.begin(), roots_.end(), root));
      return false;
    }
    node(root).children[0] = count();
    node(root).flow = flow;
    nodes_.push_back(end);
    return true;
  }

  void insert(const Joint& joint, const Vector3d& terminal, double flow) {
    const int below = joint.vessel;
    const int above = node(below).parent;
    const int middle = count();
    VesselNode bifurcation;
    bifurcation.position = joint.position;
    bifurcation.parent = above;
    bifurcation.children[0] = below;
    bifurcation.children[1] = middle + 1;
    bifurcation.flow = node(below).flow;
    bifurcation.length = (joint.position - node(above).position).norm();
    VesselNode end;
    end.position = terminal;
    end.parent = middle;
    end.flow = flow;
    end.length = (terminal - joint.position).norm();
    for (int& c : node(above).children)
      if (c == below) c = middle;
    node(below).parent = middle;
    node(below).length = (node(below).position - joint.position).norm();
    nodes_.push_back(bifurcation);
    nodes_.push_back(end);
    for (int n = middle; n >= 0; n = node(n).parent) node(n).flow += flow;
  }

  /// Moves every bifurcation to the point of least volume for the flows of now, where there is
  /// room.
  void relax(int sweeps, const Progress& progress) {
    updateRootsAndFinalRadii();
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (int n = 0; n < count(); ++n) {
        VesselNode& b = node(n);
        if (b.parent < 0 || b.children[1] < 0) continue;
        progress.check();
        const std::array<int, 3> around{b.parent, b.children[0], b.children[1]};
        const std::array<Vector3d, 3> ends{node(around[0]).position, node(around[1]).position,
                                           node(around[2]).position};
        const Vector3d target = leastVolumePoint(
            ends,
            {weightOf(b.flow), weightOf(node(around[1]).flow), weightOf(node(around[2]).flow)});
        const std::array<double, 3> radii{finalRadius_[static_cast<std::size_t>(n)],
                                          finalRadius_[static_cast<std::size_t>(around[1])],
                                          finalRadius_[static_cast<std::size_t>(around[2])]};
        for (const double step : {1.0, 0.5, 0.2}) {
          const Vector3d moved = b.position + step * (target - b.position);
          if (!fits(moved, ends, radii, around, n)) continue;
          b.position = moved;
          b.length = (moved - ends[0]).norm();
          node(around[1]).length = (moved - ends[1]).norm();
          node(around[2]).length = (moved - ends[2]).norm();
          break;
        }
      }
  }

  GrowthParams params_;
  std::uint64_t random_;
  std::uint64_t counter_ = 0;
  int terminals_ = 0;
  std::vector<int> roots_;
  std::vector<VesselNode> nodes_;
  std::vector<int> rootOf_;
  std::vector<double> finalRadius_;
};

}  // namespace

double vesselVolume(const std::vector<VesselNode>& nodes, double radiusOfUnitFlow) {
  double sum = 0.0;
  for (const VesselNode& n : nodes)
    if (n.parent >= 0) sum += weightOf(n.flow) * n.length;
  return std::numbers::pi * radiusOfUnitFlow * radiusOfUnitFlow * sum;
}

std::vector<VesselNode> growVessels(const GrowthParams& params, const Progress& progress) {
  return Growth(params).run(progress);
}

}  // namespace angiomesh
