// SPDX-License-Identifier: BSD-3-Clause
#include "render/surface/slice_quads.h"

#include <vtkImageData.h>
#include <vtkImageProperty.h>
#include <vtkImageSlice.h>
#include <vtkImageSliceMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <array>

namespace angiomesh {

namespace {

using Eigen::Vector3d;

constexpr double kOverlayMm = 0.02;  // in front of the slice, and as much behind it

/// All that a quad looks like follows from this.
struct Look {
  const SliceScene* scene = nullptr;
  std::array<vtkMTimeType, 2> changes{};
  double window = 0.0, level = 0.0;
  bool overlaid = false;

  bool operator==(const Look&) const = default;
};

Look lookOf(const SliceScene& scene) {
  const SlicePixels& pixels = scene.pixels();
  return {&scene,
          {pixels.grey()->GetMTime(), pixels.colour()->GetMTime()},
          pixels.window(),
          pixels.level(),
          pixels.overlaid()};
}

/// From the slice's mm to patient space.
vtkNew<vtkMatrix4x4> matrixOf(const SlicePlane& plane) {
  const Vector3d origin = plane.toLps({0.0, 0.0});
  const Vector3d right = plane.toLps({1.0, 0.0}) - origin;
  const Vector3d up = plane.toLps({0.0, 1.0}) - origin;
  const Vector3d normal = right.cross(up).normalized();
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row) {
    matrix->SetElement(row, 0, right[row]);
    matrix->SetElement(row, 1, up[row]);
    matrix->SetElement(row, 2, normal[row]);
    matrix->SetElement(row, 3, origin[row]);
  }
  return matrix;
}

/// A turned slice is larger than what the image fills of it.
void clip(vtkImageSliceMapper* mapper, const Geometry& image) {
  mapper->RemoveAllClippingPlanes();
  const Eigen::Matrix3d toIndex = image.physicalToIndexMatrix();
  for (int axis = 0; axis < 3; ++axis)
    for (const bool low : {true, false}) {
      const double size = image.size[static_cast<std::size_t>(axis)];
      const Vector3d inward = (low ? 1.0 : -1.0) * toIndex.row(axis).transpose().normalized();
      const Vector3d border =
          image.toPhysical(Vector3d::Unit(axis) * (low ? -0.5 - 1e-3 : size - 0.5 + 1e-3));
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(border[0], border[1], border[2]);
      plane->SetNormal(inward[0], inward[1], inward[2]);
      mapper->AddClippingPlane(plane);
    }
}

/// A slice, or its colours.
struct Quad {
  vtkNew<vtkImageSlice> prop;
  vtkNew<vtkImageSliceMapper> mapper;

  void build(vtkRenderer* renderer) {
    mapper->BorderOn();
    mapper->SetOrientationToZ();
    prop->SetMapper(mapper);
    prop->VisibilityOff();
    prop->PickableOff();
    prop->GetProperty()->SetInterpolationTypeToLinear();
    renderer->AddViewProp(prop);
  }
  void show(vtkImageData* pixels, const SliceScene& scene, double window, double level) {
    mapper->SetInputData(pixels);
    clip(mapper, scene.image()->geometry);
    prop->GetProperty()->SetColorWindow(window);
    prop->GetProperty()->SetColorLevel(level);
    prop->SetUserMatrix(matrixOf(scene.plane()));
    prop->VisibilityOn();
  }
};

struct Quads {
  Quad grey, front, back;  // the colours are seen from both sides
};

}  // namespace

struct SliceQuads::Parts {
  std::array<Quads, 3> quads;
  std::vector<Look> shown;
};

SliceQuads::SliceQuads(vtkRenderer* renderer) : parts_(std::make_unique<Parts>()) {
  for (Quads& quads : parts_->quads) {
    quads.grey.build(renderer);
    for (Quad* colour : {&quads.front, &quads.back}) {
      colour->build(renderer);
      colour->prop->ForceTranslucentOn();
    }
    quads.front.prop->SetPosition(0.0, 0.0, kOverlayMm);
    quads.back.prop->SetPosition(0.0, 0.0, -kOverlayMm);
  }
}

SliceQuads::~SliceQuads() = default;

bool SliceQuads::show(const std::vector<const SliceScene*>& scenes) {
  std::vector<Look> looks;
  for (const SliceScene* scene : scenes)
    if (scene->image() && looks.size() < parts_->quads.size()) looks.push_back(lookOf(*scene));
  if (looks == parts_->shown) return false;
  parts_->shown = looks;
  for (std::size_t i = 0; i < parts_->quads.size(); ++i) {
    Quads& quads = parts_->quads[i];
    for (Quad* quad : {&quads.grey, &quads.front, &quads.back}) quad->prop->VisibilityOff();
    if (i >= looks.size()) continue;
    const Look& look = looks[i];
    const SlicePixels& pixels = look.scene->pixels();
    quads.grey.show(pixels.grey(), *look.scene, look.window, look.level);
    if (!look.overlaid) continue;
    for (Quad* colour : {&quads.front, &quads.back})
      colour->show(pixels.colour(), *look.scene, 255.0, 127.5);
  }
  return true;
}

}  // namespace angiomesh
