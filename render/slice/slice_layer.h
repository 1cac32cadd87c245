// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>

#include <Eigen/Core>
#include <array>
#include <vector>

class vtkActor;
class vtkPolyData;

namespace angiomesh {

/// Lines or dots in a slice pane's flat scene.
struct SliceLayer {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkActor> actor;  ///< to be added to a renderer

  SliceLayer();
  ~SliceLayer();
  SliceLayer(const SliceLayer&) = delete;
  SliceLayer& operator=(const SliceLayer&) = delete;

  void colour(double r, double g, double b);
  /// @param depth towards the viewer
  void setSegments(const std::vector<std::array<Eigen::Vector2d, 2>>& segments, double depth);
};

}  // namespace angiomesh
