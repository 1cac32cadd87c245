// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/sagitta_offset.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/base/parallel.h"
#include "core/surface/mesh_edges.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr std::size_t blockSize = 1024;

// Which border planes of the grid each vertex lies in: bit 2 a before, bit 2 a + 1 behind on axis
// a.
std::vector<std::uint8_t> planesOf(const TriMesh& mesh, const Geometry& g) {
  constexpr double hair = 1e-4;  // voxels; what single precision leaves of a plane
  const Eigen::Matrix3d toIndex = g.physicalToIndexMatrix();
  std::vector<std::uint8_t> planes(mesh.points.size(), 0);
  parallelFor(0, planes.size(), blockSize, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      const Vector3d index = toIndex * (mesh.points[v] - g.origin);
      for (int a = 0; a < 3; ++a) {
        const double end = g.size[static_cast<std::size_t>(a)] - 1;
        if (index[a] < hair) planes[v] |= static_cast<std::uint8_t>(1 << (2 * a));
        if (index[a] > end - hair) planes[v] |= static_cast<std::uint8_t>(2 << (2 * a));
      }
    }
  });
  return planes;
}

// Triangles in a border plane are caps.
bool isCap(const std::array<std::uint32_t, 3>& t, const std::vector<std::uint8_t>& planes) {
  return (planes[t[0]] & planes[t[1]] & planes[t[2]]) != 0;
}

// The signed distance along `normal` from `point` to the zero set.
double heightOver(const Vector3d& point, const Vector3d& normal, double farthest,
                  const SplineField& phi) {
  double height = 0.0;
  for (int n = 0; n < 3; ++n) {
    const SplineField::Jet jet = phi.at(point + height * normal);
    const double slope = jet.gradient.dot(normal);
    if (!(slope > 0.3 * jet.gradient.norm())) return 0.0;
    const double step = jet.value / slope;
    height -= step;
    if (!(std::fabs(height) < farthest)) return 0.0;
    if (std::fabs(step) < 1e-3 * farthest) break;
  }
  return height;
}

// The mean height of the zero set over a triangle: six points, exact for polynomials of degree 4
// (Dunavant 1985).
double meanHeight(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& normal,
                  const SplineField& phi) {
  constexpr std::array<std::array<double, 2>, 2> rule{
      {{0.445948490915965, 0.223381589678011}, {0.091576213509771, 0.109951743655322}}};
  const double farthest = 0.3 * std::sqrt((b - a).cross(c - a).norm());
  double mean = 0.0;
  for (const auto& [share, weight] : rule) {
    const double rest = 1.0 - 2.0 * share;
    for (const Vector3d& p :
         {Vector3d(rest * a + share * (b + c)), Vector3d(rest * b + share * (a + c)),
          Vector3d(rest * c + share * (a + b))})
      mean += weight * heightOver(p, normal, farthest, phi);
  }
  return mean;
}

class SagittaOffset {
 public:
  SagittaOffset(const TriMesh& mesh, const SplineField& phi, const std::vector<char>& frozen,
                const Progress& progress)
      : mesh_(mesh), phi_(phi), progress_(progress), planes_(planesOf(mesh, phi.geometry())) {
    measureFaces();
    meanOverVertices();
    setWays(frozen);
  }

  // Twice towards the linear prediction's error: the volume is a cubic in the factor, nearly
  // straight.
  TriMesh run() {
    const MeshComponents parts = meshComponents(mesh_);
    std::vector<double> missing(parts.count, 0.0), factor(parts.count, 1.0);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      missing[parts.label[t]] += area_[t] * height_[t];
    const std::vector<double> start = volumes(mesh_.points, parts);
    std::vector<std::uint32_t> part(mesh_.points.size(), 0);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const std::uint32_t v : mesh_.triangles[t]) part[v] = parts.label[t];
    TriMesh result = mesh_;
    for (int round = 0; round < 3; ++round) {
      for (std::size_t v = 0; v < result.points.size(); ++v)
        result.points[v] = mesh_.points[v] + factor[part[v]] * way_[v];
      const std::vector<double> now = volumes(result.points, parts);
      for (std::size_t p = 0; p < parts.count; ++p) {
        const double gained = now[p] - start[p];
        if (std::fabs(gained) > 1e-12 * std::fabs(start[p]))
          factor[p] = std::clamp(factor[p] * missing[p] / gained, 0.5, 2.0);
      }
    }
    return result;
  }

 private:
  // Area, and mean height of the zero set over it (0 for caps), of each triangle.
  void measureFaces() {
    area_.resize(mesh_.triangles.size());
    height_.resize(area_.size());
    parallelFor(0, area_.size(), blockSize, [&](std::size_t first, std::size_t last) {
      progress_.check();
      for (std::size_t i = first; i < last; ++i) {
        const auto& t = mesh_.triangles[i];
        const Vector3d &a = mesh_.points[t[0]], &b = mesh_.points[t[1]], &c = mesh_.points[t[2]];
        const Vector3d n = (b - a).cross(c - a);
        const double length = n.norm();
        area_[i] = isCap(t, planes_) ? 0.0 : 0.5 * length;
        height_[i] = area_[i] > 0.0 ? meanHeight(a, b, c, n / length, phi_) : 0.0;
      }
    });
  }

  // Each vertex takes the mean of its triangles, then half of the mean of those of its neighbours.
  void meanOverVertices() {
    const std::size_t count = mesh_.points.size();
    shift_.assign(count, 0.0);
    std::vector<double> sum(count), weight(count);
    for (int round = 0; round < 2; ++round) {
      std::fill(sum.begin(), sum.end(), 0.0);
      std::fill(weight.begin(), weight.end(), 0.0);
      for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
        const auto& t = mesh_.triangles[i];
        const double mean = (shift_[t[0]] + shift_[t[1]] + shift_[t[2]]) / 3.0;
        const double value = round == 0 ? height_[i] : mean;
        for (const std::uint32_t v : t) {
          sum[v] += area_[i] * value;
          weight[v] += area_[i];
        }
      }
      for (std::size_t v = 0; v < count; ++v) {
        if (weight[v] <= 0.0) continue;
        const double mean = sum[v] / weight[v];
        shift_[v] = round == 0 ? mean : 0.5 * (shift_[v] + mean);
      }
    }
  }

  void setWays(const std::vector<char>& frozen) {
    way_.assign(mesh_.points.size(), Vector3d::Zero());
    const Eigen::Matrix3d toIndex = phi_.geometry().physicalToIndexMatrix();
    parallelFor(0, way_.size(), blockSize, [&](std::size_t first, std::size_t last) {
      progress_.check();
      for (std::size_t v = first; v < last; ++v) {
        const int held = std::popcount(static_cast<unsigned>(planes_[v]));
        if (frozen[v] != 0 || shift_[v] == 0.0 || held > 1) continue;
        const Vector3d gradient = phi_.at(mesh_.points[v]).gradient;
        const double slope = gradient.norm();
        if (!(slope > 0.0) || !std::isfinite(slope)) continue;
        Vector3d along = gradient / slope;
        if (held == 1) {
          const int axis = std::countr_zero(static_cast<unsigned>(planes_[v])) / 2;
          const Vector3d plane = toIndex.row(axis).transpose().normalized();
          along -= along.dot(plane) * plane;
        }
        const double share = along.squaredNorm();
        if (share > 0.1) way_[v] = shift_[v] / share * along;
      }
    });
  }

  // Six times the volume that each component encloses, over six; about a point of its own, for the
  // sake of precision.
  [[nodiscard]] std::vector<double> volumes(const std::vector<Vector3d>& points,
                                            const MeshComponents& parts) const {
    std::vector<double> sum(parts.count, 0.0);
    const Vector3d centre = mesh_.points[mesh_.triangles.front()[0]];
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const auto& t = mesh_.triangles[i];
      const Vector3d a = points[t[0]] - centre, b = points[t[1]] - centre,
                     c = points[t[2]] - centre;
      sum[parts.label[i]] += a.dot(b.cross(c)) / 6.0;
    }
    return sum;
  }

  const TriMesh& mesh_;
  const SplineField& phi_;
  const Progress& progress_;
  std::vector<std::uint8_t> planes_;
  std::vector<double> area_, height_;  ///< of triangles
  std::vector<double> shift_;          ///< of vertices, mm along the wall's normal
  std::vector<Vector3d> way_;          ///< the shift in the directions that a vertex can go
};

}  // namespace

bool inscribedInZeroSet(const TriMesh& mesh, const SplineField& phi) {
  if (mesh.triangles.empty()) return false;
  const std::vector<std::uint8_t> planes = planesOf(mesh, phi.geometry());
  std::vector<char> wall(mesh.points.size(), 0);
  std::size_t thin = 0;
  constexpr double cos20 = 0.9396926207859084;
  for (const auto& t : mesh.triangles) {
    double sharpest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!isCap(t, planes)) wall[t[k]] = 1;
      const Vector3d a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]],
                     b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
      const double lengths = std::sqrt(a.squaredNorm() * b.squaredNorm());
      sharpest = std::max(sharpest, lengths > 0.0 ? a.dot(b) / lengths : 1.0);
    }
    if (sharpest > cos20) ++thin;
  }
  if (100 * thin > mesh.triangles.size()) return false;
  const double reach = 0.01 * phi.geometry().voxelMm();
  std::vector<char> off(mesh.points.size(), 0);
  parallelFor(0, off.size(), blockSize, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      if (wall[v] == 0) continue;
      const SplineField::Jet jet = phi.at(mesh.points[v]);
      if (!(std::fabs(jet.value) <= reach * jet.gradient.norm())) off[v] = 1;
    }
  });
  std::size_t far = 0, count = 0;
  for (std::size_t v = 0; v < off.size(); ++v) {
    count += wall[v] != 0 ? 1 : 0;
    far += off[v] != 0 ? 1 : 0;
  }
  return count > 0 && 200 * far <= count;
}

TriMesh offsetBySagitta(const TriMesh& mesh, const SplineField& phi,
                        const std::vector<char>& frozen, const Progress& progress) {
  if (mesh.triangles.empty()) return mesh;
  return SagittaOffset(mesh, phi, frozen, progress).run();
}

}  // namespace angiomesh
