// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "core/contour/patch_mesh.h"

namespace angiomesh {

/// A triangle mesh that is taken apart and put together again: index-based half-edges over flat
/// arrays with free lists. Half-edge h = 3 t + k runs from corner k of triangle t to the next one.
/// Vertices whose triangles are not one fan are `locked`: nothing around them changes. While a
/// trial is on, every change is written down, so that it can be taken back.
class EditMesh {
 public:
  using Vector3d = Eigen::Vector3d;
  static constexpr std::uint32_t none = 0xffffffffU;
  static constexpr std::size_t ringLimit = 48;  ///< vertices of so many neighbours are locked

  /// The neighbours of a vertex, counter-clockwise; at an open rim the first and the last are its
  /// neighbours along the rim.
  struct Ring {
    std::array<std::uint32_t, ringLimit> vertex;
    std::array<std::uint32_t, ringLimit> side;  ///< half-edge from vertex[i] to the next; or none
    std::uint32_t count = 0;
    bool open = false;
    /// triangles around the vertex
    [[nodiscard]] std::uint32_t triangles() const { return open ? count - 1 : count; }
    [[nodiscard]] std::uint32_t after(std::uint32_t i) const { return i + 1 < count ? i + 1 : 0; }
  };

  /// @throws InputError when the arrays of `start` do not fit together
  explicit EditMesh(const PatchMesh& start);

  /// What is left, in the order of the numbers.
  [[nodiscard]] PatchMesh result() const;

  [[nodiscard]] std::uint32_t vertexSlots() const {
    return static_cast<std::uint32_t>(points_.size());
  }
  [[nodiscard]] std::uint32_t halfEdgeSlots() const {
    return static_cast<std::uint32_t>(corner_.size());
  }
  [[nodiscard]] bool lives(std::uint32_t t) const { return corner_[3 * t] != none; }
  [[nodiscard]] bool livesVertex(std::uint32_t v) const { return leaving_[v] != none; }

  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  [[nodiscard]] std::uint32_t origin(std::uint32_t h) const { return corner_[h]; }
  [[nodiscard]] std::uint32_t target(std::uint32_t h) const { return corner_[next(h)]; }
  [[nodiscard]] std::uint32_t apex(std::uint32_t h) const { return corner_[previous(h)]; }
  [[nodiscard]] std::uint32_t twin(std::uint32_t h) const { return twin_[h]; }
  [[nodiscard]] std::uint32_t leaving(std::uint32_t v) const { return leaving_[v]; }

  [[nodiscard]] const Vector3d& point(std::uint32_t v) const { return points_[v]; }
  [[nodiscard]] const Vector3d& normal(std::uint32_t v) const { return normals_[v]; }
  [[nodiscard]] double size(std::uint32_t v) const { return sizes_[v]; }
  [[nodiscard]] const Place& place(std::uint32_t v) const { return places_[v]; }
  [[nodiscard]] std::uint16_t patch(std::uint32_t t) const { return patches_[t]; }
  [[nodiscard]] bool locked(std::uint32_t v) const { return locked_[v] != 0; }
  void lock(std::uint32_t v) { locked_[v] = 1; }

  /// Position, outward normal of the wall (of the plane inside a cap) and wanted edge length there.
  void set(std::uint32_t v, const Vector3d& point, const Vector3d& normal, double size);

  [[nodiscard]] Ring ring(std::uint32_t v) const;
  [[nodiscard]] std::uint32_t valence(std::uint32_t v) const { return valence_[v]; }
  [[nodiscard]] bool onRim(std::uint32_t v) const { return twin_[leaving_[v]] == none; }
  /// Between different patches, or on an open rim.
  [[nodiscard]] bool isFeature(std::uint32_t h) const {
    return twin_[h] == none || patches_[h / 3] != patches_[twin_[h] / 3];
  }
  [[nodiscard]] std::uint32_t edgeBetween(std::uint32_t u, std::uint32_t v) const;

  [[nodiscard]] bool canFlip(std::uint32_t h) const;
  /// Replaces the edge by the one between the opposite corners; canFlip() must hold. The new edge
  /// is the half-edge next(h).
  void flip(std::uint32_t h);

  /// Puts a vertex on the edge; it has no position yet. Returns the vertex.
  std::uint32_t split(std::uint32_t h, const Place& place);

  /// Whether the origin of h can be merged into its target and leave a manifold of the same
  /// topology (link condition) and the same patches.
  [[nodiscard]] bool canCollapse(std::uint32_t h) const;
  void collapse(std::uint32_t h);

  /// Numbers vertices and triangles along a space-filling curve, without gaps: neighbours on the
  /// surface come to lie together in memory. Not within a trial.
  void reorder();

  void beginTrial();
  void takeBack();
  void keep();

 private:
  struct Change {
    std::uint8_t what;
    std::uint32_t index, value;
  };
  struct Moved {
    std::uint32_t vertex;
    Vector3d point, normal;
    double size;
  };

  void put(std::vector<std::uint32_t>& array, std::uint8_t what, std::uint32_t index,
           std::uint32_t value) {
    if (trial_) changes_.push_back({what, index, array[index]});
    array[index] = value;
  }
  void setCorner(std::uint32_t h, std::uint32_t v) { put(corner_, 0, h, v); }
  void setTwin(std::uint32_t h, std::uint32_t o) { put(twin_, 1, h, o); }
  void setLeaving(std::uint32_t v, std::uint32_t h) { put(leaving_, 2, v, h); }
  void addValence(std::uint32_t v, std::uint32_t change) {
    put(valence_, 3, v, valence_[v] + change);
  }
  void join(std::uint32_t h, std::uint32_t o) {
    if (h != none) setTwin(h, o);
    if (o != none) setTwin(o, h);
  }
  std::uint32_t newTriangle(std::uint32_t like);
  std::uint32_t newVertex(const Place& place);
  void buildTwins();
  void lockIrregular();
  void startAtRim(std::uint32_t v);

  std::vector<std::uint32_t> corner_, twin_, leaving_, valence_;
  std::vector<Vector3d> points_, normals_;
  std::vector<double> sizes_;
  std::vector<Place> places_;
  std::vector<std::uint16_t> patches_;
  std::vector<std::uint8_t> locked_;
  std::vector<FaceOrigin> origins_;
  std::vector<std::uint32_t> groups_;
  std::vector<std::uint32_t> freeTriangles_, freeVertices_;
  std::vector<Change> changes_;
  std::vector<Moved> moved_;
  std::vector<std::uint32_t> deadTriangles_, deadVertices_;  ///< of the trial
  std::vector<std::uint32_t> madeTriangles_, madeVertices_;  ///< in the trial
  bool trial_ = false;
};

}  // namespace angiomesh
