// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/mesh_file_job.h"

#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/field/wall_field.h"
#include "core/quality/wall_triangles.h"
#include "gui/job/file_jobs.h"
#include "io/mesh/mesh_io.h"

namespace angiomesh {

namespace {

/// phi is clamped at 5 voxels: from here on it does not tell how far the wall is.
constexpr double kKnownVoxels = 4.9;

/// Where the points of a mesh's wall lie, as shares of them.
struct Whereabouts {
  double outside = 0.0;  ///< off the volume
  double far = 0.0;      ///< within it, farther from the wall than phi tells
};

Whereabouts whereaboutsOf(const TriMesh& mesh, const SplineField& phi) {
  const std::vector<char> wall = wallTriangles(mesh, phi.geometry());
  const double known = kKnownVoxels * phi.geometry().voxelMm();
  std::vector<char> counts(mesh.points.size(), 0);
  for (std::size_t t = 0; t < wall.size(); ++t)
    if (wall[t] != 0)
      for (const std::uint32_t v : mesh.triangles[t]) counts[v] = 1;
  std::size_t all = 0, outside = 0, far = 0;
  for (std::size_t v = 0; v < counts.size(); ++v) {
    if (counts[v] == 0) continue;
    ++all;
    if (!phi.geometry().holds(mesh.points[v], 1e-6))
      ++outside;
    else if (std::fabs(phi.at(mesh.points[v]).value) > known)
      ++far;
  }
  if (all == 0) return {1.0, 0.0};
  return {static_cast<double>(outside) / static_cast<double>(all),
          static_cast<double>(far) / static_cast<double>(all)};
}

std::string limitsOf(const Whereabouts& where) {
  if (where.outside >= 1.0)
    return "It lies off the volume: its distance to the wall is not measured. Is it in RAS, or in "
           "metres?";
  if (where.far > 0.0)
    return formatted(
        "%.1f %% of its points lie too far from the wall for its distance to be known: none is "
        "given.",
        100.0 * where.far);
  if (where.outside > 0.0)
    return formatted("%.1f %% of its points lie off the volume: the others are measured.",
                     100.0 * where.outside);
  return {};
}

}  // namespace

void MeshFileJob::execute() noexcept {
  try {
    if (!mesh) {
      LoadedMesh loaded = loadMesh(path);
      warnings = std::move(loaded.warnings);
      if (loaded.mesh.triangles.empty())
        throw InputError("the mesh has no triangles", path.string(), "choose another file");
      mesh = std::make_shared<const TriMesh>(std::move(loaded.mesh));
    }
    progress.check();
    measure();
  } catch (const Cancelled&) {
    // Nobody waits for it any more.
  } catch (const std::exception& failure) {
    error = withoutPath(failure.what(), path, path.filename().string());
  }
}

void MeshFileJob::measure() {
  std::optional<SplineField> wall;
  // Without patches nothing tells its caps from the wall but the edges that cuts made in phi.
  if (surface) wall = wallField(mesh->patch.empty() ? *surface->phi : *surface->uncutPhi, spline);
  if (wall) {
    const Whereabouts where = whereaboutsOf(*mesh, *wall);
    limits = limitsOf(where);
    if (where.outside >= 1.0 || where.far > 0.0) wall.reset();
  }
  progress.check();
  quality =
      std::make_shared<const MeshQuality>(measureQuality(*mesh, wall ? &*wall : nullptr, progress));
}

}  // namespace angiomesh
