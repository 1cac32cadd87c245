// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include "core/image/projection.h"

class vtkRenderWindow;

namespace angiomesh {

/// A window that nobody sees. @throws IoError when no X display with OpenGL opens
vtkSmartPointer<vtkRenderWindow> makeOffscreenWindow(int width, int height);

/// Renders the window's scenes. @throws IoError when OpenGL gives no pixels
Picture takePicture(vtkRenderWindow* window);

}  // namespace angiomesh
