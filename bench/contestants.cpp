// SPDX-License-Identifier: BSD-3-Clause
#include "bench/contestants.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>

#include "bench/cgal_meshes.h"
#include "core/contour/marching_cubes.h"
#include "core/field/spline_field.h"
#include "core/sizing/guidance_field.h"
#include "core/surface/zero_set_mesh.h"

namespace angiomesh::bench {
namespace {

/// As VTK gives it, specks and degenerate triangles included.
TriMesh flyingEdges(const Volume<float>& phi) {
  const Geometry& g = phi.geometry;
  vtkNew<vtkImageData> image;
  image->SetDimensions(g.size[0], g.size[1], g.size[2]);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::copy(phi.voxels.begin(), phi.voxels.end(), static_cast<float*>(image->GetScalarPointer()));
  vtkNew<vtkFlyingEdges3D> filter;
  filter->SetInputData(image);
  filter->SetValue(0, 0.0);
  filter->ComputeNormalsOff();
  filter->ComputeScalarsOff();
  filter->Update();
  vtkPolyData& surface = *filter->GetOutput();
  TriMesh mesh;
  for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i)
    mesh.points.push_back(g.toPhysical(Eigen::Vector3d(surface.GetPoint(i))));
  const auto cells = vtk::TakeSmartPointer(surface.GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* corner = nullptr;
    cells->GetCurrentCell(count, corner);
    mesh.triangles.push_back({static_cast<std::uint32_t>(corner[0]),
                              static_cast<std::uint32_t>(corner[1]),
                              static_cast<std::uint32_t>(corner[2])});
  }
  return mesh;
}

}  // namespace

std::vector<Contestant> contestants(const Volume<float>& phi, const SizingParams& sizing,
                                    double edgeMm) {
  const double voxel = phi.geometry.voxelMm();
  return {
      {"spline and guidance field alone",
       [&phi, sizing] {
         const SplineField field(phi, SplineKind::InterpolatingBspline);
         const GuidanceField guidance(field, sizing);
         return TriMesh{};
       }},
      {"advancing front",
       [&phi, sizing] {
         const SplineField field(phi, SplineKind::InterpolatingBspline);
         return meshZeroSet(field, sizing, SurfaceMethod::AdvancingFront, SurfaceBorder::Cap).mesh;
       }},
      {"remesh",
       [&phi, sizing] {
         const SplineField field(phi, SplineKind::InterpolatingBspline);
         return meshZeroSet(field, sizing, SurfaceMethod::Remesh, SurfaceBorder::Cap).mesh;
       }},
      {"VTK flying edges", [&phi] { return flyingEdges(phi); }},
      {"CGAL isotropic remeshing of it",
       [&phi, edgeMm] { return cgalIsotropicRemeshing(marchingCubes(phi), edgeMm); }},
      {"CGAL Delaunay refinement",
       [&phi, edgeMm, voxel] {
         const SplineField field(phi, SplineKind::InterpolatingBspline);
         return cgalDelaunayRefinement(field, {30.0, 0.75 * edgeMm, 0.1 * voxel});
       }},
  };
}

}  // namespace angiomesh::bench
