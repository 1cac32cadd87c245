// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/expected_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/base/large_pages.h"
#include "core/sizing/guidance_samples.h"

namespace angiomesh {
namespace {

/// The fronts' triangles are a little smaller than equilateral ones of the wanted edge: where they
/// meet there is no room for whole ones.
constexpr double kFrontExcess = 1.045;

/// As measured with five million triangles.
constexpr double kBytesPerTriangle = 500.0;

/// Of meshing, smoothing and measuring on one processor of 2020, where the wall is rough; smooth
/// walls go twice as fast.
constexpr double kTrianglesPerSecond = 20000.0;

/// Shapes, phantom trees at any noise and scans come out at 0.9 to 1.1, with thick slices at 1.4;
/// of walls that were not made smooth and triangles that follow each bend, up to 3.
constexpr double kRough = 2.0;
/// A small surface costs little, whatever it looks like.
constexpr double kWorthAWord = 200000.0;
constexpr double kLongSeconds = 300.0;

std::string text(const char* format, double value) {
  char buffer[48];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

double gigabytes(double bytes) { return bytes / (1024.0 * 1024.0 * 1024.0); }

/// Area and triangles of the caps where vessels leave the volume.
double capTriangles(const SplineField& field, const GuidanceField& size, const CutAway& away) {
  const Geometry& g = field.geometry();
  const double voxel = g.voxelMm();
  double triangles = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const double pixel = g.spacing[u] * g.spacing[v];
    for (const int side : {0, g.size[axis] - 1}) {
      // The wanted length grows from the rim inwards; far inside it takes long to look up.
      double deep = 0.0, rim = 0.0, rimLength = 0.0;
      Index3 n;
      n[axis] = side;
      for (n[u] = 0; n[u] < g.size[u]; ++n[u])
        for (n[v] = 0; n[v] < g.size[v]; ++n[v]) {
          const double value = field.atVoxel(n[0], n[1], n[2]);
          if (!(value < 0.0)) continue;
          const Eigen::Vector3d point = g.toPhysical({1.0 * n[0], 1.0 * n[1], 1.0 * n[2]});
          if (!away.empty() && away.takenAt(point)) continue;
          if (value < -2.0 * voxel) {
            deep += pixel;
            continue;
          }
          const double length = size.at(point);
          rim += pixel;
          rimLength += pixel * length;
          triangles += evenTriangles(pixel, length);
        }
      if (rim == 0.0) continue;
      const double length = rimLength / rim + 3.0 * voxel * size.slope();
      triangles += evenTriangles(deep, length);
    }
  }
  return triangles;
}

/// Triangles of smooth vessels, and the edge that is wanted where they are thinnest.
void addSmooth(ExpectedSurface& expected, const SplineField& field, const SizingParams& sizing,
               const std::vector<SegmentComponent>& components) {
  const IdealLength ideal(field, sizing);
  std::vector<std::pair<double, double>> edges;  // length and the area that has it
  const auto add = [&](double area, double radius) {
    const double edge = ideal.at(1.0 / radius, [&](double) { return 2.0 * radius; });
    expected.smoothTriangles += evenTriangles(area, edge);
    edges.emplace_back(edge, area);
  };
  for (const SegmentComponent& part : components) {
    if (!part.kept) continue;
    ++expected.parts;
    const double before = expected.smoothTriangles;
    double radius = portableCubeRoot(0.75 * part.volumeMm3 / std::numbers::pi);
    int tips = 2;
    if (part.measure && part.measure->meanRadiusMm > 0.0) {
      for (const VesselPiece& piece : part.measure->pieces)
        add(2.0 * std::numbers::pi * piece.radiusMm * piece.lengthMm, piece.radiusMm);
      radius = part.measure->meanRadiusMm;
      tips = part.measure->tips;
    }
    if (radius > 0.0) add(2.0 * std::numbers::pi * radius * radius * tips, radius);
    if (part.volumeMm3 < 0.01 * components.front().volumeMm3) {
      ++expected.specks;
      expected.speckTriangles += expected.smoothTriangles - before;
    }
  }
  std::sort(edges.begin(), edges.end());
  double area = 0.0, seen = 0.0;
  for (const auto& [edge, share] : edges) area += share;
  for (const auto& [edge, share] : edges) {
    expected.smoothEdgeMm = edge;
    if ((seen += share) >= 0.1 * area) break;
  }
}

/// What can be done against too many triangles.
std::string remedies(const ExpectedSurface& expected) {
  std::string list = "ask for longer edges (surface.edgeMinMm";
  if (expected.smoothEdgeMm > 0.0) list += ", such as " + text("%.2g", expected.smoothEdgeMm);
  list += ")";
  if (expected.parts > 1)
    list += ", keep fewer of the " + std::to_string(expected.parts) +
            " parts (segmentation.keep, segmentation.minVolumeMm3)";
  return list + ", or draw a region of interest";
}

std::string duration(double seconds) {
  return seconds < 5400.0 ? text("%.0f minutes", std::max(1.0, std::round(seconds / 60.0)))
                          : text("%.1f hours", seconds / 3600.0);
}

}  // namespace

double ExpectedSurface::bytes() const { return kBytesPerTriangle * triangles; }

double ExpectedSurface::seconds() const { return triangles / kTrianglesPerSecond; }

double ExpectedSurface::roughness() const {
  return smoothTriangles > 0.0 ? triangles / smoothTriangles : 0.0;
}

ExpectedSurface expectSurface(const SplineField& field, const GuidanceField& size,
                              const SurfaceParams& params,
                              const std::vector<SegmentComponent>& components,
                              const CutAway& away) {
  ExpectedSurface expected;
  expected.triangles = size.estimatedTriangles();
  if (params.border == SurfaceBorder::Cap) expected.triangles += capTriangles(field, size, away);
  expected.triangles *= kFrontExcess;
  addSmooth(expected, field, params.sizing, components);
  return expected;
}

std::vector<SegmentComponent> allComponents(const Volume<float>& phi, const Progress& progress) {
  const bool any =
      std::any_of(phi.voxels.begin(), phi.voxels.end(), [](float value) { return value < 0.0F; });
  if (!any) return {};
  return selectSegments(phi, {}, {}, progress).components;
}

ExpectedSurface expectSurface(const Volume<float>& phi, const SplineField& field,
                              const SurfaceParams& params, const Progress& progress,
                              const CutAway& away) {
  const GuidanceField size(field, params.sizing, progress.sub(0.0, 0.5), &away);
  return expectSurface(field, size, params, allComponents(phi, progress.sub(0.5, 1.0)), away);
}

SurfaceLimits SurfaceLimits::ofMachine() {
  SurfaceLimits limits;
  limits.bytes = static_cast<double>(physicalMemory());
  return limits;
}

std::optional<std::string> refusal(const ExpectedSurface& expected, const SurfaceParams& params,
                                   const SurfaceLimits& limits) {
  if (params.maxTriangles) {
    if (*params.maxTriangles == 0 || expected.triangles <= *params.maxTriangles)
      return std::nullopt;
    return "surface.maxTriangles = " + std::to_string(*params.maxTriangles) + " allows fewer";
  }
  // 0: not known.
  if (limits.bytes > 0.0 && expected.bytes() >= limits.bytes)
    return "they take about " + text("%.0f GB", gigabytes(expected.bytes())) +
           " of memory and this machine has " + text("%.0f GB", gigabytes(limits.bytes));
  if (expected.seconds() > limits.seconds)
    return "they take about " + duration(expected.seconds()) + " of processor time";
  return std::nullopt;
}

void checkExpected(const ExpectedSurface& expected, const SurfaceParams& params,
                   const SurfaceLimits& limits) {
  const std::optional<std::string> why = refusal(expected, params, limits);
  if (!why) return;
  throw InputError(
      "the surface is not begun: " + aboutSoMany(expected.triangles) + " triangles are expected" +
          (expected.roughness() > kRough ? ", " + text("%.0f", expected.roughness()) +
                                               " times as many as smooth vessels of this size have"
                                         : std::string()) +
          "; " + *why,
      "surface", remedies(expected) + "; surface.maxTriangles = 0 makes it all the same");
}

std::vector<std::string> warningsOf(const ExpectedSurface& expected) {
  std::vector<std::string> list;
  const std::string many = aboutSoMany(expected.triangles) + " triangles are expected";
  if (expected.roughness() > kRough && expected.triangles > kWorthAWord)
    list.push_back(many + ", " + text("%.0f", expected.roughness()) +
                   " times as many as smooth vessels of this length and thickness have: the wall "
                   "is rough; " +
                   remedies(expected));
  else if (expected.triangles > kWorthAWord &&
           expected.speckTriangles > 0.5 * expected.smoothTriangles)
    list.push_back(many + ", most of them on " + std::to_string(expected.specks) +
                   " specks of less than a hundredth of the largest part: keep fewer parts "
                   "(segmentation.keep, segmentation.minVolumeMm3)");
  else if (expected.seconds() > kLongSeconds)
    list.push_back(many + ", which take up to " + duration(expected.seconds()) +
                   " of processor time and about " + text("%.1f GB", gigabytes(expected.bytes())) +
                   " of memory: for fewer, " + remedies(expected));
  return list;
}

std::string aboutSoMany(double count) {
  if (count >= 999500.0)
    return "about " + text(count < 9.95e6 ? "%.1f" : "%.0f", 1e-6 * count) + " million";
  double unit = 1.0;
  while (count >= 100.0 * unit) unit *= 10.0;
  std::string digits = text("%.0f", std::round(count / unit) * unit);
  if (digits.size() > 3) digits.insert(digits.size() - 3, ",");
  return "about " + digits;
}

}  // namespace angiomesh
