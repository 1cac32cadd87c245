// SPDX-License-Identifier: BSD-3-Clause
#include "core/image/itk_volume.h"

#include <itkCommand.h>
#include <itkImage.h>
#include <itkProcessObject.h>

#include <algorithm>

namespace angiomesh {

itk::SmartPointer<ItkImage> toItk(const Volume<float>& image) {
  const Geometry& g = image.geometry;
  const auto out = ItkImage::New();
  ItkImage::SizeType size;
  ItkImage::SpacingType spacing;
  for (unsigned int a = 0; a < 3; ++a) {
    size[a] = static_cast<itk::SizeValueType>(g.size[a]);
    spacing[a] = g.spacing[static_cast<Eigen::Index>(a)] / g.voxelMm();
  }
  out->SetRegions(size);
  out->SetSpacing(spacing);
  out->Allocate();
  std::copy(image.voxels.begin(), image.voxels.end(), out->GetBufferPointer());
  return out;
}

Volume<float> fromItk(const ItkImage& image, const Geometry& geometry) {
  Volume<float> out(geometry);
  std::copy_n(image.GetBufferPointer(), out.voxels.size(), out.voxels.begin());
  return out;
}

void runFilter(itk::ProcessObject& filter, const Progress& progress) {
  const auto watch = itk::CStyleCommand::New();
  watch->SetClientData(const_cast<Progress*>(&progress));
  watch->SetCallback([](itk::Object* caller, const itk::EventObject&, void* data) {
    if (static_cast<const Progress*>(data)->cancelled())
      dynamic_cast<itk::ProcessObject*>(caller)->AbortGenerateDataOn();
  });
  filter.AddObserver(itk::ProgressEvent(), watch);
  filter.AddObserver(itk::IterationEvent(), watch);
  try {
    filter.Update();
  } catch (const itk::ProcessAborted&) {
    progress.check();
    throw;
  }
  progress.check();
}

}  // namespace angiomesh
