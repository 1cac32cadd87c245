// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

class vtkCamera;
class vtkRenderer;

namespace angiomesh {

/// A small cube in the lower left corner of a 3D pane whose faces name the patient's sides; it has
/// a renderer of its own in layer 2, above the scene's, and turns with the scene's camera.
class DirectionCube {
 public:
  DirectionCube();
  ~DirectionCube();
  DirectionCube(const DirectionCube&) = delete;
  DirectionCube& operator=(const DirectionCube&) = delete;

  [[nodiscard]] vtkRenderer* renderer() const;
  /// To be called before each frame.
  void follow(vtkCamera* camera, int widthPixels, int heightPixels, double pixelRatio);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace angiomesh
