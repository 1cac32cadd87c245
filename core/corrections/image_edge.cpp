// SPDX-License-Identifier: BSD-3-Clause
#include "core/corrections/image_edge.h"

#include <algorithm>
#include <vector>

#include "core/base/error.h"
#include "core/base/statistics.h"
#include "core/distance/redistance.h"
#include "core/image/voxels.h"

namespace angiomesh {
namespace {

/// What shows the vessel's brightness: of the voxels in its middle the brighter ones, as a brush
/// also covers what lies beside it.
constexpr double kBright = 0.8;
/// Working voxels off the walls: full, or empty.
constexpr double kFull = 0.7, kEmpty = 1.5;
constexpr double kBeyondTube = 1.0;
/// Voxels beyond the tube, for its surroundings.
constexpr int kAround = 4;

[[noreturn]] void refuse(const char* what) {
  throw InputError(what, "brush to the edge",
                   "use a larger radius, or the brush that does not look at the image");
}

/// Brightness, bright for a vessel, with weights 1, 2, 1 along each axis, which take most of the
/// noise.
Volume<float> smoothBrightness(const Volume<float>& image, const VoxelBox& box, Polarity polarity) {
  Volume<float> value = cropped(image, box);
  if (polarity == Polarity::Dark)
    for (float& v : value.voxels) v = -v;
  const Geometry& g = value.geometry;
  for (std::size_t a = 0; a < 3; ++a) {
    const Volume<float> from = value;
    for (std::size_t v = 0; v < from.voxels.size(); ++v) {
      Index3 low = g.indexOf(v), high = low;
      low[a] = std::max(low[a] - 1, 0);
      high[a] = std::min(high[a] + 1, g.size[a] - 1);
      value.voxels[v] = 0.25F * (from.at(low[0], low[1], low[2]) + 2.0F * from.voxels[v] +
                                 from.at(high[0], high[1], high[2]));
    }
  }
  return value;
}

/// The tube and its surroundings, on one grid.
struct Ground {
  Ground(const Volume<float>& image, Polarity polarity, const Volume<float>& vessels,
         const Shape& shape)
      : box(shape.box.widened(kAround, vessels.geometry)),
        value(smoothBrightness(image, box, polarity)),
        phi(cropped(vessels, box)),
        tube(value.geometry, static_cast<float>(5.0 * vessels.geometry.voxelMm())) {
    const VoxelBox inner = shape.box.seenFrom(box);
    const Index3& size = shape.phi.geometry.size;
    for (int k = 0; k < size[2]; ++k)
      for (int j = 0; j < size[1]; ++j)
        std::copy_n(&shape.phi.at(0, j, k), size[0],
                    &tube.at(inner.low[0], inner.low[1] + j, inner.low[2] + k));
  }

  template <class Take>
  [[nodiscard]] std::vector<double> values(Take take) const {
    std::vector<double> taken;
    for (std::size_t v = 0; v < value.voxels.size(); ++v)
      if (take(tube.voxels[v], phi.voxels[v])) taken.push_back(value.voxels[v]);
    return taken;
  }

  /// Negative where it is brighter than half-way between `lumen` and the surroundings: a distance,
  /// mm.
  [[nodiscard]] Volume<float> edge(std::vector<double> lumen) const {
    const auto voxel = static_cast<float>(phi.geometry.voxelMm());
    std::vector<double> around =
        values([&](float t, float p) { return t > kBeyondTube * voxel && p > kEmpty * voxel; });
    if (lumen.empty() || around.empty())
      refuse(lumen.empty() ? "there is no vessel beside the brush"
                           : "nothing around the brush lies outside the vessels");
    const double bright = percentile(lumen, kBright), dark = percentile(around, 0.5);
    if (!(bright > dark)) refuse("the image is not brighter here than around");
    const auto half = static_cast<float>(0.5 * (bright + dark));
    const auto contrast = static_cast<float>(bright - dark);
    Volume<float> level(value.geometry);
    for (std::size_t v = 0; v < level.voxels.size(); ++v)
      level.voxels[v] = voxel * (half - value.voxels[v]) / contrast;
    return level;
  }

  VoxelBox box;
  Volume<float> value, phi, tube;
};

Volume<float> distanceOf(Volume<float> level) {
  try {
    return redistance(std::move(level));
  } catch (const NumericError&) {
    refuse("the image has no edge here");
  }
}

/// Leaves of phi < 0 only the parts that have a voxel in `middle`.
void keepTouching(Volume<float>& level, const Volume<std::uint8_t>& middle, float outside) {
  const Components parts = connectedComponents(insideMask(level));
  std::vector<char> kept(parts.sizes.size() + 1, 0);
  for (std::size_t v = 0; v < level.voxels.size(); ++v)
    if (middle.voxels[v] != 0) kept[static_cast<std::size_t>(parts.labels.voxels[v])] = 1;
  kept[0] = 0;
  for (std::size_t v = 0; v < level.voxels.size(); ++v) {
    const std::int32_t part = parts.labels.voxels[v];
    if (part != 0 && kept[static_cast<std::size_t>(part)] == 0) level.voxels[v] = outside;
  }
}

}  // namespace

Shape vesselInTube(const Volume<float>& image, Polarity polarity, const Volume<float>& phi,
                   const Shape& tube) {
  if (tube.phi.voxels.empty()) return {};
  const Ground ground(image, polarity, phi, tube);
  const auto voxel = static_cast<float>(phi.geometry.voxelMm());
  // Half of the radius, but at least the voxels that the line runs through.
  const float deepest = *std::min_element(ground.tube.voxels.begin(), ground.tube.voxels.end());
  const float middleTo = std::max(0.5F * deepest, deepest + voxel);
  const auto inMiddle = [&](float t) { return t < 0.0F && t <= middleTo; };
  Volume<float> level = ground.edge(ground.values([&](float t, float) { return inMiddle(t); }));
  Volume<std::uint8_t> middle(level.geometry);
  for (std::size_t v = 0; v < level.voxels.size(); ++v) {
    middle.voxels[v] = inMiddle(ground.tube.voxels[v]) && level.voxels[v] < 0.0F ? 1 : 0;
    // What lies beyond the tube joins nothing within.
    if (ground.tube.voxels[v] > kBeyondTube * voxel)
      level.voxels[v] = std::max(level.voxels[v], 0.5F * voxel);
  }
  keepTouching(level, middle, 0.5F * voxel);
  Shape shape{ground.box, distanceOf(std::move(level))};
  for (std::size_t v = 0; v < shape.phi.voxels.size(); ++v)
    shape.phi.voxels[v] = std::max(shape.phi.voxels[v], ground.tube.voxels[v]);
  return shape;
}

Shape backgroundInTube(const Volume<float>& image, Polarity polarity, const Volume<float>& phi,
                       const Shape& tube) {
  if (tube.phi.voxels.empty()) return {};
  const Ground ground(image, polarity, phi, tube);
  const auto full = static_cast<float>(-kFull * phi.geometry.voxelMm());
  Volume<float> level = ground.edge(ground.values([&](float, float p) { return p < full; }));
  Shape shape{ground.box, distanceOf(std::move(level))};
  for (std::size_t v = 0; v < shape.phi.voxels.size(); ++v)
    shape.phi.voxels[v] = std::max(-shape.phi.voxels[v], ground.tube.voxels[v]);
  return shape;
}

}  // namespace angiomesh
