// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"

namespace angiomesh {
namespace {
constexpr std::uint32_t leafSize = 6;
}

std::array<Eigen::Vector3d, 3> cornersOf(const TriMesh& mesh, std::uint32_t triangle) {
  const auto& t = mesh.triangles[triangle];
  return {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
}

TriangleTree::TriangleTree(const TriMesh& mesh, const Progress& progress) : mesh_(mesh) {
  const std::size_t count = mesh.triangles.size();
  if (count == 0) return;
  std::vector<Item> items(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto corners = cornersOf(mesh, i);
    items[i] = {corners[0] + corners[1] + corners[2], i};
  }
  order_.resize(count);
  boxes_.resize(count);
  nodes_.reserve(2 * count / leafSize + 64);
  build(0, static_cast<std::uint32_t>(count), items, progress);
}

std::uint32_t TriangleTree::build(std::uint32_t first, std::uint32_t last, std::vector<Item>& items,
                                  const Progress& progress) {
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  if (last - first <= leafSize) {
    Node leaf;
    leaf.start = first;
    leaf.count = last - first;
    for (std::uint32_t i = first; i < last; ++i) {
      order_[i] = items[i].triangle;
      for (const auto& corner : cornersOf(mesh_, order_[i])) boxes_[i].extend(corner);
      leaf.box.extend(boxes_[i]);
    }
    nodes_[at] = leaf;
    return at;
  }
  if (last - first > 4096) progress.check();
  Box spread;
  for (std::uint32_t i = first; i < last; ++i) spread.extend(items[i].sum);
  Eigen::Index axis = 0;
  spread.sizes().maxCoeff(&axis);
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(items.begin() + first, items.begin() + middle, items.begin() + last,
                   [axis](const Item& a, const Item& b) {
                     const double x = a.sum[axis], y = b.sum[axis];
                     return x != y ? x < y : a.triangle < b.triangle;
                   });
  const std::uint32_t left = build(first, middle, items, progress);
  const std::uint32_t right = build(middle, last, items, progress);
  nodes_[at].start = right;
  nodes_[at].box = nodes_[left].box.merged(nodes_[right].box);
  return at;
}

TriangleTree::Closest TriangleTree::closest(const Eigen::Vector3d& point) const {
  Closest best;
  double bestSquared = std::numeric_limits<double>::infinity();
  struct Waiting {
    std::uint32_t node;
    double squared;
  };
  std::array<Waiting, 64> stack{};
  std::size_t depth = 0;
  stack[depth++] = {0, nodes_[0].box.squaredExteriorDistance(point)};
  while (depth > 0) {
    const Waiting waiting = stack[--depth];
    if (waiting.squared >= bestSquared) continue;
    const Node& node = nodes_[waiting.node];
    if (node.count == 0) {
      Waiting near{waiting.node + 1, nodes_[waiting.node + 1].box.squaredExteriorDistance(point)};
      Waiting far{node.start, nodes_[node.start].box.squaredExteriorDistance(point)};
      if (far.squared < near.squared) std::swap(near, far);
      stack[depth++] = far;
      stack[depth++] = near;
      continue;
    }
    for (std::uint32_t i = node.start; i < node.start + node.count; ++i) {
      if (boxes_[i].squaredExteriorDistance(point) >= bestSquared) continue;
      const auto corners = cornersOf(mesh_, order_[i]);
      const Eigen::Vector3d w = closestWeights(corners, point);
      const Eigen::Vector3d on = w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2];
      const double squared = (on - point).squaredNorm();
      if (squared < bestSquared) {
        bestSquared = squared;
        best = {order_[i], on, w};
      }
    }
  }
  best.distance = std::sqrt(bestSquared);
  return best;
}

double TriangleTree::firstExit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                               double least) const {
  Stop stop;
  stop.least = least;
  return firstStop(origin, direction, stop);
}

double TriangleTree::firstStop(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                               const Stop& stop) const {
  const double least = stop.least;
  const double side = stop.entering ? -1.0 : 1.0;
  double best = stop.most;
  bool any = false;
  const Eigen::Array3d inverse = direction.array().inverse();
  const auto misses = [&](const Box& box) {
    const Eigen::Array3d a = (box.min() - origin).array() * inverse;
    const Eigen::Array3d b = (box.max() - origin).array() * inverse;
    double enter = least;
    double leave = best;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      if (direction[axis] == 0.0) {
        if (origin[axis] < box.min()[axis] || origin[axis] > box.max()[axis]) return true;
        continue;
      }
      enter = std::max(enter, std::min(a[axis], b[axis]));
      leave = std::min(leave, std::max(a[axis], b[axis]));
    }
    return enter > leave;
  };
  forEachLeaf(misses, [&](std::uint32_t i) {
    const auto corners = cornersOf(mesh_, order_[i]);
    const Eigen::Vector3d ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    const Eigen::Vector3d normal = ab.cross(ac);
    const double facing = side * normal.dot(direction);
    if (!(facing > 0.0)) return;
    for (const std::uint32_t v : mesh_.triangles[order_[i]])
      if (v == stop.notAt[0] || v == stop.notAt[1] || v == stop.notAt[2]) return;
    // Moeller and Trumbore 1997.
    const Eigen::Vector3d from = origin - corners[0];
    const Eigen::Vector3d turned = direction.cross(from);
    const double u = side * ac.dot(turned), v = -side * ab.dot(turned);
    // A ray through an edge or a corner is not to slip out between the triangles there.
    const double hair = 1e-9 * facing;
    if (u < -hair || v < -hair || u + v > facing + hair) return;
    const double distance = -side * normal.dot(from) / facing;
    if (!(distance > least && distance < best)) return;
    best = distance;
    any = true;
  });
  return any ? best : std::numeric_limits<double>::infinity();
}

Eigen::Vector3d closestWeights(const std::array<Eigen::Vector3d, 3>& triangle,
                               const Eigen::Vector3d& point) {
  const Eigen::Vector3d &a = triangle[0], &b = triangle[1], &c = triangle[2];
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = point - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  const Eigen::Vector3d bp = point - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 / (d1 - d3);
    return {1.0 - v, v, 0.0};
  }
  const Eigen::Vector3d cp = point - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 / (d2 - d6);
    return {1.0 - w, 0.0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0.0, 1.0 - w, w};
  }
  const double sum = va + vb + vc;
  if (!(sum > 0.0)) return {1.0, 0.0, 0.0};
  return {1.0 - vb / sum - vc / sum, vb / sum, vc / sum};
}

}  // namespace angiomesh
