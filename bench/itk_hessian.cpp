// SPDX-License-Identifier: BSD-3-Clause
#include "bench/itk_hessian.h"

#include <itkDiscreteGaussianImageFilter.h>
#include <itkHessianRecursiveGaussianImageFilter.h>
#include <itkHessianToObjectnessMeasureImageFilter.h>
#include <itkImage.h>
#include <itkImportImageContainer.h>
#include <itkLinearInterpolateImageFunction.h>
#include <itkMultiScaleHessianBasedMeasureImageFilter.h>
#include <itkMultiThreaderBase.h>
#include <itkSymmetricSecondRankTensor.h>

#include <algorithm>
#include <cmath>

namespace angiomesh::bench {
namespace {

using Image = itk::Image<float, 3>;
using Tensor = itk::SymmetricSecondRankTensor<float, 3>;
using TensorImage = itk::Image<Tensor, 3>;

std::size_t voxelCount(const PlainImage& image) {
  return static_cast<std::size_t>(image.size[0]) * static_cast<std::size_t>(image.size[1]) *
         static_cast<std::size_t>(image.size[2]);
}

std::size_t at(const std::array<int, 3>& size, int i, int j, int k) {
  return static_cast<std::size_t>(i) +
         static_cast<std::size_t>(size[0]) *
             (static_cast<std::size_t>(j) +
              static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(k));
}

/// The same memory as an image of ITK's.
Image::Pointer imported(const PlainImage& plain) {
  const auto image = Image::New();
  Image::SizeType size;
  for (unsigned int a = 0; a < 3; ++a) size[a] = static_cast<itk::SizeValueType>(plain.size[a]);
  image->SetRegions(size);
  image->SetSpacing(plain.step.data());
  const auto pixels = Image::PixelContainer::New();
  pixels->SetImportPointer(const_cast<float*>(plain.values), voxelCount(plain), false);
  image->SetPixelContainer(pixels);
  return image;
}

/// body(k) for each slice, on ITK's threads.
template <class F>
void forSlices(int count, F body) {
  const auto threader = itk::MultiThreaderBase::New();
  threader->ParallelizeArray(
      0, static_cast<itk::SizeValueType>(count),
      [&](itk::SizeValueType k) { body(static_cast<int>(k)); }, nullptr);
}

/// Eq. 3.22 from the scale-normalised eigenvalues.
double valueOf(const Tensor& hessian, const PlainMeasure& measure) {
  Tensor::EigenValuesArrayType found;
  hessian.ComputeEigenValues(found);
  std::array<double, 3> l{static_cast<double>(found[0]), static_cast<double>(found[1]),
                          static_cast<double>(found[2])};
  std::sort(l.begin(), l.end(), [](double a, double b) { return std::fabs(a) < std::fabs(b); });
  if (l[1] == 0.0 || l[2] == 0.0) return 0.0;
  const double ra = std::fabs(l[1]) / std::fabs(l[2]);
  const double rb = std::fabs(l[0]) / std::sqrt(std::fabs(l[1] * l[2]));
  const double s = std::sqrt(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);
  const double structure = 1.0 - std::exp(-s * s / (2.0 * measure.c * measure.c));
  if (l[2] > 0.0)
    return measure.negative ? std::exp(-l[2] * l[2] / (0.5 * measure.c * measure.c)) - 1.0 : 0.0;
  if (l[1] > 0.0) return 0.0;
  return (1.0 - std::exp(-ra * ra / (2.0 * measure.alpha * measure.alpha))) *
         std::exp(-rb * rb / (2.0 * measure.beta * measure.beta)) * structure;
}

/// Central differences with step sigma of the smoothed image, times sigma^2.
Tensor differences(const itk::LinearInterpolateImageFunction<Image, double>& smooth,
                   const std::array<int, 3>& at, const std::array<int, 3>& size,
                   const std::array<double, 3>& step) {
  const auto value = [&](double x, double y, double z) {
    itk::ContinuousIndex<double, 3> index;
    const std::array<double, 3> wanted{at[0] + x, at[1] + y, at[2] + z};
    for (unsigned int a = 0; a < 3; ++a)
      index[a] = std::clamp(wanted[a], 0.0, static_cast<double>(size[a] - 1));
    return smooth.EvaluateAtContinuousIndex(index);
  };
  Tensor h;
  const double centre = value(0.0, 0.0, 0.0);
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = a; b < 3; ++b) {
      std::array<double, 3> p{};
      std::array<double, 3> q{};
      p[a] = step[a];
      q[b] = step[b];
      // With step sigma, the factor 1 / sigma^2 of the difference is that of the normalisation.
      const double second =
          a == b ? value(p[0], p[1], p[2]) - 2.0 * centre + value(-p[0], -p[1], -p[2])
                 : 0.25 * (value(p[0] + q[0], p[1] + q[1], p[2] + q[2]) -
                           value(p[0] - q[0], p[1] - q[1], p[2] - q[2]) -
                           value(q[0] - p[0], q[1] - p[1], q[2] - p[2]) +
                           value(-p[0] - q[0], -p[1] - q[1], -p[2] - q[2]));
      h(a, b) = static_cast<float>(second);
    }
  return h;
}

std::vector<float> discreteVesselness(const PlainImage& image, double sigma,
                                      const PlainMeasure& measure) {
  const Image::Pointer input = imported(image);
  const auto gauss = itk::DiscreteGaussianImageFilter<Image, Image>::New();
  gauss->SetInput(input);
  gauss->SetVariance(sigma * sigma);
  gauss->SetMaximumError(0.01);
  gauss->SetMaximumKernelWidth(30);
  gauss->Update();
  const auto smooth = itk::LinearInterpolateImageFunction<Image, double>::New();
  smooth->SetInputImage(gauss->GetOutput());
  const std::array<int, 3>& size = image.size;
  std::array<double, 3> step{};
  for (unsigned int a = 0; a < 3; ++a) step[a] = sigma / input->GetSpacing()[a];
  std::vector<float> out(voxelCount(image));
  forSlices(size[2], [&](int k) {
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const Tensor h = differences(*smooth, {i, j, k}, size, step);
        out[at(size, i, j, k)] = static_cast<float>(valueOf(h, measure));
      }
  });
  return out;
}

std::vector<float> recursiveVesselness(const PlainImage& image, double sigma,
                                       const PlainMeasure& measure) {
  const Image::Pointer input = imported(image);
  const auto filter = itk::HessianRecursiveGaussianImageFilter<Image, TensorImage>::New();
  filter->SetInput(input);
  filter->SetSigma(sigma);
  filter->SetNormalizeAcrossScale(true);
  filter->Update();
  const Tensor* hessian = filter->GetOutput()->GetBufferPointer();
  std::vector<float> out(voxelCount(image));
  const std::size_t slice = voxelCount(image) / static_cast<std::size_t>(image.size[2]);
  forSlices(image.size[2], [&](int k) {
    const std::size_t first = static_cast<std::size_t>(k) * slice;
    for (std::size_t i = first; i < first + slice; ++i)
      out[i] = static_cast<float>(valueOf(hessian[i], measure));
  });
  return out;
}

}  // namespace

std::vector<float> itkVesselnessAtScale(const PlainImage& image, double sigma,
                                        const PlainMeasure& measure, ItkHessian hessian) {
  return hessian == ItkHessian::Discrete ? discreteVesselness(image, sigma, measure)
                                         : recursiveVesselness(image, sigma, measure);
}

std::vector<float> itkObjectness(const PlainImage& image, double sigma, double c) {
  using Hessians = itk::Image<itk::SymmetricSecondRankTensor<double, 3>, 3>;
  using Objectness = itk::HessianToObjectnessMeasureImageFilter<Hessians, Image>;
  using MultiScale = itk::MultiScaleHessianBasedMeasureImageFilter<Image, Hessians, Image>;
  const auto objectness = Objectness::New();
  objectness->SetAlpha(0.5);
  objectness->SetBeta(0.5);
  objectness->SetGamma(c);
  objectness->SetObjectDimension(1);
  objectness->SetBrightObject(true);
  objectness->SetScaleObjectnessMeasure(false);
  const auto filter = MultiScale::New();
  filter->SetInput(imported(image));
  filter->SetHessianToMeasureFilter(objectness);
  filter->SetSigmaMinimum(sigma);
  filter->SetSigmaMaximum(sigma);
  filter->SetNumberOfSigmaSteps(1);
  filter->Update();
  const float* values = filter->GetOutput()->GetBufferPointer();
  return {values, values + voxelCount(image)};
}

}  // namespace angiomesh::bench
