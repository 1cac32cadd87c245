// SPDX-License-Identifier: BSD-3-Clause
#include "render/surface/triangle_marks.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <array>

namespace angiomesh {

namespace {

constexpr std::array<double, 3> kColour{0.10, 1.0, 0.85};
constexpr double kOutline = 2.5;  // pixels
/// From many triangles on each is seen without an outline.
constexpr std::size_t kFew = 5000;

}  // namespace

TriangleMarks::TriangleMarks() {
  mapper_->ScalarVisibilityOff();
  // In front of the surface that they are part of.
  mapper_->SetResolveCoincidentTopologyToPolygonOffset();
  mapper_->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2.0, -2.0);
  mapper_->SetRelativeCoincidentTopologyLineOffsetParameters(-2.0, -2.0);
  actor_->SetMapper(mapper_);
  vtkProperty* property = actor_->GetProperty();
  property->SetColor(kColour[0], kColour[1], kColour[2]);
  property->LightingOff();
  setPixelRatio(1.0);
  show();
}

TriangleMarks::~TriangleMarks() = default;

vtkActor* TriangleMarks::actor() const { return actor_; }

void TriangleMarks::set(const TriMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const std::uint32_t t : triangles) {
    std::array<vtkIdType, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = points->InsertNextPoint(mesh.points[mesh.triangles[t][k]].data());
    cells->InsertNextCell(3, corners.data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  mapper_->SetInputData(data);
  // Lines: the edges of a needle that covers no pixel are not drawn with its face.
  actor_->GetProperty()->SetRepresentation(triangles.size() <= kFew ? VTK_WIREFRAME : VTK_SURFACE);
  any_ = !triangles.empty();
  show();
}

void TriangleMarks::clear() {
  any_ = false;
  show();
}

void TriangleMarks::setVisible(bool visible) {
  visible_ = visible;
  show();
}

void TriangleMarks::setPixelRatio(double ratio) {
  actor_->GetProperty()->SetLineWidth(static_cast<float>(kOutline * ratio));
}

void TriangleMarks::show() { actor_->SetVisibility(any_ && visible_); }

}  // namespace angiomesh
