// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

class vtkRenderer;

namespace angiomesh {

/// Background and lights of a 3D picture.
void setStage(vtkRenderer* renderer);

/// Moves the camera along its direction of view to where the box (x0, x1, y0, y1, z0, z1) just fits
/// the renderer's part of the window (a square before there is one).
void fitCamera(vtkRenderer* renderer, const std::array<double, 6>& bounds);

/// The same with everything visible; false, and nothing done, when nothing is.
bool fitCamera(vtkRenderer* renderer);

constexpr double viewAngleDegrees = 30.0;

}  // namespace angiomesh
