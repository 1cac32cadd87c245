// SPDX-License-Identifier: BSD-3-Clause
#include "core/preprocess/curvature_flow.h"

#include <itkCurvatureFlowImageFilter.h>

#include "core/image/itk_volume.h"

namespace angiomesh {

Volume<float> curvatureFlow(const Volume<float>& image, int iterations, double timeStep,
                            const Progress& progress) {
  const auto filter = itk::CurvatureFlowImageFilter<ItkImage, ItkImage>::New();
  // The filter's step is stable up to 1/16 of the squared spacing: in working voxels.
  filter->SetInput(toItk(image));
  filter->SetNumberOfIterations(static_cast<itk::IdentifierType>(iterations));
  filter->SetTimeStep(timeStep);
  runFilter(*filter, progress);
  progress.report(1.0);
  return fromItk(*filter->GetOutput(), image.geometry);
}

}  // namespace angiomesh
