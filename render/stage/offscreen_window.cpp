// SPDX-License-Identifier: BSD-3-Clause
#include "render/stage/offscreen_window.h"

#include <dlfcn.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <cstdlib>
#include <string>

#include "core/base/error.h"

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

}  // namespace

vtkSmartPointer<vtkRenderWindow> makeOffscreenWindow(int width, int height) {
  requireDisplay();
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(4);
  window->SetSize(width, height);
  return window;
}

Picture takePicture(vtkRenderWindow* window) {
  window->Render();
  const int width = window->GetSize()[0];
  const int height = window->GetSize()[1];
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
