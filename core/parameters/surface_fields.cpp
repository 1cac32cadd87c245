// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "core/parameters/field_table.h"

namespace angiomesh {
namespace {

std::string idleForMarchingCubes(const Parameters& p) {
  return p.surface.method == SurfaceMethod::MarchingCubes
             ? "marching cubes makes triangles of the size of its cells"
             : "";
}

std::string idleWithoutMarchingCubes(const Parameters& p) {
  return p.surface.method == SurfaceMethod::MarchingCubes
             ? ""
             : "it is used only with surface.method marching-cubes";
}

std::string idleWithoutSmoothing(const Parameters& p) {
  return p.smooth.method == SmoothMethod::None ? "smooth.method is none" : "";
}

/// Of those that keep-wall reads for marching cubes only: the triangles of the other methods are
/// even, and only get the volume back that inscribed triangles lose.
std::string idleForEvenTriangles(const Parameters& p) {
  if (p.smooth.method == SmoothMethod::Taubin) return "";
  return p.smooth.method == SmoothMethod::KeepWall &&
                 p.surface.method != SurfaceMethod::MarchingCubes
             ? "keep-wall uses it only with surface.method marching-cubes"
             : idleWithoutSmoothing(p);
}

std::string idleWithoutTaubin(const Parameters& p) {
  return p.smooth.method == SmoothMethod::Taubin ? "" : "it is used only with smooth.method taubin";
}

std::string idleWithoutKeepWall(const Parameters& p) {
  return p.smooth.method == SmoothMethod::KeepWall ? idleForEvenTriangles(p)
                                                   : "it is used only with smooth.method keep-wall";
}

std::array<double, 2> upToHundredth(const FieldContext& c) { return {0.0, 0.01 * c.volumeMm3}; }

void addPorts(FieldTable& t) {
  t.texts(
       "ports.cuts", "Cuts", ANGIOMESH_MEMBER(ports.cuts), "x,y,z,NAME or x,y,z,nx,ny,nz,NAME",
       "planes that cut vessels, in mm LPS, and the names of the openings; the part on the side of "
       "the normal is removed; without a normal the cut is straight across and removes the "
       "smaller part",
       [](const std::string& text) { parseCut(text); })
      .place();
  t.boolean(
      "ports.cutBorders", "Cut across at the border", ANGIOMESH_MEMBER(ports.cutBorders),
      "cut vessels that the border slices (by more than 30 degrees, or 1.3 times their section) "
      "straight across just inside, as across_1, across_2, ...");
  t.texts("ports.names", "Names of ports", ANGIOMESH_MEMBER(ports.names),
          "border_1=NAME or x,y,z=NAME",
          "new names of ports, which are given by their name in the report or by their position in "
          "mm LPS",
          [](const std::string& text) { parsePortNaming(text); })
      .place()
      .remakesNothing();
  t.real("ports.cutEndsRadii", "Ends cut at", ANGIOMESH_MEMBER(ports.cutEndsRadii), 0.0, 50.0,
         "radii",
         "cut every vessel that ends inside the volume this many radii before its tip, as end_1, "
         "end_2, ...; 0: off")
      .main()
      .rises("more of each end is cut off");
}

void addCorrections(FieldTable& t) {
  t.texts("segmentation.corrections", "Corrections", ANGIOMESH_MEMBER(segmentation.corrections),
          kCorrectionForm,
          "corrections of the segmentation by hand, made in their order after the evolution",
          [](const std::string& text) { parseCorrection(text); })
      .place();
}

void addParts(FieldTable& t) {
  t.choice("segmentation.keep", "Parts kept", ANGIOMESH_MEMBER(segmentation.keep),
           {"all", "largest", "seeded"},
           "which components go into the surface; seeded: those that hold a seed given by hand");
  t.real("segmentation.minVolumeMm3", "Least volume", ANGIOMESH_MEMBER(segmentation.minVolumeMm3),
         0.0, 1e9, "mm3", "components smaller than this are left out")
      .slider(upToHundredth)
      .rises("small parts are left out");
  t.real(
       "segmentation.minLengthMm", "Least length", ANGIOMESH_MEMBER(segmentation.minLengthMm), 0.0,
       1e4, "mm",
       "components with centre lines shorter than this, all branches together, are left out; so is "
       "what is not longer than it is thick")
      .slider(0.0, 100.0, SliderUnit::Voxel)
      .rises("short pieces and blobs are left out, however thick they are");
  t.points("segmentation.drop", "Parts ticked off", ANGIOMESH_MEMBER(segmentation.drop),
           "the components that hold these points, x,y,z,... in mm LPS, are left out")
      .place();
}

/// The wanted edge length of the methods that follow it.
void addSizing(FieldTable& t) {
  t.begin(Step::Surface, ReadOf::All, idleForMarchingCubes);
  t.real("surface.rho", "Accuracy ρ", ANGIOMESH_MEMBER(surface.sizing.rho), 0.02, 2.0, "rad",
         "accuracy: the angle that an edge subtends on the osculating circle, eq. 4.1, down to "
         "edgeMinVoxels")
      .main()
      .logarithmic()
      .slider(0.02, 1.2)
      .rises("fewer and larger triangles, which follow the wall less closely");
  t.real("surface.etaInverse", "Even sizes 1/η", ANGIOMESH_MEMBER(surface.sizing.etaInverse), 0.3,
         0.99, "", "1/eta of eq. 4.2: the wanted edge length grows by at most 1 - 1/eta per length")
      .main()
      .rises("neighbouring triangles are more alike, and there are more of them");
  t.boolean("surface.etaCompensated", "Accuracy from ρ only",
            ANGIOMESH_MEMBER(surface.sizing.etaCompensated),
            "on: only rho sets the accuracy and 1/eta the gradation (eq. 4.4); off: 1/eta shortens "
            "the edges too");
  t.real("surface.curvatureRelax", "Relax bends", ANGIOMESH_MEMBER(surface.sizing.curvatureRelax),
         0.1, 10.0, "", "the curvature is divided by it; 3 imitates the reference program")
      .rises("longer edges where the wall is curved");
  t.countOrNone("surface.edgesAround", "Edges around", ANGIOMESH_MEMBER(surface.sizing.edgesAround),
                3.0, 96.0,
                "least number of edges around any vessel; none: only the curvature counts")
      .main()
      .slider(3.0, 48.0)
      .suggest([](const Parameters&, const FieldContext&) {
        return static_cast<double>(SizingParams().edgesAround);
      })
      .rises("thin vessels get rounder, of more triangles");
  t.real("surface.edgeMinVoxels", "Finest edge", ANGIOMESH_MEMBER(surface.sizing.edgeMinVoxels),
         0.02, 20.0, "voxels",
         "curvature asks for no shorter edge than this, in edges of a cube as large as a voxel; "
         "none: no limit")
      .main()
      .logarithmic()
      .emptyWord("none")
      .slider(0.1, 4.0)
      .suggest([](const Parameters&, const FieldContext&) {
        return SizingParams().edgeMinVoxels.value_or(1.0);
      })
      .rises("fewer triangles where the wall is most curved");
  t.real("surface.edgeMinMm", "Shortest edge", ANGIOMESH_MEMBER(surface.sizing.edgeMinMm), 1e-3,
         1e3, "mm", "shortest wanted edge; none: no limit")
      .logarithmic()
      .emptyWord("none")
      .slider(0.02, 20.0, SliderUnit::Voxel)
      .suggest([](const Parameters& p, const FieldContext& c) {
        return std::min(0.2 * c.voxelMm, p.surface.sizing.edgeMaxMm.value_or(c.voxelMm));
      })
      .rises("fewer triangles, and thin vessels get angular");
  t.real("surface.edgeMaxMm", "Longest edge", ANGIOMESH_MEMBER(surface.sizing.edgeMaxMm), 1e-3, 1e3,
         "mm", "longest wanted edge; none: no limit")
      .logarithmic()
      .emptyWord("none")
      .notBelow("surface.edgeMinMm")
      .slider(0.02, 20.0, SliderUnit::Voxel)
      .suggest([](const Parameters& p, const FieldContext& c) {
        return std::max(2.0 * c.voxelMm, p.surface.sizing.edgeMinMm.value_or(c.voxelMm));
      })
      .rises("fewer triangles on wide vessels");
}

void addSurface(FieldTable& t) {
  t.choice("surface.method", "Method", ANGIOMESH_MEMBER(surface.method),
           {"advancing-front", "marching-cubes", "remesh"},
           "advancing-front: triangles of the wanted size, made on phi = 0 itself; marching-cubes: "
           "the triangles of each cell; remesh: marching cubes, remeshed to the wanted size")
      .main();
  t.choice("surface.spline", "Interpolant", ANGIOMESH_MEMBER(surface.spline),
           {"interpolating-bspline", "bspline", "catmull-rom"},
           "interpolant of phi whose zero set is the wall");
  addSizing(t);
  t.begin(Step::Surface, ReadOf::All);
  t.real("surface.cellVoxels", "Cell size", ANGIOMESH_MEMBER(surface.cellVoxels), 0.25, 4.0,
         "voxels", "edge of a marching cubes cell, working voxels")
      .main()
      .logarithmic()
      .idle(idleWithoutMarchingCubes)
      .rises("fewer and larger triangles");
  t.choice("surface.border", "At the border", ANGIOMESH_MEMBER(surface.border), {"cap", "open"},
           "where a vessel leaves the volume: a flat cap or an open rim")
      .main();
  t.real("surface.minComponentMm3", "Least component", ANGIOMESH_MEMBER(surface.minComponentMm3),
         0.0, 1e9, "mm3", "surface components that enclose less are left out")
      .slider(upToHundredth)
      .rises("small pieces of the surface are left out");
  t.integer("surface.maxTriangles", "Most triangles", ANGIOMESH_MEMBER(surface.maxTriangles), 0.0,
            2e9,
            "do not start a surface expected to have more triangles than this; 0: no limit; auto: "
            "what fits this machine's memory and about half an hour")
      .idle(idleForMarchingCubes)
      .rises("larger surfaces are begun");
}

void addSmooth(FieldTable& t) {
  t.choice("smooth.method", "Smoothing", ANGIOMESH_MEMBER(smooth.method),
           {"keep-wall", "taubin", "none"},
           "keep-wall: smooths the triangulation, not the vessel; taubin: as in the thesis")
      .main();
  t.integer("smooth.iterations", "Iterations", ANGIOMESH_MEMBER(smooth.iterations), 0, 1000,
            "sweeps over the vertices, with taubin pairs of a lambda and a mu step; 0: nothing is "
            "smoothed")
      .main()
      .slider(0.0, 500.0)
      .idle(idleWithoutSmoothing)
      .rises("smoother, and with taubin the vessel's own detail goes too");
  t.real("smooth.lambda", "Smooth by λ", ANGIOMESH_MEMBER(smooth.lambda), 0.0, 1.0, "",
         "weight of the shrinking step")
      .idle(idleWithoutTaubin)
      .rises("each iteration smooths more");
  t.real("smooth.mu", "Grow back by μ", ANGIOMESH_MEMBER(smooth.mu), -1.0, 0.0, "",
         "weight of the growing step")
      .idle(idleWithoutTaubin)
      .rises("less of the shrinking is made up for");
  t.real("smooth.wallBoundVoxels", "Stay near the wall", ANGIOMESH_MEMBER(smooth.wallBoundVoxels),
         0.0, 1.0, "voxels",
         "keep-wall: largest distance of a vertex from the wall, working voxels")
      .idle(idleWithoutKeepWall)
      .rises("vertices may leave the wall farther");
}

}  // namespace

void addSurfaceFields(FieldTable& table) {
  table.begin(Step::Correct, ReadOf::All);
  addCorrections(table);
  table.begin(Step::Surface, ReadOf::All);
  addPorts(table);
  addParts(table);
  addSurface(table);
  table.begin(Step::Smooth, ReadOf::All);
  addSmooth(table);
}

}  // namespace angiomesh
