// SPDX-License-Identifier: BSD-3-Clause
#include "core/parameters/field_table.h"

namespace angiomesh {
namespace {

void addPreprocess(FieldTable& t) {
  t.choice("preprocess.isotropic", ANGIOMESH_MEMBER(preprocess.isotropic), {"auto", "off", "on"},
           "resample to cubic voxels of the smallest spacing; auto: when spacing differs by more "
           "than 10 % and the voxels grow at most threefold");
  Field& lower = t.real("preprocess.clamp.lower", ANGIOMESH_MEMBER(preprocess.clampLower), -1e6,
                        1e6, "", "intensities below are raised to it; none: no bound");
  lower.emptyWord = "none";
  Field& upper =
      t.real("preprocess.clamp.upper", ANGIOMESH_MEMBER(preprocess.clampUpper), -1e6, 1e6, "",
             "voxels above are bone, calcium or metal: they and their rim are filled "
             "with the median intensity between the bounds; none: no bound");
  upper.emptyWord = "none";
  t.integer("preprocess.clamp.rimVoxels", ANGIOMESH_MEMBER(preprocess.clampRimVoxels), 0, 10,
            "width of the rim that is filled with them, voxels of the input")
      .idle = [](const Parameters& p) {
    return p.preprocess.clampUpper ? "" : "of preprocess.clamp.upper alone";
  };
  t.boolean("preprocess.sigmoid.enabled", ANGIOMESH_MEMBER(preprocess.sigmoidEnabled),
            "map intensities through a sigmoid that keeps the range of the vessels")
      .main = true;
  t.real("preprocess.sigmoid.window", ANGIOMESH_MEMBER(preprocess.sigmoidWindow), 1e-6, 1e6, "",
         "width of the sigmoid, as the viewer's window; auto: 1st to 99.8th percentile")
      .main = true;
  t.real("preprocess.sigmoid.level", ANGIOMESH_MEMBER(preprocess.sigmoidLevel), -1e6, 1e6, "",
         "centre of the sigmoid, as the viewer's level; auto: middle of the percentiles")
      .main = true;
  t.boolean("preprocess.curvatureFlow.enabled", ANGIOMESH_MEMBER(preprocess.curvatureFlowEnabled),
            "smooth along the edges of the image by curvature flow");
  t.integer("preprocess.curvatureFlow.iterations",
            ANGIOMESH_MEMBER(preprocess.curvatureFlowIterations), 1, 1000,
            "iterations of the curvature flow");
  t.real("preprocess.curvatureFlow.timeStep", ANGIOMESH_MEMBER(preprocess.curvatureFlowTimeStep),
         1e-4, 0.125, "voxels\u00b2",
         "time step of the curvature flow, in voxels whatever their size; 0.0625 is stable");
  t.box("preprocess.roi", ANGIOMESH_MEMBER(preprocess.roi),
        "region of interest: two opposite corners x0,y0,z0,x1,y1,z1 in mm LPS");
}

void addVesselness(FieldTable& t) {
  Field& low =
      t.real("vesselness.sigmaMinMm", ANGIOMESH_MEMBER(vesselness.sigmaMinMm), 0.01, 100.0, "mm",
             "smallest scale: about the radius of the thinnest vessel; auto: 1 working voxel");
  low.main = low.logarithmic = true;
  Field& high = t.real(
      "vesselness.sigmaMaxMm", ANGIOMESH_MEMBER(vesselness.sigmaMaxMm), 0.01, 100.0, "mm",
      "largest scale: about the radius of the thickest vessel; auto: 6 working voxels, or by "
      "scalesFromImage");
  high.main = high.logarithmic = true;
  t.boolean(
       "vesselness.scalesFromImage", ANGIOMESH_MEMBER(vesselness.scalesFromImage),
       "an automatic sigmaMaxMm is half of the radius of the thickest bright thing, where that "
       "is more than 6 working voxels; 15 at most")
      .idle = [](const Parameters& p) {
    return p.vesselness.sigmaMaxMm ? "of an automatic sigmaMaxMm alone" : "";
  };
  t.integer("vesselness.scales", ANGIOMESH_MEMBER(vesselness.scales), 1, 32,
            "number of scales, evenly spaced in log(sigma); auto: by scaleRule");
  t.choice(
      "vesselness.scaleRule", ANGIOMESH_MEMBER(vesselness.scaleRule), {"ratio", "difference"},
      "ratio: ceil(log_1.5(max / min)) + 1; difference: eq. 5.1 in working voxels, at least 2");
  t.choice("vesselness.measure", ANGIOMESH_MEMBER(vesselness.measure), {"modified", "frangi"},
           "modified: eq. 3.22, negative beside vessels; frangi: eq. 3.15");
  t.real("vesselness.alpha", ANGIOMESH_MEMBER(vesselness.alpha), 0.01, 10.0, "",
         "sensitivity to plates (R_A)");
  t.real("vesselness.beta", ANGIOMESH_MEMBER(vesselness.beta), 0.01, 10.0, "",
         "sensitivity to blobs (R_B)");
  t.real("vesselness.k", ANGIOMESH_MEMBER(vesselness.kMm), 0.01, 100.0, "mm",
         "largest sigma at which the negative branch acts; auto: 2 sigmaMin");
  t.real(
      "vesselness.c", ANGIOMESH_MEMBER(vesselness.c), 1e-6, 1e7, "",
      "structureness at which the measure saturates, intensities; auto: cFraction of the contrast");
  t.real("vesselness.cFraction", ANGIOMESH_MEMBER(vesselness.cFraction), 1e-3, 2.0, "",
         "share of the contrast that makes c");
  t.choice("vesselness.contrast", ANGIOMESH_MEMBER(vesselness.contrast), {"robust", "range"},
           "robust: 99.9th percentile minus median; range: maximum minus minimum");
  t.choice("vesselness.polarity", ANGIOMESH_MEMBER(vesselness.polarity), {"bright", "dark"},
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

void addLevelSet(FieldTable& t) {
  t.boolean("seeds.automatic", ANGIOMESH_MEMBER(seeds.automatic), "find seeds by vesselness");
  t.real("seeds.topPercent", ANGIOMESH_MEMBER(seeds.topPercent), 1e-4, 10.0, "%",
         "share of the voxels that become seeds, highest single-scale vesselness first")
      .logarithmic = true;
  t.real("seeds.least", ANGIOMESH_MEMBER(seeds.least), 0.0, 1.0, "",
         "vesselness of an automatic seed at least, but for the best one: topPercent may be more "
         "than there is of vessels");
  t.real("seeds.radiusVoxels", ANGIOMESH_MEMBER(seeds.radiusVoxels), 0.5, 20.0, "voxels",
         "radius of the starting spheres, working voxels");
  t.points("seeds.points", ANGIOMESH_MEMBER(seeds.points),
           "seeds by hand, x,y,z,... in mm LPS, added to the automatic ones");
  t.choice("segmentation.method", ANGIOMESH_MEMBER(segmentation.method),
           {"level-set", "geodesic-active-contour", "confidence-connected", "threshold", "label"},
           "how the step evolve segments; label: the image is a segmentation; the others are there "
           "to compare the level set with, from the same seeds")
      .main = true;
  Field& label = t.integer("segmentation.label", ANGIOMESH_MEMBER(segmentation.label), 1,
                           1000000000, "value of the voxels of a segmentation that are vessel");
  label.main = true;
  label.idle = [](const Parameters& p) { return idleUnless(p, SegmentationMethod::Label); };
  t.choice("segmentation.connectivity", ANGIOMESH_MEMBER(segmentation.connectivity),
           {"faces", "edges", "corners"},
           "which voxels of a mask or label are joined: those that share a face (6 neighbours), an "
           "edge too (18) or a corner too (26)")
      .idle = [](const Parameters& p) { return idleUnless(p, SegmentationMethod::Label); };
  t.choice(
      "levelset.start", ANGIOMESH_MEMBER(levelset.start), {"flood", "seeds"},
      "flood: all that is connected to a seed at v >= b, at once; seeds: the front goes all the "
      "way");
  t.integer("levelset.floodLeastVoxels", ANGIOMESH_MEMBER(levelset.floodLeastVoxels), 1, 1000000,
            "parts with v >= b of this size are vessels without a seed")
      .idle = [](const Parameters& p) {
    return p.levelset.start == StartRule::Flood ? "" : "of levelset.start flood alone";
  };
  t.real("levelset.gamma", ANGIOMESH_MEMBER(levelset.gamma), 0.0, 1.0, "",
         "weight of the vesselness term against the curvature term")
      .main = true;
  t.real("levelset.d", ANGIOMESH_MEMBER(levelset.d), 0.0, 5.0, "", "strength of the curvature term")
      .main = true;
  t.boolean("levelset.acrossCrests", ANGIOMESH_MEMBER(levelset.acrossCrests),
            "the front moves in vessels and gaps one voxel wide too, where upwind differences "
            "vanish");
  t.real("levelset.stepVoxels", ANGIOMESH_MEMBER(levelset.stepVoxels), 0.01, 0.5, "voxels",
         "how far the front moves in an iteration at most: about half a voxel it flickers about "
         "steep walls, a sixth comes to rest");
  Field& xi = t.real("levelset.xi", ANGIOMESH_MEMBER(levelset.xi), 0.1, 500.0, "",
                     "scales the threshold b: larger segments less");
  xi.main = xi.logarithmic = true;
  t.real("levelset.b", ANGIOMESH_MEMBER(levelset.b), 1e-4, 1.0, "",
         "vesselness at which the front stands still; auto: by bRule");
  t.choice("levelset.bRule", ANGIOMESH_MEMBER(levelset.bRule), {"contrast", "average"},
           "contrast: b = 0.007 xi; average: eq. 3.20, clamped to bMin..bMax");
  t.real("levelset.bMin", ANGIOMESH_MEMBER(levelset.bMin), 1e-4, 1.0, "",
         "lower bound of b by eq. 3.20");
  t.real("levelset.bMax", ANGIOMESH_MEMBER(levelset.bMax), 1e-4, 1.0, "",
         "upper bound of b by eq. 3.20");
  t.integer("levelset.maxIterations", ANGIOMESH_MEMBER(levelset.maxIterations), 1, 1000000,
            "the evolution ends here at the latest");
  t.integer("levelset.checkEvery", ANGIOMESH_MEMBER(levelset.checkEvery), 1, 10000,
            "iterations between two checks of convergence");
  t.real("levelset.tolerance", ANGIOMESH_MEMBER(levelset.tolerance), 0.0, 10.0, "voxels",
         "converged below this change per inside voxel between checks");
  t.real("levelset.toleranceDelta", ANGIOMESH_MEMBER(levelset.toleranceDelta), 0.0, 10.0, "voxels",
         "and below this difference from the previous change");
  t.boolean("levelset.refine", ANGIOMESH_MEMBER(lumen.enabled),
            "place the wall between the brightness of lumen and surroundings, after the evolution");
  const auto idle = [](const Parameters& p) {
    return p.lumen.enabled ? "" : "of levelset.refine alone";
  };
  Field& level = t.real(
      "levelset.refineLevel", ANGIOMESH_MEMBER(lumen.level), 0.1, 0.9, "",
      "what a voxel of the vessel has at least, from the surroundings' brightness (0) to the "
      "lumen's (1); the wall lies half-way, or here if this is more");
  level.main = true;
  level.idle = idle;
  t.real("levelset.refineAlong", ANGIOMESH_MEMBER(lumen.along), 0.0, 1000.0, "",
         "smoothing along the vessels, times the squared ratio of noise to contrast")
      .idle = idle;
  t.real("levelset.refineAcross", ANGIOMESH_MEMBER(lumen.across), 0.0, 1000.0, "",
         "smoothing across the vessels, times the squared ratio of noise to contrast")
      .idle = idle;
  t.integer("levelset.refineMeanSteps", ANGIOMESH_MEMBER(lumen.meanSteps), 0, 1000,
            "how far the lumen's brightness is averaged along the vessels: steps of 2/3 voxel^2")
      .idle = idle;
  t.real("levelset.refineReachVoxels", ANGIOMESH_MEMBER(lumen.reachVoxels), 1.0, 10.0, "voxels",
         "from what the evolution found to where the wall is looked for")
      .idle = idle;
}

void addWall(FieldTable& t) {
  const auto ofWalls = [](const Parameters& p) -> std::string {
    if (isSegmented(p)) return "";
    if (p.segmentation.method != SegmentationMethod::LevelSet)
      return idleUnless(p, SegmentationMethod::LevelSet);
    return p.lumen.enabled ? "" : "of levelset.refine alone";
  };
  Field& smooth = t.boolean(
      "wall.smooth", ANGIOMESH_MEMBER(wall.enabled),
      "make the wall as smooth as the vessel is, within what noise and contrast leave open");
  smooth.main = true;
  smooth.idle = ofWalls;
  const auto ofSmooth = [ofWalls](const Parameters& p) {
    return p.wall.enabled ? ofWalls(p) : "of wall.smooth alone";
  };
  Field& reach =
      t.real("wall.reach", ANGIOMESH_MEMBER(wall.reach), 2.0, 30.0, "",
             "how far around each place of the wall is looked at: times the fourth root of the "
             "vessel's radius times the wall's uncertainty, voxels; more is smoother");
  reach.idle = ofSmooth;
  Field& spread =
      t.real("wall.spreadVoxels", ANGIOMESH_MEMBER(wall.spreadVoxels), 0.2, 3.0, "voxels",
             "standard deviation of the image's point spread; auto: measured at the walls");
  spread.emptyWord = "auto";
  spread.idle = [ofSmooth](const Parameters& p) {
    return isSegmented(p) ? std::string("of scans alone") : ofSmooth(p);
  };
}

/// The methods that ours is compared with, in the order of the step evolve.
void addComparison(FieldTable& t) {
  const auto of = [](SegmentationMethod method) {
    return [method](const Parameters& p) { return idleUnless(p, method); };
  };
  const auto gac = of(SegmentationMethod::GeodesicActiveContour);
  t.real("comparison.gac.sigmaVoxels", ANGIOMESH_MEMBER(comparison.gacSigmaVoxels), 0.3, 10.0,
         "voxels", "scale of the gradient that stops the contour")
      .idle = gac;
  t.real(
       "comparison.gac.alpha", ANGIOMESH_MEMBER(comparison.gacAlpha), -1e6, -1e-9, "",
       "width of the sigmoid of the gradient magnitude, negative; auto: from the image's contrast "
       "and noise")
      .idle = gac;
  t.real("comparison.gac.beta", ANGIOMESH_MEMBER(comparison.gacBeta), 0.0, 1e7, "",
         "gradient magnitude, intensities per working voxel, at which the contour has half its "
         "speed; auto: from the image's contrast and noise")
      .idle = gac;
  t.real("comparison.gac.propagation", ANGIOMESH_MEMBER(comparison.gacPropagation), -10.0, 100.0,
         "", "weight of the contour's outward speed")
      .idle = gac;
  t.real("comparison.gac.curvature", ANGIOMESH_MEMBER(comparison.gacCurvature), 0.0, 100.0, "",
         "weight of the term that smooths the contour")
      .idle = gac;
  t.real("comparison.gac.advection", ANGIOMESH_MEMBER(comparison.gacAdvection), 0.0, 100.0, "",
         "weight of the term that draws the contour to edges")
      .idle = gac;
  t.integer("comparison.gac.iterations", ANGIOMESH_MEMBER(comparison.gacIterations), 1, 100000,
            "the contour ends here at the latest")
      .idle = gac;
  t.real("comparison.gac.rms", ANGIOMESH_MEMBER(comparison.gacRms), 0.0, 10.0, "voxels",
         "the contour ends below this root mean square change of an iteration")
      .idle = gac;
  const auto confidence = of(SegmentationMethod::ConfidenceConnected);
  t.real("comparison.confidence.multiplier", ANGIOMESH_MEMBER(comparison.confidenceMultiplier), 0.1,
         20.0, "",
         "half the width of the interval of intensities around the region's mean, standard "
         "deviations")
      .idle = confidence;
  t.integer("comparison.confidence.iterations", ANGIOMESH_MEMBER(comparison.confidenceIterations),
            0, 100, "how often the region is grown anew from its own mean and deviation")
      .idle = confidence;
  t.integer("comparison.confidence.radiusVoxels",
            ANGIOMESH_MEMBER(comparison.confidenceRadiusVoxels), 0, 10,
            "half the edge of the cubes around the seeds that the first mean is taken of")
      .idle = confidence;
  const auto threshold = of(SegmentationMethod::Threshold);
  t.real("comparison.threshold.lower", ANGIOMESH_MEMBER(comparison.thresholdLower), -1e6, 1e6, "",
         "least intensity of a vessel; auto: Otsu's threshold (none for dark vessels)")
      .idle = threshold;
  t.real("comparison.threshold.upper", ANGIOMESH_MEMBER(comparison.thresholdUpper), -1e6, 1e6, "",
         "largest intensity of a vessel; auto: none (Otsu's threshold for dark vessels)")
      .idle = threshold;
  t.real("comparison.threshold.sigmaVoxels", ANGIOMESH_MEMBER(comparison.thresholdSigmaVoxels), 0.0,
         10.0, "voxels", "width of a Gaussian before the threshold; 0: none")
      .idle = threshold;
  t.boolean("comparison.threshold.fromSeeds", ANGIOMESH_MEMBER(comparison.thresholdFromSeeds),
            "only the parts that hold a seed")
      .idle = threshold;
}

}  // namespace

const std::vector<Field>& parameterFields() {
  static const std::vector<Field> fields = [] {
    FieldTable table;
    addPreprocess(table);
    addVesselness(table);
    addLevelSet(table);
    addWall(table);
    addComparison(table);
    addSurfaceFields(table);
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
