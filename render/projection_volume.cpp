// SPDX-License-Identifier: BSD-3-Clause
#include "render/projection_volume.h"

#include <vtkColorTransferFunction.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

#include "render/conversion.h"

namespace angiomesh {

struct ProjectionVolume::Parts {
  vtkNew<vtkVolume> volume;
  vtkNew<vtkColorTransferFunction> grey;
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> hardware;
  vtkSmartPointer<vtkFixedPointVolumeRayCastMapper> processor;
  vtkSmartPointer<vtkImageData> image;
  double voxelMm = 1.0, coarseness = 1.0;
  bool software = false;

  void update();
};

void ProjectionVolume::Parts::update() {
  if (!image) return;
  const double ray = voxelMm * coarseness;
  if (software) {
    if (!processor) {
      processor = vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>::New();
      processor->SetBlendModeToMaximumIntensity();
      processor->AutoAdjustSampleDistancesOff();
    }
    processor->SetInputData(image);
    processor->SetSampleDistance(static_cast<float>(ray));
    processor->SetInteractiveSampleDistance(static_cast<float>(ray));
    processor->SetImageSampleDistance(static_cast<float>(coarseness));
    volume->SetMapper(processor);
  } else {
    if (!hardware) {
      hardware = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
      hardware->SetBlendModeToMaximumIntensity();
      hardware->AutoAdjustSampleDistancesOff();
    }
    hardware->SetInputData(image);
    hardware->SetSampleDistance(static_cast<float>(0.5 * ray));
    hardware->SetImageSampleDistance(static_cast<float>(coarseness));
    volume->SetMapper(hardware);
  }
}

ProjectionVolume::ProjectionVolume() : parts_(std::make_unique<Parts>()) {
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(parts_->grey);
  property->SetScalarOpacity(parts_->opacity);
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  parts_->volume->SetProperty(property);
  parts_->volume->VisibilityOff();
  parts_->volume->PickableOff();
}

ProjectionVolume::~ProjectionVolume() = default;

vtkProp3D* ProjectionVolume::prop() const { return parts_->volume; }

void ProjectionVolume::setImage(const std::shared_ptr<const Volume<float>>& image) {
  Parts& p = *parts_;
  p.image = image ? toImageData(image) : nullptr;
  if (!image) {
    p.volume->SetMapper(nullptr);
    p.hardware = nullptr;
    p.processor = nullptr;
    return;
  }
  p.voxelMm = image->geometry.voxelMm();
  p.volume->SetUserMatrix(patientMatrix(image->geometry));
  p.update();
}

void ProjectionVolume::setWindow(double from, double to) {
  const double end = std::max(to, from + 1e-6 * std::max(1.0, std::abs(from)));
  parts_->grey->RemoveAllPoints();
  // White throughout: the opacity alone makes the grey, linear as in a slice.
  parts_->grey->AddRGBPoint(from, 1.0, 1.0, 1.0);
  parts_->opacity->RemoveAllPoints();
  parts_->opacity->AddPoint(from, 0.0);
  parts_->opacity->AddPoint(end, 1.0);
}

void ProjectionVolume::setSoftware(bool software) {
  if (software == parts_->software) return;
  parts_->software = software;
  parts_->update();
  // The mapper out of use would hold on to its image.
  if (software)
    parts_->hardware = nullptr;
  else
    parts_->processor = nullptr;
}

void ProjectionVolume::setCoarseness(double coarseness) {
  if (coarseness == parts_->coarseness) return;
  parts_->coarseness = coarseness;
  parts_->update();
}

double ProjectionVolume::coarseness() const { return parts_->coarseness; }

double ProjectionVolume::secondsOfLastFrame() const {
  return parts_->volume->GetMapper() != nullptr ? parts_->volume->GetMapper()->GetTimeToDraw()
                                                : 0.0;
}

}  // namespace angiomesh
