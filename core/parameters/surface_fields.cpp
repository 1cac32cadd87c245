// SPDX-License-Identifier: BSD-3-Clause
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
void addSizing(FieldTable& t) {
  const auto add = [](Field& field) -> Field& {
    field.idle = idleForMarchingCubes;
    return field;
  };
  Field& rho = add(t.real("surface.rho", ANGIOMESH_MEMBER(surface.sizing.rho), 0.02, 2.0, "rad",
                          "accuracy: the angle that an edge subtends on the osculating circle, eq. "
                          "4.1; smaller is finer, down to edgeMinVoxels"));
  rho.main = rho.logarithmic = true;
  add(t.real("surface.etaInverse", ANGIOMESH_MEMBER(surface.sizing.etaInverse), 0.3, 0.99, "",
             "1/eta of eq. 4.2: the wanted edge length grows by at most 1 - 1/eta per length; "
             "larger is more even"))
      .main = true;
  add(t.boolean("surface.etaCompensated", ANGIOMESH_MEMBER(surface.sizing.etaCompensated),
                "rho alone sets the accuracy and 1/eta the gradation, eq. 4.4; off: 1/eta shortens "
                "the edges too"));
  add(t.real("surface.curvatureRelax", ANGIOMESH_MEMBER(surface.sizing.curvatureRelax), 0.1, 10.0,
             "", "the curvature is divided by it; 3 imitates the reference program"));
  add(t.countOrNone("surface.edgesAround", ANGIOMESH_MEMBER(surface.sizing.edgesAround), 3.0, 96.0,
                    "at least so many edges around any vessel; none: the curvature alone counts"))
      .main = true;
  Field& resolved = add(t.real(
      "surface.edgeMinVoxels", ANGIOMESH_MEMBER(surface.sizing.edgeMinVoxels), 0.02, 20.0, "voxels",
      "curvature asks for no shorter edge than this, in edges of a cube as large as a "
      "voxel; none: no limit"));
  resolved.emptyWord = "none";
  resolved.main = resolved.logarithmic = true;
  Field& least = add(t.real("surface.edgeMinMm", ANGIOMESH_MEMBER(surface.sizing.edgeMinMm), 1e-3,
                            1e3, "mm", "no shorter edge is wanted; none: no limit"));
  least.emptyWord = "none";
  least.logarithmic = true;
  Field& most = add(t.real("surface.edgeMaxMm", ANGIOMESH_MEMBER(surface.sizing.edgeMaxMm), 1e-3,
                           1e3, "mm", "no longer edge is wanted; none: no limit"));
  most.emptyWord = "none";
  most.logarithmic = true;
}

void addSurface(FieldTable& t) {
  t.choice("segmentation.keep", ANGIOMESH_MEMBER(segmentation.keep), {"all", "largest", "seeded"},
           "which components go into the surface; seeded: those that hold a seed given by hand");
  t.real("segmentation.minVolumeMm3", ANGIOMESH_MEMBER(segmentation.minVolumeMm3), 0.0, 1e9, "mm3",
         "components smaller than this are left out");
  t.points("segmentation.drop", ANGIOMESH_MEMBER(segmentation.drop),
           "the components that hold these points, x,y,z,... in mm LPS, are left out");
  t.choice("surface.method", ANGIOMESH_MEMBER(surface.method),
           {"advancing-front", "marching-cubes", "remesh"},
           "advancing-front: triangles of the wanted size, made on phi = 0 itself; marching-cubes: "
           "one set for each cell; remesh: marching cubes made over to the wanted size")
      .main = true;
  t.choice("surface.spline", ANGIOMESH_MEMBER(surface.spline),
           {"interpolating-bspline", "bspline", "catmull-rom"},
           "interpolant of phi whose zero set is the wall");
  addSizing(t);
  Field& cell = t.real("surface.cellVoxels", ANGIOMESH_MEMBER(surface.cellVoxels), 0.25, 4.0,
                       "voxels", "edge of a marching cubes cell, working voxels; smaller is finer");
  cell.main = cell.logarithmic = true;
  cell.idle = idleWithoutMarchingCubes;
  t.choice("surface.border", ANGIOMESH_MEMBER(surface.border), {"cap", "open"},
           "where a vessel leaves the volume: a flat cap or an open rim")
      .main = true;
  t.real("surface.minComponentMm3", ANGIOMESH_MEMBER(surface.minComponentMm3), 0.0, 1e9, "mm3",
         "surface components that enclose less are left out");
  Field& limit = t.integer(
      "surface.maxTriangles", ANGIOMESH_MEMBER(surface.maxTriangles), 0.0, 2e9,
      "a surface of which more are expected is not begun; 0: any is; auto: what this machine's "
      "memory and about half an hour hold");
  limit.idle = idleForMarchingCubes;
}

void addPorts(FieldTable& t) {
  t.texts("ports.cuts", ANGIOMESH_MEMBER(ports.cuts), "x,y,z,NAME or x,y,z,nx,ny,nz,NAME",
          "planes that end vessels, in mm LPS, with the names of the openings; the part beyond, on "
          "the side of the normal, goes; without a normal the vessel's axis, towards the smaller "
          "part",
          [](const std::string& text) { parseCut(text); });
  t.boolean(
      "ports.cutBorders", ANGIOMESH_MEMBER(ports.cutBorders),
      "vessels that the volume's border slices (by more than 30 degrees, or 1.3 times the area "
      "of their section) are cut across just inside, as across_1 and on");
  t.texts(
      "ports.names", ANGIOMESH_MEMBER(ports.names), "border_1=NAME or x,y,z=NAME",
      "ports, as reports call them or by where they lie, in mm LPS, and the names that they get "
      "instead",
      [](const std::string& text) { parsePortNaming(text); });
  Field& ends =
      t.real("ports.cutEndsRadii", ANGIOMESH_MEMBER(ports.cutEndsRadii), 0.0, 50.0, "radii",
             "every vessel that ends in the volume is cut so far before its tip, as end_1 "
             "and on; 0: none is");
  ends.main = true;
}

void addSmooth(FieldTable& t) {
  t.choice("smooth.method", ANGIOMESH_MEMBER(smooth.method), {"keep-wall", "taubin", "none"},
           "keep-wall: smooths the triangulation, not the vessel; taubin: as in the thesis")
      .main = true;
  Field& iterations = t.integer("smooth.iterations", ANGIOMESH_MEMBER(smooth.iterations), 0, 1000,
                                "pairs of a lambda and a mu step; 0: nothing is smoothed");
  iterations.main = true;
  iterations.idle = idleWithoutSmoothing;
  t.real("smooth.lambda", ANGIOMESH_MEMBER(smooth.lambda), 0.0, 1.0, "",
         "weight of the shrinking step")
      .idle = idleForEvenTriangles;
  t.real("smooth.mu", ANGIOMESH_MEMBER(smooth.mu), -1.0, 0.0, "", "weight of the growing step")
      .idle = idleWithoutTaubin;
  t.real("smooth.wallBoundVoxels", ANGIOMESH_MEMBER(smooth.wallBoundVoxels), 0.0, 1.0, "voxels",
         "keep-wall: largest distance of a vertex from the wall, working voxels")
      .idle = idleWithoutKeepWall;
}

}  // namespace

void addSurfaceFields(FieldTable& table) {
  addPorts(table);
  addSurface(table);
  addSmooth(table);
}

}  // namespace angiomesh
