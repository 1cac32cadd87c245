// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/image/volume.h"

namespace angiomesh {

/// Tensor-product cubics on the grid (thesis 4.2). `InterpolatingBspline` is the C2 cubic B-spline
/// whose coefficients are prefiltered so that it takes the voxel values (Unser 1999); `Bspline`
/// uses the voxel values as coefficients and so smooths; `CatmullRom` interpolates and is C1.
enum class SplineKind { InterpolatingBspline, Bspline, CatmullRom };

/// A volume as a smooth function of position; samples beyond the border are extrapolated linearly.
class SplineField {
 public:
  /// Copies what it needs of `samples`.
  SplineField(const Volume<float>& samples, SplineKind kind);

  struct Jet {
    double value;
    Eigen::Vector3d gradient;
  };

  /// Value and gradient in index space at a continuous index (clamped to the border).
  [[nodiscard]] Jet atIndex(const Eigen::Vector3d& index) const;

  /// Value and gradient (per mm, LPS) at a point in LPS mm.
  [[nodiscard]] Jet at(const Eigen::Vector3d& pointLps) const;

  /// The value alone, at about half the cost.
  [[nodiscard]] double valueAt(const Eigen::Vector3d& pointLps) const;

  struct SecondJet {
    double value;
    Eigen::Vector3d gradient;
    Eigen::Matrix3d hessian;
  };

  /// Value, gradient and Hessian (per mm, per mm^2, LPS) at a point in LPS mm, in one pass.
  [[nodiscard]] SecondJet secondAt(const Eigen::Vector3d& pointLps) const;

  /// The 4 x 4 x 4 samples (spline coefficients, or voxel values) that make up the cell between
  /// voxel `cell` and the next ones, x fastest; extrapolated beyond the border.
  void cellSamples(const Index3& cell, std::array<double, 64>& samples) const;

  /// The value at the centre of a voxel.
  [[nodiscard]] double atVoxel(int i, int j, int k) const;

  /// The values at the centres of the voxels (first..last, j, k), as atVoxel() has them.
  void atVoxels(int first, int last, int j, int k, float* values) const;

  /// Bounds of all values in the block of cells from voxel `first` to voxel `last` (each `last` at
  /// least one more than `first`): the hull of the coefficients that play a part, widened for
  /// Catmull-Rom by what its negative weights can add.
  [[nodiscard]] std::array<double, 2> bounds(const Index3& first, const Index3& last) const;

  [[nodiscard]] const Geometry& geometry() const { return geometry_; }
  [[nodiscard]] SplineKind kind() const { return kind_; }

  /// Moves `pointLps` to the zero set by Newton steps along the gradient of the moving point, each
  /// at most half a voxel, until |f| / |grad f| < 1e-6 voxel, or below 3e-4 voxel and one step
  /// more, which leaves less than 1e-6 unless the radius of curvature is below 1/20 voxel. Returns
  /// false (point as far as it got) when 50 steps do not suffice or it moved more than
  /// `reachVoxels` voxels.
  bool projectToZero(Eigen::Vector3d& pointLps, double reachVoxels = 3.0) const;

 private:
  Geometry geometry_;
  Eigen::Matrix3d toIndexMatrix_;
  SplineKind kind_;
  /// With one layer more before and one or more behind on each axis, extrapolated linearly, so that
  /// the four samples of any cell stand in a row.
  BigVector<float> coefficients_;
  std::size_t rowStride_ = 0;
  std::size_t layerStride_ = 0;

  template <int order>
  struct Place;
  template <int order>
  void place(const Eigen::Vector3d& index, Place<order>& p) const;
  void extrapolate();
};

struct PrincipalCurvatures {
  double k1 = 0.0;  ///< the greater one
  double k2 = 0.0;
  /// The one of greater magnitude, as a magnitude.
  [[nodiscard]] double maximal() const;
};

/// Curvatures of the level set through a point, from gradient and Hessian there: the eigenvalues of
/// P H P / |grad|, P the projection onto the tangent plane; per mm. Positive where the inside
/// (smaller values) is convex: 1/r twice on a ball. Both 0 where the gradient vanishes.
PrincipalCurvatures principalCurvatures(const SplineField::SecondJet& jet);

}  // namespace angiomesh
