// SPDX-License-Identifier: BSD-3-Clause
#include "render/stage/direction_cube.h"

#include <vtkAnnotatedCubeActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace angiomesh {

struct DirectionCube::Parts {
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkAnnotatedCubeActor> cube;
};

DirectionCube::DirectionCube() : parts_(std::make_unique<Parts>()) {
  vtkAnnotatedCubeActor* cube = parts_->cube;
  cube->SetXPlusFaceText("L");
  cube->SetXMinusFaceText("R");
  cube->SetYPlusFaceText("P");
  cube->SetYMinusFaceText("A");
  cube->SetZPlusFaceText("S");
  cube->SetZMinusFaceText("I");
  // Upright letters for a viewer whose up is the patient's head, or the front for S and I.
  cube->SetXFaceTextRotation(0);
  cube->SetYFaceTextRotation(0);
  cube->SetZFaceTextRotation(-90);
  cube->SetFaceTextScale(0.62);
  cube->GetCubeProperty()->SetColor(0.28, 0.33, 0.40);
  cube->GetTextEdgesProperty()->SetColor(0.95, 0.92, 0.75);
  cube->GetTextEdgesProperty()->SetLineWidth(1);
  for (vtkProperty* face : {cube->GetXPlusFaceProperty(), cube->GetXMinusFaceProperty(),
                            cube->GetYPlusFaceProperty(), cube->GetYMinusFaceProperty(),
                            cube->GetZPlusFaceProperty(), cube->GetZMinusFaceProperty()}) {
    face->SetColor(0.95, 0.92, 0.75);
    face->SetInterpolationToFlat();
  }
  parts_->renderer->AddActor(cube);
  parts_->renderer->SetLayer(2);
  parts_->renderer->InteractiveOff();
}

DirectionCube::~DirectionCube() = default;

vtkRenderer* DirectionCube::renderer() const { return parts_->renderer; }

void DirectionCube::follow(vtkCamera* camera, int widthPixels, int heightPixels,
                           double pixelRatio) {
  const double side = 84.0 * pixelRatio;
  parts_->renderer->SetViewport(0.0, 0.0, std::min(1.0, side / std::max(1, widthPixels)),
                                std::min(1.0, side / std::max(1, heightPixels)));
  double direction[3];
  camera->GetDirectionOfProjection(direction);
  double up[3];
  camera->GetViewUp(up);
  vtkCamera* own = parts_->renderer->GetActiveCamera();
  own->SetFocalPoint(0.0, 0.0, 0.0);
  own->SetPosition(-4.0 * direction[0], -4.0 * direction[1], -4.0 * direction[2]);
  own->SetViewUp(up);
  own->SetViewAngle(30.0);
  own->SetClippingRange(1.0, 10.0);
}

}  // namespace angiomesh
