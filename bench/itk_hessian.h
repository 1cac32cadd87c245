// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

// No header of core here: ITK's tensors bring a copy of Eigen that clashes with the system's.
namespace angiomesh::bench {

/// How the derivatives of the image at a scale are made.
enum class ItkHessian {
  Discrete,  ///< itk::DiscreteGaussianImageFilter, then central differences with step sigma (5.1)
  Recursive  ///< itk::HessianRecursiveGaussianImageFilter
};

/// Values with x fastest; `step` is the distance of neighbours in working voxels.
struct PlainImage {
  const float* values = nullptr;
  std::array<int, 3> size{};
  std::array<double, 3> step{1.0, 1.0, 1.0};
};

/// The numbers of eq. 3.22; `negative`: with its negative branch.
struct PlainMeasure {
  double alpha = 0.5, beta = 0.5, c = 1.0;
  bool negative = false;
};

/// v of eq. 3.22 at the scale sigma, working voxels, from ITK's derivatives and eigenvalues.
std::vector<float> itkVesselnessAtScale(const PlainImage& image, double sigma,
                                        const PlainMeasure& measure, ItkHessian hessian);

/// itk::MultiScaleHessianBasedMeasureImageFilter with itk::HessianToObjectnessMeasureImageFilter
/// (alpha = beta = 0.5, gamma = c, bright tubes) at one scale.
std::vector<float> itkObjectness(const PlainImage& image, double sigma, double c);

}  // namespace angiomesh::bench
