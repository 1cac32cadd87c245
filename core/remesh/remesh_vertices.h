// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/remesh/remesh_ground.h"
#include "core/remesh/remesh_mesh.h"

namespace angiomesh {

/// A mesh over its ground whose vertices come to lie as evenly as their wanted edge lengths say,
/// without a change of its edges.
class RemeshVertices {
 public:
  using Vector3d = Eigen::Vector3d;

  /// Whether edges may only be flipped, so that vertices and triangles keep their numbers.
  enum class Edits { All, FlipsOnly };

  /// `held`, per vertex of `start`, may be empty: those that stay in place with their triangles.
  RemeshVertices(const PatchMesh& start, const RemeshGround& ground, const Progress& progress,
                 const std::vector<char>& held = {}, Edits edits = Edits::All);

  [[nodiscard]] PatchMesh result() const { return mesh_.result(); }

 protected:
  using Ring = EditMesh::Ring;

  // The least cosine between a triangle and the wall that an edit may leave: half a right angle and
  // some more, as a coarse triangle leans by that much on a tight bend; flips and the search for a
  // better place, which have a choice, are held to less.
  static constexpr double kLeastAgreement = 0.4, kChosenAgreement = 0.5;

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

  EditMesh mesh_;
  const RemeshGround& ground_;
  const Progress& progress_;
  std::vector<std::uint8_t> active_, moved_;
  bool partly_ = false;  ///< some vertices are held
  const Edits edits_;

 private:
  std::vector<std::vector<std::uint32_t>> colours_;
};

}  // namespace angiomesh
