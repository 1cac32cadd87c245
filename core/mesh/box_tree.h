// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// A tree of bounding boxes in single precision over the triangles of a mesh, which must outlive
/// it. Triangles that follow one another along a curve that fills space share a leaf, eight by
/// eight, and so do the nodes of each level: one look at a node tells which of its eight boxes meet
/// another.
class BoxTree {
 public:
  /// @throws Cancelled
  explicit BoxTree(const TriMesh& mesh, const Progress& progress = {});

  [[nodiscard]] std::size_t leaves() const { return levels_.front().size(); }

  /// Calls visit(a, b) for each pair of triangles whose boxes meet, or all but do, of which one is
  /// in the leaf and the other in the same or a later one: once for each pair, over all leaves.
  template <class Visit>
  void forEachPair(std::size_t leaf, Visit visit) const {
    const Box box = boxOf(leaf);
    std::array<Place, kWidth * kMostLevels> stack{};
    std::size_t depth = 0;
    stack[depth++] = {levels_.size() - 1, 0};
    while (depth > 0) {
      const Place at = stack[--depth];
      if (at.level == 0) {
        pairsOf(leaf, at.index, visit);
        continue;
      }
      const std::size_t below = at.level - 1;
      for (Lanes lanes = meeting(levels_[at.level][at.index], box); lanes != 0;
           lanes &= lanes - 1) {
        const std::size_t child = kWidth * at.index + lowest(lanes);
        // All of the child's leaves come before this one.
        if ((child + 1) << (3 * below) <= leaf) continue;
        stack[depth++] = {below, child};
      }
    }
  }

 private:
  static constexpr std::size_t kWidth = 8;
  static constexpr std::size_t kMostLevels = 11;  // 8^11 > 2^32

  /// A bit for each of the boxes of a node.
  using Lanes = std::uint32_t;
  static std::size_t lowest(Lanes lanes) {
    return static_cast<std::size_t>(std::countr_zero(lanes));
  }

  /// Of one box or of eight, from the mesh's lowest corner on. Both ends are rounded alike, so that
  /// boxes that meet still do so.
  struct Box {
    std::array<float, 3> low, high;
  };
  struct Boxes {
    std::array<std::array<float, kWidth>, 3> low, high;
  };
  struct Place {
    std::size_t level, index;
  };

  static Lanes meeting(const Boxes& boxes, const Box& box) {
    // Loops that compilers make vector instructions of.
    std::array<Lanes, kWidth> hits;
    for (std::size_t j = 0; j < kWidth; ++j) hits[j] = Lanes{1} << j;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t j = 0; j < kWidth; ++j) {
        hits[j] = boxes.low[axis][j] <= box.high[axis] ? hits[j] : 0U;
        hits[j] = boxes.high[axis][j] >= box.low[axis] ? hits[j] : 0U;
      }
    Lanes lanes = 0;
    for (const Lanes hit : hits) lanes |= hit;
    return lanes;
  }

  static Box boxAt(const Boxes& boxes, std::size_t lane) {
    return {{boxes.low[0][lane], boxes.low[1][lane], boxes.low[2][lane]},
            {boxes.high[0][lane], boxes.high[1][lane], boxes.high[2][lane]}};
  }
  [[nodiscard]] Box boxOf(std::size_t leaf) const {
    return boxAt(levels_[1][leaf / kWidth], leaf % kWidth);
  }

  template <class Visit>
  void pairsOf(std::size_t leaf, std::size_t other, Visit& visit) const {
    const Boxes& own = levels_[0][leaf];
    for (Lanes lanes = meeting(own, boxOf(other)); lanes != 0; lanes &= lanes - 1) {
      const std::size_t i = lowest(lanes);
      Lanes met = meeting(levels_[0][other], boxAt(own, i));
      if (other == leaf) met &= ~Lanes{0} << (i + 1);
      for (; met != 0; met &= met - 1)
        visit(order_[kWidth * leaf + i], order_[kWidth * other + lowest(met)]);
    }
  }

  void sort(double extent, const Progress& progress);
  void measure(const Progress& progress);

  const TriMesh& mesh_;
  Eigen::Vector3d corner_{0.0, 0.0, 0.0};  ///< the lowest of the mesh's box
  std::vector<std::uint32_t> order_;       ///< triangles as the leaves hold them
  /// Of each level from the leaves up: node n holds the boxes of the triangles, or of the nodes
  /// below, 8 n to 8 n + 7. At least two levels.
  std::vector<std::vector<Boxes>> levels_;
};

}  // namespace angiomesh
