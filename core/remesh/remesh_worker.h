// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/remesh/remesh_edges.h"

namespace angiomesh {

/// One run of remesh(), improveTriangles() or keepWallSmooth().
class RemeshWorker : public RemeshEdges {
 public:
  using RemeshEdges::RemeshEdges;

  /// Works on the bad triangles one by one.
  void repair();
  /// Brings the vertices exactly to the wall.
  void finish();

 private:
  // What a trial is judged by: the squares of what is bad, the worst of it, and the edges' lengths.
  struct Merit {
    double sum = 0.0, worst = 0.0, worstShape = 0.0, shortest = 1e9, longest = 0.0;
    [[nodiscard]] bool betterThan(const Merit& other) const;
  };
  struct Job {
    double badness;
    std::uint32_t triangle;
    bool operator<(const Job& o) const {
      return badness != o.badness ? badness < o.badness : triangle > o.triangle;
    }
  };
  enum class Kind : std::uint8_t { Relocate, Flip, Collapse, Split };
  struct Move {
    Kind kind;
    std::uint32_t side;
  };

  [[nodiscard]] std::vector<std::uint32_t> around(std::uint32_t t, int level) const;
  void facesOf(const std::vector<std::uint32_t>& vertices, std::vector<std::uint32_t>& faces);
  Merit merit(const std::vector<std::uint32_t>& vertices);
  [[nodiscard]] double ringBadness(const Ring& ring, const Vector3d& point);
  bool relocate(std::uint32_t v);
  void settle(const std::vector<std::uint32_t>& vertices, int rounds);
  bool apply(const Move& move, std::vector<std::uint32_t>& vertices);
  [[nodiscard]] std::vector<Move> movesFor(std::uint32_t t, int level) const;
  bool work(std::uint32_t t, int level, std::size_t quota);
  std::vector<Job> badFaces() const;

  std::vector<std::uint32_t> marks_;
  std::uint32_t mark_ = 0;
  std::size_t effort_ = 0;  ///< triangles looked at by repair()
  std::vector<std::uint32_t> faces_, touched_;
};

}  // namespace angiomesh
