// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/contour/marching_cubes.h"
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
  std::vector<double>
      drop;  ///< x,y,z,... LPS mm: the components that hold these points are left out
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
};

/// Everything that a run depends on besides its input.
struct Parameters {
  PreprocessParams preprocess;
  VesselnessParams vesselness;
  SeedParams seeds;
  LevelSetParams levelset;
  LumenParams lumen;
  SmoothWallParams wall;
  ComparisonParams comparison;
  SegmentationParams segmentation;
  PortParams ports;
  SurfaceParams surface;
  SmoothParams smooth;
};

/// Whether the segmentation is a front that moves until it comes to rest.
bool evolves(const Parameters& params);

/// Whether the image is a segmentation, of which nothing but the step evolve and those after it
/// make anything.
bool isSegmented(const Parameters& params);

/// A field's value: monostate stands for the field's empty word ("auto", "none").
using FieldValue = std::variant<std::monostate, bool, std::int64_t, double, std::string,
                                std::vector<double>, std::vector<std::string>>;
enum class FieldKind { Boolean, Integer, Real, Choice, Numbers, Texts };

/// The one description of a parameter: JSON, --set, GUI form, validation and documentation come
/// from it.
struct Field {
  std::string key;  ///< "vesselness.sigmaMinMm"
  FieldKind kind = FieldKind::Real;
  double minimum = 0.0, maximum = 0.0;  ///< inclusive, for Integer, Real and each of Numbers
  std::string unit;
  std::string help;                  ///< one line
  std::vector<std::string> choices;  ///< Choice
  std::string emptyWord;             ///< "auto" or "none" where the field may be empty, else ""
  bool zeroIsEmpty = false;          ///< 0 may be written for the empty word
  std::size_t groupOf = 0;           ///< Numbers come in whole groups of this many
  std::string form;                  ///< Texts: how each is written
  /// Texts: throws InputError for one that cannot be used.
  std::function<void(const std::string&)> check;
  bool main = false;         ///< shown among the few main sliders of its step
  bool logarithmic = false;  ///< a slider moves in equal ratios
  /// Why the field has no effect with these parameters; "" when it has one, or when not set.
  std::function<std::string(const Parameters&)> idle;
  std::function<FieldValue(const Parameters&)> get;
  std::function<void(Parameters&, const FieldValue&)>
      put;  ///< stores without checking: use setField()
};

/// All fields in the order of the pipeline.
const std::vector<Field>& parameterFields();

/// @throws InputError naming the nearest known key
const Field& findField(std::string_view key);

/// Checks kind, range, choice and group, then stores.
/// @throws InputError that names the key, the value and what is allowed
void setField(Parameters& params, std::string_view key, const FieldValue& value);

/// As --set: `text` is parsed by the field's kind ("auto", "true", "3", "0.5", "modified",
/// "1,2,3", texts separated by ';').
void setFieldFromText(Parameters& params, std::string_view key, std::string_view text);

std::string fieldText(const FieldValue& value, const Field& field);

/// Relations between fields (sigmaMin <= sigmaMax, edgeMin <= edgeMax ...). @throws InputError
void validate(const Parameters& params);

/// `angiomesh`, `ct` (angiograms in HU) or `thesis`. @throws InputError
Parameters preset(std::string_view name);
const std::vector<std::string>& presetNames();

/// Nested JSON by the dots of the keys. Reading takes nested or dotted keys, changes only those
/// named, and throws InputError for unknown keys and for values of the wrong kind or out of range.
std::string parametersToJson(const Parameters& params);
Parameters parametersFromJson(std::string_view json, const Parameters& base,
                              const std::string& where);

}  // namespace angiomesh
