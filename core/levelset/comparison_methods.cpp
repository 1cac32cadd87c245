// SPDX-License-Identifier: BSD-3-Clause
#include "core/levelset/comparison_methods.h"

#include <itkCommand.h>
#include <itkConfidenceConnectedImageFilter.h>
#include <itkDiscreteGaussianImageFilter.h>
#include <itkGeodesicActiveContourLevelSetImageFilter.h>
#include <itkGradientMagnitudeRecursiveGaussianImageFilter.h>
#include <itkImage.h>
#include <itkOtsuThresholdImageFilter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/base/parallel.h"
#include "core/base/statistics.h"
#include "core/image/itk_volume.h"
#include "core/image/voxels.h"
#include "core/levelset/seeds.h"

namespace angiomesh {
namespace {

using Image = ItkImage;
using Mask = itk::Image<std::uint8_t, 3>;

/// Voxels nearest to the seeds; those outside the volume are none.
std::vector<Index3> seedVoxels(const Geometry& g, const std::vector<Eigen::Vector3d>& seedsLps) {
  std::vector<Index3> voxels;
  for (const Eigen::Vector3d& seed : seedsLps) {
    const Eigen::Vector3d index = g.toIndex(seed);
    Index3 p;
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = static_cast<int>(std::floor(index[static_cast<Eigen::Index>(a)] + 0.5));
    if (g.contains(p[0], p[1], p[2])) voxels.push_back(p);
  }
  if (voxels.empty())
    throw InputError("there are no seeds to start from", "seeds",
                     "give seeds by hand or turn seeds.automatic on");
  return voxels;
}

void checkNotTrivial(const Volume<float>& phi) {
  const auto inside =
      std::count_if(phi.voxels.begin(), phi.voxels.end(), [](float v) { return v < 0.0F; });
  if (inside == 0)
    throw NumericError("no voxel is inside", "segmentation.method",
                       "change the comparison.* parameters of the method, or the seeds");
  if (static_cast<std::size_t>(inside) == phi.voxels.size())
    throw NumericError("every voxel is inside", "segmentation.method",
                       "change the comparison.* parameters of the method");
}

/// g of the gradient magnitude, in place.
void toEdgePotential(Image& magnitude, const Volume<float>& image, const ComparisonParams& params) {
  const std::size_t count = image.voxels.size();
  float* m = magnitude.GetBufferPointer();
  std::vector<float> magnitudes(m, m + count);
  const auto noise = static_cast<double>(upperMedian(magnitudes));
  const std::vector<double> p = percentiles(image, {0.001, 0.5, 0.999});
  // Of bright or dark vessels alike: what stands out furthest from the median.
  const double contrast = std::max(p[2] - p[1], p[1] - p[0]);
  const double edge = std::max(
      contrast / (std::sqrt(2.0 * std::numbers::pi) * params.gacSigmaVoxels), 1.001 * noise);
  const double beta = params.gacBeta.value_or(0.5 * (edge + noise));
  const double alpha = params.gacAlpha.value_or(-(edge - noise) / 6.0);
  if (alpha == 0.0)
    throw InputError("the edges of the image have no contrast", "comparison.gac.alpha",
                     "give comparison.gac.alpha and .beta by hand");
  parallelForEach(count, 1 << 16, [&](std::size_t i) {
    m[i] =
        static_cast<float>(1.0 / (1.0 + portableExp(-(static_cast<double>(m[i]) - beta) / alpha)));
  });
}

/// What an iteration of the contour tells the outside, and what the outside asks of it.
struct ContourWatch {
  const std::function<bool()>& stop;
  const Progress& progress;
  bool stopped = false;
};

ComparisonResult activeContour(const Volume<float>& image,
                               const std::vector<Eigen::Vector3d>& seedsLps, double radiusVoxels,
                               const ComparisonParams& params, const std::function<bool()>& stop,
                               const Progress& progress) {
  Image::Pointer potential;
  {
    const auto gradient = itk::GradientMagnitudeRecursiveGaussianImageFilter<Image, Image>::New();
    gradient->SetInput(toItk(image));
    gradient->SetSigma(params.gacSigmaVoxels);
    runFilter(*gradient, progress);
    potential = gradient->GetOutput();
    potential->DisconnectPipeline();
  }
  toEdgePotential(*potential, image, params);
  progress.report(0.1);

  using Filter = itk::GeodesicActiveContourLevelSetImageFilter<Image, Image>;
  const auto filter = Filter::New();
  filter->SetInput(toItk(fastMarchingStart(image.geometry, seedsLps, radiusVoxels)));
  filter->SetFeatureImage(potential);
  filter->SetPropagationScaling(params.gacPropagation);
  filter->SetCurvatureScaling(params.gacCurvature);
  filter->SetAdvectionScaling(params.gacAdvection);
  filter->SetDerivativeSigma(params.gacSigmaVoxels);
  filter->SetMaximumRMSError(params.gacRms);
  filter->SetNumberOfIterations(static_cast<itk::IdentifierType>(params.gacIterations));

  ContourWatch state{stop, progress};
  const auto watch = itk::CStyleCommand::New();
  watch->SetClientData(&state);
  watch->SetCallback([](itk::Object* caller, const itk::EventObject&, void* data) {
    auto& contour = *dynamic_cast<Filter*>(caller);
    auto& s = *static_cast<ContourWatch*>(data);
    s.progress.evolution(static_cast<int>(contour.GetElapsedIterations()), contour.GetRMSChange());
    if (s.stop && s.stop()) {
      s.stopped = true;
      contour.SetNumberOfIterations(contour.GetElapsedIterations());
    }
  });
  filter->AddObserver(itk::IterationEvent(), watch);
  runFilter(*filter, progress);

  ComparisonResult result;
  result.iterations = static_cast<int>(filter->GetElapsedIterations());
  if (state.stopped)
    result.stopReason = StopReason::Stopped;
  else if (result.iterations >= params.gacIterations)
    result.stopReason = StopReason::Limit;
  result.phi = fromItk(*filter->GetOutput(), image.geometry);
  return result;
}

ComparisonResult confidenceConnected(const Volume<float>& image,
                                     const std::vector<Index3>& seedVoxels,
                                     const ComparisonParams& params, const Progress& progress) {
  const auto filter = itk::ConfidenceConnectedImageFilter<Image, Mask>::New();
  filter->SetInput(toItk(image));
  filter->SetMultiplier(params.confidenceMultiplier);
  filter->SetNumberOfIterations(static_cast<unsigned int>(params.confidenceIterations));
  filter->SetInitialNeighborhoodRadius(static_cast<unsigned int>(params.confidenceRadiusVoxels));
  filter->SetReplaceValue(1);
  for (const Index3& p : seedVoxels) filter->AddSeed({{p[0], p[1], p[2]}});
  runFilter(*filter, progress);
  ComparisonResult result;
  const double deviation = std::sqrt(filter->GetVariance());
  result.lower = filter->GetMean() - params.confidenceMultiplier * deviation;
  result.upper = filter->GetMean() + params.confidenceMultiplier * deviation;
  result.iterations = params.confidenceIterations;
  result.phi = Volume<float>(image.geometry);
  const std::uint8_t* found = filter->GetOutput()->GetBufferPointer();
  for (float& value : result.phi.voxels) value = *found++ != 0 ? -0.5F : 0.5F;
  return result;
}

/// Takes the parts without a seed in or beside them out of a mask of 1 and 0.
void keepSeeded(Volume<std::uint8_t>& mask, const std::vector<Index3>& seedVoxels) {
  const Components parts = connectedComponents(mask);
  std::vector<char> seeded(parts.sizes.size() + 1, 0);
  const Geometry& g = mask.geometry;
  for (const Index3& p : seedVoxels)
    forAround(g, g.offset(p[0], p[1], p[2]), [&](std::size_t, std::size_t voxel) {
      seeded[static_cast<std::size_t>(parts.labels.voxels[voxel])] = 1;
    });
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    if (seeded[static_cast<std::size_t>(parts.labels.voxels[i])] == 0) mask.voxels[i] = 0;
}

ComparisonResult threshold(const Volume<float>& image, const std::vector<Index3>& seedVoxels,
                           const ComparisonParams& params, Polarity polarity,
                           const Progress& progress) {
  Image::Pointer smooth = toItk(image);
  if (params.thresholdSigmaVoxels > 0.0) {
    const auto gauss = itk::DiscreteGaussianImageFilter<Image, Image>::New();
    gauss->SetInput(smooth);
    gauss->SetVariance(params.thresholdSigmaVoxels * params.thresholdSigmaVoxels);
    runFilter(*gauss, progress);
    smooth = gauss->GetOutput();
    smooth->DisconnectPipeline();
  }
  progress.report(0.5);
  ComparisonResult result;
  result.lower = params.thresholdLower;
  result.upper = params.thresholdUpper;
  std::optional<double>& side = polarity == Polarity::Dark ? result.upper : result.lower;
  if (!side) {
    const auto otsu = itk::OtsuThresholdImageFilter<Image, Mask>::New();
    otsu->SetInput(smooth);
    runFilter(*otsu, progress);
    side = static_cast<double>(otsu->GetThreshold());
  }
  if (result.lower && result.upper && *result.upper < *result.lower)
    throw InputError("the upper threshold, " + std::to_string(*result.upper) +
                         ", is below the lower, " + std::to_string(*result.lower),
                     "comparison.threshold.lower, comparison.threshold.upper",
                     "make upper at least lower");
  Volume<std::uint8_t> mask(image.geometry);
  const float* values = smooth->GetBufferPointer();
  const double low = result.lower.value_or(std::numeric_limits<double>::lowest());
  const double high = result.upper.value_or(std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    const auto value = static_cast<double>(values[i]);
    mask.voxels[i] = value >= low && value <= high ? 1 : 0;
  }
  if (params.thresholdFromSeeds) keepSeeded(mask, seedVoxels);
  result.phi = Volume<float>(image.geometry);
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    result.phi.voxels[i] = mask.voxels[i] != 0 ? -0.5F : 0.5F;
  return result;
}

}  // namespace

ComparisonResult segmentByComparison(const Volume<float>& image, SegmentationMethod method,
                                     const std::vector<Eigen::Vector3d>& seedsLps,
                                     double seedRadiusVoxels, const ComparisonParams& params,
                                     Polarity polarity, const std::function<bool()>& stop,
                                     const Progress& progress) {
  const std::vector<Index3> seeds = seedVoxels(image.geometry, seedsLps);
  ComparisonResult result;
  switch (method) {
    case SegmentationMethod::LevelSet:
    case SegmentationMethod::Label:
      throw InputError("the level set and a label are no comparison methods", "segmentation.method",
                       "use geodesic-active-contour, confidence-connected or threshold");
    case SegmentationMethod::GeodesicActiveContour:
      result = activeContour(image, seedsLps, seedRadiusVoxels, params, stop, progress);
      break;
    case SegmentationMethod::ConfidenceConnected:
      result = confidenceConnected(image, seeds, params, progress);
      break;
    case SegmentationMethod::Threshold:
      result = threshold(image, seeds, params, polarity, progress);
      break;
  }
  checkNotTrivial(result.phi);
  progress.report(1.0);
  return result;
}

}  // namespace angiomesh
