// SPDX-License-Identifier: BSD-3-Clause
#include "render/marks/surface_pick.h"

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace angiomesh {

namespace {

using Eigen::Vector3d;

/// What a camera with a perspective shows.
struct Pinhole {
  Vector3d eye, forward, up, right;
  double pixelsPerSlope;  // display pixels for a slope of 1 off the middle
  Eigen::Vector2d middle;

  explicit Pinhole(vtkRenderer* renderer) {
    vtkCamera* camera = renderer->GetActiveCamera();
    eye = Vector3d(camera->GetPosition());
    forward = (Vector3d(camera->GetFocalPoint()) - eye).normalized();
    right = forward.cross(Vector3d(camera->GetViewUp())).normalized();
    up = right.cross(forward);
    const int* size = renderer->GetRenderWindow() != nullptr ? renderer->GetSize() : nullptr;
    const double width = size != nullptr ? std::max(size[0], 1) : 1.0;
    const double height = size != nullptr ? std::max(size[1], 1) : 1.0;
    middle = {0.5 * width, 0.5 * height};
    pixelsPerSlope =
        0.5 * height / std::tan(0.5 * camera->GetViewAngle() * std::numbers::pi / 180.0);
  }
};

}  // namespace

ViewRay viewRay(vtkRenderer* renderer, double displayX, double displayY) {
  const Pinhole view(renderer);
  const double x = (displayX - view.middle[0]) / view.pixelsPerSlope;
  const double y = (displayY - view.middle[1]) / view.pixelsPerSlope;
  return {view.eye, (view.forward + x * view.right + y * view.up).normalized()};
}

Eigen::Vector2d displayOf(vtkRenderer* renderer, const Vector3d& point) {
  const Pinhole view(renderer);
  const Vector3d d = point - view.eye;
  const double depth = std::max(d.dot(view.forward), 1e-9);
  return view.middle +
         view.pixelsPerSlope / depth * Eigen::Vector2d(d.dot(view.right), d.dot(view.up));
}

double mmPerPixelAt(vtkRenderer* renderer, const Vector3d& point) {
  const Pinhole view(renderer);
  return std::max((point - view.eye).dot(view.forward), 1e-9) / view.pixelsPerSlope;
}

double distanceToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                         const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double length = ab.squaredNorm();
  const double t = length > 0.0 ? std::clamp((p - a).dot(ab) / length, 0.0, 1.0) : 0.0;
  return (p - a - t * ab).norm();
}

std::optional<SurfaceHit> firstHit(const TriMesh& mesh, const ViewRay& ray) {
  // Moeller & Trumbore 1997, "Fast, minimum storage ray-triangle intersection".
  double nearest = std::numeric_limits<double>::infinity();
  SurfaceHit hit;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& triangle = mesh.triangles[i];
    const Vector3d& a = mesh.points[triangle[0]];
    const Vector3d ab = mesh.points[triangle[1]] - a, ac = mesh.points[triangle[2]] - a;
    const Vector3d p = ray.direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0.0) continue;
    const Vector3d s = ray.from - a;
    const double u = s.dot(p) / determinant;
    if (u < 0.0 || u > 1.0) continue;
    const Vector3d q = s.cross(ab);
    const double v = ray.direction.dot(q) / determinant;
    if (v < 0.0 || u + v > 1.0) continue;
    const double t = ac.dot(q) / determinant;
    if (!(t > 0.0 && t < nearest)) continue;
    nearest = t;
    hit.triangle = i;
  }
  if (!std::isfinite(nearest)) return std::nullopt;
  hit.place = ray.from + nearest * ray.direction;
  return hit;
}

}  // namespace angiomesh
