// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/slice_seeds.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace angiomesh {

namespace {

/// Seeds by hand that are farther from the slab, in slices, would only confuse.
constexpr double kFarthest = 3.0;
constexpr double kDotPixels = 7.0;
/// Those by hand lie this far above those that were found.
constexpr double kAbove = 0.2;
/// RGBA, in the slab and beside it; of what was found.
constexpr std::array<double, 4> kHere{60.0, 230.0, 120.0, 255.0}, kBeside{60.0, 230.0, 120.0, 90.0},
    kFound{70.0, 170.0, 255.0, 150.0};

}  // namespace

SliceSeeds::SliceSeeds(vtkRenderer* renderer) {
  dots_.actor->GetProperty()->RenderPointsAsSpheresOn();
  dots_.actor->VisibilityOff();
  renderer->AddActor(dots_.actor);
}

void SliceSeeds::set(std::vector<Eigen::Vector3d> byHand, std::vector<Eigen::Vector3d> found) {
  byHand_ = std::move(byHand);
  found_ = std::move(found);
}

void SliceSeeds::show(const SlicePlane* plane, int slice, const std::array<int, 2>& slab,
                      double depth, double pixelRatio) {
  seen_.clear();
  const bool visible = plane != nullptr && !(byHand_.empty() && found_.empty());
  dots_.actor->SetVisibility(visible);
  if (!visible) return;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> dots;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(4);
  const auto slicesOff = [&](const Eigen::Vector3d& inPlane) {
    const double position = slice + inPlane[2];
    return std::max({slab[0] - 0.5 - position, position - slab[1] - 0.5, 0.0});
  };
  const auto add = [&](const Eigen::Vector3d& inPlane, const std::array<double, 4>& colour) {
    const double above = &colour == &kFound ? 0.0 : kAbove;
    dots->InsertNextCell({points->InsertNextPoint(inPlane[0], inPlane[1], depth + above)});
    colours->InsertNextTuple(colour.data());
  };
  for (const Eigen::Vector3d& seed : found_) {
    const Eigen::Vector3d p = plane->fromLps(seed);
    if (slicesOff(p) == 0.0) add(p, kFound);
  }
  for (std::size_t n = 0; n < byHand_.size(); ++n) {
    const Eigen::Vector3d p = plane->fromLps(byHand_[n]);
    const double off = slicesOff(p);
    if (off > kFarthest) continue;
    add(p, off > 0.0 ? kBeside : kHere);
    if (off == 0.0) seen_.emplace_back(n, p.head<2>());
  }
  dots_.data->SetPoints(points);
  dots_.data->SetVerts(dots);
  dots_.data->GetPointData()->SetScalars(colours);
  dots_.actor->GetProperty()->SetPointSize(static_cast<float>(kDotPixels * pixelRatio));
}

std::optional<std::size_t> SliceSeeds::at(const Eigen::Vector2d& place, double reachMm) const {
  std::optional<std::size_t> nearest;
  for (const auto& [index, dot] : seen_) {
    const double away = (dot - place).norm();
    if (away > reachMm) continue;
    reachMm = away;
    nearest = index;
  }
  return nearest;
}

}  // namespace angiomesh
