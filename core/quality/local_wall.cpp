// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/local_wall.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr double kLeastRidge = 1e-8;  // of sums of squares of n points: coarse tubes have few rows
/// The size that the coefficients of terms with z have on vessels, in units of the farthest point.
constexpr double kHeightTerm = 0.5;
constexpr int kRidgeSteps = 4;

template <class Solver>
bool usable(const Solver& solver, double count) {
  return solver.info() == Eigen::Success && solver.vectorD().cwiseAbs().minCoeff() > 1e-14 * count;
}

}  // namespace

MeshRings::MeshRings(const TriMesh& mesh, const std::vector<char>& counts) : mesh_(mesh) {
  const auto counted = [&](std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return (counts.empty() || counts[t] != 0) && a != b && b != c && c != a;
  };
  const std::size_t vertices = mesh.points.size();
  start_.assign(vertices + 1, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (counted(t))
      for (const std::uint32_t v : mesh.triangles[t]) ++start_[v + 1];
  for (std::size_t v = 0; v < vertices; ++v) start_[v + 1] += start_[v];
  items_.resize(start_[vertices]);
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (counted(t))
      for (const std::uint32_t v : mesh.triangles[t])
        items_[next[v]++] = static_cast<std::uint32_t>(t);
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
      for (const std::uint32_t t : trianglesAt(found[n]))
        for (const std::uint32_t other : mesh_.triangles[t]) {
          if (marks[other] != 0) continue;
          if (!whole && (mesh_.points[other] - centre).squaredNorm() > reachMm * reachMm) continue;
          marks[other] = 1;
          found.push_back(other);
        }
    first = last;
  }
  for (const std::uint32_t v : found) marks[v] = 0;
}

std::optional<LocalWall> LocalWall::fit(const TriMesh& mesh,
                                        const std::vector<std::uint32_t>& found,
                                        const Vector3d& normal, bool graph) {
  const int terms = graph ? kGraphTerms : kTerms;
  if (found.size() < static_cast<std::size_t>(terms) + (graph ? 0 : 5) || normal.isZero())
    return std::nullopt;
  LocalWall wall;
  wall.origin_ = mesh.points[found.front()];
  wall.axes_.col(2) = normal;
  wall.axes_.col(0) = normal.unitOrthogonal();
  wall.axes_.col(1) = normal.cross(wall.axes_.col(0));
  double square = 0.0;
  for (const std::uint32_t v : found)
    square = std::max(square, (mesh.points[v] - wall.origin_).squaredNorm());
  if (!(square > 0.0)) return std::nullopt;
  wall.scale_ = std::sqrt(square);

  using Square = Eigen::Matrix<double, kTerms, kTerms>;
  Square matrix = Square::Zero();
  Terms right = Terms::Zero();
  std::vector<Vector3d> local;
  local.reserve(found.size());
  for (const std::uint32_t v : found) {
    local.push_back(wall.toLocal(mesh.points[v]));
    const Vector3d& p = local.back();
    const double xx = p[0] * p[0];
    const double xy = p[0] * p[1];
    const double yy = p[1] * p[1];
    Terms row;
    row << 1.0, p[0], p[1], xx, xy, yy, xx * p[0], xx * p[1], p[0] * yy, yy * p[1], p[2] * p[2],
        p[0] * p[2], p[1] * p[2], xx * p[2], xy * p[2], yy * p[2];
    if (graph) row.tail<kTerms - kGraphTerms>().setZero();
    matrix.noalias() += row * row.transpose();
    right += p[2] * row;
  }
  const auto count = static_cast<double>(found.size());
  for (int i = kGraphTerms; i < kTerms; ++i) matrix(i, i) += graph ? 1.0 : kLeastRidge * count;
  if (graph) {
    const Eigen::LDLT<Square> solver(matrix);
    if (!usable(solver, count)) return std::nullopt;
    wall.terms_ = solver.solve(right);
    if (!wall.terms_.allFinite()) return std::nullopt;
    return wall;
  }
  // A ridge of the noise's variance over that of the coefficients (Hoerl and Kennard 1970) keeps
  // the terms with z from following the noise of a flat wall, where z is nearly 0.
  double ridge = 1e6;
  for (int step = 0; step < kRidgeSteps; ++step) {
    Square held = matrix;
    for (int i = kCubicTerms; i < kTerms; ++i) held(i, i) += ridge;
    const Eigen::LDLT<Square> solver(held);
    if (!usable(solver, count)) return std::nullopt;
    wall.terms_ = solver.solve(right);
    if (!wall.terms_.allFinite()) return std::nullopt;
    double sum = 0.0;
    for (const Vector3d& p : local) {
      Vector3d gradient;
      const double value = wall.valueAt(p, gradient);
      sum += value * value / std::max(gradient.squaredNorm(), 0.25);
    }
    double used = kTerms;  // degrees of freedom: the trace of the fit's projection
    for (int i = kCubicTerms; i < kTerms; ++i) used -= ridge * solver.solve(Terms::Unit(i))[i];
    const double variance = sum / std::max(1.0, count - used);
    wall.spreadMm_ = wall.scale_ * std::sqrt(variance);
    ridge = variance / (kHeightTerm * kHeightTerm);
  }
  return wall;
}

double LocalWall::valueAt(const Vector3d& p, Vector3d& gradient) const {
  const Terms& c = terms_;
  const double x = p[0];
  const double y = p[1];
  const double z = p[2];
  gradient[0] = -(c[1] + 2.0 * c[3] * x + c[4] * y + 3.0 * c[6] * x * x + 2.0 * c[7] * x * y +
                  c[8] * y * y + z * (c[11] + 2.0 * c[13] * x + c[14] * y));
  gradient[1] = -(c[2] + c[4] * x + 2.0 * c[5] * y + c[7] * x * x + 2.0 * c[8] * x * y +
                  3.0 * c[9] * y * y + z * (c[12] + c[14] * x + 2.0 * c[15] * y));
  const double withHeight = c[11] * x + c[12] * y + c[13] * x * x + c[14] * x * y + c[15] * y * y;
  gradient[2] = 1.0 - 2.0 * c[10] * z - withHeight;
  const double linear = c[0] + c[1] * x + c[2] * y;
  const double square = c[3] * x * x + c[4] * x * y + c[5] * y * y;
  const double cubic = x * x * (c[6] * x + c[7] * y) + y * y * (c[8] * x + c[9] * y);
  return z - (linear + square + cubic + z * (c[10] * z + withHeight));
}

Vector3d LocalWall::foot(const Vector3d& point) const {
  Vector3d p = toLocal(point);
  for (int step = 0; step < 3; ++step) {
    Vector3d gradient;
    const double value = valueAt(p, gradient);
    p -= value / std::max(gradient.squaredNorm(), 1e-12) * gradient;
  }
  return origin_ + scale_ * (axes_ * p);
}

double LocalWall::meanCurvature() const {
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
