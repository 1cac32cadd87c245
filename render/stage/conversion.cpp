// SPDX-License-Identifier: BSD-3-Clause
#include "render/stage/conversion.h"

#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>

#include <map>
#include <utility>

namespace angiomesh {

namespace {

/// Sits as an observer on an array, and so lives exactly as long as the array does.
class KeepAlive : public vtkCommand {
 public:
  static KeepAlive* New() { return new KeepAlive; }
  void Execute(vtkObject*, unsigned long, void*) override {}
  std::shared_ptr<const void> kept;
};

/// The mesh with a point of its own for each patch that meets at one: shading is smooth within
/// patches alone.
TriMesh partedAtPatches(const TriMesh& mesh) {
  TriMesh parted;
  std::map<std::pair<std::uint32_t, std::uint16_t>, std::uint32_t> others;
  std::vector<int> first(mesh.points.size(), -1);
  parted.points = mesh.points;
  parted.triangles = mesh.triangles;
  for (std::size_t i = 0; i < parted.triangles.size(); ++i) {
    const std::uint16_t patch = mesh.patch[i];
    for (std::uint32_t& vertex : parted.triangles[i]) {
      if (first[vertex] < 0) first[vertex] = patch;
      if (first[vertex] == patch) continue;
      const auto [found, made] =
          others.try_emplace({vertex, patch}, static_cast<std::uint32_t>(parted.points.size()));
      if (made) parted.points.push_back(mesh.points[vertex]);
      vertex = found->second;
    }
  }
  return parted;
}

}  // namespace

vtkSmartPointer<vtkImageData> toImageData(const std::shared_ptr<const Volume<float>>& volume) {
  vtkNew<vtkFloatArray> values;
  // VTK has no read-only arrays; nothing here writes to it.
  values->SetArray(const_cast<float*>(volume->voxels.data()),
                   static_cast<vtkIdType>(volume->voxels.size()), 1);
  vtkNew<KeepAlive> keeper;
  keeper->kept = volume;
  values->AddObserver(vtkCommand::DeleteEvent, keeper);

  const Geometry& g = volume->geometry;
  vtkNew<vtkImageData> image;
  image->SetDimensions(g.size[0], g.size[1], g.size[2]);
  image->SetSpacing(g.spacing[0], g.spacing[1], g.spacing[2]);
  image->GetPointData()->SetScalars(values);
  return image;
}

vtkSmartPointer<vtkMatrix4x4> patientMatrix(const Geometry& geometry) {
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      matrix->SetElement(row, column, geometry.direction(row, column));
    matrix->SetElement(row, 3, geometry.origin[row]);
  }
  return matrix;
}

vtkSmartPointer<vtkPolyData> toPolyData(const TriMesh& mesh) {
  if (!mesh.patch.empty()) return toPolyData(partedAtPatches(mesh));
  const auto pointCount = static_cast<vtkIdType>(mesh.points.size());
  const auto faceCount = static_cast<vtkIdType>(mesh.triangles.size());
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(pointCount);
  float* xyz = coordinates->GetPointer(0);
  for (const Eigen::Vector3d& point : mesh.points)
    for (int axis = 0; axis < 3; ++axis) *xyz++ = static_cast<float>(point[axis]);

  vtkNew<vtkTypeInt32Array> corners;
  corners->SetNumberOfValues(3 * faceCount);
  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(faceCount + 1);
  vtkTypeInt32* corner = corners->GetPointer(0);
  vtkTypeInt32* offset = offsets->GetPointer(0);
  for (vtkIdType face = 0; face < faceCount; ++face) {
    for (const std::uint32_t vertex : mesh.triangles[static_cast<std::size_t>(face)])
      *corner++ = static_cast<vtkTypeInt32>(vertex);
    *offset++ = static_cast<vtkTypeInt32>(3 * face);
  }
  *offset = static_cast<vtkTypeInt32>(3 * faceCount);

  vtkNew<vtkFloatArray> normalArray;
  normalArray->SetNumberOfComponents(3);
  normalArray->SetNumberOfTuples(pointCount);
  float* n = normalArray->GetPointer(0);
  for (const Eigen::Vector3d& normal : vertexNormals(mesh))
    for (int axis = 0; axis < 3; ++axis) *n++ = static_cast<float>(normal[axis]);

  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkCellArray> faces;
  faces->SetData(offsets, corners);
  vtkNew<vtkPolyData> result;
  result->SetPoints(points);
  result->SetPolys(faces);
  result->GetPointData()->SetNormals(normalArray);
  return result;
}

}  // namespace angiomesh
