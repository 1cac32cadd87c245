// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/slice_layer.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace angiomesh {

SliceLayer::SliceLayer() {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
}

SliceLayer::~SliceLayer() = default;

void SliceLayer::colour(double r, double g, double b) { actor->GetProperty()->SetColor(r, g, b); }

void SliceLayer::setSegments(const std::vector<std::array<Eigen::Vector2d, 2>>& segments,
                             double depth) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  points->Allocate(static_cast<vtkIdType>(2 * segments.size()));
  for (const auto& segment : segments) {
    const vtkIdType a = points->InsertNextPoint(segment[0][0], segment[0][1], depth);
    const vtkIdType b = points->InsertNextPoint(segment[1][0], segment[1][1], depth);
    lines->InsertNextCell({a, b});
  }
  data->SetPoints(points);
  data->SetLines(lines);
}

}  // namespace angiomesh
