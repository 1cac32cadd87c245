// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/slice_pixels.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkImageProperty.h>
#include <vtkImageSlice.h>
#include <vtkImageSliceMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "render/slice/slice_cast.h"

namespace angiomesh {

namespace {

using Eigen::Vector3d;
using Colour = std::array<double, 3>;

constexpr double kOverlayDepth = 0.5;  // of the flat scene, towards the viewer

Colour mixed(const Colour& a, const Colour& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

/// Of the share of the way from the beginning of the range to its end.
Colour hot(double share) {
  constexpr Colour darkRed{0.55, 0.0, 0.05}, orange{1.0, 0.45, 0.0}, yellow{1.0, 0.95, 0.25};
  return share < 0.5 ? mixed(darkRed, orange, 2.0 * share)
                     : mixed(orange, yellow, 2.0 * share - 1.0);
}

Colour cold(double share) {
  constexpr Colour darkBlue{0.05, 0.1, 0.55}, lightBlue{0.25, 0.7, 1.0};
  return mixed(darkBlue, lightBlue, share);
}

void shape(vtkImageData* pixels, const SlicePlane& plane, vtkDataArray* values) {
  pixels->SetDimensions(plane.width(), plane.height(), 1);
  pixels->SetSpacing(plane.pixelWidthMm(), plane.pixelHeightMm(), 1.0);
  pixels->GetPointData()->SetScalars(values);
  pixels->Modified();
}

}  // namespace

std::array<unsigned char, 4> overlayColour(const ColourLayer& layer, float value) {
  if (value == kOutside || !std::isfinite(value)) return {0, 0, 0, 0};
  const bool signedRange = layer.from < 0.0 && layer.to > 0.0;
  const double zero = signedRange ? 0.0 : layer.from;
  const bool below = value < zero;
  const double end = below ? layer.from : layer.to;
  const double share = end == zero ? 0.0 : std::clamp((value - zero) / (end - zero), 0.0, 1.0);
  if (below && !signedRange) return {0, 0, 0, 0};
  const Colour colour = below ? cold(share) : hot(share);
  const auto byte = [](double part) {
    return static_cast<unsigned char>(std::lround(255.0 * part));
  };
  return {byte(colour[0]), byte(colour[1]), byte(colour[2]),
          byte(std::clamp(layer.opacity, 0.0, 1.0) * std::sqrt(share))};
}

struct SlicePixels::Parts {
  vtkNew<vtkImageData> grey, colour;
  vtkNew<vtkImageSlice> greyProp, colourProp;
  std::shared_ptr<const Volume<float>> image;
  ColourLayer layer;
  std::vector<float> values, overlay;  // in screen order
  PaneGrid pane;
  SlicePlane plane;
  SlabMode mode = SlabMode::None;
  int slice = 0, first = 0, last = 0;

  void showOverlay();
  [[nodiscard]] Vector3d placeOf(const Vector3d& lps) const;
};

SlicePixels::SlicePixels(vtkRenderer* renderer) : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  for (const auto& [prop, pixels] :
       {std::pair{p.greyProp.Get(), p.grey.Get()}, std::pair{p.colourProp.Get(), p.colour.Get()}}) {
    vtkNew<vtkImageSliceMapper> mapper;
    mapper->SetInputData(pixels);
    mapper->BorderOn();
    mapper->SetOrientationToZ();
    prop->SetMapper(mapper);
    prop->GetProperty()->SetInterpolationTypeToLinear();
    prop->VisibilityOff();
    renderer->AddViewProp(prop);
  }
  p.colourProp->ForceTranslucentOn();
  p.colourProp->SetPosition(0.0, 0.0, kOverlayDepth);
  p.colourProp->GetProperty()->SetColorWindow(255.0);
  p.colourProp->GetProperty()->SetColorLevel(127.5);
}

SlicePixels::~SlicePixels() = default;

void SlicePixels::setImage(std::shared_ptr<const Volume<float>> image) {
  parts_->image = std::move(image);
  parts_->greyProp->SetVisibility(parts_->image != nullptr);
  if (!parts_->image) parts_->colourProp->VisibilityOff();
}

const std::shared_ptr<const Volume<float>>& SlicePixels::image() const { return parts_->image; }

void SlicePixels::setOverlay(const ColourLayer& layer) { parts_->layer = layer; }

void SlicePixels::show(const PaneGrid& pane, const SlicePlane& plane, SlabMode mode, int slice,
                       int first, int last) {
  Parts& p = *parts_;
  if (!p.image) return;
  p.pane = pane;
  p.plane = plane;
  p.mode = mode;
  p.slice = slice;
  p.first = first;
  p.last = last;
  castSlab(*p.image, pane.grid, pane.axes, mode, first, last, p.values);
  vtkNew<vtkFloatArray> array;
  array->SetArray(p.values.data(), static_cast<vtkIdType>(p.values.size()), 1);
  shape(p.grey, plane, array);
  p.showOverlay();
}

void SlicePixels::Parts::showOverlay() {
  const bool visible = layer.values && !layer.values->voxels.empty();
  colourProp->SetVisibility(visible);
  if (!visible) return;
  castSlab(*layer.values, pane.grid, pane.axes, mode, first, last, overlay);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(4);
  colours->SetNumberOfTuples(static_cast<vtkIdType>(overlay.size()));
  unsigned char* target = colours->GetPointer(0);
  for (const float value : overlay) {
    const std::array<unsigned char, 4> rgba = overlayColour(layer, value);
    target = std::copy(rgba.begin(), rgba.end(), target);
  }
  shape(colour, plane, colours);
}

void SlicePixels::setWindowLevel(double window, double level) {
  parts_->greyProp->GetProperty()->SetColorWindow(window);
  parts_->greyProp->GetProperty()->SetColorLevel(level);
}

double SlicePixels::window() const { return parts_->greyProp->GetProperty()->GetColorWindow(); }
double SlicePixels::level() const { return parts_->greyProp->GetProperty()->GetColorLevel(); }

void SlicePixels::setInterpolated(bool on) {
  for (vtkImageSlice* prop : {parts_->greyProp.Get(), parts_->colourProp.Get()})
    prop->GetProperty()->SetInterpolationType(on ? VTK_LINEAR_INTERPOLATION
                                                 : VTK_NEAREST_INTERPOLATION);
}

/// In a projection of extremes the place across the slices that holds what is shown.
Vector3d SlicePixels::Parts::placeOf(const Vector3d& lps) const {
  const Vector3d index = pane.grid.toIndex(lps);
  const auto inSlice = [&](int along) {
    Vector3d moved = index;
    moved[pane.axes.across] = along;
    return pane.grid.toPhysical(moved);
  };
  Vector3d place = inSlice(slice);
  if (mode != SlabMode::Mip && mode != SlabMode::MinIp) return place;
  Vector3d pixel = index;
  for (const int axis : {pane.axes.right, pane.axes.up}) pixel[axis] = std::round(index[axis]);
  std::optional<float> extreme;
  for (int along = first; along <= last; ++along) {
    pixel[pane.axes.across] = along;
    const float value = valueAt(*image, pane.grid.toPhysical(pixel));
    if (value == kOutside) continue;
    if (extreme && (mode == SlabMode::Mip ? value <= *extreme : value >= *extreme)) continue;
    extreme = value;
    place = inSlice(along);
  }
  return place;
}

std::optional<SlicePixels::Probe> SlicePixels::probe(const Vector3d& lps) const {
  const Parts& p = *parts_;
  if (!p.image || p.values.empty()) return std::nullopt;
  const Vector3d xy = p.plane.fromLps(lps);
  const double column = std::round(xy[0] / p.plane.pixelWidthMm());
  const double row = std::round(xy[1] / p.plane.pixelHeightMm());
  if (!(column >= 0.0 && row >= 0.0 && column < p.plane.width() && row < p.plane.height()))
    return std::nullopt;
  const std::size_t pixel =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(p.plane.width()) +
      static_cast<std::size_t>(column);
  Probe probe;
  probe.value = p.values[pixel];
  if (probe.value == kOutside) return std::nullopt;
  probe.placeLps = p.placeOf(lps);
  const Vector3d index = p.image->geometry.toIndex(probe.placeLps);
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    probe.voxel[axis] =
        static_cast<int>(std::clamp(std::round(index[a]), 0.0, p.image->geometry.size[axis] - 1.0));
  }
  if (overlaid() && p.overlay[pixel] != kOutside) probe.overlay = p.overlay[pixel];
  return probe;
}

vtkImageData* SlicePixels::grey() const { return parts_->grey; }
vtkImageData* SlicePixels::colour() const { return parts_->colour; }
bool SlicePixels::overlaid() const {
  return parts_->layer.values && parts_->overlay.size() == parts_->values.size();
}

}  // namespace angiomesh
