// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <itkImage.h>
#include <itkImportImageContainer.h>

#include <algorithm>

#include "core/image/volume.h"

namespace angiomesh::bench {

using ItkImage = itk::Image<float, 3>;

/// The volume as an image of ITK's that reads the same memory; lengths in working voxels, axes
/// those of the grid. The volume must outlive the image and is not written to.
inline ItkImage::Pointer asItk(const Volume<float>& volume) {
  const auto image = ItkImage::New();
  ItkImage::SizeType size;
  ItkImage::SpacingType spacing;
  for (unsigned int a = 0; a < 3; ++a) {
    size[a] = static_cast<itk::SizeValueType>(volume.geometry.size[a]);
    spacing[a] = volume.geometry.spacing[static_cast<int>(a)] / volume.geometry.voxelMm();
  }
  image->SetRegions(size);
  image->SetSpacing(spacing);
  const auto pixels = ItkImage::PixelContainer::New();
  pixels->SetImportPointer(const_cast<float*>(volume.voxels.data()), volume.voxels.size(), false);
  image->SetPixelContainer(pixels);
  return image;
}

/// A copy on the grid `geometry`, which has the image's size.
inline Volume<float> fromItk(const ItkImage& image, const Geometry& geometry) {
  Volume<float> volume(geometry);
  std::copy_n(image.GetBufferPointer(), volume.voxels.size(), volume.voxels.begin());
  return volume;
}

}  // namespace angiomesh::bench
