// SPDX-License-Identifier: BSD-3-Clause
#include "io/recipe/methods_text.h"

#include <algorithm>
#include <vector>

#include "core/base/formatted.h"
#include "core/parameters/field.h"
#include "core/pipeline/report.h"
#include "io/recipe/command_line.h"
#include "io/recipe/recipe_file.h"

namespace angiomesh {
namespace {

constexpr const char* kThesis =
    "Vessel segmentation and surface reconstruction from MRA images. MSc thesis, Istanbul "
    "Technical "
    "University, 2012.";
constexpr const char* kFrangi =
    "Frangi AF, Niessen WJ, Vincken KL, Viergever MA. Multiscale vessel enhancement filtering. "
    "MICCAI, LNCS 1496:130-137, 1998.";
constexpr const char* kLorensen =
    "Lorensen WE, Cline HE. Marching cubes: a high resolution 3D surface construction algorithm. "
    "Computer Graphics 21(4):163-169, 1987.";
constexpr const char* kOsher =
    "Osher S, Sethian JA. Fronts propagating with curvature-dependent speed. Journal of "
    "Computational Physics 79:12-49, 1988.";
constexpr const char* kTaubin =
    "Taubin G. A signal processing approach to fair surface design. SIGGRAPH, 351-358, 1995.";
constexpr const char* kWhitaker =
    "Whitaker RT. A level-set approach to 3D reconstruction from range data. International Journal "
    "of Computer Vision 29:203-231, 1998.";

/// Sentences, and the works that they refer to, numbered as they come.
class Paragraph {
 public:
  void say(const std::string& sentence) { text_ += (text_.empty() ? "" : " ") + sentence; }

  std::string cite(const std::string& work) {
    const auto found = std::find(works_.begin(), works_.end(), work);
    const auto n = static_cast<std::size_t>(found - works_.begin());
    if (found == works_.end()) works_.push_back(work);
    return "[" + std::to_string(n + 1) + "]";
  }

  [[nodiscard]] std::string text() const {
    std::string all = text_ + "\n\n";
    for (std::size_t n = 0; n < works_.size(); ++n)
      all += "[" + std::to_string(n + 1) + "] " + works_[n] + "\n";
    return all;
  }

 private:
  std::string text_;
  std::vector<std::string> works_;
};

std::string gridText(const Geometry& grid) {
  return formatted("%d x %d x %d voxels of %.4g x %.4g x %.4g mm", grid.size[0], grid.size[1],
                   grid.size[2], grid.spacing[0], grid.spacing[1], grid.spacing[2]);
}

std::string number(double value) { return formatted("%.4g", value); }

/// "1 seed", "3 seeds".
std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// The value with its unit: "0.4 mm", "auto".
std::string valueText(const Field& field, const Parameters& params) {
  const FieldValue value = field.get(params);
  const bool hasUnit = !field.unit.empty() && !std::holds_alternative<std::monostate>(value);
  return fieldText(value, field) + (hasUnit ? " " + field.unit : "");
}

std::string valueText(const char* key, const Parameters& params) {
  return valueText(findField(key), params);
}

/// Of the vesselness, with its unit.
std::string smallestScale(const RunResult& run) {
  return run.params.vesselness.sigmaMinMm ? valueText("vesselness.sigmaMinMm", run.params)
                                          : number(run.evolve->phi->geometry.voxelMm()) + " mm";
}

void sayVolume(const RunResult& run, const Recipe& recipe, Paragraph& p) {
  const std::string program = std::string("Angiomesh, version ") + versionText() + ".";
  const Geometry& given = run.source.image->geometry;
  const Geometry& working = run.evolve->phi->geometry;
  p.say("Vessel surfaces were made with Angiomesh " + recipe.program + " " + p.cite(program) +
        " from a volume of " + gridText(given) + ".");
  if (run.params.preprocess.roi) p.say("A region of interest was cut out of it.");
  if (working.size != given.size || working.spacing != given.spacing)
    p.say("All steps worked on " + gridText(working) + ".");
}

void sayVessels(const RunResult& run, Paragraph& p) {
  const Parameters& params = run.params;
  if (isSegmented(params))
    return p.say("The vessels are label " + std::to_string(params.segmentation.label) +
                 " of a segmentation that was made before.");
  if (params.segmentation.method != SegmentationMethod::LevelSet)
    return p.say("The vessels were segmented by the method " +
                 valueText("segmentation.method", params) + ".");
  const std::string hessian =
      "Vessels were enhanced by a measure of the Hessian " + p.cite(kFrangi);
  const bool modified = params.vesselness.measure == VesselMeasure::Modified;
  const std::string form =
      modified ? ", in a form that is negative between neighbouring vessels " + p.cite(kThesis)
               : "";
  p.say(hessian + form + ", at scales from " + smallestScale(run) + " to " +
        (params.vesselness.sigmaMaxMm ? valueText("vesselness.sigmaMaxMm", params)
                                      : "one that the program chose") +
        ".");
  const EvolveResult& evolve = *run.evolve;
  const char* end = evolve.stopReason == StopReason::Stopped ? "was ended after "
                    : evolve.converged                       ? "converged after "
                                                             : "stopped after ";
  const std::string levelSet =
      "They were segmented by a level set " + p.cite(kThesis) + p.cite(kOsher);
  p.say(levelSet + p.cite(kWhitaker) + " with gamma = " + valueText("levelset.gamma", params) +
        ", d = " + valueText("levelset.d", params) +
        " and a least vesselness of b = " + number(evolve.thresholds.b) + ", which " + end +
        counted(static_cast<std::size_t>(evolve.iterations), "iteration") + ".");
}

void sayWall(const Parameters& params, Paragraph& p) {
  const bool placed =
      params.segmentation.method == SegmentationMethod::LevelSet && params.lumen.enabled;
  if (placed)
    p.say("The wall was placed between the brightness of lumen and surroundings (at " +
          number(std::max(50.0, 100.0 * params.lumen.level)) + " % of the contrast).");
  if (params.wall.enabled && (placed || isSegmented(params)))
    p.say("It was made smooth by local fits of quadrics (wall.reach = " +
          valueText("wall.reach", params) + ").");
}

void saySurface(const RunResult& run, Paragraph& p) {
  const Parameters& params = run.params;
  const SurfaceParams& surface = params.surface;
  const std::string spline =
      "The zero level set of its spline (" + valueText("surface.spline", params) + ") ";
  const std::string sizes = "rho = " + valueText("surface.rho", params) +
                            " and 1/eta = " + valueText("surface.etaInverse", params);
  switch (surface.method) {
    case SurfaceMethod::AdvancingFront:
      p.say(spline + "was triangulated by an advancing front " + p.cite(kThesis) + " with " +
            sizes + ".");
      break;
    case SurfaceMethod::MarchingCubes:
      p.say(spline + "was triangulated by marching cubes " + p.cite(kLorensen) + " with cells of " +
            valueText("surface.cellVoxels", params) + ".");
      break;
    case SurfaceMethod::Remesh:
      p.say(spline + "was triangulated by marching cubes " + p.cite(kLorensen) +
            " and remeshed with " + sizes + ".");
      break;
  }
  const auto& parts = run.surface->origin.components;
  const auto others = std::count_if(parts.begin(), parts.end(), [](const SurfaceComponent& part) {
    return !part.instead.empty();
  });
  if (others > 0)
    p.say("Of its " + counted(parts.size(), "part") + ", " + std::to_string(others) +
          " had to be made by another method.");
  if (!run.smoothed || params.smooth.method == SmoothMethod::None)
    p.say("It was not smoothed.");
  else if (params.smooth.method == SmoothMethod::Taubin)
    p.say("It was smoothed by Taubin's filter " + p.cite(kTaubin) + " (" +
          counted(static_cast<std::size_t>(params.smooth.iterations), "iteration") + ", lambda = " +
          valueText("smooth.lambda", params) + ", mu = " + valueText("smooth.mu", params) + ").");
  else
    p.say("Its triangles were smoothed within " + valueText("smooth.wallBoundVoxels", params) +
          " of the wall.");
}

void sayHand(const RunResult& run, Paragraph& p) {
  const Parameters& params = run.params;
  std::vector<std::string> made;
  const auto add = [&made](std::size_t count, const char* what) {
    if (count > 0) made.push_back(what + (" (" + std::to_string(count) + ")"));
  };
  add(params.seeds.points.size() / 3, "seeds");
  add(params.segmentation.corrections.size(), "corrections of the segmentation");
  add(params.segmentation.drop.size() / 3, "parts left out");
  add(params.ports.cuts.size(), "cuts");
  add(params.ports.names.size(), "names of openings");
  if (!made.empty()) p.say("By hand were given: " + joined(made) + ".");
}

void sayMesh(const RunResult& run, Paragraph& p) {
  const TriMesh& mesh = *finalMesh(run);
  std::string text = "The mesh has " + std::to_string(mesh.triangles.size()) + " triangles, " +
                     std::to_string(mesh.points.size()) + " vertices and " +
                     counted(run.ports.size(), "opening");
  if (run.quality) {
    const MeshQuality& q = run.quality->mesh;
    text += "; its edges are " + number(q.edgeMinMm) + " to " + number(q.edgeMaxMm) + " mm long, " +
            number(q.edgeMeanMm) + " mm in the mean, its smallest angle is " +
            number(q.minAngleMin) + " degrees, and it is " + (q.closed ? "closed" : "not closed");
  }
  p.say(text + ".");
}

void sayParameters(const Parameters& params, Paragraph& p) {
  const NearestPreset nearest = nearestPreset(params);
  std::vector<std::string> others;
  for (const Field* field : nearest.others)
    if (!field->idle || field->idle(params).empty())
      others.push_back(field->key + " = " + valueText(*field, params));
  p.say(others.empty() ? "All parameters are those of the preset " + nearest.name + "."
                       : "Parameters are those of the preset " + nearest.name + ", but for " +
                             joined(others) + ".");
}

}  // namespace

std::string methodsText(const RunResult& run) {
  if (finalMesh(run) == nullptr || !run.evolve) return {};
  const Recipe recipe = recipeOf(run.params, run.source, run.evolve.get());
  Paragraph p;
  sayVolume(run, recipe, p);
  sayVessels(run, p);
  sayWall(run.params, p);
  sayHand(run, p);
  saySurface(run, p);
  sayMesh(run, p);
  sayParameters(recipe.params, p);
  p.say("Hashes (XXH3, 64 bits): volume " + run.source.hash + ", recipe " + recipeHash(recipe) +
        ", mesh " + meshHash(*finalMesh(run)) + ".");
  return p.text();
}

}  // namespace angiomesh
