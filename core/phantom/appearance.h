// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/base/progress.h"
#include "core/phantom/shape.h"

// What makes a phantom look like a scan without moving its walls.

namespace angiomesh {

/// @throws InputError for a drift, fade or noise that makes no sense
void checkAppearance(const PhantomParams& params);

/// The vessels' brightness, 1 at the proximal end down to fadePercent / 100 at every distal end.
/// Tree, CapsuleTree and VesselTree: along the centre lines from the roots, continuous at the
/// bifurcations and linear along the longest way; the remaining kinds: linear along the axis, over
/// the length of the centre lines (Torus: along a diameter, from wall to wall).
class VesselFade {
 public:
  VesselFade(const PhantomParams& params, const Shape& shape);
  [[nodiscard]] double at(const Eigen::Vector3d& point) const;

 private:
  void alongTree();
  void alongAxis(const Eigen::Vector3d& direction, double margin);

  std::vector<CentreLineSegment> lines_;
  std::vector<std::array<double, 2>> ends_;  ///< brightness at each line's ends; empty: by the axis
  Eigen::Vector3d direction_ = Eigen::Vector3d::UnitZ();
  double low_ = 0.0, high_ = 1.0;  ///< along direction_, mm
  double least_ = 1.0;
};

/// Multiplies by 1 + driftPercent / 100 sin(3/2 pi t), where t runs along a direction drawn by the
/// random seed, in parts of the volume's sides from its centre: both extremes lie inside the
/// volume, at t = +-1/3.
void addDrift(Volume<float>& image, const PhantomParams& params, const Progress& progress);

/// Gaussian: adds; Rician: the magnitude of a complex value with the same noise in both parts.
void addNoise(Volume<float>& image, const PhantomParams& params, const Progress& progress);

}  // namespace angiomesh
