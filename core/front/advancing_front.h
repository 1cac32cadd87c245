// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/contour/patch_mesh.h"
#include "core/front/front_surface.h"
#include "core/mesh/edge_map.h"
#include "core/mesh/point_grid.h"

namespace angiomesh {

/// Advancing-front triangulation of a surface (thesis 4.2; Schreiner, Scheidegger, Silva 2006):
/// free triangles, whose corner is a new point of the surface, are placed before connection
/// triangles, which join the fronts there are; within a class the best-shaped first. An edge is
/// used at most once from each side, so that the result is an oriented manifold (with a rim) at
/// every step but for vertices where two fans meet.
class AdvancingFront {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  explicit AdvancingFront(const FrontSurface& surface) : surface_(surface) {}

  /// Makes room for a mesh of about so many triangles.
  void expect(double triangles);

  /// `spacing` is the surface's wanted length there, where the vertex wants another one.
  std::uint32_t addVertex(const FrontPoint& point, double spacing);
  std::uint32_t addVertex(const FrontPoint& point) { return addVertex(point, point.length); }

  /// Starts a front around a first triangle, whose corners must be alone in their surroundings.
  void startAt(const Triangle& triangle);

  /// Starts a front along a closed rim; the surface lies to the left of the loop seen from outside.
  void startAlong(const std::vector<std::uint32_t>& loop);

  /// Grows until no front is left, or none can move. @throws Cancelled
  void run(const Progress& progress);

  /// Fills what fronts are left by the triangulations of least weight (Liepa 2003) that use no edge
  /// twice. Returns the number of loops that could not be filled.
  std::size_t close();

  [[nodiscard]] const std::vector<FrontPoint>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] const std::vector<FaceOrigin>& origins() const { return origins_; }

 private:
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

  struct HeapEntry {
    std::uint64_t key;  ///< class, then shape, then age: smaller first
    std::uint32_t edge, stamp;
    bool operator<(const HeapEntry& other) const { return key > other.key; }
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

  [[nodiscard]] Frame frameOf(const Edge& e) const;
  void collect(const Frame& frame, const Eigen::Vector3d& centre, double radius, double spacing,
               bool relaxed);
  [[nodiscard]] ApexWish wishFor(const Frame& frame, std::uint32_t id) const;
  [[nodiscard]] double cornerAngle(std::uint32_t in, std::uint32_t out) const;
  [[nodiscard]] bool clearAround(const Edge& e, const FrontPoint& apex) const;
  [[nodiscard]] bool meshedAt(const FrontPoint& place) const;
  [[nodiscard]] bool legal(const Frame& frame, std::uint32_t id, std::uint32_t apex,
                           const Eigen::Vector2d& at, bool relaxed) const;
  [[nodiscard]] bool crossesFront(const Frame& frame, std::uint32_t id, std::uint32_t apex,
                                  const Eigen::Vector2d& at) const;
  [[nodiscard]] bool edgesUsable(std::uint32_t id, std::uint32_t apex) const;
  [[nodiscard]] std::uint32_t openCorner(const Frame& frame, std::uint32_t id, std::uint32_t apex,
                                         const Eigen::Vector2d& at) const;

  bool tryFree(std::uint32_t id);
  bool tryConnection(std::uint32_t id, bool relaxed);
  void emit(std::uint32_t id, std::uint32_t apex, std::uint32_t corner, FaceOrigin origin);
  void flipAround(std::uint32_t triangle);
  bool flip(std::uint32_t from, std::uint32_t to);

  std::uint32_t newEdge(std::uint32_t from, std::uint32_t to);
  void dropEdge(std::uint32_t id);
  void join(std::uint32_t before, std::uint32_t after);
  [[nodiscard]] bool valid(const HeapEntry& entry) const {
    return edges_[entry.edge].alive && edges_[entry.edge].stamp == entry.stamp;
  }
  void dropVoid();
  void push(std::uint32_t id, Class kind, double shape);
  void refresh(std::uint32_t id);
  std::uint32_t addTriangle(const Triangle& t, FaceOrigin origin);

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
  std::vector<HeapEntry> heap_;
  std::uint32_t age_ = 0;
  std::vector<Near> near_;
  std::vector<std::uint32_t> seen_;  ///< per vertex: the last collect() that found it
  std::uint32_t collected_ = 0;
  std::vector<NearEdge> nearEdges_;
};

}  // namespace angiomesh
