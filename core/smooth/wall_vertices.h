// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/half_edges.h"
#include "core/openings/port.h"
#include "core/smooth/smoothing.h"
#include "core/smooth/wall.h"

namespace angiomesh {

/// A mesh whose vertices slide along the wall, each as freely as caps and rims let it, and by the
/// volume between mesh and wall that has to be given back.
class WallVertices {
 public:
  /// Patches, `ports` and `phi` (may be null) tell where caps and open rims lie; `frozen` vertices
  /// keep their place and their edges. All references must outlive the object.
  WallVertices(const TriMesh& mesh, const SmoothParams& params, const SplineField* phi,
               const Wall& wall, const std::vector<Port>& ports, const std::vector<char>& frozen);

 protected:
  using Vector3d = Eigen::Vector3d;
  using Corners = std::array<std::uint32_t, 3>;
  using Ring = std::array<std::uint32_t, 64>;

  // What a vertex may do. A cap is a patch, or a plane half a voxel outside the grid of phi; an
  // open rim lies in the outermost plane of voxel centres, or at a port: their vertices stay in
  // these planes.
  struct Freedom {
    bool fixed = false;
    bool cap = false;
    bool held = false;              ///< in the plane of planeNormal
    Vector3d planeNormal{0, 0, 0};  ///< outward
  };

  // What a vertex averages over, and whether it lies inside a cap (no wall to follow).
  struct Surroundings {
    Vector3d mean{0, 0, 0};
    int count = 0;
    bool insideCap = false;
    std::array<std::uint32_t, 2> alongRim{HalfEdges::none, HalfEdges::none};
  };

  // How well triangles agree with the wall (the smallest cosine of their normals), and the largest
  // cosine of their angles.
  struct Fitness {
    double agreement = 1.0, sharpness = 0.0;
  };

  // Below this agreement, or above this sharpness, a triangle may only get better.
  struct Limits {
    double agreement = 0.5, sharpness = 0.985;
  };

  void findPlanes(const Geometry& g);
  void holdPatches(const TriMesh& mesh, const std::vector<Port>& ports, const SplineField* phi);
  void fixTips();
  [[nodiscard]] bool inOneCap(const Corners& t) const;
  std::size_t ringOf(std::uint32_t v, Ring& ring) const;
  [[nodiscard]] Surroundings surroundings(std::uint32_t v) const;
  [[nodiscard]] Vector3d heldStep(std::uint32_t v, const Vector3d& step) const;
  [[nodiscard]] Vector3d toWall(std::uint32_t v, const Wall::Sample& s, double offset) const;
  [[nodiscard]] Vector3d alongRim(std::uint32_t v, const Surroundings& s, double factor) const;
  void refreshNormals();
  void relax(double factor, const Progress& progress);
  [[nodiscard]] Fitness fitness(const Corners& t, const std::vector<Vector3d>& at) const;
  void accept(std::vector<Vector3d>& moved, const Limits& limits, const Progress& progress);

  [[nodiscard]] std::vector<double> wallOffsets(const Progress& progress) const;
  void spread(std::vector<double>& values) const;
  void restoreOffsets(const std::vector<double>& before, std::vector<double>& given,
                      const Progress& progress);
  void enforceBound(const Progress& progress);

  const SmoothParams& params_;
  const Wall& wall_;
  HalfEdges edges_;
  std::vector<std::uint16_t> patch_;  ///< per triangle; may be empty
  std::vector<Vector3d> points_;
  std::vector<Freedom> freedom_;
  std::vector<Vector3d> normals_;  ///< of the wall at the vertices
};

}  // namespace angiomesh
