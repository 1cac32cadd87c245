// SPDX-License-Identifier: BSD-3-Clause
#include "render/picture/mesh_panels.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "core/base/error.h"
#include "render/stage/offscreen_window.h"
#include "render/stage/stage.h"
#include "render/surface/surface_actor.h"

namespace angiomesh {
namespace {

constexpr int titlePixels = 17;

using Box = std::array<double, 6>;

/// The triangles whose centroids lie in the box.
TriMesh within(const TriMesh& mesh, const Box& box) {
  TriMesh part;
  part.points = mesh.points;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d centroid =
        (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3.0;
    bool inside = true;
    for (int a = 0; a < 3; ++a)
      inside = inside && centroid[a] >= box[2 * static_cast<std::size_t>(a)] &&
               centroid[a] <= box[2 * static_cast<std::size_t>(a) + 1];
    if (inside) part.triangles.push_back(t);
  }
  return part;
}

using Meshes = std::vector<std::shared_ptr<const TriMesh>>;

/// The box of all triangles. @throws InputError when there is none
Box boundsOf(const Meshes& meshes) {
  constexpr double far = std::numeric_limits<double>::max();
  Box box{far, -far, far, -far, far, -far};
  for (const auto& mesh : meshes)
    for (const auto& t : mesh->triangles)
      for (const std::uint32_t v : t)
        for (std::size_t a = 0; a < 3; ++a) {
          const double x = mesh->points[v][static_cast<Eigen::Index>(a)];
          box[2 * a] = std::min(box[2 * a], x);
          box[2 * a + 1] = std::max(box[2 * a + 1], x);
        }
  if (box[0] > box[1])
    throw InputError("There is no surface to draw", "no mesh has a triangle",
                     "run the steps before it first");
  return box;
}

/// One part of the window, from (x0, y0) to (x1, y1) as fractions of it.
void addPart(vtkRenderWindow* window, const std::array<double, 4>& part, SurfaceActor& surface,
             const Box& bounds, const Viewpoint& view, const std::string& title) {
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(part[0], part[1], part[2], part[3]);
  setStage(renderer);
  renderer->AddActor(surface.actor());
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(view.from.data());
  camera->SetViewUp(view.up.data());
  fitCamera(renderer, bounds);
  if (title.empty()) return;
  vtkNew<vtkTextActor> text;
  text->SetInput(title.c_str());
  vtkTextProperty* property = text->GetTextProperty();
  property->SetFontSize(titlePixels);
  property->SetColor(0.93, 0.94, 0.96);
  property->SetJustificationToCentered();
  property->SetVerticalJustificationToTop();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(0.5, 0.985);
  renderer->AddActor2D(text);
}

}  // namespace

Picture renderMeshPanels(const std::vector<MeshPanel>& panels, const Box& detail, int panelWidth,
                         int panelHeight, bool edges) {
  Meshes rows[2];  // the whole, the detail
  for (const MeshPanel& panel : panels) {
    rows[0].push_back(std::make_shared<TriMesh>(*panel.mesh));
    rows[1].push_back(std::make_shared<TriMesh>(within(*panel.mesh, detail)));
  }
  const Viewpoint front = firstViewpoint(boundsOf(rows[0]));
  const auto count = static_cast<int>(panels.size());
  const vtkSmartPointer<vtkRenderWindow> window =
      makeOffscreenWindow(count * panelWidth, 2 * panelHeight);
  std::vector<std::unique_ptr<SurfaceActor>> actors;
  for (const bool near : {false, true}) {
    const Meshes& meshes = rows[near ? 1 : 0];
    const Box bounds = boundsOf(meshes);
    for (int i = 0; i < count; ++i) {
      const auto number = static_cast<std::size_t>(i);
      const double left = static_cast<double>(i) / count;
      const double right = static_cast<double>(i + 1) / count;
      actors.push_back(std::make_unique<SurfaceActor>(std::array<double, 3>{0.84, 0.27, 0.21}));
      actors.back()->setMesh(drawnMesh(meshes[number]));
      actors.back()->setEdgesVisible(near && edges);
      addPart(window, {left, near ? 0.0 : 0.5, right, near ? 0.5 : 1.0}, *actors.back(), bounds,
              front, near ? std::string() : panels[number].title);
    }
  }
  return takePicture(window);
}

}  // namespace angiomesh
