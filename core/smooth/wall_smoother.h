// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/remesh/remesh_worker.h"
#include "core/smooth/smoothing.h"
#include "core/smooth/wall.h"
#include "core/smooth/wall_places.h"

namespace angiomesh {

/// A wall of any kind, and the planes of a mesh that is smoothed on it.
class WallGround final : public RemeshGround {
 public:
  /// Both must outlive the object. The wanted lengths are those of the mesh itself, evened out.
  WallGround(const Wall& wall, const WallPlaces& places);

  [[nodiscard]] Vector3d inPlanes(const Place& place, const Vector3d& step) const override;
  bool land(const Place& place, Vector3d& point, Vector3d& normal, int steps) const override;
  [[nodiscard]] bool allows(std::uint32_t vertex, const Vector3d& normal) const override;
  [[nodiscard]] double sizeAt(std::uint32_t vertex, const Vector3d&) const override {
    return sizes_[vertex];
  }
  [[nodiscard]] const Vector3d& planeNormal(int plane) const override {
    return places_.planes[static_cast<std::size_t>(plane - 6)];
  }
  [[nodiscard]] double unitMm() const override { return wall_.unitMm(); }

  /// The step from where `s` was taken to the surface at `offset` from the wall, in the place's
  /// plane; 0 where the plane is along the wall, and on a line.
  [[nodiscard]] Vector3d toWall(const Place& place, const Wall::Sample& s, double offset) const;

 private:
  [[nodiscard]] bool onLine(const Place& place) const {
    return place.planes() > 0 && planeNormal(place.firstPlane()).isZero();
  }

  const Wall& wall_;
  const WallPlaces& places_;
  std::vector<double> sizes_;
  std::vector<Vector3d> normals_;  ///< of the wall at the vertices to begin with
};

/// One run of keepWallSmooth(): vertices slide along the wall, edges are flipped, the worst
/// triangles are worked on one by one, and the volume between mesh and wall is given back.
class WallSmoother : private RemeshWorker {
 public:
  /// All must outlive the object.
  WallSmoother(const WallPlaces& places, const WallGround& ground, const Wall& wall,
               const SmoothParams& params, const Progress& progress);

  TriMesh run();

 private:
  using Corners = std::array<std::uint32_t, 3>;

  // How well a triangle agrees with the wall (the smallest cosine of their normals), and the
  // largest cosine of its angles.
  struct Fitness {
    double agreement = 1.0, sharpness = 0.0;
  };
  // Below this agreement, or above this sharpness, a triangle may only get better.
  struct Limits {
    double agreement = 0.5, sharpness = 0.985;
  };

  [[nodiscard]] Corners corners(std::uint32_t t) const {
    return {mesh_.origin(3 * t), mesh_.origin(3 * t + 1), mesh_.origin(3 * t + 2)};
  }
  [[nodiscard]] bool hasOffset(std::uint32_t v) const {
    return freedom(v) > 0 && places_.offWall[v] == 0;
  }
  [[nodiscard]] Fitness fitness(std::uint32_t t, const std::vector<Vector3d>& at) const;
  void accept(std::vector<Vector3d>& moved, const Limits& limits);
  void fetch();
  bool approach();
  void spread(std::vector<double>& values) const;
  [[nodiscard]] std::vector<double> wallOffsets() const;
  void restoreOffsets(const std::vector<double>& before, std::vector<double>& given);
  void enforceBound();

  const WallPlaces& places_;
  const WallGround& wallGround_;
  const Wall& wall_;
  const SmoothParams& params_;
  std::vector<Vector3d> points_;  ///< of the vertices, where all of them move at once
};

}  // namespace angiomesh
