// SPDX-License-Identifier: BSD-3-Clause
#include "render/picture/offscreen.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOutlineSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include "core/base/error.h"
#include "render/stage/conversion.h"
#include "render/stage/offscreen_window.h"
#include "render/stage/stage.h"
#include "render/surface/surface_actor.h"

namespace angiomesh {

namespace {

void addView(vtkRenderWindow* window, SurfaceActor& surface, vtkActor* outline, bool oblique) {
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(oblique ? 0.5 : 0.0, 0.0, oblique ? 1.0 : 0.5, 1.0);
  setStage(renderer);
  renderer->AddActor(surface.actor());
  if (outline != nullptr) renderer->AddActor(outline);
  window->AddRenderer(renderer);

  std::array<double, 6> bounds{};
  renderer->ComputeVisiblePropBounds(bounds.data());
  Viewpoint view = firstViewpoint(bounds);
  if (oblique)
    view.from = (0.8 * view.from + Eigen::Vector3d(0.75, 0.0, 0.0) + 0.45 * view.up).normalized();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(view.from.data());
  camera->SetViewUp(view.up.data());
  fitCamera(renderer, bounds);
}

vtkSmartPointer<vtkActor> outlineOf(const Geometry& g) {
  vtkNew<vtkOutlineSource> box;
  box->SetBounds(-0.5 * g.spacing[0], (g.size[0] - 0.5) * g.spacing[0], -0.5 * g.spacing[1],
                 (g.size[1] - 0.5) * g.spacing[1], -0.5 * g.spacing[2],
                 (g.size[2] - 0.5) * g.spacing[2]);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(box->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetUserMatrix(patientMatrix(g));
  actor->GetProperty()->SetColor(0.42, 0.47, 0.55);
  actor->GetProperty()->LightingOff();
  return actor;
}

}  // namespace

Picture renderSurfacePicture(const TriMesh& mesh, const Volume<float>* image, int width,
                             int height) {
  if (mesh.triangles.empty())
    throw InputError("There is no surface to draw", "the mesh has no triangles",
                     "run the steps before it first");
  SurfaceActor surface({0.84, 0.27, 0.21});
  // The mesh is only read before this function returns.
  surface.setMesh(drawnMesh(std::shared_ptr<const TriMesh>(std::shared_ptr<void>(), &mesh)));
  const vtkSmartPointer<vtkActor> outline = image != nullptr ? outlineOf(image->geometry) : nullptr;

  const vtkSmartPointer<vtkRenderWindow> window = makeOffscreenWindow(width, height);
  addView(window, surface, outline, false);
  addView(window, surface, outline, true);
  return takePicture(window);
}

}  // namespace angiomesh
