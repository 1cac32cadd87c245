// SPDX-License-Identifier: BSD-3-Clause
#include "render/marks/port_marks.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "render/marks/surface_pick.h"

namespace angiomesh {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kSides = 64;
constexpr double kArrowRadii = 2.2;    // of the vessel's radius, at least
constexpr double kArrowPixels = 34.0;  // design pixels, at least
constexpr double kGripPixels = 8.0;
constexpr int kNameSize = 13;
constexpr double kNameAspect = 0.6;  // a letter's width to its height, about
/// Towards the viewer, in 65000ths of the depth shown.
constexpr double kBefore = -40.0, kOnTop = -25000.0;

/// Two unit vectors across a normal.
std::array<Vector3d, 2> across(const Vector3d& normal) {
  const Vector3d u = normal.unitOrthogonal();
  return {u, normal.cross(u)};
}

/// Takes x to the normal, scaled.
vtkSmartPointer<vtkMatrix4x4> placement(const CutPlane& plane, double along, double aside) {
  const auto [u, v] = across(plane.normalLps);
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row) {
    matrix->SetElement(row, 0, along * plane.normalLps[row]);
    matrix->SetElement(row, 1, aside * u[row]);
    matrix->SetElement(row, 2, aside * v[row]);
    matrix->SetElement(row, 3, plane.pointLps[row]);
  }
  return matrix;
}

/// Distance from a convex outline on the screen, 0 inside.
double fromDisc(const Vector2d& p, const std::vector<Vector2d>& outline) {
  double nearest = std::numeric_limits<double>::infinity();
  bool left = true, right = true;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector2d& a = outline[k];
    const Vector2d& b = outline[(k + 1) % outline.size()];
    nearest = std::min(nearest, distanceToSegment(p, a, b));
    const double side = (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
    left = left && side >= 0.0;
    right = right && side <= 0.0;
  }
  return left || right ? 0.0 : nearest;
}

/// A unit disc across x and its rim.
void buildDisc(vtkPolyData* disc, vtkPolyData* rim) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> face, line;
  face->InsertNextCell(kSides);
  line->InsertNextCell(kSides + 1);
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kSides;
    const vtkIdType id = points->InsertNextPoint(0.0, std::cos(angle), std::sin(angle));
    face->InsertCellPoint(id);
    line->InsertCellPoint(id);
  }
  line->InsertCellPoint(0);
  disc->SetPoints(points);
  disc->SetPolys(face);
  rim->SetPoints(points);
  rim->SetLines(line);
}

struct MarkActors {
  vtkNew<vtkActor> disc, rim, arrow;
  vtkNew<vtkTextActor> name;
};

}  // namespace

struct PortMarks::Parts {
  vtkRenderer* renderer = nullptr;
  vtkNew<vtkPolyDataMapper> discMapper, rimMapper, arrowMapper;
  std::vector<PortMark> marks;
  std::vector<std::unique_ptr<MarkActors>> actors;
  double pixelRatio = 1.0;

  void resize(std::size_t count);
  void style(std::size_t index);
  void remove(MarkActors& mark);
  [[nodiscard]] double arrowMm(std::size_t index) const;
  void placeNames();
};

void PortMarks::Parts::remove(MarkActors& mark) {
  for (vtkActor* actor : {mark.disc.Get(), mark.rim.Get(), mark.arrow.Get()})
    renderer->RemoveActor(actor);
  renderer->RemoveViewProp(mark.name);
}

void PortMarks::Parts::resize(std::size_t count) {
  while (actors.size() > count) {
    remove(*actors.back());
    actors.pop_back();
  }
  while (actors.size() < count) {
    auto made = std::make_unique<MarkActors>();
    made->disc->SetMapper(discMapper);
    made->rim->SetMapper(rimMapper);
    made->arrow->SetMapper(arrowMapper);
    for (vtkActor* actor : {made->disc.Get(), made->rim.Get()}) actor->GetProperty()->LightingOff();
    made->arrow->GetProperty()->SetAmbient(0.35);
    made->name->GetPositionCoordinate()->SetCoordinateSystemToViewport();
    vtkTextProperty* text = made->name->GetTextProperty();
    text->SetFontFamilyToArial();
    text->SetFontSize(kNameSize);
    text->ShadowOn();
    text->SetVerticalJustificationToCentered();
    for (vtkActor* actor : {made->disc.Get(), made->rim.Get(), made->arrow.Get()})
      renderer->AddActor(actor);
    renderer->AddViewProp(made->name);
    actors.push_back(std::move(made));
  }
}

void PortMarks::Parts::style(std::size_t index) {
  const PortMark& mark = marks[index];
  MarkActors& shown = *actors[index];
  const auto& c = mark.colour;
  for (vtkActor* actor : {shown.disc.Get(), shown.rim.Get(), shown.arrow.Get()})
    actor->GetProperty()->SetColor(c[0], c[1], c[2]);
  shown.disc->GetProperty()->SetOpacity(mark.selected ? 0.55 : 0.3);
  shown.name->GetTextProperty()->SetColor(c[0], c[1], c[2]);
  shown.name->GetTextProperty()->SetBold(mark.selected);
  shown.name->SetInput(mark.name.c_str());
}

PortMarks::PortMarks(vtkRenderer* renderer) : parts_(std::make_unique<Parts>()) {
  parts_->renderer = renderer;
  vtkNew<vtkPolyData> disc, rim;
  buildDisc(disc, rim);
  parts_->discMapper->SetInputData(disc);
  parts_->rimMapper->SetInputData(rim);
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipResolution(24);
  arrow->SetShaftResolution(16);
  arrow->SetTipLength(0.4);
  arrow->SetTipRadius(0.14);
  arrow->SetShaftRadius(0.045);
  parts_->arrowMapper->SetInputConnection(arrow->GetOutputPort());
  // The disc lies in the cap that comes of it, and the arrow of a cut to come in the vessel.
  parts_->discMapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, kBefore);
  parts_->arrowMapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, kOnTop);
  for (vtkPolyDataMapper* mapper : {parts_->discMapper.Get(), parts_->arrowMapper.Get()})
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
}

PortMarks::~PortMarks() { parts_->resize(0); }

void PortMarks::set(std::vector<PortMark> marks) {
  parts_->marks = std::move(marks);
  parts_->resize(parts_->marks.size());
  for (std::size_t i = 0; i < parts_->marks.size(); ++i) parts_->style(i);
}

const std::vector<PortMark>& PortMarks::marks() const { return parts_->marks; }

double PortMarks::Parts::arrowMm(std::size_t index) const {
  const PortMark& mark = marks[index];
  const double pixel = mmPerPixelAt(renderer, mark.plane.pointLps);
  return std::max(kArrowRadii * mark.radiusMm, kArrowPixels * pixelRatio * pixel);
}

double PortMarks::arrowMm(std::size_t mark) const { return parts_->arrowMm(mark); }

void PortMarks::follow(double pixelRatio) {
  Parts& p = *parts_;
  p.pixelRatio = pixelRatio;
  for (std::size_t i = 0; i < p.marks.size(); ++i) {
    const PortMark& mark = p.marks[i];
    MarkActors& shown = *p.actors[i];
    const auto flat = placement(mark.plane, mark.discRadiusMm(), mark.discRadiusMm());
    shown.disc->SetUserMatrix(flat);
    shown.rim->SetUserMatrix(flat);
    const double length = arrowMm(i);
    shown.arrow->SetUserMatrix(placement(mark.plane, length, length));
    shown.rim->GetProperty()->SetLineWidth(
        static_cast<float>((mark.selected ? 2.5 : 1.5) * pixelRatio));
  }
  p.placeNames();
}

void PortMarks::Parts::placeNames() {
  // Of names that would run into each other the first is shown, the selected one before all.
  std::vector<std::size_t> order(marks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t i) { return marks[i].selected; });
  std::vector<Eigen::AlignedBox2d> taken;
  for (const std::size_t i : order) {
    const CutPlane& plane = marks[i].plane;
    vtkTextActor* name = actors[i]->name;
    // Beyond the arrow's tip, on the side to which it points.
    const Vector2d from = displayOf(renderer, plane.pointLps);
    const Vector2d tip = displayOf(renderer, plane.pointLps + arrowMm(i) * plane.normalLps);
    const bool leftwards = tip.x() < from.x();
    if (leftwards)
      name->GetTextProperty()->SetJustificationToRight();
    else
      name->GetTextProperty()->SetJustificationToLeft();
    const double x = tip.x() + (leftwards ? -6.0 : 6.0) * pixelRatio;
    name->SetPosition(x, tip.y());
    const double width =
        kNameAspect * kNameSize * pixelRatio * static_cast<double>(marks[i].name.size());
    const double half = 0.6 * kNameSize * pixelRatio;
    const double low = leftwards ? x - width : x;
    const Eigen::AlignedBox2d box(Vector2d(low, tip.y() - half),
                                  Vector2d(low + width, tip.y() + half));
    const bool free = std::none_of(taken.begin(), taken.end(),
                                   [&](const auto& other) { return other.intersects(box); });
    name->SetVisibility(free);
    if (free) taken.push_back(box);
  }
}

std::optional<PortHit> PortMarks::at(double displayX, double displayY) const {
  const Parts& p = *parts_;
  const Vector2d here(displayX, displayY);
  const double reach = kGripPixels * p.pixelRatio;
  std::optional<PortHit> hit;
  double least = reach;
  for (std::size_t i = 0; i < p.marks.size(); ++i) {
    const PortMark& mark = p.marks[i];
    if (!mark.movable) continue;
    const auto point = [&](double share) {
      return displayOf(p.renderer, mark.plane.pointLps + share * arrowMm(i) * mark.plane.normalLps);
    };
    // The part by the disc belongs to the disc.
    const double off = distanceToSegment(here, point(0.5), point(1.0));
    if (off < least) {
      least = off;
      hit = PortHit{i, PortDrag::Grip::Arrow};
    }
  }
  if (hit) return hit;
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < p.marks.size(); ++i) {
    const PortMark& mark = p.marks[i];
    if (!mark.movable) continue;
    const auto [u, v] = across(mark.plane.normalLps);
    std::vector<Vector2d> outline;
    for (int k = 0; k < kSides; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kSides;
      outline.push_back(displayOf(
          p.renderer,
          mark.plane.pointLps + mark.discRadiusMm() * (std::cos(angle) * u + std::sin(angle) * v)));
    }
    const double pixel = mmPerPixelAt(p.renderer, mark.plane.pointLps);
    if (fromDisc(here, outline) > 0.5 * reach || pixel >= depth) continue;
    depth = pixel;  // grows with the distance from the eye
    hit = PortHit{i, PortDrag::Grip::Disc};
  }
  return hit;
}

}  // namespace angiomesh
