// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/contour/marching_cubes.h"
#include "core/corrections/correction.h"
#include "core/cuts/cuts.h"
#include "core/levelset/comparison_methods.h"
#include "core/levelset/evolution.h"
#include "core/levelset/seeds.h"
#include "core/lumen/lumen.h"
#include "core/lumen/smooth_wall.h"
#include "core/preprocess/preprocess.h"
#include "core/sizing/sizing.h"
#include "core/smooth/smoothing.h"
#include "core/surface/zero_set_mesh.h"
#include "core/topology/mask_contacts.h"
#include "core/vesselness/vesselness.h"

namespace angiomesh {

enum class KeepComponents { All, Largest, Seeded };

struct SegmentationParams {
  SegmentationMethod method = SegmentationMethod::LevelSet;  ///< of the step evolve
  int label = 1;  ///< of SegmentationMethod::Label: the value of the voxels that are vessel
  MaskConnectivity connectivity = MaskConnectivity::Corners;  ///< of its voxels
  KeepComponents keep = KeepComponents::All;
  double minVolumeMm3 = 0.0;
  double minLengthMm = 0.0;  ///< of the centre lines of a component
  std::vector<double>
      drop;  ///< x,y,z,... LPS mm: the components that hold these points are left out
  std::vector<std::string>
      corrections;  ///< by hand, in their order, as parseCorrection() takes them

  bool operator==(const SegmentationParams&) const = default;
};

struct SurfaceParams {
  SurfaceMethod method = SurfaceMethod::AdvancingFront;
  SplineKind spline = SplineKind::InterpolatingBspline;
  SizingParams sizing;      ///< of the methods that follow the size field
  double cellVoxels = 1.0;  ///< edge of a marching cubes cell, working voxels
  SurfaceBorder border = SurfaceBorder::Cap;
  double minComponentMm3 = 0.0;
  /// A surface of which more are expected is not begun; 0: any is. Empty: what memory and half an
  /// hour hold, see SurfaceLimits.
  std::optional<int> maxTriangles;

  bool operator==(const SurfaceParams&) const = default;
};

/// Everything that a run depends on besides its input.
struct Parameters {
  PreprocessParams preprocess;
  VesselnessParams vesselness;
  SeedParams seeds;
  LevelSetParams levelset;
  ThresholdParams thresholds;
  LumenParams lumen;
  SmoothWallParams wall;
  ComparisonParams comparison;
  SegmentationParams segmentation;
  PortParams ports;
  SurfaceParams surface;
  SmoothParams smooth;

  bool operator==(const Parameters&) const = default;
};

/// Whether the segmentation is a front that moves until it comes to rest.
bool evolves(const Parameters& params);

/// Whether the image is a segmentation, of which nothing but the step evolve and those after it
/// make anything.
bool isSegmented(const Parameters& params);

/// Relations between fields (sigmaMin <= sigmaMax, edgeMin <= edgeMax ...). @throws InputError
void validate(const Parameters& params);

/// `angiomesh`, `ct` (angiograms in HU) or `thesis`. @throws InputError
Parameters preset(std::string_view name);
const std::vector<std::string>& presetNames();

}  // namespace angiomesh
