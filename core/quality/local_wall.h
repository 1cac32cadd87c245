// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/mesh/tri_mesh.h"

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
    [[nodiscard]] bool empty() const { return first == last; }
  };
  [[nodiscard]] Range trianglesAt(std::uint32_t vertex) const {
    return {items_.data() + start_[vertex], items_.data() + start_[vertex + 1]};
  }

  /// The mean of the triangles' normals at a vertex by area, of length 1; zero without triangles.
  [[nodiscard]] Eigen::Vector3d normalAt(std::uint32_t vertex) const;

  /// `vertex` first, then those joined to it by edges within `reachMm` (0: none), ring by ring, and
  /// whole rings beyond until there are `least` or `rings` rings.
  /// @param marks scratch of the caller: one value for each vertex, all 0 before and after
  void around(std::uint32_t vertex, double reachMm, std::size_t least, int rings,
              std::vector<char>& marks, std::vector<std::uint32_t>& found) const;

 private:
  const TriMesh& mesh_;
  std::vector<std::size_t> start_;  ///< of each vertex in items_
  std::vector<std::uint32_t> items_;
};

/// The wall near a vertex, F(x, y, z) = 0 with F = z - c . (1, x, y, x^2, xy, y^2, x^3, x^2 y, x
/// y^2, y^3, z^2, xz, yz, x^2 z, xyz, y^2 z) in a frame whose z is the wall's normal: a cubic
/// height with what makes balls and tubes exact, whatever share of them the points cover, and a
/// tube that bends to second order of its bend. A graph ends with the sixth term: a quadratic
/// height.
class LocalWall {
 public:
  /// By least squares of F over the points `found`, the first of which is the frame's origin.
  /// @param graph the first six terms alone
  /// Nothing when there are too few points for the terms, or they lie in a line.
  static std::optional<LocalWall> fit(const TriMesh& mesh, const std::vector<std::uint32_t>& found,
                                      const Eigen::Vector3d& normal, bool graph);

  /// Root mean square distance of the points from it (to first order), over their number less the
  /// degrees of freedom that the fit used, mm; not of a graph.
  [[nodiscard]] double spreadMm() const { return spreadMm_; }
  /// The point of the surface near a point close to it.
  [[nodiscard]] Eigen::Vector3d foot(const Eigen::Vector3d& point) const;
  /// Of a graph at the origin, 1/mm, positive where the wall is convex seen from outside.
  [[nodiscard]] double meanCurvature() const;

  static constexpr int kTerms = 16, kCubicTerms = 10, kGraphTerms = 6;

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
  double spreadMm_ = 0.0;
};

}  // namespace angiomesh
