// SPDX-License-Identifier: BSD-3-Clause
#include "core/parameters/field_table.h"

namespace angiomesh {
namespace {

/// Of fields that only one method of segmentation reads.
IdleReason onlyWith(SegmentationMethod method) {
  return [method](const Parameters& p) -> std::string {
    static const Field& field = findField("segmentation.method");
    if (p.segmentation.method == method) return "";
    Parameters wanted;
    wanted.segmentation.method = method;
    return "it is used only with segmentation.method " + fieldText(field.get(wanted), field);
  };
}

std::string idleWithoutRefining(const Parameters& p) {
  const std::string why = onlyWith(SegmentationMethod::LevelSet)(p);
  if (!why.empty()) return why;
  return p.lumen.enabled ? "" : "it is used only with levelset.refine";
}

std::string idleWithoutWall(const Parameters& p) {
  return isSegmented(p) ? "" : idleWithoutRefining(p);
}

std::string idleWithoutSmoothWall(const Parameters& p) {
  return p.wall.enabled ? idleWithoutWall(p) : "it is used only with wall.smooth";
}

void addMethod(FieldTable& t) {
  t.begin(Step::Evolve, ReadOf::Scans);
  t.choice(
       "segmentation.method", "Method", ANGIOMESH_MEMBER(segmentation.method),
       {"level-set", "geodesic-active-contour", "confidence-connected", "threshold", "label"},
       "how the vessels are segmented; label: the image is already a segmentation; the others are "
       "for comparison with the level set, from the same seeds")
      .ofMask(Step::Preprocess)  // what a segmentation is made of differs from there on
      .main();
  t.begin(Step::Evolve, ReadOf::Scans, onlyWith(SegmentationMethod::Label));
  t.integer("segmentation.label", "Label", ANGIOMESH_MEMBER(segmentation.label), 1, 1000000000,
            "value of the voxels of a segmentation that are vessel")
      .onlyOfMask(Step::Evolve)
      .main()
      .slider([](const FieldContext& c) {
        return std::array<double, 2>{1.0, c.largestValue};
      });
  t.choice("segmentation.connectivity", "Voxels joined by",
           ANGIOMESH_MEMBER(segmentation.connectivity), {"faces", "edges", "corners"},
           "which voxels of a mask or label are joined: those that share a face (6 neighbours), an "
           "edge too (18) or a corner too (26)")
      .onlyOfMask(Step::Evolve);
}

void addLevelSet(FieldTable& t) {
  t.begin(Step::Evolve, ReadOf::Scans, onlyWith(SegmentationMethod::LevelSet));
  t.choice("levelset.start", "Start from", ANGIOMESH_MEMBER(levelset.start), {"flood", "seeds"},
           "flood: start from everything with v >= b that is connected to a seed; seeds: grow from "
           "the seeds");
  t.integer("levelset.floodLeastVoxels", "Least part without a seed",
            ANGIOMESH_MEMBER(levelset.floodLeastVoxels), 1, 1000000,
            "parts with v >= b and at least this many voxels count as vessels even without a "
            "seed")
      .idle([](const Parameters& p) {
        return p.levelset.start == StartRule::Flood ? ""
                                                    : "it is used only with levelset.start flood";
      })
      .rises("small parts without a seed are left out");
  t.real("levelset.gamma", "Follow image γ", ANGIOMESH_MEMBER(levelset.gamma), 0.0, 1.0, "",
         "weight of the vesselness term against the curvature term")
      .main()
      .rises("the front follows the image more, and is less smooth");
  t.real("levelset.d", "Thin vessels d", ANGIOMESH_MEMBER(levelset.d), 0.0, 5.0, "",
         "strength of the curvature term")
      .main()
      .rises("the front goes farther into thin vessels");
  t.boolean("levelset.acrossCrests", "Pass one-voxel vessels",
            ANGIOMESH_MEMBER(levelset.acrossCrests),
            "also move the front in vessels and gaps one voxel wide, where upwind differences "
            "vanish");
  t.real("levelset.stepVoxels", "Step of the front", ANGIOMESH_MEMBER(levelset.stepVoxels), 0.01,
         0.5, "voxels",
         "largest step of the front per iteration; near 0.5 it flickers at steep walls, at 1/6 it "
         "comes to rest")
      .rises("it takes fewer iterations, and flickers more about steep walls");
  t.real("levelset.xi", "Specificity ξ", ANGIOMESH_MEMBER(thresholds.xi), 0.1, 500.0, "",
         "scales the threshold b")
      .main()
      .logarithmic()
      .ofSpeed()
      .rises("faint vessels are left out");
  t.real("levelset.b", "Least vesselness b", ANGIOMESH_MEMBER(thresholds.b), 1e-4, 1.0, "",
         "vesselness at which the front stands still; auto: by bRule")
      .ofSpeed()
      .suggest([](const Parameters& p, const FieldContext& c) {
        return c.b.value_or(0.5 * (p.thresholds.bMin + p.thresholds.bMax));
      })
      .rises("faint vessels are left out");
  t.choice("levelset.bRule", "b from", ANGIOMESH_MEMBER(thresholds.bRule), {"contrast", "average"},
           "contrast: b = 0.007 xi; average: eq. 3.20, clamped to bMin..bMax")
      .ofSpeed();
  t.real("levelset.bMin", "Least b", ANGIOMESH_MEMBER(thresholds.bMin), 1e-4, 1.0, "",
         "lower bound of b by eq. 3.20")
      .ofSpeed()
      .rises("less is segmented of images with much noise");
  t.real("levelset.bMax", "Largest b", ANGIOMESH_MEMBER(thresholds.bMax), 1e-4, 1.0, "",
         "upper bound of b by eq. 3.20")
      .notBelow("levelset.bMin")
      .ofSpeed()
      .rises("less is segmented of images with strong vessels");
  t.integer("levelset.maxIterations", "Most iterations", ANGIOMESH_MEMBER(levelset.maxIterations),
            1, 1000000, "most iterations of the evolution")
      .slider(1.0, 20000.0)
      .rises("a front that has not come to rest goes on");
  t.integer(
       "levelset.stopAfter", "Stop after", ANGIOMESH_MEMBER(levelset.stopAfter), 0, 1000000,
       "end the evolution after this many iterations and take the front as it stands; none: it "
       "ends by itself")
      .emptyWord("none")
      .slider(0.0, 500.0)
      .suggest([](const Parameters&, const FieldContext&) { return 20.0; })
      .rises("the front goes on for longer");
  t.integer("levelset.checkEvery", "Check every", ANGIOMESH_MEMBER(levelset.checkEvery), 1, 10000,
            "iterations between two checks of convergence")
      .slider(1.0, 500.0)
      .rises("slow fronts are not taken for resting ones");
  t.real("levelset.tolerance", "Tolerance", ANGIOMESH_MEMBER(levelset.tolerance), 0.0, 10.0,
         "voxels", "converged below this change per inside voxel between checks")
      .rises("the evolution ends sooner");
  t.real("levelset.toleranceDelta", "Tolerance, delta", ANGIOMESH_MEMBER(levelset.toleranceDelta),
         0.0, 10.0, "voxels",
         "converged only if the change also differs from the previous one by less than this")
      .rises("the evolution ends sooner");
}

void addLumen(FieldTable& t) {
  t.boolean("levelset.refine", "Wall from the image", ANGIOMESH_MEMBER(lumen.enabled),
            "place the wall between the brightness of lumen and surroundings, after the evolution");
  t.begin(Step::Evolve, ReadOf::Scans, idleWithoutRefining);
  t.real("levelset.refineLevel", "Lumen limit", ANGIOMESH_MEMBER(lumen.level), 0.1, 0.9, "",
         "least brightness of a vessel voxel, from the surroundings (0) to the lumen (1); the wall "
         "lies half-way, or here if this is higher")
      .main()
      .rises("vessels get thinner, and narrow ones part");
  t.real("levelset.refineAlong", "Smoothing along", ANGIOMESH_MEMBER(lumen.along), 0.0, 1000.0, "",
         "strength of smoothing along the vessels, multiplied by the squared ratio of noise to "
         "contrast")
      .rises("noise disturbs the wall less, and short narrow places are filled");
  t.real("levelset.refineAcross", "Smoothing across", ANGIOMESH_MEMBER(lumen.across), 0.0, 1000.0,
         "",
         "strength of smoothing across the vessels, multiplied by the squared ratio of noise to "
         "contrast")
      .rises("noise disturbs the wall less, and neighbours run together");
  t.integer("levelset.refineMeanSteps", "Lumen mean, steps", ANGIOMESH_MEMBER(lumen.meanSteps), 0,
            1000,
            "how far the lumen's brightness is averaged along the vessels: steps of 2/3 voxel^2")
      .rises("the lumen's brightness is steadier, and follows changes along the vessel less");
  t.real("levelset.refineReachVoxels", "Reach of the wall", ANGIOMESH_MEMBER(lumen.reachVoxels),
         1.0, 10.0, "voxels", "how far from the evolution's result the wall is looked for")
      .rises("walls farther out are found, and it takes longer");
}

void addWall(FieldTable& t) {
  t.begin(Step::Evolve, ReadOf::All);
  t.boolean("wall.smooth", "Smooth wall", ANGIOMESH_MEMBER(wall.enabled),
            "make the wall as smooth as the vessel is, within what noise and contrast leave open")
      .main()
      .idle(idleWithoutWall);
  t.real("wall.reach", "Smoothness of the wall", ANGIOMESH_MEMBER(wall.reach), 2.0, 30.0, "",
         "size of the window that the wall is fitted in, multiplied by the fourth root of (vessel "
         "radius x uncertainty of the wall), voxels")
      .idle(idleWithoutSmoothWall)
      .rises("the wall gets smoother, and short bulges and dents are lost");
  t.real("wall.spreadVoxels", "Point spread", ANGIOMESH_MEMBER(wall.spreadVoxels), 0.2, 3.0,
         "voxels", "standard deviation of the image's point spread; auto: measured at the walls")
      .idle([](const Parameters& p) {
        return isSegmented(p) ? std::string("it is used only for scans") : idleWithoutSmoothWall(p);
      })
      .rises("thin vessels are taken for thinner than they look");
}

/// The methods that ours is compared with, in the order of the step evolve.
void addComparison(FieldTable& t) {
  t.begin(Step::Evolve, ReadOf::Scans, onlyWith(SegmentationMethod::GeodesicActiveContour));
  t.real("comparison.gac.sigmaVoxels", "Contour: scale",
         ANGIOMESH_MEMBER(comparison.gacSigmaVoxels), 0.3, 10.0, "voxels",
         "scale of the gradient that stops the contour")
      .rises("noise disturbs the contour less, and thin vessels are lost");
  t.real("comparison.gac.alpha", "Contour: α", ANGIOMESH_MEMBER(comparison.gacAlpha), -1e6, -1e-9,
         "",
         "width of the sigmoid of the gradient magnitude, negative; auto: from the image's "
         "contrast and noise")
      .slider([](const FieldContext& c) {
        return std::array<double, 2>{-c.window, -1e-9};
      })
      .suggest([](const Parameters&, const FieldContext& c) { return -c.window / 12.0; })
      .rises("the contour stops more abruptly");
  t.real("comparison.gac.beta", "Contour: β", ANGIOMESH_MEMBER(comparison.gacBeta), 0.0, 1e7, "",
         "gradient magnitude, intensities per working voxel, at which the contour has half its "
         "speed; auto: from the image's contrast and noise")
      .slider(0.0, 2.0, SliderUnit::Window)
      .suggest([](const Parameters&, const FieldContext& c) { return 0.25 * c.window; })
      .rises("only stronger edges stop the contour");
  t.real("comparison.gac.propagation", "Contour: propagation",
         ANGIOMESH_MEMBER(comparison.gacPropagation), -10.0, 100.0, "",
         "weight of the contour's outward speed")
      .rises("the contour goes farther, and leaks sooner");
  t.real("comparison.gac.curvature", "Contour: curvature",
         ANGIOMESH_MEMBER(comparison.gacCurvature), 0.0, 100.0, "",
         "weight of the term that smooths the contour")
      .rises("the contour gets smoother, and stays out of thin vessels");
  t.real("comparison.gac.advection", "Contour: advection",
         ANGIOMESH_MEMBER(comparison.gacAdvection), 0.0, 100.0, "",
         "weight of the term that draws the contour to edges")
      .rises("the contour holds to edges more");
  t.integer("comparison.gac.iterations", "Contour: iterations",
            ANGIOMESH_MEMBER(comparison.gacIterations), 1, 100000,
            "the contour ends here at the latest")
      .slider(1.0, 20000.0)
      .rises("a contour that has not come to rest goes on");
  t.real("comparison.gac.rms", "Contour: RMS change", ANGIOMESH_MEMBER(comparison.gacRms), 0.0,
         10.0, "voxels", "the contour ends below this root mean square change of an iteration")
      .rises("the contour ends sooner");
  t.begin(Step::Evolve, ReadOf::Scans, onlyWith(SegmentationMethod::ConfidenceConnected));
  t.real("comparison.confidence.multiplier", "Region: multiplier",
         ANGIOMESH_MEMBER(comparison.confidenceMultiplier), 0.1, 20.0, "",
         "half-width of the accepted intensity range around the region's mean, in standard "
         "deviations")
      .rises("the region grows, and leaks sooner");
  t.integer("comparison.confidence.iterations", "Region: iterations",
            ANGIOMESH_MEMBER(comparison.confidenceIterations), 0, 100,
            "how often the region is grown anew from its own mean and deviation")
      .rises("the interval fits the region more");
  t.integer("comparison.confidence.radiusVoxels", "Region: radius",
            ANGIOMESH_MEMBER(comparison.confidenceRadiusVoxels), 0, 10,
            "half the edge of the cubes around the seeds that the first mean is taken of")
      .rises("the first mean takes in more of the surroundings");
  t.begin(Step::Evolve, ReadOf::Scans, onlyWith(SegmentationMethod::Threshold));
  t.real("comparison.threshold.lower", "Threshold: lower",
         ANGIOMESH_MEMBER(comparison.thresholdLower), -1e6, 1e6, "",
         "least intensity of a vessel; auto: Otsu's threshold (none for dark vessels)")
      .slider(-1.0, 2.0, SliderUnit::Level)
      .suggest([](const Parameters&, const FieldContext& c) { return c.level; })
      .rises("less is taken");
  t.real("comparison.threshold.upper", "Threshold: upper",
         ANGIOMESH_MEMBER(comparison.thresholdUpper), -1e6, 1e6, "",
         "largest intensity of a vessel; auto: none (Otsu's threshold for dark vessels)")
      .notBelow("comparison.threshold.lower")
      .slider(-1.0, 2.0, SliderUnit::Level)
      .suggest([](const Parameters&, const FieldContext& c) { return c.level + c.window; })
      .rises("more is taken");
  t.real("comparison.threshold.sigmaVoxels", "Threshold: Gaussian",
         ANGIOMESH_MEMBER(comparison.thresholdSigmaVoxels), 0.0, 10.0, "voxels",
         "width of a Gaussian before the threshold; 0: none")
      .rises("noise goes, and thin vessels are lost");
  t.boolean("comparison.threshold.fromSeeds", "Threshold: from the seeds",
            ANGIOMESH_MEMBER(comparison.thresholdFromSeeds), "only the parts that hold a seed");
}

}  // namespace

void addSegmentationFields(FieldTable& table) {
  addMethod(table);
  addLevelSet(table);
  addLumen(table);
  addWall(table);
  addComparison(table);
}

}  // namespace angiomesh
