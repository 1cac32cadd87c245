// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
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

  struct SecondJet {
    double value;
    Eigen::Vector3d gradient;
    Eigen::Matrix3d hessian;
  };

  /// Value, gradient and Hessian (per mm, per mm^2, LPS) at a point in LPS mm, in one pass.
  [[nodiscard]] SecondJet secondAt(const Eigen::Vector3d& pointLps) const;

  [[nodiscard]] const Geometry& geometry() const { return geometry_; }

  /// Moves `pointLps` to the zero set by Newton steps along the gradient of the moving point, each
  /// at most half a voxel, until |f| / |grad f| < 1e-6 voxel. Returns false (point as far as it
  /// got) when 50 steps do not suffice or it moved more than `reachVoxels` voxels.
  bool projectToZero(Eigen::Vector3d& pointLps, double reachVoxels = 3.0) const;

 private:
  Geometry geometry_;
  Eigen::Matrix3d toIndexMatrix_;
  SplineKind kind_;
  std::vector<float> coefficients_;
};

}  // namespace angiomesh
