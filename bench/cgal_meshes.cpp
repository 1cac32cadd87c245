// SPDX-License-Identifier: BSD-3-Clause
#include "bench/cgal_meshes.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include <functional>
#include <stdexcept>

namespace angiomesh::bench {
namespace {

template <class Point>
TriMesh fromCgal(const CGAL::Surface_mesh<Point>& surface) {
  TriMesh mesh;
  std::vector<std::uint32_t> number(surface.number_of_vertices() +
                                    surface.number_of_removed_vertices());
  for (const auto v : surface.vertices()) {
    number[v.idx()] = static_cast<std::uint32_t>(mesh.points.size());
    const Point& p = surface.point(v);
    mesh.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                             CGAL::to_double(p.z()));
  }
  for (const auto f : surface.faces()) {
    std::array<std::uint32_t, 3> triangle{};
    std::size_t corner = 0;
    for (const auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      triangle.at(corner++) = number[v.idx()];
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

}  // namespace

TriMesh cgalIsotropicRemeshing(const TriMesh& mesh, double edgeMm) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  Surface surface;
  std::vector<Surface::Vertex_index> vertex;
  for (const Eigen::Vector3d& p : mesh.points)
    vertex.push_back(surface.add_vertex(Kernel::Point_3(p[0], p[1], p[2])));
  for (const auto& t : mesh.triangles)
    if (surface.add_face(vertex[t[0]], vertex[t[1]], vertex[t[2]]) == Surface::null_face())
      throw std::runtime_error("marching cubes gave a mesh that is not a manifold");
  CGAL::Polygon_mesh_processing::isotropic_remeshing(
      surface.faces(), edgeMm, surface,
      CGAL::Polygon_mesh_processing::parameters::number_of_iterations(3));
  return fromCgal(surface);
}

TriMesh cgalDelaunayRefinement(const SplineField& field, const DelaunayBounds& bounds) {
  using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
  using Traits = Triangulation::Geom_traits;
  using Function = std::function<double(const Traits::Point_3&)>;
  const Geometry& g = field.geometry();
  const Function value = [&](const Traits::Point_3& p) {
    const Eigen::Vector3d x(p.x(), p.y(), p.z());
    const Eigen::Vector3d index = g.toIndex(x);
    for (int a = 0; a < 3; ++a)
      if (index[a] < 0.0 || index[a] > g.size[a] - 1.0) return 1.0;
    return field.valueAt(x);
  };
  // The ball in which the surface is looked for has its centre where the function is lowest.
  Index3 lowest{0, 0, 0};
  for (std::size_t i = 0; i < g.voxelCount(); ++i) {
    const Index3 p = g.indexOf(i);
    if (field.atVoxel(p[0], p[1], p[2]) < field.atVoxel(lowest[0], lowest[1], lowest[2]))
      lowest = p;
  }
  const Eigen::Vector3d centre = g.toPhysical({1.0 * lowest[0], 1.0 * lowest[1], 1.0 * lowest[2]});
  const double reach =
      g.spacing.cwiseProduct(Eigen::Vector3d(g.size[0], g.size[1], g.size[2])).norm();
  const Traits::Sphere_3 ball(Traits::Point_3(centre[0], centre[1], centre[2]), reach * reach);
  const CGAL::Implicit_surface_3<Traits, Function> surface(value, ball, 1e-6);

  Triangulation triangulation;
  CGAL::Complex_2_in_triangulation_3<Triangulation> complex(triangulation);
  const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(
      bounds.angleDegrees, bounds.radiusMm, bounds.distanceMm);
  CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Manifold_tag());
  CGAL::Surface_mesh<Traits::Point_3> mesh;
  CGAL::facets_in_complex_2_to_triangle_mesh(complex, mesh);
  return fromCgal(mesh);
}

}  // namespace angiomesh::bench
