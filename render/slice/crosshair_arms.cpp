// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/crosshair_arms.h"

#include <vtkActor.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace angiomesh {

namespace {

using Eigen::Vector2d;

// Design pixels.
constexpr double kGap = 10.0;  // the spot itself stays visible
constexpr double kKnobRadius = 4.0, kShortestArm = 60.0;
constexpr double kKnobShare = 0.85;  // of the way from the spot to the arm's end
constexpr int kKnobSides = 16;

/// From which to which way along a line it lies in a rectangle; the second is less where it does
/// not.
std::array<double, 2> inside(const Vector2d& from, const Vector2d& along,
                             const CrosshairArms::Frame& frame) {
  double enters = -std::numeric_limits<double>::max();
  double leaves = -enters;
  for (int a = 0; a < 2; ++a) {
    const double low = frame.low[a] - from[a];
    const double high = frame.high[a] - from[a];
    if (std::abs(along[a]) < 1e-9) {
      if (low > 0.0 || high < 0.0) return {0.0, -1.0};
      continue;
    }
    enters = std::max(enters, std::min(low / along[a], high / along[a]));
    leaves = std::min(leaves, std::max(low / along[a], high / along[a]));
  }
  return {enters, leaves};
}

}  // namespace

CrosshairArms::CrosshairArms(vtkRenderer* renderer) {
  layer_.colour(0.95, 0.85, 0.25);
  layer_.actor->GetProperty()->SetOpacity(0.6);
  layer_.actor->VisibilityOff();
  renderer->AddActor(layer_.actor);
}

void CrosshairArms::hide() {
  layer_.actor->VisibilityOff();
  knobs_.clear();
}

void CrosshairArms::show(const Vector2d& centre, const std::array<Vector2d, 2>& along,
                         const Frame& frame, double depth) {
  const double pixel = frame.pixelRatio * frame.mmPerPixel;
  knobs_.clear();
  std::vector<std::array<Vector2d, 2>> segments;
  for (const Vector2d& line : along)
    for (const double side : {1.0, -1.0}) {
      const Vector2d way = side * line;
      const auto [enters, leaves] = inside(centre, way, frame);
      const double begin = std::max(enters, kGap * pixel);
      if (leaves < begin) continue;
      segments.push_back({Vector2d(centre + begin * way), Vector2d(centre + leaves * way)});
      if (enters <= 0.0 && leaves > kShortestArm * pixel)
        knobs_.emplace_back(centre + kKnobShare * leaves * way);
    }
  for (const Vector2d& knob : knobs_)
    for (int k = 0; k < kKnobSides; ++k) {
      const auto rim = [&](int n) {
        const double angle = 2.0 * std::numbers::pi * n / kKnobSides;
        return Vector2d(knob + kKnobRadius * pixel * Vector2d(std::cos(angle), std::sin(angle)));
      };
      segments.push_back({rim(k), rim(k + 1)});
    }
  layer_.setSegments(segments, depth);
  layer_.actor->GetProperty()->SetLineWidth(static_cast<float>(frame.pixelRatio));
  layer_.actor->VisibilityOn();
}

bool CrosshairArms::knobAt(const Vector2d& place, double reachMm) const {
  return std::any_of(knobs_.begin(), knobs_.end(),
                     [&](const Vector2d& knob) { return (place - knob).norm() <= reachMm; });
}

}  // namespace angiomesh
