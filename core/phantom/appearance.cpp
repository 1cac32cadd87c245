// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/appearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/base/parallel.h"
#include "core/base/random.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kGrain = 1U << 16;
constexpr std::uint64_t kDriftStream = 0x64726966;  // apart from the noise of the same seed
constexpr std::uint64_t kQuadratureStream = 0x71756164;

/// Where along the segment, 0..1, is nearest to the point.
double nearestAlong(const CentreLineSegment& s, const Vector3d& point) {
  const Vector3d step = s.to - s.from;
  const double square = step.dot(step);
  return square > 0.0 ? std::clamp((point - s.from).dot(step) / square, 0.0, 1.0) : 0.0;
}

}  // namespace

void checkAppearance(const PhantomParams& params) {
  if (!std::isfinite(params.noiseSigma) || params.noiseSigma < 0.0)
    throw InputError("the noise has no usable standard deviation", "phantom noise",
                     "give 0 or a positive number of intensities");
  if (!std::isfinite(params.driftPercent) || params.driftPercent < 0.0 ||
      params.driftPercent > 95.0)
    throw InputError("the drift of the intensity is not usable", "phantom drift",
                     "give 0 to 95 percent");
  if (!std::isfinite(params.fadePercent) || params.fadePercent < 1.0 || params.fadePercent > 100.0)
    throw InputError("the brightness at the vessels' ends is not usable", "phantom fade",
                     "give 1 to 100 percent");
}

VesselFade::VesselFade(const PhantomParams& params, const Shape& shape)
    : lines_(shape.centreLines), least_(0.01 * params.fadePercent) {
  if (params.kind == PhantomKind::Tree || params.kind == PhantomKind::CapsuleTree ||
      params.kind == PhantomKind::VesselTree) {
    alongTree();
  } else if (const auto* torus = std::get_if<ArcTube>(&shape.solids.front());
             torus != nullptr && params.kind == PhantomKind::Torus) {
    alongAxis(torus->toMiddle, torus->radius);
  } else {
    alongAxis(params.axis / params.axis.norm(), 0.0);
  }
}

void VesselFade::alongTree() {
  std::vector<double> beyond(lines_.size(), 0.0);  // longest way from a line's end to a tip
  const auto length = [&](std::size_t i) { return (lines_[i].to - lines_[i].from).norm(); };
  for (std::size_t i = lines_.size(); i-- > 0;)
    if (lines_[i].parent >= 0) {
      double& way = beyond[static_cast<std::size_t>(lines_[i].parent)];
      way = std::max(way, beyond[i] + length(i));
    }
  ends_.resize(lines_.size());
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const int parent = lines_[i].parent;
    const double start = parent < 0 ? 1.0 : ends_[static_cast<std::size_t>(parent)][1];
    const double way = length(i) + beyond[i];
    const double share = way > 0.0 ? length(i) / way : 1.0;
    ends_[i] = {start, start + (least_ - start) * share};
  }
}

void VesselFade::alongAxis(const Vector3d& direction, double margin) {
  direction_ = direction;
  low_ = std::numeric_limits<double>::max();
  high_ = -low_;
  for (const CentreLineSegment& s : lines_)
    for (const Vector3d& end : {s.from, s.to}) {
      low_ = std::min(low_, end.dot(direction) - margin);
      high_ = std::max(high_, end.dot(direction) + margin);
    }
}

double VesselFade::at(const Vector3d& point) const {
  if (ends_.empty()) {
    const double t = std::clamp((point.dot(direction_) - low_) / (high_ - low_), 0.0, 1.0);
    return 1.0 + (least_ - 1.0) * t;
  }
  double nearest = std::numeric_limits<double>::max();
  double brightness = 1.0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const CentreLineSegment& s = lines_[i];
    const double t = nearestAlong(s, point);
    const double radius = s.radiusFromMm + (s.radiusToMm - s.radiusFromMm) * t;
    const double distance = (point - s.from - t * (s.to - s.from)).norm() - radius;
    if (distance >= nearest) continue;
    nearest = distance;
    brightness = ends_[i][0] + (ends_[i][1] - ends_[i][0]) * t;
  }
  return brightness;
}

void addDrift(Volume<float>& image, const PhantomParams& params, const Progress& progress) {
  const Geometry& g = image.geometry;
  const std::uint64_t seed = randomBits(params.randomSeed, kDriftStream);
  Vector3d direction(randomNormal(seed, 0), randomNormal(seed, 1), randomNormal(seed, 2));
  direction /= std::max(direction.norm(), 1e-9);
  const double strength = 0.01 * params.driftPercent;
  parallelForEach(image.voxels.size(), kGrain, progress, [&](std::size_t i) {
    const Index3 at = g.indexOf(i);
    double t = 0.0;
    for (int a = 0; a < 3; ++a) t += direction[a] * ((at[a] + 0.5) / g.size[a] - 0.5);
    const double factor = 1.0 + strength * portableSinTurns(0.75 * t);
    image.voxels[i] = static_cast<float>(static_cast<double>(image.voxels[i]) * factor);
  });
}

void addNoise(Volume<float>& image, const PhantomParams& params, const Progress& progress) {
  const double sigma = params.noiseSigma;
  const std::uint64_t seed = params.randomSeed;
  const std::uint64_t other = randomBits(seed, kQuadratureStream);
  const bool rician = params.noiseModel == NoiseModel::Rician;
  parallelForEach(image.voxels.size(), kGrain, progress, [&](std::size_t i) {
    double value = static_cast<double>(image.voxels[i]) + sigma * randomNormal(seed, i);
    if (rician) {
      const double imaginary = sigma * randomNormal(other, i);
      value = std::sqrt(value * value + imaginary * imaginary);
    }
    image.voxels[i] = static_cast<float>(value);
  });
}

}  // namespace angiomesh
