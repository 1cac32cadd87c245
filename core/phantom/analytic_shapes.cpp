// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/phantom/shape_frame.h"
#include "core/phantom/vessel_tree.h"

namespace angiomesh {
namespace {

constexpr double kDaughterAngle = 35.0 / 360.0;  // turns, between parent axis and each daughter
constexpr double kKissingAngle = 35.0 / 360.0;   // turns, by which each tube bends away

void addCone(Shape& shape, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
  shape.solids.emplace_back(RoundCone(from, to, radius, radius));
}

void buildTube(Shape& shape, const ShapeFrame& f) {
  requireRoom(f, f.radius, "tube");
  const Eigen::Vector3d from = f.at(0, 0, -f.through);
  const Eigen::Vector3d to = f.at(0, 0, f.through);
  addCone(shape, from, to, f.radius);
  addCentreLine(shape, f, {from, to}, {f.radius, f.radius});
}

void buildTorus(Shape& shape, const ShapeFrame& f) {
  const double major = 0.5 * f.halfSide;
  requireRoom(f, major + f.radius, "torus");
  requireRoom(f, 2.0 * (f.radius + f.unit), "torus");  // leaves the hole open
  ArcTube torus{f.centre, f.first, f.second};
  torus.majorRadius = major;
  torus.radius = f.radius;
  shape.solids.emplace_back(torus);
  constexpr int pieces = 96;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= pieces; ++i) {
    const double turns = static_cast<double>(i) / pieces;
    points.push_back(f.at(major * portableCosTurns(turns), major * portableSinTurns(turns), 0.0));
  }
  addCentreLine(shape, f, points, std::vector<double>(points.size(), f.radius));
}

void buildHelix(Shape& shape, const ShapeFrame& f) {
  HelixTube helix{f.centre, f.first, f.second, f.axis};
  helix.coilRadius = 0.5 * f.halfSide;
  helix.radius = f.radius;
  requireRoom(f, helix.coilRadius + f.radius, "helix");
  requireRoom(f, 2.0 * (f.radius + f.unit), "helix");
  const double reach = f.halfSide - f.unit - f.radius;  // the ends stay inside for any axis
  const double height = std::sqrt(reach * reach - helix.coilRadius * helix.coilRadius);
  helix.pitch = std::min(5.0 * f.radius, 2.0 * height);
  helix.halfTurns = height / helix.pitch;
  shape.solids.emplace_back(helix);
  const int pieces = static_cast<int>(std::ceil(2.0 * helix.halfTurns * 48.0));
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= pieces; ++i)
    points.push_back(helix.centreLineAt(helix.halfTurns * (2.0 * i / pieces - 1.0)));
  addCentreLine(shape, f, points, std::vector<double>(points.size(), f.radius));
}

void buildBifurcation(Shape& shape, const ShapeFrame& f) {
  requireRoom(f, 2.0 * f.radius, "bifurcation");
  const double daughter = f.radius * portableExp(-portableLog(2.0) / 3.0);  // Murray's law
  const Eigen::Vector3d from = f.at(0, 0, -f.through);
  addCone(shape, from, f.centre, f.radius);
  const int parent = addCentreLine(shape, f, {from, f.centre}, {f.radius, f.radius});
  const double along = 2.0 * f.through * portableCosTurns(kDaughterAngle);
  const double aside = 2.0 * f.through * portableSinTurns(kDaughterAngle);
  for (const double sign : {-1.0, 1.0}) {
    const Eigen::Vector3d to = f.at(sign * aside, 0, along);
    addCone(shape, f.centre, to, daughter);
    addCentreLine(shape, f, {f.centre, to}, {daughter, daughter}, parent);
  }
  shape.blendMm = 0.5 * f.radius;
}

void buildKissing(Shape& shape, const ShapeFrame& f, double gapVoxels) {
  if (!std::isfinite(gapVoxels) || gapVoxels < 0.0)
    throw InputError("the gap between the walls is negative", "phantom gap",
                     "give 0 or more voxels");
  const double aside = f.radius + 0.5 * gapVoxels * f.unit;
  requireRoom(f, aside + f.radius, "pair of kissing tubes");
  const double straight = 2.0 * f.radius;  // half the length along which the walls are parallel
  const double bend = 6.0 * f.radius;
  const double c = portableCosTurns(kKissingAngle);
  const double s = portableSinTurns(kKissingAngle);
  const double halfC = portableCosTurns(0.5 * kKissingAngle);
  const double halfS = portableSinTurns(0.5 * kKissingAngle);
  for (const double side : {-1.0, 1.0}) {
    std::vector<Eigen::Vector3d> points;
    for (const double end : {-1.0, 1.0}) {
      const auto at = [&](double u, double w) { return f.at(side * u, 0.0, end * w); };
      const Eigen::Vector3d bent = at(aside + bend * (1.0 - c), straight + bend * s);
      const Eigen::Vector3d far = bent + 2.0 * f.through * (side * s * f.first + end * c * f.axis);
      ArcTube arc{at(aside + bend, straight), -side * halfC * f.first + end * halfS * f.axis,
                  side * halfS * f.first + end * halfC * f.axis};
      arc.majorRadius = bend;
      arc.cosHalf = halfC;
      arc.sinHalf = halfS;
      arc.radius = f.radius;
      shape.solids.emplace_back(arc);
      addCone(shape, bent, far, f.radius);
      std::vector<Eigen::Vector3d> half{at(aside, straight)};
      constexpr int pieces = 16;
      for (int i = 1; i <= pieces; ++i) {
        const double turns = kKissingAngle * i / pieces;
        half.push_back(at(aside + bend * (1.0 - portableCosTurns(turns)),
                          straight + bend * portableSinTurns(turns)));
      }
      half.push_back(far);
      if (end < 0.0) std::reverse(half.begin(), half.end());
      points.insert(points.end(), half.begin(), half.end());
    }
    addCone(shape, f.at(side * aside, 0, -straight), f.at(side * aside, 0, straight), f.radius);
    addCentreLine(shape, f, points, std::vector<double>(points.size(), f.radius));
  }
}

void buildStenosis(Shape& shape, const ShapeFrame& f, double percent) {
  if (!(percent > 0.0 && percent <= 95.0))
    throw InputError("the stenosis has no usable narrowing", "phantom stenosis",
                     "give a percentage of the diameter above 0 and up to 95");
  requireRoom(f, f.radius, "stenosis");
  WaistedTube tube{f.centre, f.axis};
  tube.radius = f.radius;
  tube.throat = (1.0 - 0.01 * percent) * f.radius;
  tube.halfLength = 3.0 * f.radius;
  shape.solids.emplace_back(tube);
  std::vector<Eigen::Vector3d> points{f.at(0, 0, -f.through)};
  std::vector<double> radii{f.radius};
  constexpr int pieces = 48;
  for (int i = 0; i <= pieces; ++i) {
    const double w = tube.halfLength * (2.0 * i / pieces - 1.0);
    points.push_back(f.at(0, 0, w));
    radii.push_back(tube.radiusAt(w));
  }
  points.push_back(f.at(0, 0, f.through));
  radii.push_back(f.radius);
  addCentreLine(shape, f, points, radii);
}

void buildAneurysm(Shape& shape, const ShapeFrame& f) {
  const double sac = 2.0 * f.radius;
  const double away = 2.5 * f.radius;
  requireRoom(f, sac + away, "aneurysm");
  buildTube(shape, f);
  addCone(shape, f.at(away, 0, 0), f.at(away, 0, 0), sac);
  shape.centreLines.push_back({f.centre, f.at(away, 0, 0), f.radius, sac, 0});
  shape.blendMm = 0.5 * f.radius;
}

void buildNeckAneurysm(Shape& shape, const ShapeFrame& f) {
  const double sac = 2.0 * f.radius;
  const double away = 3.6 * f.radius;
  requireRoom(f, sac + away, "aneurysm on a neck");
  buildTube(shape, f);
  const Eigen::Vector3d centre = f.at(away, 0, 0);
  addCone(shape, f.centre, centre, 0.8 * f.radius);
  addCone(shape, centre, centre, sac);
  shape.centreLines.push_back({f.centre, centre, 0.8 * f.radius, sac, 0});
  shape.blendMm = 0.5 * f.radius;
}

void buildBentTube(Shape& shape, const ShapeFrame& f) {
  requireRoom(f, 2.0 * f.radius, "bent tube");
  constexpr double halfTurns = 0.125;  // of the arc, on either side of its middle
  ArcTube arc{f.centre + 4.0 * f.radius * f.first, -f.first, f.axis};
  arc.majorRadius = 4.0 * f.radius;
  arc.cosHalf = portableCosTurns(halfTurns);
  arc.sinHalf = portableSinTurns(halfTurns);
  arc.radius = f.radius;
  shape.solids.emplace_back(arc);
  const auto onArc = [&](double turns) -> Eigen::Vector3d {
    return arc.centre + arc.majorRadius * (portableCosTurns(turns) * arc.toMiddle +
                                           portableSinTurns(turns) * arc.side);
  };
  std::vector<Eigen::Vector3d> points;
  constexpr int pieces = 32;
  for (int i = 0; i <= pieces; ++i) points.push_back(onArc(halfTurns * (2.0 * i / pieces - 1.0)));
  const Eigen::Vector3d aside = arc.sinHalf * f.first;
  points.insert(points.begin(), points.front() + 2.0 * f.through * (aside - arc.cosHalf * f.axis));
  points.push_back(points.back() + 2.0 * f.through * (aside + arc.cosHalf * f.axis));
  addCone(shape, points[0], points[1], f.radius);
  addCone(shape, points[points.size() - 2], points.back(), f.radius);
  addCentreLine(shape, f, points, std::vector<double>(points.size(), f.radius));
}

void buildCone(Shape& shape, const ShapeFrame& f) {
  requireRoom(f, 1.5 * f.radius, "cone");
  const Eigen::Vector3d start = f.at(0, 0, -f.through);
  const Eigen::Vector3d way = 2.0 * f.through * f.axis;
  const auto part = clipToVolume(f, start, start + way);
  if (!part) return;
  const auto [enter, leave] = *part;
  // A quarter longer at either end, so that the volume holds neither.
  const double beyond = 0.25 * (leave - enter);
  const Eigen::Vector3d from = start + (enter - beyond) * way;
  const Eigen::Vector3d to = start + (leave + beyond) * way;
  const double radiusFrom = 1.75 * f.radius;
  const double radiusTo = 0.25 * f.radius;
  shape.solids.emplace_back(RoundCone(from, to, radiusFrom, radiusTo));
  addCentreLine(shape, f, {from, to}, {radiusFrom, radiusTo});
}

/// Ten tapering capsules in a ball of radius 27 (lengths for a radius of 4): a trunk, two branches
/// that fork again, two tips, and a bridge between the inner twigs.
void buildCapsuleTree(Shape& shape, const ShapeFrame& f) {
  struct Capsule {
    int from, to, parent;
    double radiusFrom, radiusTo;
  };
  static constexpr double nodes[10][3] = {
      {0, 0, -20},    {0, 0, -6},   {-9, 2, 4},     {9, -2, 4},       {-14, 4, 13},
      {-6, -2, 16.5}, {14, -5, 13}, {6.5, 3, 16.5}, {-16.5, 6, 18.5}, {16.5, -8, 17.5}};
  static constexpr Capsule capsules[10] = {
      {0, 1, -1, 6.0, 5.0}, {1, 2, 0, 4.5, 3.6}, {1, 3, 0, 4.5, 3.6}, {2, 4, 1, 3.2, 2.4},
      {2, 5, 1, 3.0, 2.2},  {3, 6, 2, 3.2, 2.4}, {3, 7, 2, 3.0, 2.0}, {4, 8, 3, 2.4, 1.5},
      {6, 9, 5, 2.4, 1.5},  {5, 7, 4, 2.2, 1.8}};
  const double thickness = f.radius / 4.0;
  const double room = f.halfSide - f.unit;
  const double length = std::min((room - 6.0 * thickness) / 20.0, (room - 1.5 * thickness) / 25.5);
  if (length < thickness) requireRoom(f, 27.0 * thickness, "capsule tree");
  const auto at = [&](int n) {
    return f.at(length * nodes[n][0], length * nodes[n][1], length * nodes[n][2]);
  };
  for (const Capsule& c : capsules) {
    const double from = c.radiusFrom * thickness;
    const double to = c.radiusTo * thickness;
    shape.solids.emplace_back(RoundCone(at(c.from), at(c.to), from, to));
    shape.centreLines.push_back({at(c.from), at(c.to), from, to, c.parent});
  }
  shape.blendMm = 2.0 * f.unit;
}

}  // namespace

Shape analyticShape(const PhantomParams& params) {
  const ShapeFrame frame = makeShapeFrame(params, phantomGeometry(params));
  Shape shape;
  switch (params.kind) {
    case PhantomKind::Tree:
      throw InputError("a vascular tree has no closed form", "phantom kind",
                       "name one of the other kinds");
    case PhantomKind::Tube:
      buildTube(shape, frame);
      break;
    case PhantomKind::Torus:
      buildTorus(shape, frame);
      break;
    case PhantomKind::Bifurcation:
      buildBifurcation(shape, frame);
      break;
    case PhantomKind::Kissing:
      buildKissing(shape, frame, params.gap);
      break;
    case PhantomKind::Helix:
      buildHelix(shape, frame);
      break;
    case PhantomKind::Stenosis:
      buildStenosis(shape, frame, params.stenosisPercent);
      break;
    case PhantomKind::Aneurysm:
      buildAneurysm(shape, frame);
      break;
    case PhantomKind::CapsuleTree:
      buildCapsuleTree(shape, frame);
      break;
    case PhantomKind::BentTube:
      buildBentTube(shape, frame);
      break;
    case PhantomKind::Cone:
      buildCone(shape, frame);
      break;
    case PhantomKind::NeckAneurysm:
      buildNeckAneurysm(shape, frame);
      break;
    case PhantomKind::VesselTree:
      buildVesselTree(shape, frame, params.randomSeed);
      break;
  }
  return shape;
}

}  // namespace angiomesh
