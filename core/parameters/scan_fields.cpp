// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "core/parameters/field_table.h"

namespace angiomesh {
namespace {

std::string idleWithoutSigmoid(const Parameters& p) {
  return p.preprocess.sigmoidEnabled ? "" : "it is used only with preprocess.sigmoid.enabled";
}

std::string idleWithoutFlow(const Parameters& p) {
  return p.preprocess.curvatureFlowEnabled
             ? ""
             : "it is used only with preprocess.curvatureFlow.enabled";
}

void addPreprocess(FieldTable& t) {
  t.begin(Step::Preprocess, ReadOf::Scans);
  t.choice("preprocess.isotropic", "Cubic voxels", ANGIOMESH_MEMBER(preprocess.isotropic),
           {"auto", "off", "on"},
           "resample to cubic voxels of the smallest spacing; auto: when spacing differs by more "
           "than 10 % and the voxels grow at most threefold");
  t.real("preprocess.clamp.lower", "Lowest intensity", ANGIOMESH_MEMBER(preprocess.clampLower),
         -1e6, 1e6, "", "raise darker voxels to this intensity; none: no lower bound")
      .emptyWord("none")
      .slider(-1.0, 2.0, SliderUnit::Level)
      .suggest([](const Parameters&, const FieldContext& c) { return c.level - c.window; })
      .rises("more of the dark tissue becomes one grey");
  t.real("preprocess.clamp.upper", "Bone above", ANGIOMESH_MEMBER(preprocess.clampUpper), -1e6, 1e6,
         "",
         "brighter voxels count as bone, calcium or metal; they and a rim around them are filled "
         "with "
         "the median intensity between the bounds; none: no upper bound")
      .emptyWord("none")
      .above("preprocess.clamp.lower")
      .slider(-1.0, 2.0, SliderUnit::Level)
      .suggest([](const Parameters&, const FieldContext& c) { return c.level + c.window; })
      .rises("less of bone and calcium is taken out");
  t.integer("preprocess.clamp.rimVoxels", "Rim of bone",
            ANGIOMESH_MEMBER(preprocess.clampRimVoxels), 0, 10,
            "width of that rim, in voxels of the input")
      .idle([](const Parameters& p) {
        return p.preprocess.clampUpper ? "" : "it is used only with preprocess.clamp.upper";
      })
      .rises("bone's blurred edge goes, and vessels that touch it get thinner");
  t.boolean("preprocess.sigmoid.enabled", "Stretch the vessels' greys",
            ANGIOMESH_MEMBER(preprocess.sigmoidEnabled),
            "map intensities through a sigmoid that keeps the range of the vessels")
      .main();
  t.real("preprocess.sigmoid.window", "Stretch, width", ANGIOMESH_MEMBER(preprocess.sigmoidWindow),
         1e-6, 1e6, "",
         "width of the sigmoid, as the viewer's window; auto: 1st to 99.8th percentile")
      .main()
      .slider(0.01, 3.0, SliderUnit::Window)
      .suggest([](const Parameters&, const FieldContext& c) { return c.window; })
      .idle(idleWithoutSigmoid)
      .rises("the step from dark to bright gets gentler");
  t.real("preprocess.sigmoid.level", "Stretch, middle", ANGIOMESH_MEMBER(preprocess.sigmoidLevel),
         -1e6, 1e6, "",
         "centre of the sigmoid, as the viewer's level; auto: middle of the percentiles")
      .main()
      .slider(-1.0, 2.0, SliderUnit::Level)
      .suggest([](const Parameters&, const FieldContext& c) { return c.level; })
      .idle(idleWithoutSigmoid)
      .rises("faint vessels get darker");
  t.boolean("preprocess.curvatureFlow.enabled", "Remove noise",
            ANGIOMESH_MEMBER(preprocess.curvatureFlowEnabled),
            "smooth along the edges of the image by curvature flow");
  t.integer("preprocess.curvatureFlow.iterations", "Noise removal, steps",
            ANGIOMESH_MEMBER(preprocess.curvatureFlowIterations), 1, 1000,
            "iterations of the curvature flow")
      .idle(idleWithoutFlow)
      .rises("noise goes, and then thin vessels");
  t.real("preprocess.curvatureFlow.timeStep", "Noise removal per step",
         ANGIOMESH_MEMBER(preprocess.curvatureFlowTimeStep), 1e-4, 0.125, "voxels\u00b2",
         "time step of the curvature flow, in voxels whatever their size; 0.0625 is stable")
      .idle(idleWithoutFlow)
      .rises("each iteration smooths more");
  t.box("preprocess.roi", "Region of interest", ANGIOMESH_MEMBER(preprocess.roi),
        "region of interest: two opposite corners x0,y0,z0,x1,y1,z1 in mm LPS")
      .ofMask(Step::Preprocess)
      .place();
}

void addVesselness(FieldTable& t) {
  t.begin(Step::Vesselness, ReadOf::Scans);
  // A vessel answers most at sigma = radius, and users think in diameters: a form shows 2 sigma.
  t.real("vesselness.sigmaMinMm", "Thinnest vessel", ANGIOMESH_MEMBER(vesselness.sigmaMinMm), 0.01,
         100.0, "mm",
         "smallest scale: about the radius of the thinnest vessel; auto: 1 working voxel")
      .main()
      .logarithmic()
      .shownTimes(2.0)
      .slider(0.4, 30.0, SliderUnit::Voxel)
      .suggest([](const Parameters& p, const FieldContext& c) {
        return std::min(c.voxelMm, p.vesselness.sigmaMaxMm.value_or(c.voxelMm));
      })
      .rises("the thinnest vessels are lost, and so is noise");
  t.real("vesselness.sigmaMaxMm", "Thickest vessel", ANGIOMESH_MEMBER(vesselness.sigmaMaxMm), 0.01,
         100.0, "mm",
         "largest scale: about the radius of the thickest vessel; auto: 6 working voxels, or by "
         "scalesFromImage")
      .main()
      .logarithmic()
      .shownTimes(2.0)
      .notBelow("vesselness.sigmaMinMm")
      .slider(0.4, 30.0, SliderUnit::Voxel)
      .suggest([](const Parameters& p, const FieldContext& c) {
        return !c.scalesMm.empty()
                   ? c.scalesMm.back()
                   : std::max(6.0 * c.voxelMm, p.vesselness.sigmaMinMm.value_or(c.voxelMm));
      })
      .rises("thicker vessels are found, neighbours may run together, and it takes longer");
  t.boolean("vesselness.scalesFromImage", "Sizes from the image",
            ANGIOMESH_MEMBER(vesselness.scalesFromImage),
            "let an automatic sigmaMaxMm grow to half the radius of the thickest bright structure "
            "if that exceeds 6 working voxels, at most 15")
      .idle([](const Parameters& p) {
        return p.vesselness.sigmaMaxMm ? "it is used only with an automatic sigmaMaxMm" : "";
      });
  t.integer("vesselness.scales", "Sizes looked for", ANGIOMESH_MEMBER(vesselness.scales), 1, 32,
            "number of scales, evenly spaced in log(sigma); auto: by scaleRule")
      .suggest([](const Parameters&, const FieldContext& c) {
        return c.scalesMm.empty() ? 6.0 : static_cast<double>(c.scalesMm.size());
      })
      .rises("radii between the scales are met better, and it takes longer");
  t.choice("vesselness.scaleRule", "Spacing of the sizes", ANGIOMESH_MEMBER(vesselness.scaleRule),
           {"ratio", "difference"},
           "ratio: ceil(log_1.5(max / min)) + 1; difference: eq. 5.1 in working voxels, at least "
           "2");
  t.choice("vesselness.measure", "Vesselness measure", ANGIOMESH_MEMBER(vesselness.measure),
           {"modified", "frangi"}, "modified: eq. 3.22, negative beside vessels; frangi: eq. 3.15");
  t.real("vesselness.alpha", "Reject plates α", ANGIOMESH_MEMBER(vesselness.alpha), 0.01, 10.0, "",
         "sensitivity to plates (R_A)")
      .rises("plates count less against vessels, so that flat vessels get less");
  t.real("vesselness.beta", "Keep blobs β", ANGIOMESH_MEMBER(vesselness.beta), 0.01, 10.0, "",
         "sensitivity to blobs (R_B)")
      .rises("blobs, branchings and aneurysms get more");
  t.real("vesselness.k", "Keep apart up to k", ANGIOMESH_MEMBER(vesselness.kMm), 0.01, 100.0, "mm",
         "largest sigma at which the negative branch acts; auto: 2 sigmaMin")
      .slider(0.4, 30.0, SliderUnit::Voxel)
      .suggest([](const Parameters& p, const FieldContext& c) {
        return 2.0 * p.vesselness.sigmaMinMm.value_or(c.voxelMm);
      })
      .rises("thicker vessels are kept apart as well");
  t.real("vesselness.c", "Reject noise c", ANGIOMESH_MEMBER(vesselness.c), 1e-6, 1e7, "",
         "structureness at which the measure saturates, intensities; auto: cFraction of the "
         "contrast")
      .suggest([](const Parameters& p, const FieldContext& c) {
        return c.c.value_or(c.window * p.vesselness.cFraction);
      })
      .rises("faint vessels and noise get less");
  t.real("vesselness.cFraction", "Reject noise, share of contrast",
         ANGIOMESH_MEMBER(vesselness.cFraction), 1e-3, 2.0, "", "c as a fraction of the contrast")
      .rises("faint vessels and noise get less");
  t.choice("vesselness.contrast", "Contrast from", ANGIOMESH_MEMBER(vesselness.contrast),
           {"robust", "range"},
           "robust: 99.9th percentile minus median; range: maximum minus minimum");
  t.choice("vesselness.polarity", "Vessels are", ANGIOMESH_MEMBER(vesselness.polarity),
           {"bright", "dark"}, "vessels are brighter or darker than their surroundings");
}

void addSeeds(FieldTable& t) {
  t.begin(Step::Seeds, ReadOf::Scans);
  t.boolean("seeds.automatic", "Automatic seeds", ANGIOMESH_MEMBER(seeds.automatic),
            "find seeds by vesselness");
  t.real("seeds.topPercent", "Best voxels taken", ANGIOMESH_MEMBER(seeds.topPercent), 1e-4, 10.0,
         "%", "share of the voxels that become seeds, highest single-scale vesselness first")
      .logarithmic()
      .rises("fainter vessels get seeds, and so may what is none");
  t.real("seeds.least", "Least vesselness", ANGIOMESH_MEMBER(seeds.least), 0.0, 1.0, "",
         "lowest vesselness of an automatic seed (the best one is always kept); stops topPercent "
         "from taking noise where there are few vessels")
      .rises("faint vessels get no seeds of their own");
  t.real("seeds.radiusVoxels", "Radius", ANGIOMESH_MEMBER(seeds.radiusVoxels), 0.5, 20.0, "voxels",
         "radius of the starting spheres, working voxels")
      .rises("the front starts farther out, and may begin outside thin vessels");
  t.points("seeds.points", "Seeds by hand", ANGIOMESH_MEMBER(seeds.points),
           "seeds by hand, x,y,z,... in mm LPS, added to the automatic ones")
      .ofMask(Step::Seeds)  // for segmentation.keep
      .place();
}

}  // namespace

void addScanFields(FieldTable& table) {
  addPreprocess(table);
  addVesselness(table);
  addSeeds(table);
}

}  // namespace angiomesh
