// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>

#include <cstdint>
#include <vector>

#include "core/mesh/tri_mesh.h"

class vtkActor;
class vtkPolyDataMapper;

namespace angiomesh {

/// Triangles of a surface that stand out from it, in a colour that no scale has, with outlines that
/// show the smallest of them from afar.
class TriangleMarks {
 public:
  TriangleMarks();
  ~TriangleMarks();
  TriangleMarks(const TriangleMarks&) = delete;
  TriangleMarks& operator=(const TriangleMarks&) = delete;

  [[nodiscard]] vtkActor* actor() const;
  void set(const TriMesh& mesh, const std::vector<std::uint32_t>& triangles);
  void clear();
  void setVisible(bool visible);
  void setPixelRatio(double ratio);

 private:
  void show();

  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
  bool any_ = false, visible_ = true;
};

}  // namespace angiomesh
