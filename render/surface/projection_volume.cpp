// SPDX-License-Identifier: BSD-3-Clause
#include "render/surface/projection_volume.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/stage/conversion.h"

namespace angiomesh {

namespace {

/// Draws the last picture again where a new one would be the same: a surface that evolves in front
/// of the projection then costs nothing of it.
class RememberingCaster : public vtkFixedPointVolumeRayCastMapper {
 public:
  static RememberingCaster* New();

  void Render(vtkRenderer* renderer, vtkVolume* volume) override {
    const View now = viewOf(renderer, volume);
    if (shown_ == now) {
      DisplayRenderedImage(renderer, volume);
      return;
    }
    vtkFixedPointVolumeRayCastMapper::Render(renderer, volume);
    shown_ = now;
  }

 private:
  /// All that the picture follows from, but for the clipping range, which never cuts the volume.
  struct View {
    std::array<double, 10> camera{};
    std::array<int, 2> size{0, 0};
    std::array<vtkMTimeType, 3> changes{};

    bool operator==(const View&) const = default;
  };

  View viewOf(vtkRenderer* renderer, vtkVolume* volume) {
    View view;
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->GetPosition(&view.camera[0]);
    camera->GetFocalPoint(&view.camera[3]);
    camera->GetViewUp(&view.camera[6]);
    view.camera[9] = camera->GetViewAngle();
    view.size = {renderer->GetSize()[0], renderer->GetSize()[1]};
    view.changes = {GetMTime(), volume->GetMTime(), GetInput()->GetMTime()};
    return view;
  }

  View shown_;
};

vtkStandardNewMacro(RememberingCaster);

}  // namespace

struct ProjectionVolume::Parts {
  vtkNew<vtkVolume> volume;
  vtkNew<vtkColorTransferFunction> grey;
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> hardware;
  vtkSmartPointer<RememberingCaster> processor;
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
      processor = vtkSmartPointer<RememberingCaster>::New();
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
