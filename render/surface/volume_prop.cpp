// SPDX-License-Identifier: BSD-3-Clause
#include "render/surface/volume_prop.h"

#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <utility>

#include "render/stage/conversion.h"
#include "render/surface/software_caster.h"

namespace angiomesh {

struct VolumeProp::Parts {
  vtkNew<vtkVolume> volume;
  vtkNew<vtkVolumeProperty> property;
  vtkNew<vtkColorTransferFunction> colour;
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> hardware;
  vtkSmartPointer<SoftwareCaster> processor;
  std::shared_ptr<const DrawnVolume> drawn;
  VolumeLook look;
  double coarseness = 1.0;
  bool software = false, endsAtSurfaces = false;

  void update();
  void updateSoftware(double voxelMm);
  void updateHardware(double voxelMm);
  void showLook();
};

void VolumeProp::Parts::update() {
  if (!drawn) return;
  const double voxelMm = drawn->image->geometry.voxelMm();
  property->SetScalarOpacityUnitDistance(voxelMm);
  if (software)
    updateSoftware(voxelMm);
  else
    updateHardware(voxelMm);
}

void VolumeProp::Parts::updateSoftware(double voxelMm) {
  if (!processor) {
    processor = vtkSmartPointer<SoftwareCaster>::New();
    processor->setLook(look);
  }
  // A thin vessel must not slip between the samples of a projection.
  const double step = look.kind == RayKind::Lit ? 0.5 : 0.8;
  processor->setVolume(drawn);
  processor->setSampling(step * voxelMm * coarseness, coarseness);
  processor->setEndsAtSurfaces(endsAtSurfaces);
  volume->SetMapper(processor);
}

void VolumeProp::Parts::updateHardware(double voxelMm) {
  if (!hardware) {
    hardware = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
    hardware->AutoAdjustSampleDistancesOff();
  }
  if (look.kind == RayKind::Greatest) hardware->SetBlendModeToMaximumIntensity();
  if (look.kind == RayKind::Least) hardware->SetBlendModeToMinimumIntensity();
  if (look.kind == RayKind::Lit) hardware->SetBlendModeToComposite();
  if (hardware->GetInput() == nullptr) hardware->SetInputData(toImageData(drawn->image));
  hardware->SetSampleDistance(static_cast<float>(0.5 * voxelMm * coarseness));
  hardware->SetImageSampleDistance(static_cast<float>(coarseness));
  volume->SetMapper(hardware);
}

void VolumeProp::Parts::showLook() {
  colour->RemoveAllPoints();
  opacity->RemoveAllPoints();
  for (const TransferPoint& point : look.transfer) {
    colour->AddRGBPoint(point.value, point.colour[0], point.colour[1], point.colour[2]);
    opacity->AddPoint(point.value, point.opacity);
  }
  property->SetShade(look.kind == RayKind::Lit);
  if (processor) processor->setLook(look);
}

VolumeProp::VolumeProp() : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  p.property->SetColor(p.colour);
  p.property->SetScalarOpacity(p.opacity);
  p.property->SetInterpolationTypeToLinear();
  p.property->SetAmbient(0.25);
  p.property->SetDiffuse(0.8);
  p.property->SetSpecular(0.25);
  p.property->SetSpecularPower(16.0);
  p.volume->SetProperty(p.property);
  p.volume->VisibilityOff();
  p.volume->PickableOff();
}

VolumeProp::~VolumeProp() = default;

vtkProp3D* VolumeProp::prop() const { return parts_->volume; }

void VolumeProp::setVolume(std::shared_ptr<const DrawnVolume> volume) {
  Parts& p = *parts_;
  if (volume == p.drawn) return;
  p.drawn = std::move(volume);
  if (p.hardware) p.hardware->SetInputData(static_cast<vtkImageData*>(nullptr));
  if (!p.drawn) {
    p.volume->SetMapper(nullptr);
    p.hardware = nullptr;
    p.processor = nullptr;
    return;
  }
  p.volume->SetUserMatrix(patientMatrix(p.drawn->image->geometry));
  p.update();
}

void VolumeProp::setLook(const VolumeLook& look) {
  parts_->look = look;
  parts_->showLook();
  parts_->update();
}

void VolumeProp::setSoftware(bool software) {
  if (software == parts_->software) return;
  parts_->software = software;
  parts_->update();
  // The mapper out of use would hold on to its image.
  if (software)
    parts_->hardware = nullptr;
  else
    parts_->processor = nullptr;
}

void VolumeProp::setCoarseness(double coarseness) {
  if (coarseness == parts_->coarseness) return;
  parts_->coarseness = coarseness;
  parts_->update();
}

double VolumeProp::coarseness() const { return parts_->coarseness; }

void VolumeProp::setEndsAtSurfaces(bool ends) {
  if (std::exchange(parts_->endsAtSurfaces, ends) != ends) parts_->update();
}

double VolumeProp::secondsOfLastFrame() const {
  return parts_->volume->GetMapper() != nullptr ? parts_->volume->GetMapper()->GetTimeToDraw()
                                                : 0.0;
}

}  // namespace angiomesh
