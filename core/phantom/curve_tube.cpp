// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/curve_tube.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiomesh {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr std::size_t kSamples = 8;  // of each piece, where the nearest place is looked for
constexpr int kNewtonSteps = 8;

/// The second derivatives of the natural cubic spline through values at 0, 1, 2, ...
std::vector<Vector4d> secondDerivatives(const std::vector<Vector4d>& values) {
  const std::size_t n = values.size();
  std::vector<Vector4d> second(n, Vector4d::Zero());
  std::vector<double> upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double pivot = 4.0 - upper[i - 1];
    upper[i] = 1.0 / pivot;
    second[i] = (6.0 * (values[i + 1] - 2.0 * values[i] + values[i - 1]) - second[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) second[i] -= upper[i] * second[i + 1];
  return second;
}

}  // namespace

CurveTube::CurveTube(const std::vector<Vector3d>& points, const std::vector<double>& radii) {
  std::vector<Vector4d> values;
  for (std::size_t i = 0; i < points.size(); ++i)
    values.emplace_back(points[i][0], points[i][1], points[i][2], radii[i]);
  const std::vector<Vector4d> second = secondDerivatives(values);
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    Piece piece;
    piece.a = values[i];
    piece.b = values[i + 1] - values[i] - (2.0 * second[i] + second[i + 1]) / 6.0;
    piece.c = 0.5 * second[i];
    piece.d = (second[i + 1] - second[i]) / 6.0;
    pieces_.push_back(piece);
  }
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    Piece& piece = pieces_[i];
    piece.middle = centreAt(static_cast<double>(i) + 0.5);
    for (std::size_t k = 0; k <= kSamples; ++k) {
      const double s = static_cast<double>(k) / kSamples;
      const Ball ball = piece.a + s * (piece.b + s * (piece.c + s * piece.d));
      if (k < kSamples || i + 1 == pieces_.size()) samples_.push_back(ball);
      piece.reach = std::max(piece.reach, (ball.head<3>() - piece.middle).norm() + ball[3]);
    }
  }
}

std::size_t CurveTube::pieceAt(double t, double& s) const {
  const double last = static_cast<double>(pieces_.size()) - 1.0;
  const double piece = std::clamp(std::floor(t), 0.0, last);
  s = t - piece;
  return static_cast<std::size_t>(piece);
}

Vector3d CurveTube::centreAt(double t) const {
  double s = 0.0;
  const Piece& p = pieces_[pieceAt(t, s)];
  return (p.a + s * (p.b + s * (p.c + s * p.d))).head<3>();
}

double CurveTube::radiusAt(double t) const {
  double s = 0.0;
  const Piece& p = pieces_[pieceAt(t, s)];
  return p.a[3] + s * (p.b[3] + s * (p.c[3] + s * p.d[3]));
}

Vector3d CurveTube::tangentAt(double t) const {
  double s = 0.0;
  const Piece& p = pieces_[pieceAt(t, s)];
  const Vector3d tangent = (p.b + s * (2.0 * p.c + 3.0 * s * p.d)).head<3>();
  return tangent / tangent.norm();
}

/// The least distance to the balls near the parameter t, by Newton.
double CurveTube::refined(const Vector3d& point, double t) const {
  constexpr double limit = 1.0 / kSamples;
  double best = std::numeric_limits<double>::max();
  for (int step = 0; step <= kNewtonSteps; ++step) {
    double s = 0.0;
    const Piece& p = pieces_[pieceAt(t, s)];
    const Ball ball = p.a + s * (p.b + s * (p.c + s * p.d));
    const Vector3d u = point - ball.head<3>();
    const double distance = u.norm();
    best = std::min(best, distance - ball[3]);
    if (distance < 1e-12 || step == kNewtonSteps) break;
    const Ball first = p.b + s * (2.0 * p.c + 3.0 * s * p.d);
    const Ball second = 2.0 * p.c + 6.0 * s * p.d;
    const double along = u.dot(first.head<3>()) / distance;
    const double slope = -along - first[3];
    const double bend =
        (first.head<3>().squaredNorm() - u.dot(second.head<3>()) - along * along) / distance -
        second[3];
    const double move = bend > 0.0 ? std::clamp(-slope / bend, -limit, limit)
                                   : (slope > 0.0 ? -limit : limit) / 4.0;
    const double next = std::clamp(t + move, 0.0, length());
    if (std::fabs(next - t) < 1e-13) break;
    t = next;
  }
  return best;
}

double CurveTube::signedDistance(const Vector3d& point) const {
  double best = std::numeric_limits<double>::max();
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if ((point - pieces_[i].middle).norm() - pieces_[i].reach > best) continue;
    for (std::size_t k = i * kSamples; k <= (i + 1) * kSamples; ++k) {
      const double d = (point - samples_[k].head<3>()).norm() - samples_[k][3];
      if (d >= best) continue;
      best = d;
      nearest = k;
    }
  }
  return std::min(best, refined(point, static_cast<double>(nearest) / kSamples));
}

}  // namespace angiomesh
