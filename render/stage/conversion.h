// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <memory>

#include "core/image/volume.h"
#include "core/mesh/tri_mesh.h"

class vtkImageData;
class vtkMatrix4x4;
class vtkPolyData;

namespace angiomesh {

/// The volume without a copy, on a grid that starts at 0 with identity direction: the position in
/// patient space is that of patientMatrix(), to be set on the prop (some of VTK's mappers ignore an
/// image's direction). The result keeps the volume alive.
vtkSmartPointer<vtkImageData> toImageData(const std::shared_ptr<const Volume<float>>& volume);

/// From mm along the grid axes (0 at the first voxel's centre) to LPS mm.
vtkSmartPointer<vtkMatrix4x4> patientMatrix(const Geometry& geometry);

/// The mesh in LPS mm with area-weighted normals at its points, which are doubled where patches
/// meet: rims are sharp. Triangles keep their order.
vtkSmartPointer<vtkPolyData> toPolyData(const TriMesh& mesh);

}  // namespace angiomesh
