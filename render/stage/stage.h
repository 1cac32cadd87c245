// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

class vtkRenderer;
class vtkTextActor;

namespace angiomesh {

/// Background and lights of a 3D picture.
void setStage(vtkRenderer* renderer);

/// Letters that can be read on any picture; positions are pixels of the renderer's viewport.
void styleText(vtkTextActor* text, int size);

constexpr int textSize = 14;        ///< of lines of text, design pixels
constexpr double textMargin = 8.0;  ///< from the edges of a pane, design pixels

/// Moves the camera along its direction of view to where the box (x0, x1, y0, y1, z0, z1) just fits
/// the renderer's part of the window (a square before there is one).
void fitCamera(vtkRenderer* renderer, const std::array<double, 6>& bounds);

/// The same with everything visible; false, and nothing done, when nothing is.
bool fitCamera(vtkRenderer* renderer);

/// Where to look at something from at first: unit vectors towards the viewer and upwards, LPS.
struct Viewpoint {
  Eigen::Vector3d from{0.0, -1.0, 0.0}, up{0.0, 0.0, 1.0};
};

/// From anterior; from the feet, as an axial slice shows it, when the box (x0, x1, y0, y1, z0, z1)
/// is so flat that it would be seen from its edge.
Viewpoint firstViewpoint(const std::array<double, 6>& bounds);

/// From the patient's 'A'nterior, 'P'osterior, 'L'eft, 'R'ight, 'S'uperior or 'I'nferior side;
/// nothing for other letters.
std::optional<Viewpoint> viewpointFrom(char side);

/// Whether the processor does the work of a graphics card, once the renderer has a window.
bool drawnBySoftware(vtkRenderer* renderer);

constexpr double viewAngleDegrees = 30.0;

}  // namespace angiomesh
