// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "core/contour/patch_mesh.h"
#include "core/front/front_surface.h"
#include "core/mesh/edge_map.h"
#include "core/mesh/point_grid.h"

namespace angiomesh {

/// The triangles and the fronts of an advancing front, and what may be added to them.
class FrontRules {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  explicit FrontRules(const FrontSurface& surface) : surface_(surface) {}

  /// `spacing` is the surface's wanted length there, where the vertex wants another one.
  std::uint32_t addVertex(const FrontPoint& point, double spacing);
  std::uint32_t addVertex(const FrontPoint& point) { return addVertex(point, point.length); }

  [[nodiscard]] const std::vector<FrontPoint>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] const std::vector<FaceOrigin>& origins() const { return origins_; }

 protected:
  static constexpr std::uint32_t none = 0xffffffffU;

  enum class Class : std::uint8_t { Free, Connection, Forced, Stuck };

  // An edge of a front; the unmeshed side is to the left of from -> to.
  struct Edge {
    std::uint32_t from = none, to = none;
    std::uint32_t next = none, previous = none;
    std::uint32_t nextLeaving = none;  ///< the next front edge that leaves `from`
    std::uint32_t stamp = 0;           ///< grows with each change: older heap entries are void
    Class kind = Class::Free;
    bool alive = false;
  };

  // The surroundings of a place, in the tangent plane of a base edge.
  struct Near {
    std::uint32_t vertex;
    Eigen::Vector2d at;
  };
  struct NearEdge {
    std::uint32_t edge;
    Eigen::Vector2d from, to;
  };
  struct Frame {
    Eigen::Vector3d origin, u, v, n;
    [[nodiscard]] Eigen::Vector2d flat(const Eigen::Vector3d& p) const {
      const Eigen::Vector3d d = p - origin;
      return {d.dot(u), d.dot(v)};
    }
  };

  std::uint32_t newEdge(std::uint32_t from, std::uint32_t to);
  void dropEdge(std::uint32_t id);
  void join(std::uint32_t before, std::uint32_t after);
  std::uint32_t addTriangle(const Triangle& t, FaceOrigin origin);

  [[nodiscard]] Frame frameOf(const Edge& e) const;
  void collect(const Frame& frame, const Eigen::Vector3d& centre, double radius, double spacing,
               bool relaxed);
  [[nodiscard]] ApexWish wishFor(const Frame& frame, std::uint32_t id) const;
  [[nodiscard]] double halfCornerTangent(std::uint32_t in, std::uint32_t out) const;
  [[nodiscard]] bool clearAround(const Edge& e, const FrontPoint& apex) const;
  [[nodiscard]] bool meshedAt(const FrontPoint& place) const;
  [[nodiscard]] bool legal(const Frame& frame, std::uint32_t id, std::uint32_t apex,
                           const Eigen::Vector2d& at, bool relaxed) const;
  [[nodiscard]] bool crossesFront(const Frame& frame, std::uint32_t id, std::uint32_t apex,
                                  const Eigen::Vector2d& at) const;
  [[nodiscard]] bool edgesUsable(std::uint32_t id, std::uint32_t apex) const;
  [[nodiscard]] std::uint32_t openCorner(const Frame& frame, std::uint32_t id, std::uint32_t apex,
                                         const Eigen::Vector2d& at) const;

  const FrontSurface& surface_;
  std::vector<FrontPoint> vertices_;
  std::vector<double> spacing_;  ///< per vertex: places it in the grid
  std::vector<Triangle> triangles_;
  std::vector<FaceOrigin> origins_;
  EdgeMap used_;  ///< directed edge -> its triangle
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> freeEdges_;
  std::vector<std::uint32_t> leaving_;  ///< per vertex: a front edge that leaves it
  PointGrid grid_;                      ///< the vertices on fronts
  PointGrid all_;                       ///< all vertices
  std::vector<Near> near_;
  std::vector<std::uint32_t> seen_;  ///< per vertex: the last collect() that found it
  std::uint32_t collected_ = 0;
  std::vector<NearEdge> nearEdges_;
};

}  // namespace angiomesh
