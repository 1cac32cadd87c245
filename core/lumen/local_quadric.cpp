// SPDX-License-Identifier: BSD-3-Clause
#include "core/lumen/local_quadric.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/base/simd.h"

namespace angiomesh {
namespace {

constexpr std::size_t kLanes = LocalQuadric::kLanes;
using Vector = float __attribute__((vector_size(4 * kLanes)));
using Powers = std::array<int, 3>;

/// Where the monomial x^p y^q z^r stands: 1; x y z; xx yy zz xy xz yz; and on by degree.
constexpr std::array<Powers, 35> kPowers{
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2},
     {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {3, 0, 0}, {2, 1, 0}, {2, 0, 1}, {1, 2, 0},
     {1, 1, 1}, {1, 0, 2}, {0, 3, 0}, {0, 2, 1}, {0, 1, 2}, {0, 0, 3}, {4, 0, 0},
     {3, 1, 0}, {3, 0, 1}, {2, 2, 0}, {2, 1, 1}, {2, 0, 2}, {1, 3, 0}, {1, 2, 1},
     {1, 1, 2}, {1, 0, 3}, {0, 4, 0}, {0, 3, 1}, {0, 2, 2}, {0, 1, 3}, {0, 0, 4}}};

constexpr std::size_t placeOf(const Powers& p) {
  for (std::size_t i = 0; i < kPowers.size(); ++i)
    if (kPowers[i] == p) return i;
  return kPowers.size();
}

/// Each monomial as a variable times one of lower degree.
struct Step {
  std::size_t from = 0, axis = 0;
};
constexpr std::array<Step, 35> steps() {
  std::array<Step, 35> list{};
  for (std::size_t i = 1; i < kPowers.size(); ++i)
    for (std::size_t a = 0; a < 3; ++a) {
      Powers lower = kPowers[i];
      if (lower[a] == 0) continue;
      --lower[a];
      list[i] = {placeOf(lower), a};
      break;
    }
  return list;
}
constexpr std::array<Step, 35> kSteps = steps();

/// The product of two terms as a monomial.
constexpr std::array<std::array<std::size_t, 10>, 10> products() {
  std::array<std::array<std::size_t, 10>, 10> table{};
  for (std::size_t i = 0; i < 10; ++i)
    for (std::size_t j = 0; j < 10; ++j) {
      Powers p{};
      for (std::size_t a = 0; a < 3; ++a) p[a] = kPowers[i][a] + kPowers[j][a];
      table[i][j] = placeOf(p);
    }
  return table;
}
constexpr std::array<std::array<std::size_t, 10>, 10> kProducts = products();
/// The terms of y.C y / 2 that are squares have a factor of a half.
constexpr std::array<double, 10> kFactor{1, 1, 1, 1, 0.5, 0.5, 0.5, 1, 1, 1};
/// Which entry of C stands in row a, column b.
constexpr std::array<std::array<std::size_t, 3>, 3> kEntry{{{4, 7, 8}, {7, 5, 9}, {8, 9, 6}}};

Vector& vectorOf(std::array<float, kLanes>& lanes) {
  return *reinterpret_cast<Vector*>(lanes.data());
}

ANGIOMESH_SIMD void addBlock(std::array<float, kLanes>* at, std::array<float, kLanes>* normal,
                             std::array<float, kLanes>& weight, std::array<float, kLanes>& target,
                             std::array<float, kLanes>* moments, std::array<float, kLanes>* targets,
                             std::array<float, kLanes>* normals) {
  Vector y[3], monomial[35];
  for (int a = 0; a < 3; ++a) y[a] = vectorOf(at[a]);
  monomial[0] = vectorOf(weight);
  for (std::size_t i = 1; i < 35; ++i) monomial[i] = monomial[kSteps[i].from] * y[kSteps[i].axis];
  for (std::size_t i = 0; i < 35; ++i) vectorOf(moments[i]) += monomial[i];
  for (std::size_t i = 0; i < 10; ++i) vectorOf(targets[i]) += monomial[i] * vectorOf(target);
  for (std::size_t a = 0; a < 3; ++a) {
    const Vector n = vectorOf(normal[a]);
    vectorOf(normals[a]) += monomial[0] * n;
    for (std::size_t b = 0; b < 3; ++b) vectorOf(normals[3 + 3 * a + b]) += monomial[1 + b] * n;
  }
}

double total(const std::array<float, kLanes>& lanes) {
  double sum = 0.0;
  for (const float x : lanes) sum += static_cast<double>(x);
  return sum;
}

}  // namespace

void LocalQuadric::sum() {
  for (std::size_t lane = used_; lane < kLanes; ++lane) weight_[lane] = 0.0F;
  addBlock(at_.data(), normal_.data(), weight_, target_, moments_.data(), targets_.data(),
           normals_.data());
  used_ = 0;
}

LocalQuadric::Fit LocalQuadric::solve(double steadiness) {
  if (used_ > 0) sum();
  std::array<double, kMoments> m{};
  for (std::size_t i = 0; i < kMoments; ++i) m[i] = total(moments_[i]);
  Fit fit;
  fit.weight = m[0];
  if (!(m[0] > 0.0)) return fit;
  using Matrix = Eigen::Matrix<double, kTerms, kTerms>;
  using Terms = Eigen::Matrix<double, kTerms, 1>;
  Matrix a;
  Terms b;
  for (std::size_t i = 0; i < kTerms; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t j = 0; j < kTerms; ++j)
      a(row, static_cast<Eigen::Index>(j)) = kFactor[i] * kFactor[j] * m[kProducts[i][j]];
    b[row] = kFactor[i] * total(targets_[i]);
  }
  // The gradient's part along axis k is b_k + sum C_kj y_j, over the unit.
  const double s = steadiness / (unit_ * unit_);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto linear = static_cast<Eigen::Index>(1 + k);
    const double along = total(normals_[k]);
    a(linear, linear) += s * m[0];
    b[linear] += s * unit_ * along;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto entry = static_cast<Eigen::Index>(kEntry[k][j]);
      a(linear, entry) += s * m[1 + j];
      a(entry, linear) += s * m[1 + j];
      b[entry] += s * unit_ * total(normals_[3 + 3 * k + j]);
      for (std::size_t l = 0; l < 3; ++l)
        a(entry, static_cast<Eigen::Index>(kEntry[k][l])) += s * m[kProducts[1 + j][1 + l]];
    }
  }
  // On a plane or a cylinder some quadrics vanish: the smallest of them.
  constexpr double ridge = 1e-5;
  for (Eigen::Index i = 1; i < kTerms; ++i) a(i, i) += ridge * m[0];
  const Terms q = a.ldlt().solve(b);
  const Eigen::Vector3d gradient = q.segment<3>(1) / unit_;
  const double slope = gradient.norm();
  if (!(slope > 0.3)) return fit;
  Eigen::Matrix3d hessian;
  for (Eigen::Index k = 0; k < 3; ++k)
    for (Eigen::Index j = 0; j < 3; ++j)
      hessian(k, j) = q[static_cast<Eigen::Index>(
                          kEntry[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)])] /
                      (unit_ * unit_);
  const Eigen::Vector3d n = gradient / slope;
  const double bend = n.dot(hessian * n);
  double t = -q[0] / slope;
  for (int i = 0; i < 4; ++i) t = -(q[0] + 0.5 * bend * t * t) / slope;
  if (!std::isfinite(t)) return fit;
  const Eigen::Matrix3d tangent = Eigen::Matrix3d::Identity() - n * n.transpose();
  const Eigen::Matrix3d shape = tangent * hessian * tangent / std::max(slope + bend * t, 0.3);
  fit.found = true;
  fit.offset = t;
  fit.mean = shape.trace();
  fit.gauss = 0.5 * (fit.mean * fit.mean - (shape * shape).trace());
  return fit;
}

}  // namespace angiomesh
