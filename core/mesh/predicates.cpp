// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/predicates.h"

#include <cmath>
#include <cstddef>

namespace angiomesh {
namespace {

constexpr double epsilon = 1.1102230246251565e-16;  // 2^-53, half a unit in the last place of 1

// An unevaluated sum of doubles, smallest first, no two of which overlap (Shewchuk 1997, section
// 2); zeros are left out.
template <std::size_t Capacity>
struct Expansion {
  double part[Capacity];
  std::size_t count = 0;

  void push(double value) {
    if (value != 0.0) part[count++] = value;
  }
  [[nodiscard]] int sign() const { return count == 0 ? 0 : part[count - 1] > 0.0 ? 1 : -1; }
};

struct SumAndError {
  double sum, error;
};

SumAndError twoSum(double a, double b) {
  const double sum = a + b;
  const double bVirtual = sum - a;
  return {sum, (a - (sum - bVirtual)) + (b - bVirtual)};
}

SumAndError twoProduct(double a, double b) {
  // Dekker's splitting: fma() is no faster where the processor lacks it.
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const auto split = [](double x) {
    const double c = splitter * x;
    const double high = c - (c - x);
    return SumAndError{high, x - high};
  };
  const double product = a * b;
  const auto [aHigh, aLow] = split(a);
  const auto [bHigh, bLow] = split(b);
  const double error = ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow;
  return {product, error};
}

Expansion<2> difference(double a, double b) {
  const auto [sum, error] = twoSum(a, -b);
  Expansion<2> result;
  result.push(error);
  result.push(sum);
  return result;
}

// Shewchuk's FAST-EXPANSION-SUM with zeros left out.
template <std::size_t N, std::size_t M>
Expansion<N + M> operator+(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<N + M> result;
  std::size_t i = 0, j = 0;
  const auto next = [&] {
    const bool takeE = j == f.count || (i < e.count && std::abs(e.part[i]) < std::abs(f.part[j]));
    return takeE ? e.part[i++] : f.part[j++];
  };
  if (e.count + f.count == 0) return result;
  double sum = next();
  while (i < e.count || j < f.count) {
    const SumAndError s = twoSum(sum, next());
    result.push(s.error);
    sum = s.sum;
  }
  result.push(sum);
  return result;
}

template <std::size_t N>
Expansion<N> operator-(Expansion<N> e) {
  for (std::size_t i = 0; i < e.count; ++i) e.part[i] = -e.part[i];
  return e;
}

// Shewchuk's SCALE-EXPANSION with zeros left out.
template <std::size_t N>
Expansion<2 * N> scaled(const Expansion<N>& e, double factor) {
  Expansion<2 * N> result;
  if (e.count == 0) return result;
  const SumAndError first = twoProduct(e.part[0], factor);
  result.push(first.error);
  double sum = first.sum;
  for (std::size_t i = 1; i < e.count; ++i) {
    const SumAndError product = twoProduct(e.part[i], factor);
    const SumAndError low = twoSum(sum, product.error);
    result.push(low.error);
    const SumAndError high = twoSum(product.sum, low.sum);
    result.push(high.error);
    sum = high.sum;
  }
  result.push(sum);
  return result;
}

template <std::size_t N>
Expansion<4 * N> operator*(const Expansion<N>& e, const Expansion<2>& f) {
  Expansion<2 * N> low, high;
  if (f.count > 0) low = scaled(e, f.part[0]);
  if (f.count > 1) high = scaled(e, f.part[1]);
  return low + high;
}

int exactOrient2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const auto left = difference(a.x(), c.x()) * difference(b.y(), c.y());
  const auto right = difference(a.y(), c.y()) * difference(b.x(), c.x());
  return (left + -right).sign();
}

int exactDeterminant(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                     const Eigen::Vector3d& origin) {
  const auto from = [&](const Eigen::Vector3d& p, int axis) {
    return difference(p[axis], origin[axis]);
  };
  const auto minor = [&](int i, int j) {
    return from(b, i) * from(c, j) + -(from(b, j) * from(c, i));
  };
  const auto x = minor(1, 2) * from(a, 0);
  const auto y = minor(2, 0) * from(a, 1);
  const auto z = minor(0, 1) * from(a, 2);
  return (x + y + z).sign();
}

}  // namespace

int orient2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double det = left - right;
  const double bound = (3.0 + 16.0 * epsilon) * epsilon * (std::abs(left) + std::abs(right));
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return exactOrient2d(a, b, c);
}

int orient3d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
             const Eigen::Vector3d& d) {
  const Eigen::Vector3d p = b - a, q = c - a, r = d - a;
  const double yz = q.y() * r.z(), zy = q.z() * r.y();
  const double zx = q.z() * r.x(), xz = q.x() * r.z();
  const double xy = q.x() * r.y(), yx = q.y() * r.x();
  const double det = p.x() * (yz - zy) + p.y() * (zx - xz) + p.z() * (xy - yx);
  const double permanent = std::abs(p.x()) * (std::abs(yz) + std::abs(zy)) +
                           std::abs(p.y()) * (std::abs(zx) + std::abs(xz)) +
                           std::abs(p.z()) * (std::abs(xy) + std::abs(yx));
  const double bound = (7.0 + 56.0 * epsilon) * epsilon * permanent;
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return exactDeterminant(b, c, d, a);
}

}  // namespace angiomesh
