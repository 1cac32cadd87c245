// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/brighter_around.h"

#include <algorithm>
#include <cmath>

#include "core/image/voxels.h"

namespace angiomesh {
namespace {

constexpr double kOffVoxels = 2.0;
/// Of fewer places nothing is concluded.
constexpr std::size_t kLeastPlaces = 20;

struct Part {
  double sum = 0.0;
  std::size_t voxels = 0, places = 0, brighter = 0;
};

/// An image at the voxels of another grid.
class Sampler {
 public:
  Sampler(const Volume<float>& image, const Geometry& grid)
      : image_(image), grid_(grid), same_(grid == image.geometry) {}

  [[nodiscard]] double at(std::size_t n) const {
    if (same_) return static_cast<double>(image_.voxels[n]);
    Index3 q = nearestVoxel(image_.geometry, voxelCentre(grid_, n));
    for (std::size_t a = 0; a < 3; ++a) q[a] = std::clamp(q[a], 0, image_.geometry.size[a] - 1);
    return static_cast<double>(image_.at(q[0], q[1], q[2]));
  }

 private:
  const Volume<float>& image_;
  const Geometry& grid_;
  bool same_;
};

class Surroundings {
 public:
  explicit Surroundings(const Volume<float>& phi) : phi_(phi), grid_(phi.geometry) {}

  /// The voxel that lies off the wall beside an inner voxel; `none` where there is none, the volume
  /// ends, or another vessel lies there.
  static constexpr std::size_t none = ~std::size_t{0};
  [[nodiscard]] std::size_t beside(const Index3& p) const {
    Eigen::Vector3d slope;
    bool atWall = false;
    for (std::size_t a = 0; a < 3; ++a) {
      const double before = valueAt(p, a, -1, atWall), after = valueAt(p, a, 1, atWall);
      slope[static_cast<Eigen::Index>(a)] = (after - before) / grid_.spacing[static_cast<int>(a)];
    }
    if (!atWall || !(slope.norm() > 0.0)) return none;
    const Eigen::Vector3d step =
        kOffVoxels * grid_.voxelMm() * slope.normalized().cwiseQuotient(grid_.spacing);
    Index3 q;
    for (std::size_t a = 0; a < 3; ++a)
      q[a] = p[a] + static_cast<int>(std::lround(step[static_cast<Eigen::Index>(a)]));
    if (!grid_.contains(q[0], q[1], q[2])) return none;
    const std::size_t n = grid_.offset(q[0], q[1], q[2]);
    return phi_.voxels[n] < 0.0F ? none : n;
  }

 private:
  double valueAt(const Index3& p, std::size_t axis, int step, bool& outside) const {
    Index3 q = p;
    q[axis] += step;
    if (!grid_.contains(q[0], q[1], q[2])) q = p;
    const float value = phi_.at(q[0], q[1], q[2]);
    outside = outside || value >= 0.0F;
    return static_cast<double>(value);
  }

  const Volume<float>& phi_;
  const Geometry& grid_;
};

}  // namespace

std::vector<double> brighterAround(const Volume<float>& image, const Volume<float>& phi,
                                   const Volume<std::int32_t>& labels, std::size_t count,
                                   Polarity polarity) {
  const double sign = polarity == Polarity::Bright ? 1.0 : -1.0;
  const Sampler sampler(image, phi.geometry);
  const auto brightness = [&](std::size_t n) { return sign * sampler.at(n); };
  std::vector<Part> parts(count + 1);
  for (std::size_t n = 0; n < labels.voxels.size(); ++n) {
    const auto label = static_cast<std::size_t>(labels.voxels[n]);
    if (label == 0 || label > count) continue;
    parts[label].sum += brightness(n);
    ++parts[label].voxels;
  }
  const Surroundings surroundings(phi);
  for (std::size_t n = 0; n < labels.voxels.size(); ++n) {
    const auto label = static_cast<std::size_t>(labels.voxels[n]);
    if (label == 0 || label > count) continue;
    const std::size_t beside = surroundings.beside(phi.geometry.indexOf(n));
    if (beside == Surroundings::none) continue;
    Part& part = parts[label];
    ++part.places;
    if (brightness(beside) * static_cast<double>(part.voxels) > part.sum) ++part.brighter;
  }
  std::vector<double> shares;
  for (std::size_t label = 1; label <= count; ++label) {
    const Part& part = parts[label];
    shares.push_back(part.places < kLeastPlaces
                         ? 0.0
                         : static_cast<double>(part.brighter) / static_cast<double>(part.places));
  }
  return shares;
}

}  // namespace angiomesh
