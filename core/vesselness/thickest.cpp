// SPDX-License-Identifier: BSD-3-Clause
#include "core/vesselness/thickest.h"

#include <itkImage.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace angiomesh {
namespace {

constexpr double kBlockVoxels = 4.0;
constexpr double kLeastVoxels = 6.0, kMostVoxels = 15.0;  // of the largest scale

/// Means over blocks that are about as long in each direction; those at the far border are smaller.
Volume<float> blockMeans(const Volume<float>& image) {
  const Geometry& g = image.geometry;
  Geometry coarse = g;
  Index3 block{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    block[a] =
        std::max(1, static_cast<int>(std::lround(kBlockVoxels * g.voxelMm() / g.spacing[axis])));
    coarse.size[a] = (g.size[a] + block[a] - 1) / block[a];
    coarse.spacing[axis] = g.spacing[axis] * block[a];
  }
  Volume<float> means(coarse);
  parallelFor(0, means.voxels.size(), 256, [&](std::size_t first, std::size_t last) {
    for (std::size_t n = first; n < last; ++n) {
      const Index3 at = coarse.indexOf(n);
      Index3 low{};
      Index3 high{};
      for (std::size_t a = 0; a < 3; ++a) {
        low[a] = at[a] * block[a];
        high[a] = std::min(low[a] + block[a], g.size[a]);
      }
      double sum = 0.0;
      for (int k = low[2]; k < high[2]; ++k)
        for (int j = low[1]; j < high[1]; ++j)
          for (int i = low[0]; i < high[0]; ++i) sum += static_cast<double>(image.at(i, j, k));
      means.voxels[n] = static_cast<float>(
          sum / (1.0 * (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2])));
    }
  });
  return means;
}

}  // namespace

double thickestRadiusMm(const Volume<float>& image, Polarity polarity) {
  const Volume<float> means = blockMeans(image);
  const Geometry& g = means.geometry;
  const bool bright = polarity == Polarity::Bright;
  const std::vector<double> p = percentiles(means, {bright ? 0.999 : 0.001, 0.5});
  const double middle = 0.5 * (p[0] + p[1]);

  using Mask = itk::Image<std::uint8_t, 3>;
  using Distances = itk::Image<float, 3>;
  const auto mask = Mask::New();
  Mask::SizeType size;
  Mask::SpacingType spacing;
  for (unsigned int a = 0; a < 3; ++a) {
    size[a] = static_cast<itk::SizeValueType>(g.size[a]);
    spacing[a] = g.spacing[static_cast<Eigen::Index>(a)];
  }
  mask->SetRegions(size);
  mask->SetSpacing(spacing);
  mask->Allocate();
  std::size_t inside = 0;
  for (std::size_t i = 0; i < means.voxels.size(); ++i) {
    const auto value = static_cast<double>(means.voxels[i]);
    const bool in = bright ? value > middle : value < middle;
    mask->GetBufferPointer()[i] = in ? 1 : 0;
    inside += in ? 1 : 0;
  }
  if (inside == 0 || inside == means.voxels.size()) return 0.0;
  const auto filter = itk::SignedMaurerDistanceMapImageFilter<Mask, Distances>::New();
  filter->SetInput(mask);
  filter->SquaredDistanceOff();
  filter->InsideIsPositiveOn();
  filter->UseImageSpacingOn();
  filter->Update();
  const float* distance = filter->GetOutput()->GetBufferPointer();
  // From the centres of the outermost blocks inside: the surface is half a block further.
  return static_cast<double>(*std::max_element(distance, distance + means.voxels.size())) +
         0.5 * g.spacing.minCoeff();
}

VesselnessParams withScalesFromImage(VesselnessParams params, const Volume<float>& image) {
  if (params.sigmaMaxMm || !params.scalesFromImage) return params;
  const double voxel = image.geometry.voxelMm();
  params.sigmaMaxMm = std::clamp(0.5 * thickestRadiusMm(image, params.polarity),
                                 kLeastVoxels * voxel, kMostVoxels * voxel);
  return params;
}

}  // namespace angiomesh
