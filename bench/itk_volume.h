// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <itkImage.h>
#include <itkImportImageContainer.h>

#include "core/image/itk_volume.h"

namespace angiomesh::bench {

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

}  // namespace angiomesh::bench
