// SPDX-License-Identifier: BSD-3-Clause
#include "core/contour/marching_cubes.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace angiomesh {
namespace {

// phi as it is contoured: kept away from 0, and with one layer around it for a closed surface.
class ContouredField {
 public:
  ContouredField(const Volume<float>& phi, SurfaceBorder border)
      : phi_(phi), pad_(border == SurfaceBorder::Cap ? 1 : 0) {
    nudge_ = 1e-3 * phi.geometry.voxelMm();
  }

  [[nodiscard]] int pad() const { return pad_; }
  [[nodiscard]] Index3 size() const {
    const Index3& n = phi_.geometry.size;
    return {n[0] + 2 * pad_, n[1] + 2 * pad_, n[2] + 2 * pad_};
  }

  // +1 outside, -1 inside, for a row of the padded grid.
  void signsOf(int j, int k, signed char* row, std::size_t count) const {
    const Index3& n = phi_.geometry.size;
    std::fill(row, row + count, static_cast<signed char>(1));
    if (j < pad_ || k < pad_ || j - pad_ >= n[1] || k - pad_ >= n[2]) return;
    const float* values = &phi_.at(0, j - pad_, k - pad_);
    for (int i = 0; i < n[0]; ++i) row[i + pad_] = values[i] < 0.0F ? -1 : 1;
  }

  // Value at a voxel of the padded grid. The outside layer mirrors the border voxel, so that the
  // crossing lies exactly half way between the two.
  [[nodiscard]] double at(const Index3& voxel) const {
    bool outside = false;
    std::array<int, 3> q{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int p = voxel[axis] - pad_;
      q[axis] = std::clamp(p, 0, phi_.geometry.size[axis] - 1);
      outside = outside || q[axis] != p;
    }
    const double value = nudged(static_cast<double>(phi_.at(q[0], q[1], q[2])));
    return outside ? std::abs(value) : value;
  }

 private:
  [[nodiscard]] double nudged(double value) const {
    if (std::abs(value) >= nudge_) return value;
    return value < 0.0 ? -nudge_ : nudge_;
  }

  const Volume<float>& phi_;
  int pad_;
  double nudge_ = 0.0;
};

// +1 outside, -1 inside: all that marching cubes needs to choose its triangles. The contour then
// crosses every edge half way, which floats hold exactly, so that each vertex of VTK's result names
// its grid edge.
vtkSmartPointer<vtkImageData> signImage(const ContouredField& field, const Progress& progress) {
  const Index3 n = field.size();
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n[0], n[1], n[2]);
  image->AllocateScalars(VTK_SIGNED_CHAR, 1);
  auto* signs = static_cast<signed char*>(image->GetScalarPointer());
  parallelFor(0, static_cast<std::size_t>(n[2]), 4, [&](std::size_t first, std::size_t last) {
    progress.check();
    const auto nx = static_cast<std::size_t>(n[0]), ny = static_cast<std::size_t>(n[1]);
    for (std::size_t k = first; k < last; ++k) {
      for (std::size_t j = 0; j < ny; ++j) {
        signed char* row = signs + nx * (j + ny * k);
        field.signsOf(static_cast<int>(j), static_cast<int>(k), row, nx);
      }
    }
  });
  return image;
}

// The point where phi, linear along the grid edge with midpoint `middle` (padded index), is 0;
// continuous index of the volume.
Eigen::Vector3d crossing(const ContouredField& field, const Eigen::Vector3d& middle) {
  Index3 from{};
  std::size_t along = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double m = middle[static_cast<Eigen::Index>(axis)];
    from[axis] = static_cast<int>(std::floor(m));
    if (m != std::floor(m)) along = axis;
  }
  Index3 to = from;
  ++to[along];
  const double a = field.at(from), b = field.at(to);
  // Keeps vertices of different edges apart whatever the range of the values.
  const double t = std::clamp(a / (a - b), 1e-4, 1.0 - 1e-4);
  Eigen::Vector3d index(from[0], from[1], from[2]);
  index[static_cast<Eigen::Index>(along)] += t;
  return index - Eigen::Vector3d::Constant(field.pad());
}

}  // namespace

TriMesh marchingCubes(const Volume<float>& phi, SurfaceBorder border, const Progress& progress) {
  TriMesh mesh;
  if (phi.voxels.empty()) return mesh;
  const ContouredField field(phi, border);
  progress.report(0.0);
  vtkNew<vtkFlyingEdges3D> contour;
  {
    const auto image = signImage(field, progress);
    contour->SetInputData(image);
    contour->ComputeNormalsOff();
    contour->ComputeGradientsOff();
    contour->ComputeScalarsOff();
    contour->SetValue(0, 0.0);
    progress.report(0.3);
    contour->Update();
    contour->SetInputData(nullptr);
  }
  progress.report(0.7);

  vtkPolyData* surface = contour->GetOutput();
  vtkPoints* middles = surface->GetPoints();
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPoints());
  mesh.points.resize(count);
  parallelForEach(count, 4096, progress, [&](std::size_t v) {
    Eigen::Vector3d middle;
    middles->GetPoint(static_cast<vtkIdType>(v), middle.data());
    mesh.points[v] = phi.geometry.toPhysical(crossing(field, middle));
  });

  // VTK's triangles are counter-clockwise from the side of the smaller values in index space.
  const bool reverse = phi.geometry.direction.determinant() > 0.0;
  mesh.triangles.reserve(static_cast<std::size_t>(surface->GetNumberOfPolys()));
  const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(corners, ids);
    if (corners != 3) continue;
    std::array<std::uint32_t, 3> t{};
    for (std::size_t k = 0; k < 3; ++k) t[k] = static_cast<std::uint32_t>(ids[k]);
    if (reverse) std::swap(t[1], t[2]);
    mesh.triangles.push_back(t);
  }
  progress.report(1.0);
  return mesh;
}

}  // namespace angiomesh
