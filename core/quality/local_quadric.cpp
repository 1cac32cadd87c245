// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/local_quadric.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace angiomesh {
namespace {

using Eigen::Vector3d;

/// What the last three terms cost, against sums of squares in units of the farthest point: without
/// it they would follow the noise of a flat wall, where z is nearly 0.
constexpr double kRidge = 1e-8;

}  // namespace

MeshRings::MeshRings(const TriMesh& mesh, const std::vector<char>& counts) : mesh_(mesh) {
  const auto counted = [&](std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return (counts.empty() || counts[t] != 0) && a != b && b != c && c != a;
  };
  const std::size_t vertices = mesh.points.size();
  triangles_.start.assign(vertices + 1, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (counted(t))
      for (const std::uint32_t v : mesh.triangles[t]) ++triangles_.start[v + 1];
  for (std::size_t v = 0; v < vertices; ++v) triangles_.start[v + 1] += triangles_.start[v];
  triangles_.items.resize(triangles_.start[vertices]);
  std::vector<std::size_t> next(triangles_.start.begin(), triangles_.start.end() - 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (counted(t))
      for (const std::uint32_t v : mesh.triangles[t])
        triangles_.items[next[v]++] = static_cast<std::uint32_t>(t);
  neighbours_.start.assign(1, 0);
  std::vector<std::uint32_t> ring;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    ring.clear();
    for (const std::uint32_t t : trianglesAt(v))
      for (const std::uint32_t other : mesh.triangles[t])
        if (other != v) ring.push_back(other);
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    neighbours_.items.insert(neighbours_.items.end(), ring.begin(), ring.end());
    neighbours_.start.push_back(neighbours_.items.size());
  }
}

Vector3d MeshRings::normalAt(std::uint32_t vertex) const {
  Vector3d sum = Vector3d::Zero();
  for (const std::uint32_t t : trianglesAt(vertex)) {
    const auto& [a, b, c] = mesh_.triangles[t];
    sum += (mesh_.points[b] - mesh_.points[a]).cross(mesh_.points[c] - mesh_.points[a]);
  }
  const double length = sum.norm();
  return length > 0.0 ? Vector3d(sum / length) : Vector3d(Vector3d::Zero());
}

void MeshRings::around(std::uint32_t vertex, double reachMm, std::size_t least, int rings,
                       std::vector<char>& marks, std::vector<std::uint32_t>& found) const {
  found.assign(1, vertex);
  marks[vertex] = 1;
  const Vector3d& centre = mesh_.points[vertex];
  std::size_t first = 0;
  for (int ring = 1; first < found.size(); ++ring) {
    const std::size_t last = found.size();
    const bool whole = ring <= rings || last < least;
    for (std::size_t n = first; n < last; ++n)
      for (const std::uint32_t other : neighboursOf(found[n])) {
        if (marks[other] != 0) continue;
        if (!whole && (mesh_.points[other] - centre).squaredNorm() > reachMm * reachMm) continue;
        marks[other] = 1;
        found.push_back(other);
      }
    first = last;
  }
  for (const std::uint32_t v : found) marks[v] = 0;
}

std::optional<LocalQuadric> LocalQuadric::fit(const TriMesh& mesh,
                                              const std::vector<std::uint32_t>& found,
                                              const Vector3d& normal, bool graph) {
  const int terms = graph ? kGraphTerms : kTerms;
  if (found.size() < static_cast<std::size_t>(terms) + (graph ? 0 : 3) || normal.isZero())
    return std::nullopt;
  LocalQuadric quadric;
  quadric.origin_ = mesh.points[found.front()];
  quadric.axes_.col(2) = normal;
  quadric.axes_.col(0) = normal.unitOrthogonal();
  quadric.axes_.col(1) = normal.cross(quadric.axes_.col(0));
  double square = 0.0;
  for (const std::uint32_t v : found)
    square = std::max(square, (mesh.points[v] - quadric.origin_).squaredNorm());
  if (!(square > 0.0)) return std::nullopt;
  quadric.scale_ = std::sqrt(square);

  Eigen::Matrix<double, kTerms, kTerms> normalMatrix =
      Eigen::Matrix<double, kTerms, kTerms>::Zero();
  Terms right = Terms::Zero();
  for (const std::uint32_t v : found) {
    const Vector3d p = quadric.toLocal(mesh.points[v]);
    Terms row;
    row << 1.0, p[0], p[1], p[0] * p[0], p[0] * p[1], p[1] * p[1], p[2] * p[2], p[0] * p[2],
        p[1] * p[2];
    if (graph) row.tail<kTerms - kGraphTerms>().setZero();
    normalMatrix.noalias() += row * row.transpose();
    right += p[2] * row;
  }
  const auto count = static_cast<double>(found.size());
  for (int i = kGraphTerms; i < kTerms; ++i) normalMatrix(i, i) += graph ? 1.0 : kRidge * count;
  const Eigen::LDLT<Eigen::Matrix<double, kTerms, kTerms>> solver(normalMatrix);
  if (solver.info() != Eigen::Success ||
      solver.vectorD().head(terms).cwiseAbs().minCoeff() < 1e-14 * count)
    return std::nullopt;
  quadric.terms_ = solver.solve(right);
  if (!quadric.terms_.allFinite()) return std::nullopt;
  return quadric;
}

double LocalQuadric::valueAt(const Vector3d& p, Vector3d& gradient) const {
  const Terms& c = terms_;
  gradient[0] = -(c[1] + 2.0 * c[3] * p[0] + c[4] * p[1] + c[7] * p[2]);
  gradient[1] = -(c[2] + c[4] * p[0] + 2.0 * c[5] * p[1] + c[8] * p[2]);
  gradient[2] = 1.0 - (2.0 * c[6] * p[2] + c[7] * p[0] + c[8] * p[1]);
  return p[2] - (c[0] + p[0] * (c[1] + c[3] * p[0] + c[4] * p[1] + c[7] * p[2]) +
                 p[1] * (c[2] + c[5] * p[1] + c[8] * p[2]) + c[6] * p[2] * p[2]);
}

double LocalQuadric::distanceOf(const Vector3d& point) const {
  Vector3d gradient;
  const double value = valueAt(toLocal(point), gradient);
  return scale_ * value / std::max(gradient.norm(), 1e-6);
}

Vector3d LocalQuadric::foot(const Vector3d& point) const {
  Vector3d p = toLocal(point);
  for (int step = 0; step < 3; ++step) {
    Vector3d gradient;
    const double value = valueAt(p, gradient);
    p -= value / std::max(gradient.squaredNorm(), 1e-12) * gradient;
  }
  return origin_ + scale_ * (axes_ * p);
}

double LocalQuadric::meanCurvature() const {
  const double dx = terms_[1];
  const double dy = terms_[2];
  const double xx = 2.0 * terms_[3];
  const double xy = terms_[4];
  const double yy = 2.0 * terms_[5];
  const double steep = 1.0 + dx * dx + dy * dy;
  const double twice = (1.0 + dy * dy) * xx - 2.0 * dx * dy * xy + (1.0 + dx * dx) * yy;
  return -0.5 * twice / (steep * std::sqrt(steep)) / scale_;
}

}  // namespace angiomesh
