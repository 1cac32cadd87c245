// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/progress.h"
#include "core/field/spline_field.h"
#include "core/mesh/tri_mesh.h"
#include "core/mesh/triangle_tree.h"

namespace angiomesh {

/// The surface that a smoothed mesh has to stay on.
class Wall {
 public:
  struct Sample {
    Eigen::Vector3d normal{0.0, 0.0, 0.0};  ///< outward, unit; 0 where the wall is unknown
    double offset = 0.0;                    ///< signed distance to first order, mm, < 0 inside
  };

  virtual ~Wall() = default;
  [[nodiscard]] virtual Sample at(const Eigen::Vector3d& pointLps) const = 0;
  /// The length that bounds are given in, mm.
  [[nodiscard]] virtual double unitMm() const = 0;
  /// How far from offset 0 a point may be for a bound in these units, mm.
  [[nodiscard]] virtual double offsetLimitMm(double boundUnits) const {
    // A hair less: offsets are distances to first order.
    return 0.98 * boundUnits * unitMm();
  }
  /// The least cosine between the wall's normals where a vertex lay and where it may slide to.
  [[nodiscard]] virtual double leastTurn() const { return -1.0; }

 protected:
  Wall() = default;
  Wall(const Wall&) = default;
  Wall& operator=(const Wall&) = default;
};

/// The zero set of phi, continued straight out of its grid; the unit is phi's voxel. phi must
/// outlive it.
class ZeroSetWall : public Wall {
 public:
  explicit ZeroSetWall(const SplineField& phi)
      : phi_(phi), toIndex_(phi.geometry().physicalToIndexMatrix()) {}
  [[nodiscard]] Sample at(const Eigen::Vector3d& pointLps) const override;
  [[nodiscard]] double unitMm() const override { return phi_.geometry().voxelMm(); }

 private:
  const SplineField& phi_;
  Eigen::Matrix3d toIndex_;
};

/// A mesh, bulging between its vertices as their normals say (Phong tessellation, Boubekeur and
/// Alexa 2008), so that a vertex that slides over it does not cut the corner, at most by half the
/// bound; the other half is left for offsets. The unit is the mean edge length. The mesh must
/// outlive it.
class MeshWall : public Wall {
 public:
  MeshWall(const TriMesh& mesh, double boundUnits, const Progress& progress);
  [[nodiscard]] Sample at(const Eigen::Vector3d& pointLps) const override;
  [[nodiscard]] double unitMm() const override { return unitMm_; }
  [[nodiscard]] double offsetLimitMm(double boundUnits) const override {
    return 0.5 * Wall::offsetLimitMm(boundUnits);
  }
  /// Some 8 degrees: between its vertices a mesh says little of the wall, and those of a thin
  /// vessel would cut it off.
  [[nodiscard]] double leastTurn() const override { return 0.99; }

 private:
  const TriMesh& mesh_;
  TriangleTree tree_;
  std::vector<Eigen::Vector3d> normals_;
  double unitMm_ = 1.0;
  double bulgeMm_ = 0.0;
};

}  // namespace angiomesh
