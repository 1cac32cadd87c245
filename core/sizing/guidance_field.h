// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/field/spline_field.h"
#include "core/sizing/sizing.h"

namespace angiomesh {

struct CutAway;

/// The wanted edge length g(x) near the zero set (thesis eq. 4.1 to 4.3): the smallest, over sample
/// points s of the zero set, of (1 - 1/eta) |x - s| + l(s) / eta, l(s) = 2 sin(rho/2) /
/// kappa_max(s). A sample stands for the piece of the zero set around it, so |x - s| counts from
/// the edge of that piece: g does not rise between the samples of a surface of constant curvature.
/// Lipschitz with 1 - 1/eta; the same for any number of threads.
class GuidanceField {
 public:
  /// A point of the zero set and what its cone starts from.
  struct Sample {
    Eigen::Vector3d point;  ///< LPS mm
    double lengthMm;        ///< l(s)/eta (or l(s), see SizingParams), after all limits
    double reachMm;         ///< radius of the piece of the zero set that it stands for
    double areaMm2;         ///< area of that piece
  };

  /// Of the zero set without what `away` (may be null) takes. `field` must outlive the object.
  /// @throws Cancelled
  GuidanceField(const SplineField& field, const SizingParams& params, const Progress& progress = {},
                const CutAway* away = nullptr);
  ~GuidanceField();

  /// The wanted edge length at a point, mm. Constant time within about four voxels of the zero set;
  /// further away all samples are looked at.
  [[nodiscard]] double at(const Eigen::Vector3d& pointLps) const;

  /// The length that a curvature (1/mm, of the zero set or a curve on it) asks for by itself, mm,
  /// after the factor 1/eta and all limits but that of thickness.
  [[nodiscard]] double idealLength(double curvature) const;
  /// The same of the largest curvature at a point of the zero set.
  [[nodiscard]] double idealLength(const SplineField::SecondJet& jet) const;

  [[nodiscard]] const std::vector<Sample>& samples() const;

  /// The sum of area / (sqrt(3)/4 g^2) over the zero set: the triangles to expect, before meshing.
  [[nodiscard]] double estimatedTriangles() const;
  [[nodiscard]] double estimatedAreaMm2() const;

  /// 1 - 1/eta
  [[nodiscard]] double slope() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace angiomesh
