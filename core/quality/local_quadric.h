// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/surface/tri_mesh.h"

namespace angiomesh {

/// The triangles and vertices around each vertex of a mesh, of some of its triangles.
class MeshRings {
 public:
  /// @param counts of each triangle: 0 for one that is left out; empty: none is
  explicit MeshRings(const TriMesh& mesh, const std::vector<char>& counts = {});

  /// A list of numbers in memory.
  struct Range {
    const std::uint32_t* first;
    const std::uint32_t* last;
    [[nodiscard]] const std::uint32_t* begin() const { return first; }
    [[nodiscard]] const std::uint32_t* end() const { return last; }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };
  [[nodiscard]] Range trianglesAt(std::uint32_t vertex) const { return range(triangles_, vertex); }
  [[nodiscard]] Range neighboursOf(std::uint32_t vertex) const {
    return range(neighbours_, vertex);
  }

  /// The mean of the triangles' normals at a vertex by area, of length 1; zero without triangles.
  [[nodiscard]] Eigen::Vector3d normalAt(std::uint32_t vertex) const;

  /// `vertex` first, then those joined to it by edges within `reachMm` (0: none), ring by ring, and
  /// whole rings beyond until there are `least` or `rings` rings.
  /// @param marks scratch of the caller: one value for each vertex, all 0 before and after
  void around(std::uint32_t vertex, double reachMm, std::size_t least, int rings,
              std::vector<char>& marks, std::vector<std::uint32_t>& found) const;

  [[nodiscard]] const TriMesh& mesh() const { return mesh_; }

 private:
  struct Lists {
    std::vector<std::size_t> start;
    std::vector<std::uint32_t> items;
  };
  static Range range(const Lists& lists, std::uint32_t v) {
    return {lists.items.data() + lists.start[v], lists.items.data() + lists.start[v + 1]};
  }

  const TriMesh& mesh_;
  Lists triangles_, neighbours_;
};

/// A quadric near a vertex: F(x, y, z) = z - c . (1, x, y, x^2, xy, y^2, z^2, xz, yz) in a frame
/// whose z is the wall's normal. Balls and tubes are among them exactly, whatever share of them the
/// points cover.
class LocalQuadric {
 public:
  /// By least squares of F over the points `found`, the first of which is the frame's origin.
  /// @param graph a height z over the tangent plane alone, without the last three terms
  /// Nothing when there are too few points for the terms, or they lie in a line.
  static std::optional<LocalQuadric> fit(const TriMesh& mesh,
                                         const std::vector<std::uint32_t>& found,
                                         const Eigen::Vector3d& normal, bool graph);

  /// Signed distance of a point near the surface, to first order, mm.
  [[nodiscard]] double distanceOf(const Eigen::Vector3d& point) const;
  /// The point of the surface near a point close to it.
  [[nodiscard]] Eigen::Vector3d foot(const Eigen::Vector3d& point) const;
  /// Of a graph at the origin, 1/mm, positive where the wall is convex seen from outside.
  [[nodiscard]] double meanCurvature() const;

  static constexpr int kTerms = 9, kGraphTerms = 6;

 private:
  using Terms = Eigen::Matrix<double, kTerms, 1>;

  /// The value and its gradient at a point in the frame, in units of scale_.
  double valueAt(const Eigen::Vector3d& local, Eigen::Vector3d& gradient) const;
  [[nodiscard]] Eigen::Vector3d toLocal(const Eigen::Vector3d& point) const {
    return axes_.transpose() * (point - origin_) / scale_;
  }

  Eigen::Vector3d origin_{0.0, 0.0, 0.0};
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  double scale_ = 1.0;  ///< the farthest point's distance, mm
  Terms terms_ = Terms::Zero();
};

}  // namespace angiomesh
