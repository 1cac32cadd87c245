// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <type_traits>
#include <utility>

#include "core/pipeline/parameters.h"

namespace angiomesh {
namespace {

/// Collects the fields; each add...() names a member by a function Parameters& -> member&.
class Table {
 public:
  template <class M>
  Field& real(const char* key, M member, double minimum, double maximum, const char* unit,
              const char* help) {
    Field& field = add(key, FieldKind::Real, minimum, maximum, unit, help);
    bind<double>(field, member);
    return field;
  }

  template <class M>
  Field& integer(const char* key, M member, double minimum, double maximum, const char* help) {
    Field& field = add(key, FieldKind::Integer, minimum, maximum, "", help);
    bind<std::int64_t>(field, member);
    return field;
  }

  /// A whole number of which 0 stands for "none".
  template <class M>
  Field& countOrNone(const char* key, M member, double minimum, double maximum, const char* help) {
    Field& field = add(key, FieldKind::Integer, minimum, maximum, "", help);
    field.emptyWord = "none";
    field.zeroIsEmpty = true;
    field.get = [member](const Parameters& p) -> FieldValue {
      const int count = member(const_cast<Parameters&>(p));
      if (count == 0) return std::monostate{};
      return static_cast<std::int64_t>(count);
    };
    field.put = [member](Parameters& p, const FieldValue& value) {
      const auto* count = std::get_if<std::int64_t>(&value);
      member(p) = count != nullptr ? static_cast<int>(*count) : 0;
    };
    return field;
  }

  template <class M>
  Field& boolean(const char* key, M member, const char* help) {
    Field& field = add(key, FieldKind::Boolean, 0.0, 1.0, "", help);
    bind<bool>(field, member);
    return field;
  }

  /// The enumerators of the member's type in order, by name.
  template <class M>
  Field& choice(const char* key, M member, std::vector<std::string> names, const char* help) {
    Field& field = add(key, FieldKind::Choice, 0.0, 0.0, "", help);
    field.choices = names;
    field.get = [member, names](const Parameters& p) -> FieldValue {
      return names[static_cast<std::size_t>(member(const_cast<Parameters&>(p)))];
    };
    field.put = [member, names](Parameters& p, const FieldValue& value) {
      for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == std::get<std::string>(value)) {
          auto& to = member(p);
          to = static_cast<std::remove_reference_t<decltype(to)>>(i);
        }
    };
    return field;
  }

  /// x,y,z,... in mm LPS
  template <class M>
  Field& points(const char* key, M member, const char* help) {
    Field& field = add(key, FieldKind::Numbers, -1e5, 1e5, "mm", help);
    field.groupOf = 3;
    field.emptyWord = "none";
    field.get = [member](const Parameters& p) -> FieldValue {
      const std::vector<double>& numbers = member(const_cast<Parameters&>(p));
      if (numbers.empty()) return std::monostate{};
      return numbers;
    };
    field.put = [member](Parameters& p, const FieldValue& value) {
      const auto* numbers = std::get_if<std::vector<double>>(&value);
      member(p) = numbers != nullptr ? *numbers : std::vector<double>{};
    };
    return field;
  }

  /// Each of the form that `check` takes; none is the empty list.
  template <class M>
  Field& texts(const char* key, M member, const char* form, const char* help,
               std::function<void(const std::string&)> check) {
    Field& field = add(key, FieldKind::Texts, 0.0, 0.0, "", help);
    field.form = form;
    field.check = std::move(check);
    field.emptyWord = "none";
    field.get = [member](const Parameters& p) -> FieldValue {
      const std::vector<std::string>& all = member(const_cast<Parameters&>(p));
      if (all.empty()) return std::monostate{};
      return all;
    };
    field.put = [member](Parameters& p, const FieldValue& value) {
      const auto* all = std::get_if<std::vector<std::string>>(&value);
      member(p) = all != nullptr ? *all : std::vector<std::string>{};
    };
    return field;
  }

  template <class M>
  Field& box(const char* key, M member, const char* help) {
    Field& field = add(key, FieldKind::Numbers, -1e5, 1e5, "mm", help);
    field.groupOf = 6;
    field.emptyWord = "none";
    field.get = [member](const Parameters& p) -> FieldValue {
      const auto& corners = member(const_cast<Parameters&>(p));
      if (!corners) return std::monostate{};
      return std::vector<double>(corners->begin(), corners->end());
    };
    field.put = [member](Parameters& p, const FieldValue& value) {
      const auto* numbers = std::get_if<std::vector<double>>(&value);
      auto& corners = member(p);
      if (numbers == nullptr) {
        corners.reset();
        return;
      }
      corners.emplace();
      for (std::size_t i = 0; i < 6; ++i) (*corners)[i] = (*numbers)[i];
    };
    return field;
  }

  std::vector<Field> take() { return std::move(fields_); }

 private:
  Field& add(const char* key, FieldKind kind, double minimum, double maximum, const char* unit,
             const char* help) {
    Field field;
    field.key = key;
    field.kind = kind;
    field.minimum = minimum;
    field.maximum = maximum;
    field.unit = unit;
    field.help = help;
    fields_.push_back(std::move(field));
    return fields_.back();
  }

  /// A member of type T, int or an optional of them. Stored is the variant's alternative V.
  template <class V, class M>
  void bind(Field& field, M member) {
    using T = std::remove_reference_t<decltype(member(std::declval<Parameters&>()))>;
    if constexpr (requires(T t) { t.has_value(); }) {
      field.emptyWord = "auto";
      field.get = [member](const Parameters& p) -> FieldValue {
        const auto& value = member(const_cast<Parameters&>(p));
        if (!value) return std::monostate{};
        return static_cast<V>(*value);
      };
      field.put = [member](Parameters& p, const FieldValue& value) {
        if (std::holds_alternative<std::monostate>(value))
          member(p).reset();
        else
          member(p) = static_cast<typename T::value_type>(std::get<V>(value));
      };
    } else {
      field.get = [member](const Parameters& p) -> FieldValue {
        return static_cast<V>(member(const_cast<Parameters&>(p)));
      };
      field.put = [member](Parameters& p, const FieldValue& value) {
        member(p) = static_cast<T>(std::get<V>(value));
      };
    }
  }

  std::vector<Field> fields_;
};

#define MEMBER(path) \
  [](Parameters & p) -> auto& { return p.path; }

void addPreprocess(Table& t) {
  t.choice("preprocess.isotropic", MEMBER(preprocess.isotropic), {"auto", "off", "on"},
           "resample to cubic voxels of the smallest spacing; auto: when spacing differs by more "
           "than 10 % and the voxels grow at most threefold");
  Field& lower = t.real("preprocess.clamp.lower", MEMBER(preprocess.clampLower), -1e6, 1e6, "",
                        "intensities below are raised to it; none: no bound");
  lower.emptyWord = "none";
  Field& upper = t.real("preprocess.clamp.upper", MEMBER(preprocess.clampUpper), -1e6, 1e6, "",
                        "voxels above are bone, calcium or metal: they and their rim are filled "
                        "with the median intensity between the bounds; none: no bound");
  upper.emptyWord = "none";
  t.integer("preprocess.clamp.rimVoxels", MEMBER(preprocess.clampRimVoxels), 0, 10,
            "width of the rim that is filled with them, voxels of the input")
      .idle = [](const Parameters& p) {
    return p.preprocess.clampUpper ? "" : "of preprocess.clamp.upper alone";
  };
  t.boolean("preprocess.sigmoid.enabled", MEMBER(preprocess.sigmoidEnabled),
            "map intensities through a sigmoid that keeps the range of the vessels")
      .main = true;
  t.real("preprocess.sigmoid.window", MEMBER(preprocess.sigmoidWindow), 1e-6, 1e6, "",
         "width of the sigmoid, as the viewer's window; auto: 1st to 99.8th percentile")
      .main = true;
  t.real("preprocess.sigmoid.level", MEMBER(preprocess.sigmoidLevel), -1e6, 1e6, "",
         "centre of the sigmoid, as the viewer's level; auto: middle of the percentiles")
      .main = true;
  t.boolean("preprocess.curvatureFlow.enabled", MEMBER(preprocess.curvatureFlowEnabled),
            "smooth along the edges of the image by curvature flow");
  t.integer("preprocess.curvatureFlow.iterations", MEMBER(preprocess.curvatureFlowIterations), 1,
            1000, "iterations of the curvature flow");
  t.real("preprocess.curvatureFlow.timeStep", MEMBER(preprocess.curvatureFlowTimeStep), 1e-4, 0.125,
         "", "time step of the curvature flow");
  t.box("preprocess.roi", MEMBER(preprocess.roi),
        "region of interest: two opposite corners x0,y0,z0,x1,y1,z1 in mm LPS");
}

void addVesselness(Table& t) {
  Field& low =
      t.real("vesselness.sigmaMinMm", MEMBER(vesselness.sigmaMinMm), 0.01, 100.0, "mm",
             "smallest scale: about the radius of the thinnest vessel; auto: 1 working voxel");
  low.main = low.logarithmic = true;
  Field& high = t.real(
      "vesselness.sigmaMaxMm", MEMBER(vesselness.sigmaMaxMm), 0.01, 100.0, "mm",
      "largest scale: about the radius of the thickest vessel; auto: 6 working voxels, or by "
      "scalesFromImage");
  high.main = high.logarithmic = true;
  t.boolean(
       "vesselness.scalesFromImage", MEMBER(vesselness.scalesFromImage),
       "an automatic sigmaMaxMm is half of the radius of the thickest bright thing, where that "
       "is more than 6 working voxels; 15 at most")
      .idle = [](const Parameters& p) {
    return p.vesselness.sigmaMaxMm ? "of an automatic sigmaMaxMm alone" : "";
  };
  t.integer("vesselness.scales", MEMBER(vesselness.scales), 1, 32,
            "number of scales, evenly spaced in log(sigma); auto: by scaleRule");
  t.choice(
      "vesselness.scaleRule", MEMBER(vesselness.scaleRule), {"ratio", "difference"},
      "ratio: ceil(log_1.5(max / min)) + 1; difference: eq. 5.1 in working voxels, at least 2");
  t.choice("vesselness.measure", MEMBER(vesselness.measure), {"modified", "frangi"},
           "modified: eq. 3.22, negative beside vessels; frangi: eq. 3.15");
  t.real("vesselness.alpha", MEMBER(vesselness.alpha), 0.01, 10.0, "",
         "sensitivity to plates (R_A)");
  t.real("vesselness.beta", MEMBER(vesselness.beta), 0.01, 10.0, "", "sensitivity to blobs (R_B)");
  t.real("vesselness.k", MEMBER(vesselness.kMm), 0.01, 100.0, "mm",
         "largest sigma at which the negative branch acts; auto: 2 sigmaMin");
  t.real(
      "vesselness.c", MEMBER(vesselness.c), 1e-6, 1e7, "",
      "structureness at which the measure saturates, intensities; auto: cFraction of the contrast");
  t.real("vesselness.cFraction", MEMBER(vesselness.cFraction), 1e-3, 2.0, "",
         "share of the contrast that makes c");
  t.choice("vesselness.contrast", MEMBER(vesselness.contrast), {"robust", "range"},
           "robust: 99.9th percentile minus median; range: maximum minus minimum");
  t.choice("vesselness.polarity", MEMBER(vesselness.polarity), {"bright", "dark"},
           "vessels are brighter or darker than their surroundings");
}

std::string idleUnless(const Parameters& p, SegmentationMethod method) {
  static const Field& field = findField("segmentation.method");
  if (p.segmentation.method == method) return "";
  Parameters wanted;
  wanted.segmentation.method = method;
  return "of segmentation.method " + fieldText(field.get(wanted), field) + " alone";
}

/// Whether the field serves to find vessels in a scan.
bool isOfScans(const std::string& key) {
  return key.starts_with("vesselness.") || (key.starts_with("seeds.") && key != "seeds.points") ||
         (key.starts_with("preprocess.") && key != "preprocess.roi");
}

void addLevelSet(Table& t) {
  t.boolean("seeds.automatic", MEMBER(seeds.automatic), "find seeds by vesselness");
  t.real("seeds.topPercent", MEMBER(seeds.topPercent), 1e-4, 10.0, "%",
         "share of the voxels that become seeds, highest single-scale vesselness first")
      .logarithmic = true;
  t.real("seeds.least", MEMBER(seeds.least), 0.0, 1.0, "",
         "vesselness of an automatic seed at least, but for the best one: topPercent may be more "
         "than there is of vessels");
  t.real("seeds.radiusVoxels", MEMBER(seeds.radiusVoxels), 0.5, 20.0, "voxels",
         "radius of the starting spheres, working voxels");
  t.points("seeds.points", MEMBER(seeds.points),
           "seeds by hand, x,y,z,... in mm LPS, added to the automatic ones");
  t.choice("segmentation.method", MEMBER(segmentation.method),
           {"level-set", "geodesic-active-contour", "confidence-connected", "threshold", "label"},
           "how the step evolve segments; label: the image is a segmentation; the others are there "
           "to compare the level set with, from the same seeds")
      .main = true;
  Field& label = t.integer("segmentation.label", MEMBER(segmentation.label), 1, 1000000000,
                           "value of the voxels of a segmentation that are vessel");
  label.main = true;
  label.idle = [](const Parameters& p) { return idleUnless(p, SegmentationMethod::Label); };
  t.choice(
      "levelset.start", MEMBER(levelset.start), {"flood", "seeds"},
      "flood: all that is connected to a seed at v >= b, at once; seeds: the front goes all the "
      "way");
  t.integer("levelset.floodLeastVoxels", MEMBER(levelset.floodLeastVoxels), 1, 1000000,
            "parts with v >= b of this size are vessels without a seed")
      .idle = [](const Parameters& p) {
    return p.levelset.start == StartRule::Flood ? "" : "of levelset.start flood alone";
  };
  t.real("levelset.gamma", MEMBER(levelset.gamma), 0.0, 1.0, "",
         "weight of the vesselness term against the curvature term")
      .main = true;
  t.real("levelset.d", MEMBER(levelset.d), 0.0, 5.0, "", "strength of the curvature term").main =
      true;
  t.boolean("levelset.acrossCrests", MEMBER(levelset.acrossCrests),
            "the front moves in vessels and gaps one voxel wide too, where upwind differences "
            "vanish");
  t.real("levelset.stepVoxels", MEMBER(levelset.stepVoxels), 0.01, 0.5, "voxels",
         "how far the front moves in an iteration at most: about half a voxel it flickers about "
         "steep walls, a sixth comes to rest");
  Field& xi = t.real("levelset.xi", MEMBER(levelset.xi), 0.1, 500.0, "",
                     "scales the threshold b: larger segments less");
  xi.main = xi.logarithmic = true;
  t.real("levelset.b", MEMBER(levelset.b), 1e-4, 1.0, "",
         "vesselness at which the front stands still; auto: by bRule");
  t.choice("levelset.bRule", MEMBER(levelset.bRule), {"contrast", "average"},
           "contrast: b = 0.007 xi; average: eq. 3.20, clamped to bMin..bMax");
  t.real("levelset.bMin", MEMBER(levelset.bMin), 1e-4, 1.0, "", "lower bound of b by eq. 3.20");
  t.real("levelset.bMax", MEMBER(levelset.bMax), 1e-4, 1.0, "", "upper bound of b by eq. 3.20");
  t.integer("levelset.maxIterations", MEMBER(levelset.maxIterations), 1, 1000000,
            "the evolution ends here at the latest");
  t.integer("levelset.checkEvery", MEMBER(levelset.checkEvery), 1, 10000,
            "iterations between two checks of convergence");
  t.real("levelset.tolerance", MEMBER(levelset.tolerance), 0.0, 10.0, "voxels",
         "converged below this change per inside voxel between checks");
  t.real("levelset.toleranceDelta", MEMBER(levelset.toleranceDelta), 0.0, 10.0, "voxels",
         "and below this difference from the previous change");
  t.boolean("levelset.refine", MEMBER(lumen.enabled),
            "place the wall between the brightness of lumen and surroundings, after the evolution");
  const auto idle = [](const Parameters& p) {
    return p.lumen.enabled ? "" : "of levelset.refine alone";
  };
  Field& level = t.real(
      "levelset.refineLevel", MEMBER(lumen.level), 0.1, 0.9, "",
      "what a voxel of the vessel has at least, from the surroundings' brightness (0) to the "
      "lumen's (1); the wall lies half-way, or here if this is more");
  level.main = true;
  level.idle = idle;
  t.real("levelset.refineAlong", MEMBER(lumen.along), 0.0, 1000.0, "",
         "smoothing along the vessels, times the squared ratio of noise to contrast")
      .idle = idle;
  t.real("levelset.refineAcross", MEMBER(lumen.across), 0.0, 1000.0, "",
         "smoothing across the vessels, times the squared ratio of noise to contrast")
      .idle = idle;
  t.integer("levelset.refineMeanSteps", MEMBER(lumen.meanSteps), 0, 1000,
            "how far the lumen's brightness is averaged along the vessels: steps of 2/3 voxel^2")
      .idle = idle;
  t.real("levelset.refineReachVoxels", MEMBER(lumen.reachVoxels), 1.0, 10.0, "voxels",
         "from what the evolution found to where the wall is looked for")
      .idle = idle;
}

/// The methods that ours is compared with, in the order of the step evolve.
void addComparison(Table& t) {
  const auto of = [](SegmentationMethod method) {
    return [method](const Parameters& p) { return idleUnless(p, method); };
  };
  const auto gac = of(SegmentationMethod::GeodesicActiveContour);
  t.real("comparison.gac.sigmaVoxels", MEMBER(comparison.gacSigmaVoxels), 0.3, 10.0, "voxels",
         "scale of the gradient that stops the contour")
      .idle = gac;
  t.real(
       "comparison.gac.alpha", MEMBER(comparison.gacAlpha), -1e6, -1e-9, "",
       "width of the sigmoid of the gradient magnitude, negative; auto: from the image's contrast "
       "and noise")
      .idle = gac;
  t.real("comparison.gac.beta", MEMBER(comparison.gacBeta), 0.0, 1e7, "",
         "gradient magnitude, intensities per working voxel, at which the contour has half its "
         "speed; auto: from the image's contrast and noise")
      .idle = gac;
  t.real("comparison.gac.propagation", MEMBER(comparison.gacPropagation), -10.0, 100.0, "",
         "weight of the contour's outward speed")
      .idle = gac;
  t.real("comparison.gac.curvature", MEMBER(comparison.gacCurvature), 0.0, 100.0, "",
         "weight of the term that smooths the contour")
      .idle = gac;
  t.real("comparison.gac.advection", MEMBER(comparison.gacAdvection), 0.0, 100.0, "",
         "weight of the term that draws the contour to edges")
      .idle = gac;
  t.integer("comparison.gac.iterations", MEMBER(comparison.gacIterations), 1, 100000,
            "the contour ends here at the latest")
      .idle = gac;
  t.real("comparison.gac.rms", MEMBER(comparison.gacRms), 0.0, 10.0, "voxels",
         "the contour ends below this root mean square change of an iteration")
      .idle = gac;
  const auto confidence = of(SegmentationMethod::ConfidenceConnected);
  t.real("comparison.confidence.multiplier", MEMBER(comparison.confidenceMultiplier), 0.1, 20.0, "",
         "half the width of the interval of intensities around the region's mean, standard "
         "deviations")
      .idle = confidence;
  t.integer("comparison.confidence.iterations", MEMBER(comparison.confidenceIterations), 0, 100,
            "how often the region is grown anew from its own mean and deviation")
      .idle = confidence;
  t.integer("comparison.confidence.radiusVoxels", MEMBER(comparison.confidenceRadiusVoxels), 0, 10,
            "half the edge of the cubes around the seeds that the first mean is taken of")
      .idle = confidence;
  const auto threshold = of(SegmentationMethod::Threshold);
  t.real("comparison.threshold.lower", MEMBER(comparison.thresholdLower), -1e6, 1e6, "",
         "least intensity of a vessel; auto: Otsu's threshold (none for dark vessels)")
      .idle = threshold;
  t.real("comparison.threshold.upper", MEMBER(comparison.thresholdUpper), -1e6, 1e6, "",
         "largest intensity of a vessel; auto: none (Otsu's threshold for dark vessels)")
      .idle = threshold;
  t.real("comparison.threshold.sigmaVoxels", MEMBER(comparison.thresholdSigmaVoxels), 0.0, 10.0,
         "voxels", "width of a Gaussian before the threshold; 0: none")
      .idle = threshold;
  t.boolean("comparison.threshold.fromSeeds", MEMBER(comparison.thresholdFromSeeds),
            "only the parts that hold a seed")
      .idle = threshold;
}

std::string idleForMarchingCubes(const Parameters& p) {
  return p.surface.method == SurfaceMethod::MarchingCubes
             ? "marching cubes makes triangles of the size of its cells"
             : "";
}

std::string idleWithoutMarchingCubes(const Parameters& p) {
  return p.surface.method == SurfaceMethod::MarchingCubes
             ? ""
             : "of surface.method marching-cubes alone";
}

std::string idleWithoutSmoothing(const Parameters& p) {
  return p.smooth.method == SmoothMethod::None ? "smooth.method is none" : "";
}

/// Of those that keep-wall reads for marching cubes alone: the triangles of the other methods are
/// even, and only get the volume back that inscribed triangles lose.
std::string idleForEvenTriangles(const Parameters& p) {
  if (p.smooth.method == SmoothMethod::Taubin) return "";
  return p.smooth.method == SmoothMethod::KeepWall &&
                 p.surface.method != SurfaceMethod::MarchingCubes
             ? "keep-wall uses it for surface.method marching-cubes alone"
             : idleWithoutSmoothing(p);
}

std::string idleWithoutTaubin(const Parameters& p) {
  return p.smooth.method == SmoothMethod::Taubin ? "" : "of smooth.method taubin alone";
}

std::string idleWithoutKeepWall(const Parameters& p) {
  return p.smooth.method == SmoothMethod::KeepWall ? idleForEvenTriangles(p)
                                                   : "of smooth.method keep-wall alone";
}

/// The wanted edge length of the methods that follow it.
void addSizing(Table& t) {
  const auto add = [](Field& field) -> Field& {
    field.idle = idleForMarchingCubes;
    return field;
  };
  Field& rho = add(t.real("surface.rho", MEMBER(surface.sizing.rho), 0.02, 2.0, "rad",
                          "accuracy: the angle that an edge subtends on the osculating circle, eq. "
                          "4.1; smaller is finer"));
  rho.main = rho.logarithmic = true;
  add(t.real("surface.etaInverse", MEMBER(surface.sizing.etaInverse), 0.3, 0.99, "",
             "1/eta of eq. 4.2: the wanted edge length grows by at most 1 - 1/eta per length; "
             "larger is more even"))
      .main = true;
  add(t.boolean("surface.etaCompensated", MEMBER(surface.sizing.etaCompensated),
                "rho alone sets the accuracy and 1/eta the gradation, eq. 4.4; off: 1/eta shortens "
                "the edges too"));
  add(t.real("surface.curvatureRelax", MEMBER(surface.sizing.curvatureRelax), 0.1, 10.0, "",
             "the curvature is divided by it; 3 imitates the reference program"));
  add(t.countOrNone("surface.edgesAround", MEMBER(surface.sizing.edgesAround), 3.0, 96.0,
                    "at least so many edges around any vessel; none: the curvature alone counts"))
      .main = true;
  Field& least = add(t.real("surface.edgeMinMm", MEMBER(surface.sizing.edgeMinMm), 1e-3, 1e3, "mm",
                            "no shorter edge is wanted; none: no limit"));
  least.emptyWord = "none";
  least.logarithmic = true;
  Field& most = add(t.real("surface.edgeMaxMm", MEMBER(surface.sizing.edgeMaxMm), 1e-3, 1e3, "mm",
                           "no longer edge is wanted; none: no limit"));
  most.emptyWord = "none";
  most.logarithmic = true;
}

void addSurface(Table& t) {
  t.choice("segmentation.keep", MEMBER(segmentation.keep), {"all", "largest", "seeded"},
           "which components go into the surface; seeded: those that hold a seed given by hand");
  t.real("segmentation.minVolumeMm3", MEMBER(segmentation.minVolumeMm3), 0.0, 1e9, "mm3",
         "components smaller than this are left out");
  t.points("segmentation.drop", MEMBER(segmentation.drop),
           "the components that hold these points, x,y,z,... in mm LPS, are left out");
  t.choice("surface.method", MEMBER(surface.method),
           {"advancing-front", "marching-cubes", "remesh"},
           "advancing-front: triangles of the wanted size, made on phi = 0 itself; marching-cubes: "
           "one set for each cell; remesh: marching cubes made over to the wanted size")
      .main = true;
  t.choice("surface.spline", MEMBER(surface.spline),
           {"interpolating-bspline", "bspline", "catmull-rom"},
           "interpolant of phi whose zero set is the wall");
  addSizing(t);
  Field& cell = t.real("surface.cellVoxels", MEMBER(surface.cellVoxels), 0.25, 4.0, "voxels",
                       "edge of a marching cubes cell, working voxels; smaller is finer");
  cell.main = cell.logarithmic = true;
  cell.idle = idleWithoutMarchingCubes;
  t.choice("surface.border", MEMBER(surface.border), {"cap", "open"},
           "where a vessel leaves the volume: a flat cap or an open rim")
      .main = true;
  t.real("surface.minComponentMm3", MEMBER(surface.minComponentMm3), 0.0, 1e9, "mm3",
         "surface components that enclose less are left out");
}

void addPorts(Table& t) {
  t.texts("ports.cuts", MEMBER(ports.cuts), "x,y,z,NAME or x,y,z,nx,ny,nz,NAME",
          "planes that end vessels, in mm LPS, with the names of the openings; the part beyond, on "
          "the side of the normal, goes; without a normal the vessel's axis, towards the smaller "
          "part",
          [](const std::string& text) { parseCut(text); });
  Field& ends =
      t.real("ports.cutEndsRadii", MEMBER(ports.cutEndsRadii), 0.0, 50.0, "radii",
             "every vessel that ends in the volume is cut so far before its tip, as end_1 "
             "and on; 0: none is");
  ends.main = true;
}

void addSmooth(Table& t) {
  t.choice("smooth.method", MEMBER(smooth.method), {"keep-wall", "taubin", "none"},
           "keep-wall: smooths the triangulation, not the vessel; taubin: as in the thesis")
      .main = true;
  Field& iterations = t.integer("smooth.iterations", MEMBER(smooth.iterations), 0, 1000,
                                "pairs of a lambda and a mu step; 0: nothing is smoothed");
  iterations.main = true;
  iterations.idle = idleWithoutSmoothing;
  t.real("smooth.lambda", MEMBER(smooth.lambda), 0.0, 1.0, "", "weight of the shrinking step")
      .idle = idleForEvenTriangles;
  t.real("smooth.mu", MEMBER(smooth.mu), -1.0, 0.0, "", "weight of the growing step").idle =
      idleWithoutTaubin;
  t.real("smooth.wallBoundVoxels", MEMBER(smooth.wallBoundVoxels), 0.0, 1.0, "voxels",
         "keep-wall: largest distance of a vertex from the wall, working voxels")
      .idle = idleWithoutKeepWall;
}

#undef MEMBER

}  // namespace

const std::vector<Field>& parameterFields() {
  static const std::vector<Field> fields = [] {
    Table table;
    addPreprocess(table);
    addVesselness(table);
    addLevelSet(table);
    addComparison(table);
    addPorts(table);
    addSurface(table);
    addSmooth(table);
    std::vector<Field> all = table.take();
    for (Field& field : all) {
      if (isOfScans(field.key))
        field.idle = [among = field.idle](const Parameters& p) {
          if (isSegmented(p)) return std::string("of scans alone: this is a segmentation");
          return among ? among(p) : std::string();
        };
      if (field.key.starts_with("levelset."))
        field.idle = [among = field.idle](const Parameters& p) {
          const std::string why = idleUnless(p, SegmentationMethod::LevelSet);
          return !why.empty() || !among ? why : among(p);
        };
    }
    return all;
  }();
  return fields;
}

}  // namespace angiomesh
