// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/field/spline_field.h"
#include "core/sizing/guidance_field.h"

namespace angiomesh {

/// A point that the front has reached.
struct FrontPoint {
  Eigen::Vector3d point{0.0, 0.0, 0.0};   ///< LPS mm
  Eigen::Vector3d normal{0.0, 0.0, 1.0};  ///< outward, unit
  double length = 0.0;                    ///< wanted edge length there, mm
};

/// The corner of a new triangle on the base a -> b, before it lies on the surface: at `along` mm
/// from a on the base line and `height` mm to the left of it.
struct ApexWish {
  double along = 0.0, height = 0.0;
};

/// What an advancing front grows on.
class FrontSurface {
 public:
  virtual ~FrontSurface() = default;

  /// Turns the wished corner about the base until it lies on the surface, so that both new edges
  /// keep their lengths. False where there is no surface within a turn of 60 degrees or its normal
  /// differs from the base's by more than 72 degrees.
  [[nodiscard]] virtual bool turn(const FrontPoint& a, const FrontPoint& b, const ApexWish& wish,
                                  FrontPoint& apex) const = 0;

  /// The wanted edge length near the surface, mm.
  [[nodiscard]] virtual double lengthAt(const Eigen::Vector3d& point) const = 0;

  /// By how much the wanted length may change per mm.
  [[nodiscard]] virtual double slope() const = 0;

 protected:
  FrontSurface() = default;
  FrontSurface(const FrontSurface&) = default;
  FrontSurface& operator=(const FrontSurface&) = default;
};

/// phi = 0. Field and sizes must outlive it.
class WallSurface : public FrontSurface {
 public:
  WallSurface(const SplineField& field, const GuidanceField& size) : field_(field), size_(size) {}
  [[nodiscard]] bool turn(const FrontPoint& a, const FrontPoint& b, const ApexWish& wish,
                          FrontPoint& apex) const override;
  [[nodiscard]] double lengthAt(const Eigen::Vector3d& point) const override;
  [[nodiscard]] double slope() const override { return size_.slope(); }
  /// The nearest point of phi = 0 to a point close to it; false when there is none.
  [[nodiscard]] bool settle(const Eigen::Vector3d& near, FrontPoint& point) const;

 private:
  const SplineField& field_;
  const GuidanceField& size_;
};

/// The part of a border plane where phi < 0: a cap. Field and sizes must outlive it.
class CapSurface : public FrontSurface {
 public:
  CapSurface(const SplineField& field, const GuidanceField& size) : field_(field), size_(size) {}
  [[nodiscard]] bool turn(const FrontPoint& a, const FrontPoint& b, const ApexWish& wish,
                          FrontPoint& apex) const override;
  [[nodiscard]] double lengthAt(const Eigen::Vector3d& point) const override {
    return size_.at(point);
  }
  [[nodiscard]] double slope() const override { return size_.slope(); }

 private:
  const SplineField& field_;
  const GuidanceField& size_;
};

}  // namespace angiomesh
