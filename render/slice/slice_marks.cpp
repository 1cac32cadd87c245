// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/slice_marks.h"

#include <vtkActor.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/marks/surface_pick.h"
#include "render/slice/slice_layer.h"

namespace angiomesh {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kSides = 64;
constexpr double kHeadShare = 0.3;  // of the arrow's length

using Segments = std::vector<std::array<Vector2d, 2>>;

/// Of one mark on a slice: the section of its disc, and its arrow with the shaft first.
struct MarkLines {
  Segments disc, arrow;
};

Segments arrowOf(const Vector2d& from, const Vector2d& along) {
  const Vector2d tip = from + along;
  const Vector2d aside(-along.y(), along.x());
  Segments segments{{from, tip}};
  for (const double side : {-1.0, 1.0})
    segments.push_back({tip, tip - kHeadShare * along + side * 0.6 * kHeadShare * aside});
  return segments;
}

/// None away from the slice.
MarkLines linesOf(const PortMark& mark, const SlicePlane& plane) {
  const Vector3d u = mark.plane.normalLps.unitOrthogonal();
  const Vector3d v = mark.plane.normalLps.cross(u);
  const double radius = mark.discRadiusMm();
  std::vector<Vector3d> rim;
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kSides;
    rim.push_back(
        plane.fromLps(mark.plane.pointLps + radius * (std::cos(angle) * u + std::sin(angle) * v)));
  }
  MarkLines lines;
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
      lines.disc.push_back({rim[k].head<2>(), rim[(k + 1) % rim.size()].head<2>()});
  } else if (crossings.size() == 2) {
    lines.disc.push_back({crossings[0], crossings[1]});
    if (normal.norm() > 0.05 * radius)
      lines.arrow = arrowOf(0.5 * (crossings[0] + crossings[1]), normal);
  }
  return lines;
}

double distanceTo(const Segments& segments, const Vector2d& place) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& segment : segments)
    least = std::min(least, distanceToSegment(place, segment[0], segment[1]));
  return least;
}

}  // namespace

struct SliceMarks::Parts {
  SliceLayer layer;
  std::vector<PortMark> marks;
  std::vector<MarkLines> lines;  ///< of the marks on the slice last shown; none before
};

SliceMarks::SliceMarks(vtkRenderer* renderer) : parts_(std::make_unique<Parts>()) {
  parts_->layer.actor->VisibilityOff();
  renderer->AddActor(parts_->layer.actor);
}

SliceMarks::~SliceMarks() = default;

void SliceMarks::set(std::vector<PortMark> marks) {
  parts_->marks = std::move(marks);
  parts_->lines.clear();
}

const std::vector<PortMark>& SliceMarks::marks() const { return parts_->marks; }

void SliceMarks::show(const SlicePlane& plane, bool visible, double depth, double pixelRatio) {
  Parts& p = *parts_;
  p.lines.clear();
  Segments all;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (std::size_t i = 0; visible && i < p.marks.size(); ++i) {
    p.lines.push_back(linesOf(p.marks[i], plane));
    for (const Segments* segments : {&p.lines[i].disc, &p.lines[i].arrow})
      all.insert(all.end(), segments->begin(), segments->end());
    const auto& c = p.marks[i].colour;
    while (colours->GetNumberOfTuples() < static_cast<vtkIdType>(all.size()))
      colours->InsertNextTuple3(255.0 * c[0], 255.0 * c[1], 255.0 * c[2]);
  }
  p.layer.setSegments(all, depth);
  p.layer.data->GetCellData()->SetScalars(colours);
  p.layer.actor->SetVisibility(!all.empty());
  p.layer.actor->GetProperty()->SetLineWidth(static_cast<float>(2.5 * pixelRatio));
}

std::optional<PortHit> SliceMarks::at(const Vector2d& place, double reachMm) const {
  std::optional<PortHit> hit;
  double least = reachMm;
  const auto offer = [&](double distance, std::size_t mark, PortDrag::Grip grip) {
    if (distance >= least) return;
    least = distance;
    hit = PortHit{mark, grip};
  };
  for (std::size_t i = 0; i < parts_->lines.size(); ++i) {
    if (!parts_->marks[i].movable) continue;
    const MarkLines& lines = parts_->lines[i];
    offer(distanceTo(lines.disc, place), i, PortDrag::Grip::Disc);
    if (lines.arrow.empty()) continue;
    const auto& [from, tip] = lines.arrow.front();
    offer(distanceToSegment(place, 0.5 * (from + tip), tip), i, PortDrag::Grip::Turn);
  }
  return hit;
}

}  // namespace angiomesh
