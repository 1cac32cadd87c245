// SPDX-License-Identifier: BSD-3-Clause
#include "core/preprocess/curvature_flow.h"

#include <itkCommand.h>
#include <itkCurvatureFlowImageFilter.h>
#include <itkImage.h>

#include <algorithm>

namespace angiomesh {

Volume<float> curvatureFlow(const Volume<float>& image, int iterations, double timeStep,
                            const Progress& progress) {
  using Image = itk::Image<float, 3>;
  const Geometry& g = image.geometry;
  const auto input = Image::New();
  Image::SizeType size;
  Image::SpacingType spacing;
  for (unsigned int a = 0; a < 3; ++a) {
    size[a] = static_cast<itk::SizeValueType>(g.size[a]);
    // The filter's step is stable up to 1/16 of the squared spacing.
    spacing[a] = g.spacing[static_cast<Eigen::Index>(a)] / g.spacing.minCoeff();
  }
  input->SetRegions(size);
  input->SetSpacing(spacing);
  input->Allocate();
  std::copy(image.voxels.begin(), image.voxels.end(), input->GetBufferPointer());

  const auto filter = itk::CurvatureFlowImageFilter<Image, Image>::New();
  filter->SetInput(input);
  filter->SetNumberOfIterations(static_cast<itk::IdentifierType>(iterations));
  filter->SetTimeStep(timeStep);
  const auto watch = itk::CStyleCommand::New();
  // An exception may not cross ITK's iteration event: ask the filter to stop, throw after it has.
  watch->SetClientData(const_cast<Progress*>(&progress));
  watch->SetCallback([](itk::Object* caller, const itk::EventObject&, void* data) {
    if (static_cast<const Progress*>(data)->cancelled())
      dynamic_cast<itk::ProcessObject*>(caller)->AbortGenerateDataOn();
  });
  filter->AddObserver(itk::IterationEvent(), watch);
  try {
    filter->Update();
  } catch (const itk::ProcessAborted&) {
    progress.check();
    throw;
  }
  progress.report(1.0);
  Volume<float> out(g);
  std::copy_n(filter->GetOutput()->GetBufferPointer(), out.voxels.size(), out.voxels.begin());
  return out;
}

}  // namespace angiomesh
