// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/remesh/remesh_ground.h"
#include "core/remesh/remesh_mesh.h"

namespace angiomesh {

/// One run of remesh() or improveTriangles().
class RemeshWorker {
 public:
  using Vector3d = Eigen::Vector3d;

  /// `held`, per vertex of `start`, may be empty: those that stay in place with their triangles.
  RemeshWorker(const PatchMesh& start, const RemeshGround& ground, const Progress& progress,
               const std::vector<char>& held = {});

  /// Brings the density of the mesh to the wanted edge lengths.
  void resize();
  /// Flips and relaxation of a mesh of the right density.
  void even();
  /// Works on the bad triangles one by one.
  void repair();
  /// Brings the vertices exactly to phi = 0.
  void finish();

  [[nodiscard]] PatchMesh result() const { return mesh_.result(); }

 private:
  using Ring = EditMesh::Ring;

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
  enum class FlipBy { Valence, Shape };

  // remesh_worker.cpp
  [[nodiscard]] int freedom(std::uint32_t v) const;
  [[nodiscard]] double agreement(std::uint32_t patch, const std::array<std::uint32_t, 3>& corners,
                                 const std::array<Vector3d, 3>& points) const;
  [[nodiscard]] bool agrees(std::uint32_t patch, const std::array<std::uint32_t, 3>& corners,
                            const std::array<Vector3d, 3>& points, double least) const;
  [[nodiscard]] bool ringAgrees(std::uint32_t v, const Ring& ring, const Vector3d& point,
                                double least) const;
  [[nodiscard]] double faceBadness(std::uint32_t t) const;
  [[nodiscard]] double shapeBadness(std::uint32_t t) const;
  void place(std::uint32_t v, Vector3d point, int steps, double farthest);
  void colour();
  [[nodiscard]] bool stepOf(std::uint32_t v, const Ring& ring, Vector3d& step) const;
  [[nodiscard]] Vector3d featureStep(std::uint32_t v, const Ring& ring) const;
  bool relaxVertex(std::uint32_t v);
  std::size_t relax(int sweeps, double settled);

  // remesh_resize.cpp
  [[nodiscard]] double stretch(std::uint32_t h) const;
  [[nodiscard]] bool flipAgrees(std::uint32_t h) const;
  [[nodiscard]] bool worthFlipping(std::uint32_t h, FlipBy by) const;
  std::size_t flipEdges(FlipBy by, bool all);
  void activate(std::uint32_t v);
  [[nodiscard]] Place splitPlace(std::uint32_t h) const;
  std::uint32_t splitEdge(std::uint32_t h);
  [[nodiscard]] bool collapseFits(std::uint32_t h, double longest, Vector3d& point) const;
  bool collapseEdge(std::uint32_t h, double longest);
  std::size_t splitLong();
  std::size_t collapseShort();

  // remesh_repair.cpp
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

  EditMesh mesh_;
  const RemeshGround& ground_;
  const Progress& progress_;
  std::vector<std::uint8_t> active_, moved_;
  std::vector<std::vector<std::uint32_t>> colours_;
  std::vector<std::uint32_t> marks_;
  std::uint32_t mark_ = 0;
  std::size_t effort_ = 0;  ///< triangles looked at by repair()
  bool partly_ = false;     ///< some vertices are held
  std::vector<std::uint32_t> faces_, touched_;
};

}  // namespace angiomesh
