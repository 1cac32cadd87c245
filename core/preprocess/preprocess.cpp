// SPDX-License-Identifier: BSD-3-Clause
#include "core/preprocess/preprocess.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/base/parallel.h"
#include "core/field/spline_field.h"
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

Volume<float> cropToBox(const Volume<float>& image, const std::array<double, 6>& boxLps) {
  const Geometry& g = image.geometry;
  Index3 low = g.size;
  Index3 high{-1, -1, -1};
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const Eigen::Vector3d x = g.toPhysical({1.0 * i, 1.0 * j, 1.0 * k});
        bool inside = true;
        for (std::size_t a = 0; a < 3; ++a) {
          const double value = x[static_cast<Eigen::Index>(a)];
          inside = inside && value >= std::min(boxLps[a], boxLps[a + 3]) &&
                   value <= std::max(boxLps[a], boxLps[a + 3]);
        }
        if (!inside) continue;
        const Index3 p{i, j, k};
        for (std::size_t a = 0; a < 3; ++a) {
          low[a] = std::min(low[a], p[a]);
          high[a] = std::max(high[a], p[a]);
        }
      }
  for (std::size_t a = 0; a < 3; ++a)
    if (high[a] - low[a] < 1)
      throw InputError("the region of interest holds fewer than two voxels in some direction",
                       "preprocess.roi", "give a box in mm LPS that lies over the image");
  Geometry cropped = g;
  cropped.origin = g.toPhysical({1.0 * low[0], 1.0 * low[1], 1.0 * low[2]});
  for (std::size_t a = 0; a < 3; ++a) cropped.size[a] = high[a] - low[a] + 1;
  Volume<float> out(cropped);
  for (int k = 0; k < cropped.size[2]; ++k)
    for (int j = 0; j < cropped.size[1]; ++j) {
      const float* from = &image.at(low[0], low[1] + j, low[2] + k);
      std::copy_n(from, cropped.size[0], &out.at(0, j, k));
    }
  return out;
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
    const auto middle = between.begin() + static_cast<std::ptrdiff_t>(between.size() / 2);
    std::nth_element(between.begin(), middle, between.end());
    for (std::size_t i = 0; i < out.voxels.size(); ++i)
      if (above.voxels[i] != 0) out.voxels[i] = *middle;
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
