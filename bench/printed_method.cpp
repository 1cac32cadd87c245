// SPDX-License-Identifier: BSD-3-Clause
#include "bench/printed_method.h"

#include <itkFastMarchingImageFilter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bench/itk_volume.h"
#include "core/base/clock.h"
#include "core/base/error.h"

namespace angiomesh::bench {
namespace {

/// Eq. 5.1-5.2 in working voxels; at least two scales unless the range is empty.
std::vector<double> printedScales(double low, double high) {
  if (high <= low) return {low};
  const int count =
      std::max(2, static_cast<int>(std::ceil(std::log(high - low) / std::log(1.5) - 1e-9)));
  std::vector<double> scales;
  for (int i = 0; i < count; ++i)
    scales.push_back(low * std::pow(high / low, static_cast<double>(i) / (count - 1)));
  return scales;
}

/// Eq. 3.20 with the clamping of the preset.
Thresholds printedThresholds(const Volume<float>& v, double ratio, const ThresholdParams& params) {
  double sum = 0.0;
  std::size_t positive = 0;
  for (const float value : v.voxels)
    if (value > 0.0F) {
      sum += static_cast<double>(value);
      ++positive;
    }
  if (positive == 0) throw NumericError("no voxel looks like a vessel", "printed method", "");
  Thresholds t;
  t.vAverage = sum / static_cast<double>(positive);
  const double printed = params.xi * t.vAverage / ratio;
  t.b = params.b.value_or(std::clamp(printed, params.bMin, params.bMax));
  t.clamped = !params.b && t.b != printed;
  t.a = 2.0 * t.b;
  return t;
}

/// Distance from the seeds less the spheres' radius, by itk::FastMarchingImageFilter.
Volume<float> marchedStart(const Volume<float>& single, const SeedParams& params,
                           std::size_t& seeds) {
  constexpr double band = 4.0;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < single.voxels.size(); ++i)
    if (single.voxels[i] > 0.0F) order.push_back(i);
  const double share = params.topPercent / 100.0 * static_cast<double>(single.voxels.size());
  seeds = std::min(order.size(), static_cast<std::size_t>(std::max(1.0, std::round(share))));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return single.voxels[a] != single.voxels[b] ? single.voxels[a] > single.voxels[b] : a < b;
  });
  using Marching = itk::FastMarchingImageFilter<ItkImage, ItkImage>;
  const auto trial = Marching::NodeContainer::New();
  for (std::size_t s = 0; s < seeds; ++s) {
    const Index3 p = single.geometry.indexOf(order[s]);
    Marching::NodeType node;
    node.SetIndex({{p[0], p[1], p[2]}});
    node.SetValue(0.0F);
    trial->InsertElement(static_cast<unsigned int>(s), node);
  }
  const ItkImage::Pointer like = asItk(single);
  const auto marching = Marching::New();
  marching->SetTrialPoints(trial);
  marching->SetSpeedConstant(1.0);
  marching->SetOutputRegion(like->GetBufferedRegion());
  marching->SetOutputSpacing(like->GetSpacing());
  marching->SetStoppingValue(params.radiusVoxels + band);
  marching->Update();
  Volume<float> phi = fromItk(*marching->GetOutput(), single.geometry);
  for (float& value : phi.voxels)
    value = std::min(value - static_cast<float>(params.radiusVoxels), static_cast<float>(band));
  return phi;
}

Volume<float> vesselnessAt(const Volume<float>& image, double sigma, double k, double c,
                           const VesselnessParams& params, ItkHessian hessian) {
  PlainImage plain{image.voxels.data(), image.geometry.size, {}};
  for (std::size_t a = 0; a < 3; ++a)
    plain.step[a] = image.geometry.spacing[static_cast<int>(a)] / image.geometry.voxelMm();
  // The scales are spaced in log(sigma), which puts one on k but for rounding.
  const PlainMeasure measure{params.alpha, params.beta, c, sigma <= k * (1.0 + 1e-6)};
  const std::vector<float> measured = itkVesselnessAtScale(plain, sigma, measure, hessian);
  Volume<float> v(image.geometry);
  std::copy(measured.begin(), measured.end(), v.voxels.begin());
  return v;
}

}  // namespace

PrintedMethodResult printedMethod(const Volume<float>& image, const Parameters& params,
                                  ItkHessian hessian, ItkSolver solver) {
  const VesselnessParams& p = params.vesselness;
  const double voxel = image.geometry.voxelMm();
  const double low = p.sigmaMinMm.value_or(voxel) / voxel;
  const double high = p.sigmaMaxMm.value_or(6.0 * voxel) / voxel;
  const auto range = std::minmax_element(image.voxels.begin(), image.voxels.end());
  const double c = p.c.value_or(
      p.cFraction * (static_cast<double>(*range.second) - static_cast<double>(*range.first)));
  const double k = p.kMm ? *p.kMm / voxel : 2.0 * low;
  PrintedMethodResult result;

  auto start = Clock::now();
  for (const double sigma : printedScales(low, high)) {
    const Volume<float> v = vesselnessAt(image, sigma, k, c, p, hessian);
    if (result.vesselness.voxels.empty()) result.vesselness = Volume<float>(image.geometry);
    for (std::size_t i = 0; i < v.voxels.size(); ++i)
      if (std::fabs(v.voxels[i]) > std::fabs(result.vesselness.voxels[i]))
        result.vesselness.voxels[i] = v.voxels[i];
  }
  const Volume<float> single = vesselnessAt(image, 0.5 * (low + high), k, c, p, hessian);
  result.vesselnessSeconds = secondsSince(start);

  start = Clock::now();
  result.thresholds = printedThresholds(result.vesselness, high / low, params.thresholds);
  const Volume<float> phi0 = marchedStart(single, params.seeds, result.seeds);
  result.front = evolveItk(result.vesselness, result.thresholds, phi0, params.levelset, solver);
  result.frontSeconds = secondsSince(start);
  return result;
}

}  // namespace angiomesh::bench
