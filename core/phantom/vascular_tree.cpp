// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/vascular_tree.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/base/random.h"
#include "core/phantom/rasterise.h"
#include "core/phantom/vessel_growth.h"

namespace angiomesh {
namespace {

constexpr double kMeanFlow = 2.5;         // terminals' radii spread over about a factor 1.7
constexpr double kRoomForScaling = 1.05;  // radii may grow by so much to meet the volume share
constexpr double kFullVolume = 0.94;      // the last relaxation makes the vessels a little shorter
constexpr std::uint64_t kTreeStream = 0x74726565;  // apart from the noise of the same seed

void checkParams(const PhantomParams& params, const Geometry& geometry) {
  const auto finite = [](double v) { return std::isfinite(v); };
  if (!finite(params.radiusMin) || !finite(params.radiusMax) || params.radiusMin < 0.5 ||
      params.radiusMax < 1.2 * params.radiusMin)
    throw InputError("the range of vessel radii is not usable", "phantom radius range",
                     "give a smallest radius of at least 0.5 voxel and a larger largest one");
  if (!finite(params.volumePercent) || params.volumePercent <= 0.0 || params.volumePercent > 20.0)
    throw InputError("the share of vessel is not usable", "phantom volume share",
                     "give a percentage above 0 and up to 20");
  if (params.terminals < 0 || params.terminals > 20000)
    throw InputError("the number of terminal vessels is not usable", "phantom terminals",
                     "give 1 to 20000, or 0 to have it chosen");
  const double tissue = static_cast<double>(geometry.voxelCount()) * geometry.voxelVolumeMm3();
  const double unit = geometry.voxelMm();
  if (100.0 * params.terminals * unit * unit * unit > tissue)
    throw InputError(
        "there is no room for " + std::to_string(params.terminals) + " terminal vessels",
        "phantom terminals", "ask for fewer terminals or a larger volume");
  const double shortest =
      std::min({geometry.size[0] * geometry.spacing[0], geometry.size[1] * geometry.spacing[1],
                geometry.size[2] * geometry.spacing[2]});
  if (shortest < 32.0 * geometry.voxelMm())
    throw InputError("the volume is too small for a vascular tree", "phantom size",
                     "give at least 32 voxels in each direction");
}

Shape shapeOf(const std::vector<VesselNode>& nodes, const Geometry& g, double radiusOfUnitFlow) {
  Shape shape;
  const double unit = g.voxelMm();
  const auto position = [&](int n) -> Eigen::Vector3d {
    return unit * nodes[static_cast<std::size_t>(n)].position - 0.5 * g.spacing;
  };
  std::vector<int> segmentOf(nodes.size(), -1);
  std::vector<int> stack;
  for (std::size_t n = nodes.size(); n-- > 0;)
    if (nodes[n].parent < 0) stack.push_back(static_cast<int>(n));
  while (!stack.empty()) {
    const int n = stack.back();
    stack.pop_back();
    const VesselNode& node = nodes[static_cast<std::size_t>(n)];
    for (const int child : {node.children[1], node.children[0]})
      if (child >= 0) stack.push_back(child);
    if (node.parent < 0) continue;
    const double radius = unit * radiusOfUnitFlow * portableCubeRoot(node.flow);
    segmentOf[static_cast<std::size_t>(n)] = static_cast<int>(shape.centreLines.size());
    shape.centreLines.push_back({position(node.parent), position(n), radius, radius,
                                 segmentOf[static_cast<std::size_t>(node.parent)]});
    shape.solids.emplace_back(RoundCone(position(node.parent), position(n), radius, radius));
  }
  return shape;
}

double truthVoxels(const Shape& shape, const Geometry& geometry, const Progress& progress) {
  const Volume<std::uint8_t> counts = countSubvoxels(shape, geometry, progress);
  return static_cast<double>(std::count_if(counts.voxels.begin(), counts.voxels.end(),
                                           [](std::uint8_t c) { return c >= 4; }));
}

double largestFlow(const std::vector<VesselNode>& nodes) {
  double flow = 1.0;
  for (const VesselNode& n : nodes) flow = std::max(flow, n.flow);
  return flow;
}

double smallestFlow(const std::vector<VesselNode>& nodes) {
  double flow = largestFlow(nodes);
  for (const VesselNode& n : nodes)
    if (n.parent >= 0) flow = std::min(flow, n.flow);
  return flow;
}

int terminalsOf(const std::vector<VesselNode>& nodes) {
  return static_cast<int>(std::count_if(nodes.begin(), nodes.end(), [](const VesselNode& n) {
    return n.parent >= 0 && n.children[0] < 0;
  }));
}

/// Grows until the truth mask holds a little less than `target` voxels.
std::vector<VesselNode> growToShare(const PhantomParams& params, const Geometry& geometry,
                                    double target, const Progress& progress) {
  const double unit = geometry.voxelMm();
  const double voxelVolume = geometry.voxelVolumeMm3() / (unit * unit * unit);
  const double ratio = params.radiusMax / (params.radiusMin * kRoomForScaling);
  GrowthParams growth;
  growth.extent = Eigen::Vector3d(geometry.size[0], geometry.size[1], geometry.size[2])
                      .cwiseProduct(geometry.spacing) /
                  unit;
  growth.seed = randomBits(params.randomSeed, kTreeStream);
  growth.radiusOfUnitFlow = params.radiusMin;
  growth.meanFlow = kMeanFlow;
  growth.terminals = params.terminals;
  growth.maximumFlow = std::max(ratio * ratio * ratio, 1.0);
  growth.expectedFlow =
      growth.maximumFlow * std::min(1.0, growth.extent.prod() / (256.0 * 256.0 * 256.0));
  // The mask's volume is not quite the sum of the cylinders': overlap at the bifurcations, voxels
  // at the wall. So the growth is repeated with the share that it had, and with evener terminals
  // where the largest radius would not feed them all.
  double maskShare = 1.0;
  double aim = 0.96;
  std::vector<VesselNode> nodes;
  constexpr int attempts = 12;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    growth.volume = aim * target * voxelVolume / maskShare;
    nodes = growVessels(growth, progress);
    const double volume = vesselVolume(nodes, params.radiusMin);
    const double voxels = truthVoxels(
        shapeOf(nodes, geometry, params.radiusMin), geometry,
        progress.sub(static_cast<double>(attempt) / attempts, (attempt + 1.0) / attempts));
    const double thinnest = portableCubeRoot(smallestFlow(nodes));
    const double scaled = voxels / (thinnest * thinnest);  // with the thinnest at radiusMin
    growth.expectedFlow = std::min(largestFlow(nodes), growth.maximumFlow);
    const bool endedEarly = params.terminals > 0 ? terminalsOf(nodes) < params.terminals
                                                 : volume < kFullVolume * growth.volume;
    if (endedEarly && growth.meanFlow > 1.6)
      growth.meanFlow *= 0.85;
    else if (endedEarly)
      growth.roots = std::max(growth.roots + 1,
                              static_cast<int>(growth.roots * target / std::max(voxels, 1.0)));
    else if (params.terminals > 0 || (scaled <= target && voxels > 0.8 * target))
      break;
    else if (scaled > target)
      aim *= 0.9;
    maskShare = voxels * voxelVolume / std::max(volume, 1.0);
  }
  return nodes;
}

}  // namespace

Shape vascularTree(const PhantomParams& params, const Geometry& geometry,
                   const Progress& progress) {
  checkParams(params, geometry);
  const double ratio = params.radiusMax / params.radiusMin;
  const double target = 0.01 * params.volumePercent * static_cast<double>(geometry.voxelCount());
  const std::vector<VesselNode> nodes = growToShare(params, geometry, target, progress.sub(0, 0.6));
  const double largestScale = ratio / portableCubeRoot(largestFlow(nodes));
  const double smallestScale = 1.0 / portableCubeRoot(smallestFlow(nodes));
  double scale = 1.0;
  Shape shape = shapeOf(nodes, geometry, params.radiusMin);
  double voxels = truthVoxels(shape, geometry, progress.sub(0.6, 0.7));
  for (int step = 0; step < 6 && std::fabs(voxels / target - 1.0) > 0.003; ++step) {
    const double next = std::clamp(scale * std::sqrt(target / std::max(voxels, 1.0)), smallestScale,
                                   std::max(smallestScale, largestScale));
    if (next == scale) break;
    scale = next;
    shape = shapeOf(nodes, geometry, params.radiusMin * scale);
    voxels = truthVoxels(shape, geometry, progress.sub(0.7 + 0.05 * step, 0.75 + 0.05 * step));
  }
  if (terminalsOf(nodes) < std::max(params.terminals, 1))
    throw InputError("only " + std::to_string(terminalsOf(nodes)) + " terminal vessels found room",
                     "phantom terminals", "ask for fewer terminals or a larger volume");
  if (params.terminals == 0 && std::fabs(voxels / target - 1.0) > 0.02)
    throw InputError("vessels of these radii cannot fill " + std::to_string(params.volumePercent) +
                         " % of the volume",
                     "phantom size and radius range", "choose a larger volume or thinner vessels");
  return shape;
}

}  // namespace angiomesh
