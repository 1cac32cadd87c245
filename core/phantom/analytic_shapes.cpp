// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/phantom/shape.h"

namespace angiomesh {
namespace {

constexpr double kDaughterAngle = 35.0 / 360.0;  // turns, between parent axis and each daughter
constexpr double kKissingAngle = 35.0 / 360.0;   // turns, by which each tube bends away

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// What the builders need to know about the volume; lengths in mm.
struct Frame {
  double unit = 1.0;                    // the smallest spacing
  Eigen::Vector3d centre;               // of the volume, moved by the sub-voxel offset
  Eigen::Vector3d first, second, axis;  // right-handed, orthonormal
  Eigen::Vector3d low, high;            // the volume's corners
  double halfSide = 0.0;                // half the shortest side
  double through = 0.0;                 // a length that leaves the volume from anywhere
  double radius = 0.0;                  // of the vessel

  [[nodiscard]] Eigen::Vector3d at(double u, double v, double w) const {
    return centre + u * first + v * second + w * axis;
  }
};

Frame makeFrame(const PhantomParams& params, const Geometry& g) {
  const double norm = std::sqrt(params.axis.dot(params.axis));
  if (!std::isfinite(norm) || norm < 1e-9)
    throw InputError("the axis has no direction", "phantom axis",
                     "give three numbers that are not all 0");
  if (!params.offset.allFinite() || params.offset.cwiseAbs().maxCoeff() > 4.0)
    throw InputError("the shift is too large", "phantom offset", "give at most 4 voxels");
  if (!std::isfinite(params.radius) || params.radius < 0.5)
    throw InputError("a vessel radius of " + number(params.radius) + " voxels cannot be drawn",
                     "phantom radius", "give at least 0.5 voxel");
  Frame frame;
  frame.unit = g.voxelMm();
  frame.radius = params.radius * frame.unit;
  frame.axis = params.axis / norm;
  const Eigen::Vector3d magnitude = frame.axis.cwiseAbs();
  int least = 0;
  for (int a = 1; a < 3; ++a)
    if (magnitude[a] < magnitude[least]) least = a;
  Eigen::Vector3d side = Eigen::Vector3d::Unit(least);
  side -= side.dot(frame.axis) * frame.axis;
  frame.first = side / std::sqrt(side.dot(side));
  frame.second = Eigen::Vector3d(frame.axis[1] * frame.first[2] - frame.axis[2] * frame.first[1],
                                 frame.axis[2] * frame.first[0] - frame.axis[0] * frame.first[2],
                                 frame.axis[0] * frame.first[1] - frame.axis[1] * frame.first[0]);
  const Eigen::Vector3d size(g.size[0], g.size[1], g.size[2]);
  frame.low = -0.5 * g.spacing;
  frame.high = (size - Eigen::Vector3d::Constant(0.5)).cwiseProduct(g.spacing);
  frame.centre = 0.5 * (frame.low + frame.high) + params.offset * frame.unit;
  const Eigen::Vector3d extent = frame.high - frame.low;
  frame.halfSide = 0.5 * extent.minCoeff();
  frame.through = std::sqrt(extent.dot(extent));
  return frame;
}

/// @param halfWidth largest distance of the wall from the volume's centre that has to fit, mm
void requireRoom(const Frame& frame, double halfWidth, const char* kind) {
  const double room = frame.halfSide - frame.unit;
  if (halfWidth <= room) return;
  const double radius = frame.radius / frame.unit;
  throw InputError(
      "a " + std::string(kind) + " of radius " + number(radius) + " voxels does not fit",
      "phantom of " + number(2.0 * frame.halfSide / frame.unit) + " voxels in its shortest side",
      "give a radius of about " + number(std::max(0.5, radius * room / halfWidth)) +
          " voxels or a size of " + number(std::ceil(2.0 * (halfWidth / frame.unit + 1.0))));
}

/// The part of a segment inside the volume (Liang and Barsky 1984).
std::optional<std::array<double, 2>> clip(const Frame& frame, const Eigen::Vector3d& from,
                                          const Eigen::Vector3d& to) {
  double enter = 0.0;
  double leave = 1.0;
  for (int a = 0; a < 3; ++a) {
    const double step = to[a] - from[a];
    if (step == 0.0) {
      if (from[a] < frame.low[a] || from[a] > frame.high[a]) return std::nullopt;
      continue;
    }
    const double t0 = (frame.low[a] - from[a]) / step;
    const double t1 = (frame.high[a] - from[a]) / step;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  if (enter >= leave) return std::nullopt;
  return std::array<double, 2>{enter, leave};
}

/// Appends what lies in the volume of the line through `points`. @return the last piece's number,
/// -1 where nothing was inside
int addCentreLine(Shape& shape, const Frame& frame, const std::vector<Eigen::Vector3d>& points,
                  const std::vector<double>& radii, int parent = -1) {
  int last = parent;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto part = clip(frame, points[i - 1], points[i]);
    if (!part) {
      last = -1;
      continue;
    }
    const Eigen::Vector3d step = points[i] - points[i - 1];
    const double grow = radii[i] - radii[i - 1];
    const auto [enter, leave] = *part;
    shape.centreLines.push_back({points[i - 1] + enter * step, points[i - 1] + leave * step,
                                 radii[i - 1] + enter * grow, radii[i - 1] + leave * grow,
                                 enter > 0.0 ? -1 : last});
    last = static_cast<int>(shape.centreLines.size()) - 1;
  }
  return last;
}

void addCone(Shape& shape, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
  shape.solids.emplace_back(RoundCone(from, to, radius, radius));
}

void buildTube(Shape& shape, const Frame& f) {
  requireRoom(f, f.radius, "tube");
  const Eigen::Vector3d from = f.at(0, 0, -f.through);
  const Eigen::Vector3d to = f.at(0, 0, f.through);
  addCone(shape, from, to, f.radius);
  addCentreLine(shape, f, {from, to}, {f.radius, f.radius});
}

void buildTorus(Shape& shape, const Frame& f) {
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

void buildHelix(Shape& shape, const Frame& f) {
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

void buildBifurcation(Shape& shape, const Frame& f) {
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

void buildKissing(Shape& shape, const Frame& f, double gapVoxels) {
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

void buildStenosis(Shape& shape, const Frame& f) {
  requireRoom(f, f.radius, "stenosis");
  WaistedTube tube{f.centre, f.axis};
  tube.radius = f.radius;
  tube.throat = 0.5 * f.radius;
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

void buildAneurysm(Shape& shape, const Frame& f) {
  const double sac = 2.0 * f.radius;
  const double away = 2.5 * f.radius;
  requireRoom(f, sac + away, "aneurysm");
  buildTube(shape, f);
  addCone(shape, f.at(away, 0, 0), f.at(away, 0, 0), sac);
  shape.centreLines.push_back({f.centre, f.at(away, 0, 0), f.radius, sac, 0});
  shape.blendMm = 0.5 * f.radius;
}

/// Ten tapering capsules in a ball of radius 27 (lengths for a radius of 4): a trunk, two branches
/// that fork again, two tips, and a bridge between the inner twigs.
void buildCapsuleTree(Shape& shape, const Frame& f) {
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

Geometry phantomGeometry(const PhantomParams& params) {
  Geometry g;
  g.size = params.size;
  g.spacing = params.spacingMm;
  double voxels = 1.0;
  for (int a = 0; a < 3; ++a) {
    if (g.size[a] < 8 || g.size[a] > 4096)
      throw InputError("a side of " + std::to_string(g.size[a]) + " voxels makes no phantom",
                       "phantom size", "give 8 to 4096 voxels in each direction");
    if (!std::isfinite(g.spacing[a]) || g.spacing[a] < 1e-3 || g.spacing[a] > 1e3)
      throw InputError("a spacing of " + number(g.spacing[a]) + " mm makes no phantom",
                       "phantom spacing", "give 0.001 to 1000 mm in each direction");
    voxels *= g.size[a];
  }
  if (voxels > 1024.0 * 1024.0 * 1024.0)
    throw InputError("a phantom of " + number(voxels) + " voxels is too large", "phantom size",
                     "give at most 1024 x 1024 x 1024 voxels");
  if (g.spacing.maxCoeff() > 20.0 * g.spacing.minCoeff())
    throw InputError("the spacing differs by more than 20 times between the axes",
                     "phantom spacing", "give spacings that are closer to one another");
  return g;
}

Shape analyticShape(const PhantomParams& params) {
  const Frame frame = makeFrame(params, phantomGeometry(params));
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
      buildStenosis(shape, frame);
      break;
    case PhantomKind::Aneurysm:
      buildAneurysm(shape, frame);
      break;
    case PhantomKind::CapsuleTree:
      buildCapsuleTree(shape, frame);
      break;
  }
  return shape;
}

}  // namespace angiomesh
