// SPDX-License-Identifier: BSD-3-Clause
#include "render/marks/measure_marks.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include "render/stage/stage.h"

namespace angiomesh {

namespace {

using Eigen::Vector3d;
using Colour = std::array<double, 3>;

constexpr Colour kColour{0.35, 0.95, 0.95}, kSelected{1.0, 0.85, 0.25}, kDimmed{0.55, 0.62, 0.62};
constexpr double kLineWidth = 2.0, kPointSize = 6.0;  // design pixels
/// Towards the viewer, in 65000ths of the depth shown.
constexpr double kOnTop = -25000.0;

const Colour& colourOf(const DrawnMeasure& mark) {
  return mark.selected ? kSelected : mark.dimmed ? kDimmed : kColour;
}

void add(vtkUnsignedCharArray* colours, const Colour& c) {
  colours->InsertNextTuple3(255.0 * c[0], 255.0 * c[1], 255.0 * c[2]);
}

}  // namespace

struct MeasureMarks::Parts {
  vtkRenderer* renderer = nullptr;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  std::vector<vtkNew<vtkTextActor>> labels;

  void resizeLabels(std::size_t count);
  void showShapes(const std::vector<DrawnMeasure>& marks);
};

void MeasureMarks::Parts::resizeLabels(std::size_t count) {
  for (std::size_t i = count; i < labels.size(); ++i) renderer->RemoveViewProp(labels[i]);
  const std::size_t before = labels.size();
  labels.resize(count);
  for (std::size_t i = before; i < count; ++i) {
    styleText(labels[i], textSize);
    labels[i]->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    renderer->AddViewProp(labels[i]);
  }
}

/// Colours go by cell, and the cells of points come before those of lines.
void MeasureMarks::Parts::showShapes(const std::vector<DrawnMeasure>& marks) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> dots, lines;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  const auto insert = [&](const Vector3d& p) { return points->InsertNextPoint(p.data()); };
  for (const DrawnMeasure& mark : marks)
    for (const Vector3d& p : mark.points) {
      dots->InsertNextCell({insert(p)});
      add(colours, colourOf(mark));
    }
  for (const DrawnMeasure& mark : marks)
    for (const auto& line : mark.lines) {
      lines->InsertNextCell({insert(line[0]), insert(line[1])});
      add(colours, colourOf(mark));
    }
  data->SetPoints(points);
  data->SetVerts(dots);
  data->SetLines(lines);
  data->GetCellData()->SetScalars(colours);
  actor->SetVisibility(points->GetNumberOfPoints() > 0);
}

MeasureMarks::MeasureMarks(vtkRenderer* renderer) : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  p.renderer = renderer;
  p.mapper->SetInputData(p.data);
  p.mapper->SetResolveCoincidentTopologyToPolygonOffset();
  p.mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, kOnTop);
  p.mapper->SetRelativeCoincidentTopologyPointOffsetParameter(kOnTop);
  p.actor->SetMapper(p.mapper);
  p.actor->GetProperty()->LightingOff();
  p.actor->PickableOff();
  p.actor->VisibilityOff();
  renderer->AddActor(p.actor);
  setPixelRatio(1.0);
}

MeasureMarks::~MeasureMarks() {
  parts_->resizeLabels(0);
  parts_->renderer->RemoveActor(parts_->actor);
}

void MeasureMarks::setPixelRatio(double ratio) {
  vtkProperty* property = parts_->actor->GetProperty();
  property->SetLineWidth(static_cast<float>(kLineWidth * ratio));
  property->SetPointSize(static_cast<float>(kPointSize * ratio));
}

void MeasureMarks::show(const std::vector<DrawnMeasure>& marks) {
  Parts& p = *parts_;
  p.showShapes(marks);
  p.resizeLabels(marks.size());
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Colour& c = colourOf(marks[i]);
    // Beside its place, not on it.
    p.labels[i]->SetInput(("  " + marks[i].label).c_str());
    p.labels[i]->GetTextProperty()->SetColor(c[0], c[1], c[2]);
    const Vector3d& at = marks[i].labelAt;
    p.labels[i]->GetPositionCoordinate()->SetValue(at[0], at[1], at[2]);
    p.labels[i]->SetVisibility(!marks[i].label.empty());
  }
}

std::vector<DrawnMeasure> drawnInSpace(const std::vector<MeasureMark>& marks) {
  std::vector<DrawnMeasure> drawn;
  for (const MeasureMark& mark : marks) {
    drawn.push_back(
        {mark.lines, mark.points, mark.label, mark.labelLps, mark.selected, mark.dimmed});
    std::vector<std::array<Vector3d, 2>>& lines = drawn.back().lines;
    lines.insert(lines.end(), mark.diameters.begin(), mark.diameters.end());
    for (const auto& outline : mark.outlines)
      for (std::size_t k = 0; k < outline.size(); ++k)
        lines.push_back({outline[k], outline[(k + 1) % outline.size()]});
  }
  return drawn;
}

}  // namespace angiomesh
