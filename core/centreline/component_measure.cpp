// SPDX-License-Identifier: BSD-3-Clause
#include "core/centreline/component_measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/centreline/centre_lines.h"
#include "core/centreline/voxel_set.h"

namespace angiomesh {
namespace {

/// Smoothing of a path: a moving mean over so many points on either side, twice.
constexpr int kSmoothPoints = 3;

struct Length {
  double mm = 0.0;
  int freeTips = 0;
  std::vector<VesselPiece> pieces;
};

std::vector<Eigen::Vector3d> smoothed(const VoxelSet& set,
                                      const std::vector<std::uint32_t>& points) {
  std::vector<Eigen::Vector3d> line;
  for (const std::uint32_t n : points) line.push_back(set.position(n));
  const auto count = static_cast<int>(line.size());
  for (int pass = 0; pass < 2; ++pass) {
    const std::vector<Eigen::Vector3d> before = line;
    for (int i = 0; i < count; ++i) {
      const int half = std::min({kSmoothPoints, i, count - 1 - i});
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int j = i - half; j <= i + half; ++j) sum += before[static_cast<std::size_t>(j)];
      line[static_cast<std::size_t>(i)] = sum / (2 * half + 1);
    }
  }
  return line;
}

Length lengthOf(const CentreLines& lines, const VoxelSet& set, const CentreLines::Path& path) {
  Length length;
  std::vector<std::uint32_t> points = path.points;
  double extra = 0.0;
  for (const CentreLines::PathEnd* end : {&path.front, &path.back}) {
    const CentreLines::LineEnd line = lines.endOf(points, *end);
    if (line.kind == CentreLines::LineEnd::Kind::Tip) ++length.freeTips;
    extra += line.extraMm;
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(line.at));
    std::reverse(points.begin(), points.end());
  }
  std::reverse(points.begin(), points.end());
  const std::vector<Eigen::Vector3d> line = smoothed(set, points);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = (line[i] - line[i - 1]).norm();
    length.mm += step;
    length.pieces.push_back({step, lines.wallMm(points[i])});
  }
  if (line.size() == 1) length.pieces.push_back({1.0, lines.wallMm(points[0])});
  const double whole = std::max(length.mm + extra, 0.0);
  const double pieces = line.size() == 1 ? 1.0 : length.mm;
  for (VesselPiece& piece : length.pieces) piece.lengthMm *= whole / pieces;
  length.mm = whole;
  return length;
}

/// Makes pieces hold a volume, as volumes() has it, together with half balls at their tips.
void fillVolume(std::vector<VesselPiece>& pieces, double volume, int tips, double voxelMm) {
  double most = 0.0, length = 0.0;
  for (const VesselPiece& piece : pieces) {
    most = std::max(most, piece.radiusMm);
    length += piece.lengthMm;
  }
  const double least = 0.25 * voxelMm;
  const auto held = [&](double more) {
    double sum = 0.0, radius = 0.0;
    for (const VesselPiece& piece : pieces) {
      const double r = std::max(piece.radiusMm + more, least);
      sum += std::numbers::pi * piece.lengthMm * (r * r + voxelMm * voxelMm / 12.0);
      radius += piece.lengthMm / length * r;
    }
    return sum + tips * (2.0 / 3.0) * std::numbers::pi * radius * radius * radius;
  };
  double low = -most, high = most + voxelMm;
  for (int n = 0; n < 50; ++n) {
    const double middle = 0.5 * (low + high);
    (held(middle) < volume ? low : high) = middle;
  }
  for (VesselPiece& piece : pieces) piece.radiusMm = std::max(piece.radiusMm + low, least);
}

/// Volume of each part, mm3: voxels at the wall count by the share that phi gives them. That is the
/// mean volume of parts whose wall lies up to half a voxel farther out or in.
std::vector<double> volumes(const Volume<float>& phi, const Volume<std::int32_t>& labels,
                            std::size_t count) {
  std::vector<double> sum(count, 0.0);
  const Geometry& g = labels.geometry;
  const double h = g.voxelMm();
  const auto most = static_cast<float>(0.5 * h);
  for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
    const float value = phi.voxels[i];
    if (value >= most) continue;
    std::int32_t label = labels.voxels[i];
    if (label == 0) {
      const Index3 p = g.indexOf(i);
      for (int n = 0; n < 27 && label == 0; ++n) {
        const Index3 q{p[0] + n % 3 - 1, p[1] + n / 3 % 3 - 1, p[2] + n / 9 - 1};
        if (g.contains(q[0], q[1], q[2])) label = labels.at(q[0], q[1], q[2]);
      }
    }
    if (label > 0 && static_cast<std::size_t>(label) <= count)
      sum[static_cast<std::size_t>(label - 1)] +=
          std::clamp(0.5 - static_cast<double>(value) / h, 0.0, 1.0);
  }
  for (double& volume : sum) volume *= g.voxelVolumeMm3();
  return sum;
}

/// r of V = pi r^2 L + tips (2/3) pi r^3, V as volumes() has it.
double radiusOf(double volume, double length, int tips, double voxelMm) {
  const auto held = [&](double r) {
    return std::numbers::pi * (r * r + voxelMm * voxelMm / 12.0) *
           (length + tips * r * (2.0 / 3.0));
  };
  double low = 0.0;
  double high = voxelMm;
  while (held(high) < volume) high *= 2.0;
  for (int n = 0; n < 60; ++n) {
    const double r = 0.5 * (low + high);
    (held(r) < volume ? low : high) = r;
  }
  return 0.5 * (low + high);
}

}  // namespace

std::vector<ComponentMeasure> measureComponents(const Volume<float>& phi,
                                                const Volume<std::int32_t>& labels,
                                                std::size_t count, const Progress& progress) {
  std::vector<ComponentMeasure> result(count);
  const VoxelSet set(labels, static_cast<std::int32_t>(count));
  CentreLines lines(phi, set);
  std::vector<bool> done(count, false);
  std::vector<std::uint32_t> visited;
  const std::vector<double> volume = volumes(phi, labels, count);
  for (std::size_t n = 0; n < set.size(); ++n) {
    const auto part = static_cast<std::size_t>(labels.voxels[set.voxel(n)] - 1);
    if (done[part]) continue;
    done[part] = true;
    Length length;
    for (const auto& path : lines.find(static_cast<std::uint32_t>(n), visited, progress)) {
      const Length one = lengthOf(lines, set, path);
      length.mm += one.mm;
      length.freeTips += one.freeTips;
      length.pieces.insert(length.pieces.end(), one.pieces.begin(), one.pieces.end());
    }
    ComponentMeasure& measure = result[part];
    measure.lengthMm = length.mm;
    measure.meanRadiusMm = radiusOf(volume[part], length.mm, length.mm > 0.0 ? length.freeTips : 2,
                                    labels.geometry.voxelMm());
    if (length.mm > 0.0) {
      fillVolume(length.pieces, volume[part], length.freeTips, labels.geometry.voxelMm());
      measure.pieces = std::move(length.pieces);
      measure.tips = length.freeTips;
    }
    progress.report(static_cast<double>(n + 1) / static_cast<double>(set.size()));
  }
  return result;
}

}  // namespace angiomesh
