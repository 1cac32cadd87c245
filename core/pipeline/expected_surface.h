// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/field/spline_field.h"
#include "core/openings/cut_away.h"
#include "core/parameters/parameters.h"
#include "core/pipeline/segments.h"
#include "core/pipeline/surface_step.h"
#include "core/sizing/guidance_field.h"

namespace angiomesh {

/// `size` is of `field`, `components` those of selectSegments() of the field's samples.
ExpectedSurface expectSurface(const SplineField& field, const GuidanceField& size,
                              const SurfaceParams& params,
                              const std::vector<SegmentComponent>& components,
                              const CutAway& away = {});

/// The same of all parts of phi, which `field` interpolates, with a size field of its own.
/// @throws Cancelled
ExpectedSurface expectSurface(const Volume<float>& phi, const SplineField& field,
                              const SurfaceParams& params, const Progress& progress = {},
                              const CutAway& away = {});

/// All parts of phi < 0; empty where there are none. @throws Cancelled
std::vector<SegmentComponent> allComponents(const Volume<float>& phi,
                                            const Progress& progress = {});

/// What surface.maxTriangles = auto allows.
struct SurfaceLimits {
  double bytes = 0.0;  ///< of memory
  double seconds = 1800.0;

  /// Of this machine.
  static SurfaceLimits ofMachine();
};

/// Why a surface is not to be begun, in one line with what to do next; empty when it may be.
std::optional<std::string> refusal(const ExpectedSurface& expected, const SurfaceParams& params,
                                   const SurfaceLimits& limits);

/// @throws InputError as refusal() has it
void checkExpected(const ExpectedSurface& expected, const SurfaceParams& params,
                   const SurfaceLimits& limits = SurfaceLimits::ofMachine());

/// Sentences for a wall so rough, or a surface so large, that something is likely to be wrong.
std::vector<std::string> warningsOf(const ExpectedSurface& expected);

/// "about 2.0 million", "about 190,000".
std::string aboutSoMany(double count);

}  // namespace angiomesh
