// SPDX-License-Identifier: BSD-3-Clause
#include "render/offscreen.h"

#include <dlfcn.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOutlineSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cstdlib>
#include <string>

#include "core/base/error.h"
#include "render/conversion.h"
#include "render/stage.h"
#include "render/surface_actor.h"

namespace angiomesh {

namespace {

/// Throws unless an X display with OpenGL opens. VTK 9.1 ends the process where it finds none, so
/// this asks first; through the dynamic loader, since nothing else here needs X11's headers. The
/// connection stays open as long as the process: a virtual server starts afresh when its last
/// client leaves, and refuses whoever comes just then.
void requireDisplay() {
#ifdef __linux__
  static std::string opened;
  const char* variable = std::getenv("DISPLAY");
  const std::string name = variable != nullptr ? variable : "";
  if (!name.empty() && name == opened) return;

  constexpr const char* advice = "set DISPLAY, or use a virtual display (xvfb-run -a COMMAND)";
  const std::string where = name.empty() ? "DISPLAY is not set" : "display " + name;
  void* x11 = dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
  if (x11 == nullptr) throw IoError("Cannot draw a picture", "libX11.so.6 is missing", advice);
  using Open = void* (*)(const char*);
  using Query = int (*)(void*, const char*, int*, int*, int*);
  const auto open = reinterpret_cast<Open>(dlsym(x11, "XOpenDisplay"));
  const auto query = reinterpret_cast<Query>(dlsym(x11, "XQueryExtension"));
  void* display = open != nullptr && !name.empty() ? open(nullptr) : nullptr;
  if (display == nullptr || query == nullptr)
    throw IoError("Cannot draw a picture: no X display opens", where, advice);
  int opcode = 0;
  int event = 0;
  int error = 0;
  if (query(display, "GLX", &opcode, &event, &error) == 0)
    throw IoError("Cannot draw a picture: the X display has no OpenGL (GLX)", where, advice);
  opened = name;
#endif
}

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
  requireDisplay();
  SurfaceActor surface({0.84, 0.27, 0.21});
  // The mesh is only read before this function returns.
  surface.setMesh(std::shared_ptr<const TriMesh>(std::shared_ptr<void>(), &mesh));
  const vtkSmartPointer<vtkActor> outline = image != nullptr ? outlineOf(image->geometry) : nullptr;

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(4);
  window->SetSize(width, height);
  addView(window, surface, outline, false);
  addView(window, surface, outline, true);
  window->Render();

  vtkNew<vtkUnsignedCharArray> pixels;
  if (window->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels) == 0 ||
      pixels->GetNumberOfTuples() != static_cast<vtkIdType>(width) * height)
    throw IoError("Cannot draw a picture: OpenGL gave no pixels", "offscreen window",
                  "try another display, or a virtual one (xvfb-run -a ...)");
  Picture picture;
  picture.width = width;
  picture.height = height;
  picture.rgb.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  for (int row = height - 1; row >= 0; --row)
    for (int column = 0; column < width; ++column) {
      const unsigned char* rgba =
          pixels->GetPointer(4 * (static_cast<vtkIdType>(row) * width + column));
      picture.rgb.insert(picture.rgb.end(), rgba, rgba + 3);
    }
  return picture;
}

}  // namespace angiomesh
