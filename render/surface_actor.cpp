// SPDX-License-Identifier: BSD-3-Clause
#include "render/surface_actor.h"

#include <vtkActor.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "render/conversion.h"

namespace angiomesh {

struct SurfaceActor::Parts {
  vtkNew<vtkActor> actor;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkSmartPointer<vtkPolyData> data;
  std::vector<std::uint32_t> patch;  // of the triangles; empty: none has one
  std::vector<std::array<double, 3>> patchColours;
  std::array<double, 3> colour;
  std::vector<float> values;
  vtkSmartPointer<vtkLookupTable> table;
  bool visible = true;

  void update();
  void colourPatches();
};

void SurfaceActor::Parts::colourPatches() {
  vtkNew<vtkUnsignedCharArray> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(patch.size()));
  for (std::size_t i = 0; i < patch.size(); ++i) {
    const std::size_t n = patch[i];
    const auto& c = n == 0 || n > patchColours.size() ? colour : patchColours[n - 1];
    array->SetTuple3(static_cast<vtkIdType>(i), 255.0 * c[0], 255.0 * c[1], 255.0 * c[2]);
  }
  data->GetCellData()->SetScalars(array);
  mapper->SetScalarModeToUseCellData();
  mapper->ScalarVisibilityOn();
}

void SurfaceActor::Parts::update() {
  const vtkIdType triangles = data ? data->GetNumberOfPolys() : 0;
  actor->SetVisibility(visible && triangles > 0);
  if (triangles == 0) return;
  if (static_cast<vtkIdType>(values.size()) != triangles) values.clear();
  if (values.empty() && !patch.empty() && !patchColours.empty()) {
    colourPatches();
  } else if (values.empty()) {
    data->GetCellData()->SetScalars(nullptr);
    mapper->ScalarVisibilityOff();
  } else {
    vtkNew<vtkFloatArray> array;
    array->SetNumberOfValues(triangles);
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    data->GetCellData()->SetScalars(array);
    mapper->SetScalarModeToUseCellData();
    mapper->SetLookupTable(table);
    mapper->UseLookupTableScalarRangeOn();
    mapper->ScalarVisibilityOn();
  }
  mapper->SetInputData(data);
}

SurfaceActor::SurfaceActor(const std::array<double, 3>& colour)
    : parts_(std::make_unique<Parts>()) {
  parts_->colour = colour;
  parts_->actor->SetMapper(parts_->mapper);
  parts_->actor->VisibilityOff();
  vtkProperty* property = parts_->actor->GetProperty();
  property->SetColor(colour[0], colour[1], colour[2]);
  property->SetInterpolationToPhong();
  property->SetSpecularPower(25.0);
  property->SetEdgeColor(0.08, 0.08, 0.10);
  // The inside, seen through open ends, must not pass for the outside.
  vtkNew<vtkProperty> inside;
  inside->DeepCopy(property);
  inside->SetColor(0.45 * colour[0] + 0.1, 0.45 * colour[1] + 0.1, 0.45 * colour[2] + 0.1);
  parts_->actor->SetBackfaceProperty(inside);
  setDimmed(false);
}

SurfaceActor::~SurfaceActor() = default;

vtkActor* SurfaceActor::actor() const { return parts_->actor; }

void SurfaceActor::setMesh(const std::shared_ptr<const TriMesh>& mesh) {
  parts_->data = mesh && !mesh->triangles.empty() ? toPolyData(*mesh) : nullptr;
  if (!parts_->data) parts_->values.clear();
  parts_->patch.clear();
  if (mesh && std::any_of(mesh->patch.begin(), mesh->patch.end(), [](auto n) { return n != 0; }))
    parts_->patch.assign(mesh->patch.begin(), mesh->patch.end());
  parts_->update();
}

void SurfaceActor::setPatchColours(std::vector<std::array<double, 3>> colours) {
  if (colours == parts_->patchColours) return;
  parts_->patchColours = std::move(colours);
  parts_->update();
}

bool SurfaceActor::empty() const { return !parts_->data; }

void SurfaceActor::setVisible(bool visible) {
  parts_->visible = visible;
  parts_->update();
}

void SurfaceActor::setEdgesVisible(bool visible) {
  parts_->actor->GetProperty()->SetEdgeVisibility(visible);
}

void SurfaceActor::setDimmed(bool dimmed) {
  vtkProperty* inside = parts_->actor->GetBackfaceProperty();
  for (vtkProperty* side : {parts_->actor->GetProperty(), inside}) {
    side->SetAmbient(dimmed ? 0.2 : 0.08);
    side->SetDiffuse(dimmed ? 0.25 : 0.9);
    side->SetSpecular(dimmed || side == inside ? 0.0 : 0.25);
  }
}

void SurfaceActor::setTriangleValues(std::vector<float> values, vtkLookupTable* table) {
  parts_->values = std::move(values);
  parts_->table = table;
  parts_->update();
}

bool SurfaceActor::coloured() const { return parts_->visible && !parts_->values.empty(); }

}  // namespace angiomesh
