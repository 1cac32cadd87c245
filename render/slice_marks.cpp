// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice_marks.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace angiomesh {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kSides = 64;
constexpr double kHeadShare = 0.3;  // of the arrow's length

using Segments = std::vector<std::array<Vector2d, 2>>;

void addArrow(const Vector2d& from, const Vector2d& along, Segments& segments) {
  const Vector2d tip = from + along;
  const Vector2d aside(-along.y(), along.x());
  segments.push_back({from, tip});
  for (const double side : {-1.0, 1.0})
    segments.push_back({tip, tip - kHeadShare * along + side * 0.6 * kHeadShare * aside});
}

/// The lines of one mark on a slice; none away from it.
Segments linesOf(const PortMark& mark, const SlicePlane& plane) {
  const Vector3d u = mark.plane.normalLps.unitOrthogonal();
  const Vector3d v = mark.plane.normalLps.cross(u);
  const double radius = mark.discRadiusMm();
  std::vector<Vector3d> rim;
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2.0 * M_PI * k / kSides;
    rim.push_back(
        plane.fromLps(mark.plane.pointLps + radius * (std::cos(angle) * u + std::sin(angle) * v)));
  }
  Segments segments;
  std::vector<Vector2d> crossings;
  bool flat = true;
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const Vector3d &a = rim[k], &b = rim[(k + 1) % rim.size()];
    flat = flat && std::fabs(a.z()) <= 0.75;
    if ((a.z() > 0.0) == (b.z() > 0.0)) continue;
    crossings.emplace_back((a + a.z() / (a.z() - b.z()) * (b - a)).head<2>());
  }
  const Vector3d centre = plane.fromLps(mark.plane.pointLps);
  const Vector2d normal =
      (plane.fromLps(mark.plane.pointLps + radius * mark.plane.normalLps) - centre).head<2>();
  if (flat) {
    for (std::size_t k = 0; k < rim.size(); ++k)
      segments.push_back({rim[k].head<2>(), rim[(k + 1) % rim.size()].head<2>()});
  } else if (crossings.size() == 2) {
    segments.push_back({crossings[0], crossings[1]});
    if (normal.norm() > 0.05 * radius)
      addArrow(0.5 * (crossings[0] + crossings[1]), normal, segments);
  }
  return segments;
}

}  // namespace

struct SliceMarks::Parts {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkActor> actor;
  std::vector<PortMark> marks;
};

SliceMarks::SliceMarks(vtkRenderer* renderer) : parts_(std::make_unique<Parts>()) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(parts_->data);
  mapper->SetScalarModeToUseCellData();
  parts_->actor->SetMapper(mapper);
  parts_->actor->GetProperty()->LightingOff();
  parts_->actor->PickableOff();
  parts_->actor->VisibilityOff();
  renderer->AddActor(parts_->actor);
}

SliceMarks::~SliceMarks() = default;

void SliceMarks::set(std::vector<PortMark> marks) { parts_->marks = std::move(marks); }

void SliceMarks::show(const SlicePlane& plane, bool visible, double depth, double pixelRatio) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (const PortMark& mark : visible ? parts_->marks : std::vector<PortMark>()) {
    for (const auto& segment : linesOf(mark, plane)) {
      const vtkIdType a = points->InsertNextPoint(segment[0][0], segment[0][1], depth);
      const vtkIdType b = points->InsertNextPoint(segment[1][0], segment[1][1], depth);
      lines->InsertNextCell({a, b});
      colours->InsertNextTuple3(255.0 * mark.colour[0], 255.0 * mark.colour[1],
                                255.0 * mark.colour[2]);
    }
  }
  parts_->data->SetPoints(points);
  parts_->data->SetLines(lines);
  parts_->data->GetCellData()->SetScalars(colours);
  parts_->actor->SetVisibility(lines->GetNumberOfCells() > 0);
  parts_->actor->GetProperty()->SetLineWidth(static_cast<float>(2.5 * pixelRatio));
}

}  // namespace angiomesh
