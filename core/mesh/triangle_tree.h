// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// A binary tree of bounding boxes over the triangles of a mesh, which must outlive it.
class TriangleTree {
 public:
  using Box = Eigen::AlignedBox3d;

  /// @throws Cancelled
  explicit TriangleTree(const TriMesh& mesh, const Progress& progress = {});

  /// Calls visit(triangle) for each triangle whose box meets `box`, in an order that depends on the
  /// mesh only.
  template <class Visit>
  void forEachMeeting(const Box& box, Visit visit) const {
    forEachLeaf([&](const Box& other) { return !other.intersects(box); },
                [&](std::uint32_t i) {
                  if (boxes_[i].intersects(box)) visit(order_[i]);
                });
  }

  struct Closest {
    std::uint32_t triangle = 0;
    Eigen::Vector3d point{0.0, 0.0, 0.0};
    Eigen::Vector3d weights{0.0, 0.0, 0.0};  ///< barycentric coordinates of the point
    double distance = 0.0;
  };

  /// The point of the surface closest to `point`; the mesh must not be empty.
  [[nodiscard]] Closest closest(const Eigen::Vector3d& point) const;

  /// The distance from `origin` along `direction` (of length 1) to the first triangle that it
  /// leaves the inside through, beyond `least`; infinity where there is none.
  [[nodiscard]] double firstExit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                 double least) const;

  /// Which triangles stop a ray.
  struct Stop {
    bool entering = false;  ///< those that it gets into the inside through; else out of it
    double least = 0.0, most = std::numeric_limits<double>::infinity();  ///< distances
    /// Triangles with one of these corners do not.
    std::array<std::uint32_t, 3> notAt{noVertex, noVertex, noVertex};
  };
  static constexpr std::uint32_t noVertex = 0xFFFFFFFF;
  /// The distance from `origin` along `direction` (of length 1) to the first triangle that stops
  /// it; infinity where there is none.
  [[nodiscard]] double firstStop(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                 const Stop& stop) const;

 private:
  struct Node {
    Box box;
    std::uint32_t start = 0;  ///< leaf: first triangle; else the right child (left one follows)
    std::uint32_t count = 0;  ///< leaf: number of triangles; else 0
  };

  struct Item {
    Eigen::Vector3d sum;  ///< of its corners
    std::uint32_t triangle = 0;
  };
  std::uint32_t build(std::uint32_t first, std::uint32_t last, std::vector<Item>& items,
                      const Progress& progress);

  /// Calls visit(place in order_) for the triangles of each leaf whose nodes' boxes no misses(box)
  /// says to leave out.
  template <class Misses, class Visit>
  void forEachLeaf(Misses misses, Visit visit) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, 64> stack{};
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const std::uint32_t at = stack[--depth];
      const Node& node = nodes_[at];
      if (misses(node.box)) continue;
      if (node.count == 0) {
        stack[depth++] = node.start;
        stack[depth++] = at + 1;
        continue;
      }
      for (std::uint32_t i = node.start; i < node.start + node.count; ++i) visit(i);
    }
  }

  const TriMesh& mesh_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;  ///< triangles as the leaves hold them
  std::vector<Box> boxes_;            ///< of the triangles, in that order
};

/// The corners of a triangle of the mesh.
std::array<Eigen::Vector3d, 3> cornersOf(const TriMesh& mesh, std::uint32_t triangle);

/// The barycentric coordinates of the point of a triangle closest to `point` (Ericson 2005, 5.1.5).
Eigen::Vector3d closestWeights(const std::array<Eigen::Vector3d, 3>& triangle,
                               const Eigen::Vector3d& point);

}  // namespace angiomesh
