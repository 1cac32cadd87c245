// SPDX-License-Identifier: BSD-3-Clause
#include "core/smooth/sagitta_offset.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/base/parallel.h"
#include "core/mesh/mesh_edges.h"
#include "core/openings/held_planes.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr std::size_t blockSize = 1024;
constexpr std::uint32_t kOpenRims = 1U << 16U;  // rims of caps go by their patches

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
  SagittaOffset(const TriMesh& mesh, const SplineField& phi, const std::vector<Port>& ports,
                const std::vector<char>& frozen, const Progress& progress)
      : mesh_(mesh), phi_(phi), progress_(progress), held_(mesh, &phi.geometry(), ports) {
    measureFaces();
    meanOverVertices();
    findRims();
    setWays(frozen);
    fitRims();
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
        result.points[v] = mesh_.points[v] + (onRim_[v] != 0 ? 1.0 : factor[part[v]]) * way_[v];
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
    parallelForEach(area_.size(), blockSize, progress_, [&](std::size_t i) {
      const auto& t = mesh_.triangles[i];
      const Vector3d &a = mesh_.points[t[0]], &b = mesh_.points[t[1]], &c = mesh_.points[t[2]];
      const Vector3d n = (b - a).cross(c - a);
      const double length = n.norm();
      area_[i] = held_.isCap(i) ? 0.0 : 0.5 * length;
      height_[i] = area_[i] > 0.0 ? meanHeight(a, b, c, n / length, phi_) : 0.0;
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
    parallelForEach(way_.size(), blockSize, progress_, [&](std::size_t i) {
      const auto v = static_cast<std::uint32_t>(i);
      const int held = held_.count(v);
      if (frozen[v] != 0 || shift_[v] == 0.0 || held > 1) return;
      const Vector3d gradient = phi_.at(mesh_.points[v]).gradient;
      const double slope = gradient.norm();
      if (!(slope > 0.0) || !std::isfinite(slope)) return;
      Vector3d along = gradient / slope;
      if (held == 0) {
        way_[v] = shift_[v] * along;
        return;
      }
      along -= along.dot(held_.normal(v)) * held_.normal(v);
      const double share = along.squaredNorm();
      if (share > 0.1) way_[v] = shift_[v] / (onRim_[v] != 0 ? std::sqrt(share) : share) * along;
    });
  }

  struct CapEdge {
    std::uint32_t from, to;  ///< the cap to the left
    std::uint32_t rim;
  };

  // The edges between caps and the wall, and open rims in planes; rims by their caps' patches, open
  // ones by connection. Their vertices move by the mean height of phi = 0 over the rim's edges in
  // the plane.
  void findRims() {
    onRim_.assign(mesh_.points.size(), 0);
    DisjointSets open(mesh_.points.size());
    for (const RimEdge& edge : rimEdges(mesh_)) {
      if (!held_.sharePlane(edge.from, edge.to)) continue;
      // Where two caps meet there is no wall.
      if (!edge.open && edge.patch != 0) continue;
      rims_.push_back({edge.from, edge.to, edge.open ? 0U : edge.otherPatch});
      if (edge.open) open.join(edge.from, edge.to);
      onRim_[edge.from] = onRim_[edge.to] = 1;
    }
    for (CapEdge& e : rims_)
      if (e.rim == 0) e.rim = kOpenRims + open.find(e.from);
    std::sort(rims_.begin(), rims_.end(), [](const CapEdge& a, const CapEdge& b) {
      return std::tie(a.rim, a.from) < std::tie(b.rim, b.from);
    });
    shiftRims();
  }

  void shiftRims() {
    std::vector<double> weight(mesh_.points.size(), 0.0);
    for (const CapEdge& e : rims_) shift_[e.from] = shift_[e.to] = 0.0;
    for (const CapEdge& e : rims_) {
      const double length = (mesh_.points[e.to] - mesh_.points[e.from]).norm();
      const double height = edgeHeight(e);
      for (const std::uint32_t v : {e.from, e.to}) {
        shift_[v] += length * height;
        weight[v] += length;
      }
    }
    for (std::size_t v = 0; v < weight.size(); ++v)
      if (weight[v] > 0.0) shift_[v] /= weight[v];
  }

  // The mean height of phi = 0 over an edge within its plane, outwards: three points (Gauss).
  [[nodiscard]] double edgeHeight(const CapEdge& e) const {
    const Vector3d &a = mesh_.points[e.from], &b = mesh_.points[e.to];
    const double length = (b - a).norm();
    if (!(length > 0.0)) return 0.0;
    const Vector3d outward = ((b - a) / length).cross(held_.normal(e.from));
    double mean = 0.0;
    for (const auto& [at, weight] :
         {std::pair{0.1127016653792583, 5.0 / 18.0}, std::pair{0.5, 8.0 / 18.0},
          std::pair{0.8872983346207417, 5.0 / 18.0}})
      mean += weight * heightOver(a + at * (b - a), outward, 0.45 * length, phi_);
    return mean;
  }

  // By a common factor for each rim, it encloses the area of phi < 0 in its plane.
  void fitRims() {
    for (std::size_t i = 0; i < rims_.size();) {
      std::size_t end = i;
      double missing = 0.0;
      for (; end < rims_.size() && rims_[end].rim == rims_[i].rim; ++end)
        missing += edgeHeight(rims_[end]) *
                   (mesh_.points[rims_[end].to] - mesh_.points[rims_[end].from]).norm();
      const double start = rimArea(i, end, 0.0);
      double factor = 1.0;
      for (int round = 0; round < 4; ++round) {
        const double gained = rimArea(i, end, factor) - start;
        if (std::fabs(gained) > 1e-12 * std::fabs(start))
          factor = std::clamp(factor * missing / gained, 0.0, 3.0);
      }
      std::vector<std::uint32_t> vertices;
      for (; i < end; ++i) vertices.insert(vertices.end(), {rims_[i].from, rims_[i].to});
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      for (const std::uint32_t v : vertices) way_[v] *= factor;
    }
  }

  [[nodiscard]] double rimArea(std::size_t first, std::size_t last, double factor) const {
    const Vector3d about = mesh_.points[rims_[first].from];
    double twice = 0.0;
    for (std::size_t i = first; i < last; ++i) {
      const CapEdge& e = rims_[i];
      const Vector3d a = mesh_.points[e.from] + factor * way_[e.from] - about;
      const Vector3d b = mesh_.points[e.to] + factor * way_[e.to] - about;
      twice += a.cross(b).dot(held_.normal(e.from));
    }
    return 0.5 * twice;
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
  HeldPlanes held_;
  std::vector<CapEdge> rims_;          ///< sorted by rim
  std::vector<char> onRim_;            ///< per vertex
  std::vector<double> area_, height_;  ///< of triangles
  std::vector<double> shift_;          ///< of vertices, mm along the wall's normal
  std::vector<Vector3d> way_;          ///< the shift in the directions that a vertex can go
};

}  // namespace

std::vector<char> inscribedComponents(const TriMesh& mesh, const MeshComponents& parts,
                                      const SplineField& phi) {
  struct Tally {
    std::size_t triangles = 0, thin = 0, vertices = 0, off = 0;
  };
  const HeldPlanes held(mesh, &phi.geometry(), {});
  std::vector<std::uint32_t> wallOf(mesh.points.size(), 0);  // 1 + the part, of the wall's vertices
  std::vector<Tally> tally(parts.count);
  constexpr double cos20 = 0.9396926207859084;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    double sharpest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!held.isCap(i)) wallOf[t[k]] = parts.label[i] + 1;
      const Vector3d a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]],
                     b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
      const double lengths = std::sqrt(a.squaredNorm() * b.squaredNorm());
      sharpest = std::max(sharpest, lengths > 0.0 ? a.dot(b) / lengths : 1.0);
    }
    Tally& part = tally[parts.label[i]];
    ++part.triangles;
    if (sharpest > cos20) ++part.thin;
  }
  const double reach = 0.01 * phi.geometry().voxelMm();
  std::vector<char> off(mesh.points.size(), 0);
  parallelForEach(off.size(), blockSize, [&](std::size_t v) {
    if (wallOf[v] == 0) return;
    const SplineField::Jet jet = phi.at(mesh.points[v]);
    if (!(std::fabs(jet.value) <= reach * jet.gradient.norm())) off[v] = 1;
  });
  for (std::size_t v = 0; v < off.size(); ++v) {
    if (wallOf[v] == 0) continue;
    Tally& part = tally[wallOf[v] - 1];
    ++part.vertices;
    if (off[v] != 0) ++part.off;
  }
  std::vector<char> inscribed(parts.count, 0);
  for (std::size_t p = 0; p < parts.count; ++p)
    inscribed[p] =
        static_cast<char>(100 * tally[p].thin <= tally[p].triangles && tally[p].vertices > 0 &&
                          200 * tally[p].off <= tally[p].vertices);
  return inscribed;
}

bool inscribedInZeroSet(const TriMesh& mesh, const SplineField& phi) {
  if (mesh.triangles.empty()) return false;
  MeshComponents whole;
  whole.count = 1;
  whole.label.assign(mesh.triangles.size(), 0);
  return inscribedComponents(mesh, whole, phi).front() != 0;
}

TriMesh offsetBySagitta(const TriMesh& mesh, const SplineField& phi, const std::vector<Port>& ports,
                        const std::vector<char>& frozen, const Progress& progress) {
  if (mesh.triangles.empty()) return mesh;
  return SagittaOffset(mesh, phi, ports, frozen, progress).run();
}

}  // namespace angiomesh
