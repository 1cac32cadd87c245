// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/vessel_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/statistics.h"
#include "core/image/voxels.h"
#include "core/phantom/wall_truth.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Where phi changes sign between two neighbouring voxels, index space.
void addCrossings(const SplineField& phi, int k, std::vector<Vector3d>& crossings) {
  const Index3& n = phi.geometry().size;
  const auto columns = static_cast<std::size_t>(n[0]);
  const auto rowsOf = [&](int layer) {
    std::vector<float> values(columns * static_cast<std::size_t>(n[1]));
    for (int j = 0; j < n[1]; ++j)
      phi.atVoxels(0, n[0] - 1, j, layer, values.data() + columns * static_cast<std::size_t>(j));
    return values;
  };
  const std::vector<float> here = rowsOf(k);
  const std::vector<float> above = k + 1 < n[2] ? rowsOf(k + 1) : std::vector<float>();
  const auto test = [&](float a, float b, int i, int j, int axis) {
    if ((a < 0.0F) == (b < 0.0F)) return;
    Vector3d index(i, j, k);
    index[axis] += static_cast<double>(a) / (static_cast<double>(a) - static_cast<double>(b));
    crossings.push_back(index);
  };
  for (int j = 0; j < n[1]; ++j)
    for (int i = 0; i < n[0]; ++i) {
      const std::size_t at = static_cast<std::size_t>(i) + columns * static_cast<std::size_t>(j);
      if (i + 1 < n[0]) test(here[at], here[at + 1], i, j, 0);
      if (j + 1 < n[1]) test(here[at], here[at + columns], i, j, 1);
      if (k + 1 < n[2]) test(here[at], above[at], i, j, 2);
    }
}

/// The middle part of a straight line and what is around it.
struct Cylinder {
  Vector3d from, along;
  double low, high, around;
  Cylinder(const Vector3d& a, const Vector3d& b, double aroundMm, double share)
      : from(a),
        along((b - a).normalized()),
        low(0.5 * (1.0 - share) * (b - a).norm()),
        high(0.5 * (1.0 + share) * (b - a).norm()),
        around(aroundMm) {}
  [[nodiscard]] bool holds(const Vector3d& point, double margin) const {
    const double s = (point - from).dot(along);
    if (s < low - margin || s > high + margin) return false;
    return (point - from - s * along).norm() <= around + margin;
  }
};

/// The share of the samples in a voxel's box for which `inside` holds.
template <class Inside>
double shareOfVoxel(const Geometry& g, const Vector3d& index, const Inside& inside) {
  constexpr int samples = 4;
  int count = 0;
  for (int c = 0; c < samples; ++c)
    for (int b = 0; b < samples; ++b)
      for (int a = 0; a < samples; ++a) {
        const Vector3d shift = (Vector3d(a, b, c) + Vector3d::Constant(0.5)) / samples;
        if (inside(g.toPhysical(index + shift - Vector3d::Constant(0.5)))) ++count;
      }
  return static_cast<double>(count) / (samples * samples * samples);
}

/// sqrt(V / (pi length)) of the sum of shareOf(i, j, k, whole), whole: all of the voxel is in the
/// cylinder.
template <class ShareOf>
double radiusFromShares(const Geometry& g, const Cylinder& cylinder, const ShareOf& shareOf) {
  const double reach = 0.5 * g.spacing.norm();
  std::vector<double> slices(static_cast<std::size_t>(g.size[2]), 0.0);
  parallelForEach(slices.size(), 1, [&](std::size_t slice) {
    const int k = static_cast<int>(slice);
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const Vector3d centre = voxelCentre(g, {i, j, k});
        if (cylinder.holds(centre, reach))
          slices[slice] += shareOf(i, j, k, cylinder.holds(centre, -reach));
      }
  });
  double voxels = 0.0;
  for (const double s : slices) voxels += s;
  return std::sqrt(voxels * g.voxelVolumeMm3() /
                   (std::numbers::pi * (cylinder.high - cylinder.low)));
}

/// The number of the root that each centre line continues.
std::vector<int> rootsOf(const std::vector<CentreLineSegment>& lines) {
  std::vector<int> roots(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int parent = lines[i].parent;
    roots[i] = parent < 0 ? static_cast<int>(i) : roots[static_cast<std::size_t>(parent)];
  }
  return roots;
}

/// Calls body(segment, point, share of the segment's length) at most half a voxel apart.
template <class Body>
void walk(const std::vector<CentreLineSegment>& lines, double stepMm, const Body& body) {
  for (std::size_t n = 0; n < lines.size(); ++n) {
    const Vector3d step = lines[n].to - lines[n].from;
    const int pieces = std::max(1, static_cast<int>(std::ceil(step.norm() / stepMm)));
    for (int i = 0; i < pieces; ++i) {
      const double t = (i + 0.5) / pieces;
      body(n, Vector3d(lines[n].from + t * step), t, step.norm() / pieces);
    }
  }
}

}  // namespace

std::vector<WallSample> wallSamples(const SplineField& phi,
                                    const std::function<double(const Vector3d&)>& distanceMm,
                                    const std::vector<CentreLineSegment>& centreLines,
                                    const Progress& progress) {
  const Geometry& g = phi.geometry();
  std::vector<std::vector<WallSample>> slices(static_cast<std::size_t>(g.size[2]));
  parallelForEach(slices.size(), 1, [&](std::size_t k) {
    progress.check();
    std::vector<Vector3d> crossings;
    addCrossings(phi, static_cast<int>(k), crossings);
    for (const Vector3d& index : crossings) {
      WallSample sample;
      sample.point = g.toPhysical(index);
      Vector3d moved = sample.point;
      if (phi.projectToZero(moved, 1.0)) sample.point = moved;
      sample.signedDistanceMm = distanceMm(sample.point);
      if (!centreLines.empty()) sample.radiusMm = nearestVesselRadius(centreLines, sample.point);
      slices[k].push_back(sample);
    }
  });
  std::vector<WallSample> samples;
  for (const auto& slice : slices) samples.insert(samples.end(), slice.begin(), slice.end());
  return samples;
}

WallDistance wallDistance(const std::vector<WallSample>& samples) {
  if (samples.empty()) return {kNone, kNone};
  std::vector<double> distances;
  distances.reserve(samples.size());
  for (const WallSample& s : samples) distances.push_back(std::fabs(s.signedDistanceMm));
  return {meanOf(distances), percentile(distances, 0.95)};
}

double wallBias(const std::vector<WallSample>& samples, double fromMm, double toMm,
                double reachMm) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const WallSample& s : samples) {
    if (s.radiusMm < fromMm || s.radiusMm >= toMm || std::fabs(s.signedDistanceMm) > reachMm)
      continue;
    sum += s.signedDistanceMm;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : kNone;
}

double tubeRadius(const SplineField& phi, const Vector3d& from, const Vector3d& to, double aroundMm,
                  double share) {
  const Geometry& g = phi.geometry();
  const Cylinder cylinder(from, to, aroundMm, share);
  const double reach = 0.5 * g.spacing.norm();
  return radiusFromShares(g, cylinder, [&](int i, int j, int k, bool whole) {
    // A distance of more than two half diagonals leaves room for phi that is not quite one.
    const double value = phi.atVoxel(i, j, k);
    if (whole && std::fabs(value) > 2.0 * reach) return value < 0.0 ? 1.0 : 0.0;
    return shareOfVoxel(g, Vector3d(i, j, k), [&](const Vector3d& point) {
      return cylinder.holds(point, 0.0) && phi.valueAt(point) < 0.0;
    });
  });
}

double tubeRadiusOfShares(const Volume<float>& shares, const Vector3d& from, const Vector3d& to,
                          double aroundMm, double share) {
  const Geometry& g = shares.geometry;
  const Cylinder cylinder(from, to, aroundMm, share);
  return radiusFromShares(g, cylinder, [&](int i, int j, int k, bool whole) {
    const auto inside = static_cast<double>(shares.at(i, j, k));
    if (whole || inside == 0.0) return inside;
    return inside * shareOfVoxel(g, Vector3d(i, j, k),
                                 [&](const Vector3d& point) { return cylinder.holds(point, 0.0); });
  });
}

double centreLineRecall(const Volume<float>& phi, const std::vector<CentreLineSegment>& centreLines,
                        double leastRadiusMm) {
  double all = 0.0;
  double found = 0.0;
  walk(centreLines, 0.25 * phi.geometry.voxelMm(),
       [&](std::size_t n, const Vector3d& point, double t, double length) {
         const CentreLineSegment& s = centreLines[n];
         if (s.radiusFromMm + t * (s.radiusToMm - s.radiusFromMm) < leastRadiusMm) return;
         all += length;
         if (interpolateLinear(phi, phi.geometry.toIndex(point)) < 0.0) found += length;
       });
  return all > 0.0 ? found / all : kNone;
}

ComponentMeasures measureComponents(const Volume<std::uint8_t>& result,
                                    const Volume<std::uint8_t>& truth,
                                    const std::vector<CentreLineSegment>& centreLines) {
  if (!(result.geometry == truth.geometry))
    throw InputError("result and truth are on different grids", "comparison with the truth",
                     "give a truth mask of the same size, spacing, origin and direction");
  const Components parts = connectedComponents(result);
  std::vector<bool> isTrue(parts.sizes.size(), false);
  for (std::size_t i = 0; i < truth.voxels.size(); ++i)
    if (truth.voxels[i] != 0 && parts.labels.voxels[i] > 0)
      isTrue[static_cast<std::size_t>(parts.labels.voxels[i] - 1)] = true;
  ComponentMeasures measures;
  measures.components = parts.sizes.size();
  for (std::size_t n = 0; n < parts.sizes.size(); ++n) {
    if (isTrue[n]) continue;
    ++measures.falseOnes;
    measures.largestFalse = std::max(measures.largestFalse, parts.sizes[n]);
  }
  const Geometry& g = truth.geometry;
  const std::vector<int> roots = rootsOf(centreLines);
  std::vector<std::set<int>> vessels(parts.sizes.size());
  walk(centreLines, 0.5 * g.voxelMm(), [&](std::size_t n, const Vector3d& point, double, double) {
    const Index3 p = nearestVoxel(g, point);
    if (!g.contains(p[0], p[1], p[2])) return;
    const std::int32_t label = parts.labels.at(p[0], p[1], p[2]);
    if (label > 0) vessels[static_cast<std::size_t>(label - 1)].insert(roots[n]);
  });
  std::set<std::array<int, 2>> pairs;
  for (const std::set<int>& together : vessels)
    for (const int a : together)
      for (const int b : together)
        if (a < b) pairs.insert({a, b});
  measures.mergedVessels = pairs.size();
  return measures;
}

}  // namespace angiomesh
