// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/slice_measures.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/marks/measure_marks.h"
#include "render/slice/slice_scene.h"

namespace angiomesh {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Of the flat scene, towards the viewer.
constexpr double kDepth = 2.7;
/// What lies in a slice without a slab, in slices on either side.
constexpr double kHalfSlice = 0.75;
/// Of Qt, to take hold of a point.
constexpr double kReachPixels = 7.0;

Vector3d flat(const Vector3d& p) { return {p.x(), p.y(), kDepth}; }

/// The part of a segment within `half` slices of the slice.
std::optional<std::array<Vector3d, 2>> clipped(const Vector3d& a, const Vector3d& b, double half) {
  double from = 0.0, to = 1.0;
  for (const double side : {-1.0, 1.0}) {
    const double ha = side * a.z() - half, hb = side * b.z() - half;
    if (ha > 0.0 && hb > 0.0) return std::nullopt;
    if (ha > 0.0) from = std::max(from, ha / (ha - hb));
    if (hb > 0.0) to = std::min(to, ha / (ha - hb));
  }
  if (from > to) return std::nullopt;
  return std::array<Vector3d, 2>{flat(a + from * (b - a)), flat(a + to * (b - a))};
}

/// A flat outline: whole where it lies in the slice, else the chords in which it crosses it.
void addOutline(DrawnMeasure& drawn, const std::vector<Vector3d>& outline, double half) {
  const bool inSlice = std::all_of(outline.begin(), outline.end(),
                                   [&](const Vector3d& p) { return std::fabs(p.z()) <= half; });
  std::vector<Vector3d> crossings;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector3d &a = outline[k], &b = outline[(k + 1) % outline.size()];
    if (inSlice)
      drawn.lines.push_back({flat(a), flat(b)});
    else if ((a.z() > 0.0) != (b.z() > 0.0))
      crossings.push_back(flat(a + a.z() / (a.z() - b.z()) * (b - a)));
  }
  // In order along their common line each second gap between crossings is inside.
  std::sort(crossings.begin(), crossings.end(), [](const Vector3d& a, const Vector3d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
    drawn.lines.push_back({crossings[k], crossings[k + 1]});
}

}  // namespace

DrawnMeasure drawnInSlice(const MeasureMark& mark, const SlicePlane& plane, double halfSlices) {
  DrawnMeasure drawn;
  drawn.selected = mark.selected;
  drawn.dimmed = mark.dimmed;
  for (const auto& line : mark.lines)
    if (const auto part = clipped(plane.fromLps(line[0]), plane.fromLps(line[1]), halfSlices))
      drawn.lines.push_back(*part);
  for (const auto& diameter : mark.diameters) {
    const Vector3d from = plane.fromLps(diameter[0]), to = plane.fromLps(diameter[1]);
    if (std::fabs(from.z()) <= halfSlices && std::fabs(to.z()) <= halfSlices)
      drawn.lines.push_back({flat(from), flat(to)});
  }
  for (const std::vector<Vector3d>& outline : mark.outlines) {
    std::vector<Vector3d> seen;
    for (const Vector3d& p : outline) seen.push_back(plane.fromLps(p));
    addOutline(drawn, seen, halfSlices);
  }
  for (const Vector3d& point : mark.points) {
    const Vector3d p = plane.fromLps(point);
    if (std::fabs(p.z()) <= halfSlices) drawn.points.push_back(flat(p));
  }
  if (drawn.lines.empty() && drawn.points.empty()) return drawn;
  drawn.label = mark.label;
  drawn.labelAt = drawn.lines.empty() ? drawn.points.front() : drawn.lines.front()[1];
  for (const auto& line : drawn.lines)
    for (const Vector3d& end : line)
      if (end.x() > drawn.labelAt.x()) drawn.labelAt = end;
  return drawn;
}

struct SliceMeasures::Parts {
  explicit Parts(const SliceScene& shown) : scene(shown), overlay(shown.renderer()) {}

  const SliceScene& scene;
  MeasureMarks overlay;
  vtkNew<vtkCallbackCommand> beforeFrame;
  std::vector<MeasureMark> marks;
  // Of what was shown last.
  Geometry grid;
  int plane = -1, slice = -1;
  double slabMm = 0.0;
  bool fresh = false;
  double pixelRatio = 1.0;

  /// How far from the slice a mark is shown in it, slices.
  [[nodiscard]] double halfSlices() const;
  void follow();
};

double SliceMeasures::Parts::halfSlices() const {
  const Slab& slab = scene.slab();
  if (slab.mode == SlabMode::None) return kHalfSlice;
  return std::max(kHalfSlice, 0.5 * slab.thicknessMm / scene.grid().spacing[scene.axes().across]);
}

void SliceMeasures::Parts::follow() {
  const std::shared_ptr<const Volume<float>>& image = scene.image();
  const double slab = scene.slab().mode == SlabMode::None ? 0.0 : scene.slab().thicknessMm;
  const bool same = fresh && image && grid == scene.grid() && plane == scene.axes().plane &&
                    slice == scene.slice() && slabMm == slab;
  if (same) return;
  fresh = image != nullptr;
  std::vector<DrawnMeasure> drawn;
  if (image) {
    grid = scene.grid();
    plane = scene.axes().plane;
    slice = scene.slice();
    slabMm = slab;
    const SlicePlane flatPlane(grid, scene.axes(), slice);
    for (const MeasureMark& mark : marks)
      drawn.push_back(drawnInSlice(mark, flatPlane, halfSlices()));
  }
  overlay.show(drawn);
}

SliceMeasures::SliceMeasures(const SliceScene& scene) : parts_(std::make_unique<Parts>(scene)) {
  parts_->beforeFrame->SetClientData(parts_.get());
  parts_->beforeFrame->SetCallback(
      [](vtkObject*, unsigned long, void* parts, void*) { static_cast<Parts*>(parts)->follow(); });
  scene.renderer()->AddObserver(vtkCommand::StartEvent, parts_->beforeFrame);
}

SliceMeasures::~SliceMeasures() { parts_->scene.renderer()->RemoveObserver(parts_->beforeFrame); }

void SliceMeasures::set(std::vector<MeasureMark> marks) {
  parts_->marks = std::move(marks);
  parts_->fresh = false;
}

void SliceMeasures::setPixelRatio(double ratio) {
  parts_->pixelRatio = ratio;
  parts_->overlay.setPixelRatio(ratio);
}

std::optional<MarkPoint> SliceMeasures::pointAt(const Eigen::Vector2d& at) const {
  const SliceScene& scene = parts_->scene;
  if (!scene.image()) return std::nullopt;
  const SlicePlane plane(scene.grid(), scene.axes(), scene.slice());
  std::optional<MarkPoint> found;
  double least = kReachPixels * parts_->pixelRatio;
  for (const MeasureMark& mark : parts_->marks)
    for (std::size_t i = 0; i < mark.points.size() && !mark.name.empty(); ++i) {
      const Vector3d& point = mark.points[i];
      const double distance = (scene.displayAt(point) - at).norm();
      if (distance > least || std::fabs(plane.fromLps(point).z()) > parts_->halfSlices()) continue;
      least = distance;
      found = MarkPoint{mark.name, i, point};
    }
  return found;
}

}  // namespace angiomesh
