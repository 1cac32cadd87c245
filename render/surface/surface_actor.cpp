// SPDX-License-Identifier: BSD-3-Clause
#include "render/surface/surface_actor.h"

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

#include "core/mesh/coarse_mesh.h"
#include "core/mesh/mesh_edges.h"
#include "render/stage/conversion.h"

namespace angiomesh {

/// The polygons of a mesh, and per triangle of theirs the one of the mesh that it stands for.
struct Polygons {
  vtkSmartPointer<vtkPolyData> data;
  std::vector<std::uint32_t> from;  // empty: all, in their order
};

struct DrawnMesh {
  std::shared_ptr<const TriMesh> mesh, visible;
  Polygons full;
  Polygons coarse;  // without data where there are few triangles
  bool patches = false;
};

namespace {

void hide(DrawnMesh& drawn, const std::vector<std::size_t>& hidden) {
  const TriMesh& mesh = *drawn.mesh;
  const MeshComponents parts = meshComponents(mesh);
  std::vector<bool> gone(parts.count, false);
  for (const std::size_t triangle : hidden)
    if (triangle < parts.label.size()) gone[parts.label[triangle]] = true;
  auto visible = std::make_shared<TriMesh>();
  visible->points = mesh.points;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (gone[parts.label[i]]) continue;
    visible->triangles.push_back(mesh.triangles[i]);
    if (!mesh.patch.empty()) visible->patch.push_back(mesh.patch[i]);
    drawn.full.from.push_back(static_cast<std::uint32_t>(i));
  }
  drawn.visible = std::move(visible);
}

}  // namespace

std::shared_ptr<const DrawnMesh> drawnMesh(std::shared_ptr<const TriMesh> mesh,
                                           std::size_t coarseTriangles,
                                           const std::vector<std::size_t>& hidden) {
  auto drawn = std::make_shared<DrawnMesh>();
  drawn->mesh = std::move(mesh);
  if (!drawn->mesh || drawn->mesh->triangles.empty()) return drawn;
  const TriMesh& full = *drawn->mesh;
  drawn->visible = drawn->mesh;
  if (!hidden.empty()) hide(*drawn, hidden);
  if (drawn->visible->triangles.empty()) return drawn;
  drawn->full.data = toPolyData(*drawn->visible);
  drawn->patches = std::any_of(full.patch.begin(), full.patch.end(), [](auto n) { return n != 0; });
  if (coarseTriangles > 0 && drawn->visible->triangles.size() > coarseTriangles) {
    CoarseMesh coarse = coarseMesh(*drawn->visible, coarseTriangles);
    if (!drawn->full.from.empty())
      for (std::uint32_t& triangle : coarse.from) triangle = drawn->full.from[triangle];
    drawn->coarse = {toPolyData(coarse.mesh), std::move(coarse.from)};
  }
  return drawn;
}

const std::shared_ptr<const TriMesh>& meshOf(const DrawnMesh& drawn) { return drawn.mesh; }

const std::shared_ptr<const TriMesh>& visibleMesh(const DrawnMesh& drawn) { return drawn.visible; }

std::size_t originalTriangle(const DrawnMesh& drawn, std::size_t visible) {
  return drawn.full.from.empty() ? visible : drawn.full.from[visible];
}

struct SurfaceActor::Parts {
  vtkNew<vtkActor> actor;
  // Each keeps what it has sent to OpenGL: nothing is sent anew as a turn begins and ends.
  vtkNew<vtkPolyDataMapper> fullMapper, coarseMapper;
  std::shared_ptr<const DrawnMesh> drawn;
  std::vector<std::array<double, 3>> patchColours;
  std::array<double, 3> colour;
  std::vector<float> values;
  vtkSmartPointer<vtkLookupTable> table;
  bool visible = true, edges = false, coarse = false;

  [[nodiscard]] std::size_t triangles() const {
    return drawn && drawn->mesh ? drawn->mesh->triangles.size() : 0;
  }
  void update();
  void feed(vtkPolyDataMapper* mapper, const Polygons& polygons) const;
  void choose();
  [[nodiscard]] vtkSmartPointer<vtkDataArray> coloursOf(const Polygons& polygons) const;
};

/// Null: none of its own.
vtkSmartPointer<vtkDataArray> SurfaceActor::Parts::coloursOf(const Polygons& polygons) const {
  const auto count = static_cast<std::size_t>(polygons.data->GetNumberOfPolys());
  const auto original = [&polygons](std::size_t i) {
    return polygons.from.empty() ? i : polygons.from[i];
  };
  if (!values.empty()) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetNumberOfValues(static_cast<vtkIdType>(count));
    float* value = array->GetPointer(0);
    for (std::size_t i = 0; i < count; ++i) value[i] = values[original(i)];
    return array;
  }
  if (!drawn->patches || patchColours.empty()) return nullptr;
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  unsigned char* rgb = array->GetPointer(0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t n = drawn->mesh->patch[original(i)];
    const auto& c = n == 0 || n > patchColours.size() ? colour : patchColours[n - 1];
    for (const double part : c) *rgb++ = static_cast<unsigned char>(255.0 * part);
  }
  return array;
}

void SurfaceActor::Parts::feed(vtkPolyDataMapper* mapper, const Polygons& polygons) const {
  if (!polygons.data) return;
  const vtkSmartPointer<vtkDataArray> colours = coloursOf(polygons);
  polygons.data->GetCellData()->SetScalars(colours);
  mapper->SetScalarVisibility(colours != nullptr);
  mapper->SetScalarModeToUseCellData();
  if (!values.empty()) {
    mapper->SetLookupTable(table);
    mapper->UseLookupTableScalarRangeOn();
  }
  mapper->SetInputData(polygons.data);
}

/// After a change of the mesh or its colours.
void SurfaceActor::Parts::update() {
  choose();
  if (triangles() == 0) return;
  if (values.size() != triangles()) values.clear();
  feed(fullMapper, drawn->full);
  feed(coarseMapper, drawn->coarse);
}

void SurfaceActor::Parts::choose() {
  actor->SetVisibility(visible && drawn && drawn->full.data);
  const bool few = coarse && triangles() > 0 && drawn->coarse.data;
  actor->SetMapper(few ? coarseMapper : fullMapper);
  actor->GetProperty()->SetEdgeVisibility(edges && !few);
}

SurfaceActor::SurfaceActor(const std::array<double, 3>& colour)
    : parts_(std::make_unique<Parts>()) {
  parts_->colour = colour;
  parts_->choose();
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

void SurfaceActor::setMesh(std::shared_ptr<const DrawnMesh> mesh) {
  parts_->drawn = std::move(mesh);
  if (parts_->triangles() == 0) parts_->values.clear();
  parts_->update();
}

void SurfaceActor::setCoarse(bool coarse) {
  if (coarse == parts_->coarse) return;
  parts_->coarse = coarse;
  parts_->choose();
}

void SurfaceActor::setPatchColours(std::vector<std::array<double, 3>> colours) {
  if (colours == parts_->patchColours) return;
  parts_->patchColours = std::move(colours);
  parts_->update();
}

bool SurfaceActor::empty() const { return parts_->triangles() == 0; }

void SurfaceActor::setVisible(bool visible) {
  parts_->visible = visible;
  parts_->choose();
}

void SurfaceActor::setEdgesVisible(bool visible) {
  parts_->edges = visible;
  parts_->choose();
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
  if (values.empty() && parts_->values.empty()) return;
  parts_->values = std::move(values);
  parts_->table = table;
  parts_->update();
}

bool SurfaceActor::coloured() const { return parts_->visible && !parts_->values.empty(); }

}  // namespace angiomesh
