// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/facing_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/field/cell_bounds.h"
#include "core/mesh/triangle_shape.h"
#include "core/mesh/triangle_tree.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

// The region around a triangle in which the gradient must not turn away from its normal.
struct Region {
  Vector3d centre, normal;
  double radius = 0.0;  // mm
  double gap = 0.0;     // how far it goes beyond the triangle, mm
  double along = 0.0;   // the gradient's part along the normal, at the centre
  Vector3d low, high;   // its box in index space, inside the grid
  Index3 first{}, last{};
};

// What of a region takes the field to know; the rest is made anew where it is needed, as a region
// takes more memory than all else that a triangle has.
struct Slope {
  double along = 0.0, gap = 0.0;
};

enum class Verdict : std::uint8_t { Faces, Open, TurnsAway };

constexpr int kDeepest = 5;
constexpr std::size_t kMostPieces = 1500;

// A part of the region's box inside one cell, in index space.
struct Piece {
  Index3 cell{};
  Vector3d low, high;
  int depth = 0;
};

class FacingCheck {
 public:
  FacingCheck(const PatchMesh& mesh, const SplineField& field) : mesh_(mesh), field_(field) {
    const Eigen::Matrix3d toIndex = field.geometry().physicalToIndexMatrix();
    for (int a = 0; a < 3; ++a) indexPerMm_[a] = toIndex.row(a).norm();
  }

  std::vector<TurnedFace> run(const Progress& progress) {
    const std::size_t n = mesh_.mesh.triangles.size();
    std::vector<Slope> slopes(n);
    parallelForEach(n, 1024, progress, [&](std::size_t t) {
      if (mesh_.patch[t] == 0) slopes[t] = slopeOf(t);
    });
    boundCells(slopes, progress);
    constexpr std::size_t grain = 512;
    std::vector<std::vector<TurnedFace>> parts((n + grain - 1) / grain);
    parallelFor(0, n, grain, [&](std::size_t first, std::size_t last) {
      progress.check();
      for (std::size_t t = first; t < last; ++t)
        if (mesh_.patch[t] == 0) look(t, regionOf(t, slopes[t]), parts[first / grain]);
    });
    std::vector<TurnedFace> turned;
    for (const auto& part : parts) turned.insert(turned.end(), part.begin(), part.end());
    return turned;
  }

 private:
  void look(std::size_t t, const Region& region, std::vector<TurnedFace>& turned) const {
    if (plainlyFaces(region)) return;
    TurnedFace face;
    const Verdict verdict = faces(t, region, face);
    if (verdict == Verdict::Faces) return;
    face.triangle = static_cast<std::uint32_t>(t);
    face.measured = verdict == Verdict::TurnsAway;
    turned.push_back(face);
  }

  [[nodiscard]] Region faceOf(std::size_t t) const {
    const auto [a, b, c] = cornersOf(mesh_.mesh, static_cast<std::uint32_t>(t));
    Region r;
    r.centre = (a + b + c) / 3.0;
    const Vector3d normal = (b - a).cross(c - a);
    if (normal.norm() > 0.0)
      r.normal = normal.normalized();
    else
      r.normal.setZero();
    return r;
  }

  [[nodiscard]] Slope slopeOf(std::size_t t) const {
    const Region r = faceOf(t);
    const SplineField::Jet jet = field_.at(r.centre);
    const double slope = jet.gradient.norm();
    // Twice the distance to the foot, to first order, allows for the other points' feet.
    return {jet.gradient.dot(r.normal), slope > 1e-12 ? std::min(2.0 * std::fabs(jet.value) / slope,
                                                                 field_.geometry().voxelMm())
                                                      : 0.0};
  }

  [[nodiscard]] Region regionOf(std::size_t t, const Slope& slope) const {
    const auto [a, b, c] = cornersOf(mesh_.mesh, static_cast<std::uint32_t>(t));
    Region r = faceOf(t);
    r.along = slope.along;
    r.gap = slope.gap;
    r.radius =
        r.gap + std::max({(a - r.centre).norm(), (b - r.centre).norm(), (c - r.centre).norm()});
    const Geometry& g = field_.geometry();
    const Vector3d i0 = g.toIndex(a), i1 = g.toIndex(b), i2 = g.toIndex(c);
    const Vector3d margin = r.gap * indexPerMm_;
    r.low = i0.cwiseMin(i1).cwiseMin(i2) - margin;
    r.high = i0.cwiseMax(i1).cwiseMax(i2) + margin;
    for (int axis = 0; axis < 3; ++axis) {
      const auto s = static_cast<std::size_t>(axis);
      r.low[axis] = std::clamp(r.low[axis], 0.0, g.size[s] - 1.0);
      r.high[axis] = std::clamp(r.high[axis], 0.0, g.size[s] - 1.0);
      r.first[s] = std::min(static_cast<int>(r.low[axis]), g.size[s] - 2);
      r.last[s] = std::min(static_cast<int>(r.high[axis]), g.size[s] - 2);
    }
    return r;
  }

  template <class Visit>
  static void forEachCell(const Region& r, Visit visit) {
    for (int k = r.first[2]; k <= r.last[2]; ++k)
      for (int j = r.first[1]; j <= r.last[1]; ++j)
        for (int i = r.first[0]; i <= r.last[0]; ++i) visit(Index3{i, j, k});
  }

  void boundCells(const std::vector<Slope>& slopes, const Progress& progress) {
    const Geometry& g = field_.geometry();
    std::vector<bool> met(g.voxelCount(), false);
    for (std::size_t t = 0; t < slopes.size(); ++t)
      if (mesh_.patch[t] == 0)
        forEachCell(regionOf(t, slopes[t]),
                    [&](const Index3& c) { met[g.offset(c[0], c[1], c[2])] = true; });
    for (std::size_t i = 0; i < met.size(); ++i)
      if (met[i]) cells_.push_back(i);
    bounds_.resize(cells_.size());
    parallelForEach(cells_.size(), 256, progress, [&](std::size_t i) {
      bounds_[i] = static_cast<float>(hessianBound(field_, g.indexOf(cells_[i])) * (1.0 + 1e-6));
    });
  }

  // Whether bounds over the cells, then over the triangle's box in them, are enough.
  [[nodiscard]] bool plainlyFaces(const Region& r) const {
    const Geometry& g = field_.geometry();
    if (!(r.along > 0.0)) return false;
    bool sure = true;
    forEachCell(r, [&](const Index3& c) {
      if (!sure) return;
      const auto at = std::lower_bound(cells_.begin(), cells_.end(), g.offset(c[0], c[1], c[2]));
      const double bound =
          static_cast<double>(bounds_[static_cast<std::size_t>(at - cells_.begin())]);
      if (bound * r.radius < r.along) return;
      sure = hessianBound(field_, c, r.low, r.high) * r.radius < r.along;
    });
    return sure;
  }

  // Measures at a point of the region. False where the field turns away.
  bool measure(const Vector3d& point, const Region& r, TurnedFace& face) const {
    const Vector3d gradient = field_.at(point).gradient;
    const bool flat = !(gradient.norm() > 1e-12);
    const double cosine = gradient.dot(r.normal);
    face.degrees =
        std::max(face.degrees, flat ? 90.0 : angleDegrees(gradient.cross(r.normal).norm(), cosine));
    return !flat && cosine > 0.0;
  }

  // Divides the region's box, but for what is too far from the triangle, until a bound over each
  // piece or a point in one decides.
  Verdict faces(std::size_t t, const Region& r, TurnedFace& face) const {
    const std::array<Vector3d, 3> corner = cornersOf(mesh_.mesh, static_cast<std::uint32_t>(t));
    bool faces = !r.normal.isZero() && measure(r.centre, r, face);
    for (std::size_t k = 0; k < 3 && !r.normal.isZero(); ++k) {
      faces = measure(corner[k], r, face) && faces;
      faces = measure(0.5 * (corner[k] + corner[(k + 1) % 3]), r, face) && faces;
    }
    if (!faces) return Verdict::TurnsAway;
    std::vector<Piece> pieces;
    forEachCell(r, [&](const Index3& c) {
      Piece piece{c, r.low, r.high, 0};
      for (int axis = 0; axis < 3; ++axis) {
        const double first = c[static_cast<std::size_t>(axis)];
        piece.low[axis] = std::clamp(r.low[axis], first, first + 1.0);
        piece.high[axis] = std::clamp(r.high[axis], first, first + 1.0);
      }
      pieces.push_back(piece);
    });
    for (std::size_t looked = 0; !pieces.empty(); ++looked) {
      const Piece piece = pieces.back();
      pieces.pop_back();
      const Geometry& g = field_.geometry();
      const Vector3d middle = g.toPhysical(0.5 * (piece.low + piece.high));
      const Vector3d weights = closestWeights(corner, middle);
      const double away =
          (weights[0] * corner[0] + weights[1] * corner[1] + weights[2] * corner[2] - middle)
              .norm();
      const double reach = 0.5 * (piece.high - piece.low).cwiseProduct(g.spacing).norm();
      if (away > r.gap + reach) continue;
      if (slopeBounds(field_, piece.cell, piece.low, piece.high, r.normal)[0] > 0.0) continue;
      if (away <= r.gap && !measure(middle, r, face)) return Verdict::TurnsAway;
      if (piece.depth == kDeepest || looked > kMostPieces) return Verdict::Open;
      divide(piece, pieces);
    }
    return Verdict::Faces;
  }

  static void divide(const Piece& piece, std::vector<Piece>& pieces) {
    const Vector3d middle = 0.5 * (piece.low + piece.high);
    for (int octant = 0; octant < 8; ++octant) {
      Piece part = piece;
      ++part.depth;
      for (int axis = 0; axis < 3; ++axis)
        ((octant >> axis & 1) != 0 ? part.low : part.high)[axis] = middle[axis];
      pieces.push_back(part);
    }
  }

  const PatchMesh& mesh_;
  const SplineField& field_;
  Vector3d indexPerMm_;
  std::vector<std::size_t> cells_;
  std::vector<float> bounds_;
};

}  // namespace

std::vector<TurnedFace> turnedFaces(const PatchMesh& mesh, const SplineField& field,
                                    const Progress& progress) {
  return FacingCheck(mesh, field).run(progress);
}

}  // namespace angiomesh
