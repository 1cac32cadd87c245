// SPDX-License-Identifier: BSD-3-Clause
#include "core/preprocess/preprocess.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/base/parallel.h"
#include "core/base/statistics.h"
#include "core/field/spline_field.h"
#include "core/image/voxels.h"
#include "core/preprocess/curvature_flow.h"

namespace angiomesh {
namespace {

/// The grid of cubic voxels over the same extent.
Geometry isotropicGeometry(const Geometry& g) {
  Geometry out = g;
  out.spacing.setConstant(g.voxelMm());
  for (int a = 0; a < 3; ++a) {
    const double extent = (g.size[a] - 1) * g.spacing[a] / g.voxelMm();
    out.size[a] = std::max(2, static_cast<int>(std::floor(extent + 1e-6)) + 1);
  }
  return out;
}

}  // namespace

VoxelBox voxelsInBox(const Geometry& g, const std::array<double, 6>& boxLps) {
  Eigen::Vector3d least, most;
  for (std::size_t a = 0; a < 3; ++a) {
    least[static_cast<Eigen::Index>(a)] = std::min(boxLps[a], boxLps[a + 3]);
    most[static_cast<Eigen::Index>(a)] = std::max(boxLps[a], boxLps[a + 3]);
  }
  const auto inside = [&](int i, int j, int k) {
    const Eigen::Vector3d x = voxelCentre(g, {i, j, k});
    return (x.array() >= least.array()).all() && (x.array() <= most.array()).all();
  };
  const Eigen::Vector3d along = g.toPhysical({1.0, 0.0, 0.0}) - g.toPhysical({0.0, 0.0, 0.0});
  Index3 low = g.size;
  Index3 high{-1, -1, -1};
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j) {
      // Where the row enters and leaves the box, to a voxel; centres on its sides are looked at.
      const Eigen::Vector3d start = g.toPhysical({0.0, 1.0 * j, 1.0 * k});
      double from = 0.0, to = g.size[0] - 1.0;
      for (int a = 0; a < 3; ++a) {
        if (std::fabs(along[a]) < 1e-12 * g.spacing[0]) {
          const double slack = 1e-9 * g.spacing[0] * g.size[0];
          if (start[a] < least[a] - slack || start[a] > most[a] + slack) to = -2.0;
          continue;
        }
        const double p = (least[a] - start[a]) / along[a], q = (most[a] - start[a]) / along[a];
        from = std::max(from, std::min(p, q));
        to = std::min(to, std::max(p, q));
      }
      if (to < from - 1.0) continue;
      int first = std::max(0, static_cast<int>(std::floor(from)) - 1);
      int last = std::min(g.size[0] - 1, static_cast<int>(std::ceil(to)) + 1);
      while (first <= last && !inside(first, j, k)) ++first;
      while (last >= first && !inside(last, j, k)) --last;
      if (first > last) continue;
      low = {std::min(low[0], first), std::min(low[1], j), std::min(low[2], k)};
      high = {std::max(high[0], last), std::max(high[1], j), std::max(high[2], k)};
    }
  for (std::size_t a = 0; a < 3; ++a)
    if (high[a] - low[a] < 1)
      throw InputError("the region of interest holds fewer than two voxels in some direction",
                       "preprocess.roi", "give a box in mm LPS that lies over the image");
  return {low, high};
}

Volume<float> cropToBox(const Volume<float>& image, const std::array<double, 6>& boxLps) {
  return cropped(image, voxelsInBox(image.geometry, boxLps));
}

bool wantsIsotropic(const Geometry& geometry) {
  const double ratio = geometry.spacing.maxCoeff() / geometry.spacing.minCoeff();
  return ratio > 1.1 && isotropicGeometry(geometry).voxelCount() <= 3 * geometry.voxelCount();
}

Volume<float> resampleIsotropic(const Volume<float>& image, const Progress& progress) {
  const SplineField field(image, SplineKind::CatmullRom);
  const auto range = valueRange(image);
  Volume<float> out(isotropicGeometry(image.geometry));
  const Geometry& g = out.geometry;
  const Eigen::Vector3d step = g.spacing.cwiseQuotient(image.geometry.spacing);
  parallelFor(0, static_cast<std::size_t>(g.size[2]), 1, [&](std::size_t slice, std::size_t) {
    progress.check();
    const int k = static_cast<int>(slice);
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const double value = field.atIndex(step.cwiseProduct(Eigen::Vector3d(i, j, k))).value;
        out.at(i, j, k) = std::clamp(static_cast<float>(value), range[0], range[1]);
      }
  });
  return out;
}

namespace {

/// Voxels with a set one among their 26 neighbours are set.
void grow(Volume<std::uint8_t>& mask) {
  const Geometry& g = mask.geometry;
  const std::size_t stride[3] = {
      1, static_cast<std::size_t>(g.size[0]),
      static_cast<std::size_t>(g.size[0]) * static_cast<std::size_t>(g.size[1])};
  for (std::size_t a = 0; a < 3; ++a) {
    const BigVector<std::uint8_t> before = mask.voxels;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (before[i] == 0) continue;
      const int at = g.indexOf(i)[a];
      if (at > 0) mask.voxels[i - stride[a]] = 1;
      if (at + 1 < g.size[a]) mask.voxels[i + stride[a]] = 1;
    }
  }
}

}  // namespace

Volume<float> clampIntensities(const Volume<float>& image, std::optional<double> lower,
                               std::optional<double> upper, int rimVoxels) {
  Volume<float> out = image;
  const auto low = static_cast<float>(lower.value_or(std::numeric_limits<float>::lowest()));
  if (upper) {
    const auto high = static_cast<float>(*upper);
    Volume<std::uint8_t> above(image.geometry);
    for (std::size_t i = 0; i < image.voxels.size(); ++i)
      above.voxels[i] = image.voxels[i] > high ? 1 : 0;
    for (int n = 0; n < rimVoxels; ++n) grow(above);
    std::vector<float> between;
    for (std::size_t i = 0; i < image.voxels.size(); ++i)
      if (above.voxels[i] == 0 && image.voxels[i] > low) between.push_back(image.voxels[i]);
    if (between.empty())
      throw InputError("no voxel is left between the bounds of the intensity",
                       "preprocess.clamp.lower, preprocess.clamp.upper",
                       "choose them around the brightness of the vessels and their surroundings");
    const float middle = upperMedian(between);
    for (std::size_t i = 0; i < out.voxels.size(); ++i)
      if (above.voxels[i] != 0) out.voxels[i] = middle;
  }
  for (float& value : out.voxels) value = std::max(value, low);
  return out;
}

Volume<float> sigmoid(const Volume<float>& image, double window, double level) {
  const auto range = valueRange(image);
  const double low = range[0];
  const double span = static_cast<double>(range[1]) - low;
  Volume<float> out = image;
  for (float& value : out.voxels) {
    const double x = (static_cast<double>(value) - level) / (window / 6.0);
    value = static_cast<float>(low + span / (1.0 + portableExp(-x)));
  }
  return out;
}

namespace {

bool resamples(const PreprocessParams& params, const Geometry& geometry) {
  return params.isotropic == Isotropic::On ||
         (params.isotropic == Isotropic::Auto && wantsIsotropic(geometry));
}

}  // namespace

bool leavesAlone(const PreprocessParams& params, const Geometry& geometry) {
  return !params.roi && !params.clampLower && !params.clampUpper && !params.sigmoidEnabled &&
         !params.curvatureFlowEnabled && !resamples(params, geometry);
}

Volume<float> preprocess(const Volume<float>& image, const PreprocessParams& params,
                         const Progress& progress) {
  Volume<float> out = params.roi ? cropToBox(image, *params.roi) : image;
  if (params.roi) checkUsable(out, "preprocess.roi");
  if (params.clampLower || params.clampUpper) {
    // Before resampling, whose cubic would carry the edges of bone farther.
    out = clampIntensities(out, params.clampLower, params.clampUpper, params.clampRimVoxels);
    checkUsable(out, "preprocess.clamp");
  }
  progress.report(0.1);
  if (resamples(params, out.geometry)) out = resampleIsotropic(out, progress);
  progress.report(0.4);
  if (params.sigmoidEnabled) {
    double window = params.sigmoidWindow.value_or(0.0);
    double level = params.sigmoidLevel.value_or(0.0);
    if (!params.sigmoidWindow || !params.sigmoidLevel) {
      const std::vector<double> p = percentiles(out, {0.01, 0.998});
      if (!params.sigmoidWindow) window = std::max(p[1] - p[0], 1e-6 * std::fabs(p[1]) + 1e-12);
      if (!params.sigmoidLevel) level = 0.5 * (p[0] + p[1]);
    }
    out = sigmoid(out, window, level);
  }
  progress.report(0.5);
  if (params.curvatureFlowEnabled)
    out = curvatureFlow(out, params.curvatureFlowIterations, params.curvatureFlowTimeStep,
                        progress.sub(0.5, 1.0));
  progress.report(1.0);
  return out;
}

}  // namespace angiomesh
