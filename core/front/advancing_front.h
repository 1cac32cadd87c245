// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/front/front_rules.h"

namespace angiomesh {

/// Advancing-front triangulation of a surface (thesis 4.2; Schreiner, Scheidegger, Silva 2006):
/// free triangles, whose corner is a new point of the surface, are placed before connection
/// triangles, which join the fronts there are; within a class the best-shaped first. An edge is
/// used at most once from each side, so that the result is an oriented manifold (with a rim) at
/// every step but for vertices where two fans meet.
class AdvancingFront : public FrontRules {
 public:
  using FrontRules::FrontRules;

  /// Makes room for a mesh of about so many triangles.
  void expect(double triangles);

  /// Starts a front around a first triangle, whose corners must be alone in their surroundings.
  void startAt(const Triangle& triangle);

  /// Starts a front along a closed rim; the surface lies to the left of the loop seen from outside.
  void startAlong(const std::vector<std::uint32_t>& loop);

  /// Grows until no front is left, or none can move. @throws Cancelled
  void run(const Progress& progress);

  /// Fills what fronts are left by the triangulations of least weight (Liepa 2003) that use no edge
  /// twice. Returns the number of loops that could not be filled.
  std::size_t close();

 private:
  struct HeapEntry {
    std::uint64_t key;  ///< class, then shape, then age: smaller first
    std::uint32_t edge, stamp;
    bool operator<(const HeapEntry& other) const { return key > other.key; }
  };

  bool tryFree(std::uint32_t id);
  bool tryConnection(std::uint32_t id, bool relaxed);
  void emit(std::uint32_t id, std::uint32_t apex, std::uint32_t corner, FaceOrigin origin);
  void flipAround(std::uint32_t triangle);
  bool flip(std::uint32_t from, std::uint32_t to);

  [[nodiscard]] bool valid(const HeapEntry& entry) const {
    return edges_[entry.edge].alive && edges_[entry.edge].stamp == entry.stamp;
  }
  void dropVoid();
  void push(std::uint32_t id, Class kind, double shape);
  void refresh(std::uint32_t id);
  void refreshAround(std::uint32_t added);

  std::vector<HeapEntry> heap_;
  std::uint32_t age_ = 0;
};

}  // namespace angiomesh
