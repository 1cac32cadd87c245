// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/segments.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/distance/redistance.h"

namespace angiomesh {
namespace {

/// Labels of the components at, or one voxel beside, the given points.
std::vector<std::vector<std::size_t>> pointsIn(const Volume<std::int32_t>& labels,
                                               std::size_t count,
                                               const std::vector<double>& points) {
  const Geometry& g = labels.geometry;
  std::vector<std::vector<std::size_t>> in(count);
  for (std::size_t n = 0; n + 2 < points.size(); n += 3) {
    const Eigen::Vector3d index = g.toIndex({points[n], points[n + 1], points[n + 2]});
    Index3 centre;
    for (int a = 0; a < 3; ++a) centre[a] = static_cast<int>(std::floor(index[a] + 0.5));
    double nearest = 1e9;
    std::int32_t label = 0;
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
          const Index3 p{centre[0] + i, centre[1] + j, centre[2] + k};
          if (!g.contains(p[0], p[1], p[2]) || labels.at(p[0], p[1], p[2]) == 0) continue;
          const double d = (Eigen::Vector3d(p[0], p[1], p[2]) - index).squaredNorm();
          if (d >= nearest) continue;
          nearest = d;
          label = labels.at(p[0], p[1], p[2]);
        }
    if (label > 0) in[static_cast<std::size_t>(label - 1)].push_back(n / 3);
  }
  return in;
}

}  // namespace

std::vector<Eigen::Vector3d> innerPoints(const Volume<float>& phi, const Components& parts) {
  const BigVector<std::int32_t>& labels = parts.labels.voxels;
  std::vector<std::size_t> deepest(parts.sizes.size(), labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == 0) continue;
    std::size_t& best = deepest[static_cast<std::size_t>(labels[i] - 1)];
    if (best == labels.size() || phi.voxels[i] < phi.voxels[best]) best = i;
  }
  std::vector<Eigen::Vector3d> points;
  for (const std::size_t voxel : deepest) {
    const Index3 p = phi.geometry.indexOf(voxel);
    points.push_back(phi.geometry.toPhysical({1.0 * p[0], 1.0 * p[1], 1.0 * p[2]}));
  }
  return points;
}

Segments selectSegments(const Volume<float>& phi, const SegmentationParams& params,
                        const std::vector<double>& seedsByHand, const Progress& progress) {
  const Geometry& g = phi.geometry;
  const bool byFaces =
      params.method == SegmentationMethod::Label && params.connectivity == MaskConnectivity::Faces;
  Components found = connectedComponents(insideMask(phi), !byFaces);
  const std::vector<Eigen::Vector3d> inner = innerPoints(phi, found);
  const std::size_t count = found.sizes.size();
  const auto dropped = pointsIn(found.labels, count, params.drop);
  const auto seeded = pointsIn(found.labels, count, seedsByHand);
  const std::vector<ComponentMeasure> measures =
      measureComponents(phi, found.labels, std::min(count, kMeasuredComponents), progress);
  Segments out;
  for (std::size_t n = 0; n < count; ++n) {
    SegmentComponent component;
    component.voxels = found.sizes[n];
    component.volumeMm3 = static_cast<double>(found.sizes[n]) * g.voxelVolumeMm3();
    component.innerPointLps = inner[n];
    if (n < measures.size()) component.measure = measures[n];
    component.seeded = !seeded[n].empty();
    for (const std::size_t d : dropped[n])
      component.droppedBy.emplace_back(params.drop[3 * d], params.drop[3 * d + 1],
                                       params.drop[3 * d + 2]);
    component.kept =
        dropped[n].empty() && component.volumeMm3 >= params.minVolumeMm3 &&
        (component.measure ? component.measure->lengthMm : 0.0) >= params.minLengthMm &&
        (params.keep != KeepComponents::Largest || n == 0) &&
        (params.keep != KeepComponents::Seeded || component.seeded);
    if (component.kept) out.insideVoxels += component.voxels;
    out.components.push_back(component);
  }
  if (out.insideVoxels == 0)
    throw NumericError("no component of the segmentation is left for the surface", "segmentation",
                       "keep more: see segmentation.keep, segmentation.minVolumeMm3, "
                       "segmentation.minLengthMm, "
                       "segmentation.drop and seeds.points");
  out.labels = std::move(found.labels);
  return out;
}

bool keepsAll(const SegmentationParams& params) {
  return params.keep == KeepComponents::All && params.minVolumeMm3 == 0.0 &&
         params.minLengthMm == 0.0 && params.drop.empty();
}

std::shared_ptr<const Volume<float>> withoutDropped(std::shared_ptr<const Volume<float>> phi,
                                                    const Segments& segments,
                                                    const Progress& progress) {
  const auto& all = segments.components;
  if (std::all_of(all.begin(), all.end(), [](const SegmentComponent& c) { return c.kept; }))
    return phi;
  Volume<float> kept = *phi;
  const auto voxel = static_cast<float>(phi->geometry.voxelMm());
  for (std::size_t i = 0; i < kept.voxels.size(); ++i) {
    const std::int32_t label = segments.labels.voxels[i];
    // As far as from a wall that is a voxel away: a jump would move that wall, which is
    // interpolated.
    if (label > 0 && !all[static_cast<std::size_t>(label - 1)].kept)
      kept.voxels[i] = voxel - kept.voxels[i];
  }
  return std::make_shared<const Volume<float>>(redistance(kept, 5.0, progress));
}

std::shared_ptr<const Volume<float>> keptPhi(const RunResult& result, const Progress& progress) {
  if (result.surface) return result.surface->phi;
  if (!result.segmentation()) return nullptr;
  const Parameters& params = result.params;
  if (keepsAll(params.segmentation)) return result.segmentation()->phi;
  const Segments segments = selectSegments(*result.segmentation()->phi, params.segmentation,
                                           params.seeds.points, progress.sub(0.0, 0.5));
  return withoutDropped(result.segmentation()->phi, segments, progress.sub(0.5, 1.0));
}

Volume<float> resampleField(const SplineField& field, double cellMm, const Progress& progress) {
  const Geometry& from = field.geometry();
  Geometry g = from;
  for (int a = 0; a < 3; ++a) {
    const double extent = (from.size[a] - 1) * from.spacing[a];
    g.size[a] = std::max(2, static_cast<int>(std::floor(extent / cellMm + 0.5)) + 1);
    g.spacing[a] = extent / (g.size[a] - 1);
  }
  const Eigen::Vector3d step = g.spacing.cwiseQuotient(from.spacing);
  Volume<float> out(g);
  parallelFor(0, static_cast<std::size_t>(g.size[2]), 1, [&](std::size_t slice, std::size_t) {
    progress.check();
    const int k = static_cast<int>(slice);
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i)
        out.at(i, j, k) =
            static_cast<float>(field.atIndex(step.cwiseProduct(Eigen::Vector3d(i, j, k))).value);
  });
  return out;
}

}  // namespace angiomesh
