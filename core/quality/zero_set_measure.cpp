// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/zero_set_measure.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"

namespace angiomesh {
namespace {

struct Corner {
  Eigen::Vector3d index;  ///< continuous index
  double value;
};

/// What a row of blocks adds.
struct Sums {
  double voxels = 0.0;         ///< inside volume of the piecewise linear zero set, voxels
  double correctionMm3 = 0.0;  ///< from it to the true one
  double areaMm2 = 0.0;
};

class CellSums {
 public:
  CellSums(const SplineField& field, int refine)
      : field_(field),
        refine_(refine),
        reachMm_(field.geometry().voxelMm() / refine),
        toPhysical_(field.geometry().direction * field.geometry().spacing.asDiagonal()) {
    const auto side = static_cast<std::size_t>(refine + 1);
    values_.resize(side * side * side);
  }

  /// A voxel cell that the wall may pass.
  void addCell(const Eigen::Vector3d& corner) {
    const double step = 1.0 / refine_;
    std::size_t at = 0;
    for (int c = 0; c <= refine_; ++c)
      for (int b = 0; b <= refine_; ++b)
        for (int a = 0; a <= refine_; ++a)
          values_[at++] = field_.atIndex(corner + step * Eigen::Vector3d(a, b, c)).value;
    for (int c = 0; c < refine_; ++c)
      for (int b = 0; b < refine_; ++b)
        for (int a = 0; a < refine_; ++a) addFine(corner, {a, b, c});
  }

  void addInside(double voxels) { sums_.voxels += voxels; }
  [[nodiscard]] const Sums& sums() const { return sums_; }

 private:
  [[nodiscard]] double valueAt(int a, int b, int c) const {
    const int side = refine_ + 1;
    return values_[static_cast<std::size_t>(a + side * (b + side * c))];
  }

  /// The six tetrahedra around the cell's diagonal (Kuhn's), which fit those of its neighbours.
  void addFine(const Eigen::Vector3d& corner, const Index3& fine) {
    std::array<Corner, 8> corners;
    int inside = 0;
    const double step = 1.0 / refine_;
    for (int v = 0; v < 8; ++v) {
      const int a = fine[0] + (v & 1), b = fine[1] + ((v >> 1) & 1), c = fine[2] + ((v >> 2) & 1);
      corners[static_cast<std::size_t>(v)] = {corner + step * Eigen::Vector3d(a, b, c),
                                              valueAt(a, b, c)};
      inside += corners[static_cast<std::size_t>(v)].value < 0.0 ? 1 : 0;
    }
    if (inside == 0) return;
    if (inside == 8) {
      sums_.voxels += step * step * step;
      return;
    }
    static constexpr std::array<std::array<std::size_t, 2>, 6> middles{
        {{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}}};
    for (const auto& [first, second] : middles)
      addTetrahedron({corners[0], corners[first], corners[second], corners[7]});
  }

  void addTetrahedron(std::array<Corner, 4> v) {
    std::stable_partition(v.begin(), v.end(), [](const Corner& c) { return c.value < 0.0; });
    const auto inside = std::count_if(v.begin(), v.end(), [](auto& c) { return c.value < 0.0; });
    const double whole = 1.0 / (6.0 * refine_ * refine_ * refine_);
    // Of the way from an inside corner to an outside one.
    const auto part = [&v](std::size_t in, std::size_t out) {
      return v[in].value / (v[in].value - v[out].value);
    };
    const auto point = [&](std::size_t in, std::size_t out) -> Eigen::Vector3d {
      return v[in].index + part(in, out) * (v[out].index - v[in].index);
    };
    switch (inside) {
      case 1:
        sums_.voxels += whole * part(0, 1) * part(0, 2) * part(0, 3);
        addTriangle(point(0, 1), point(0, 2), point(0, 3));
        break;
      case 2: {
        // The wedge of the inside, cut into three tetrahedra.
        const double a = part(0, 2), b = part(0, 3), c = part(1, 2), d = part(1, 3);
        sums_.voxels += whole * (a * b + a * d * (1.0 - b) + c * d * (1.0 - a));
        addTriangle(point(0, 2), point(0, 3), point(1, 3));
        addTriangle(point(0, 2), point(1, 3), point(1, 2));
        break;
      }
      case 3:
        sums_.voxels +=
            whole * (1.0 - (1.0 - part(0, 3)) * (1.0 - part(1, 3)) * (1.0 - part(2, 3)));
        addTriangle(point(0, 3), point(1, 3), point(2, 3));
        break;
      default:
        if (inside == 4) sums_.voxels += whole;
    }
  }

  /// Maps a triangle of the piecewise linear zero set to the true one, by its edges' midpoints.
  void addTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const Eigen::Vector3d vector = 0.5 * (toPhysical_ * (b - a)).cross(toPhysical_ * (c - a));
    const Eigen::Vector3d* corners[] = {&a, &b, &c};
    for (int i = 0; i < 3; ++i) addPart(0.5 * (*corners[i] + *corners[(i + 1) % 3]), vector / 3.0);
  }

  void addPart(const Eigen::Vector3d& index, const Eigen::Vector3d& areaVector) {
    const SplineField::SecondJet jet = field_.secondAt(field_.geometry().toPhysical(index));
    const double slope = jet.gradient.norm();
    if (!(slope > 1e-12)) {
      sums_.areaMm2 += areaVector.norm();
      return;
    }
    const Eigen::Vector3d n = jet.gradient / slope;
    const double along = n.dot(jet.hessian * n);
    // Signed distance from the zero set, outside positive.
    const double first = jet.value / slope;
    double distance = first + 0.5 * along / slope * first * first;
    const PrincipalCurvatures k = principalCurvatures(jet);
    // Where the field is no graph over the triangle, the triangle itself has to do.
    if (!(std::fabs(distance) < reachMm_)) distance = 0.0;
    const double stretch = (1.0 - distance * k.k1) * (1.0 - distance * k.k2);
    const double area = std::fabs(areaVector.dot(n)) * std::clamp(stretch, 0.5, 2.0);
    sums_.areaMm2 += area;
    sums_.correctionMm3 -= area * (distance + 0.5 * (k.k1 + k.k2) * distance * distance);
  }

  const SplineField& field_;
  int refine_;
  double reachMm_;
  Eigen::Matrix3d toPhysical_;
  std::vector<double> values_;
  Sums sums_;
};

constexpr int blockCells = 8;

/// Whether all of a block of cells is inside (-1) or outside (+1); 0 when the bounds do not tell.
int sideOf(const SplineField& field, const Index3& first, const Index3& last) {
  const std::array<double, 2> range = field.bounds(first, last);
  return range[1] < 0.0 ? -1 : range[0] >= 0.0 ? 1 : 0;
}

void addBlock(CellSums& sums, const SplineField& field, const Index3& first, const Index3& last) {
  const int side = sideOf(field, first, last);
  if (side > 0) return;
  if (side < 0) {
    sums.addInside(1.0 * (last[0] - first[0]) * (last[1] - first[1]) * (last[2] - first[2]));
    return;
  }
  for (int k = first[2]; k < last[2]; ++k)
    for (int j = first[1]; j < last[1]; ++j)
      for (int i = first[0]; i < last[0]; ++i) {
        const int cellSide = sideOf(field, {i, j, k}, {i + 1, j + 1, k + 1});
        if (cellSide < 0) sums.addInside(1.0);
        if (cellSide == 0) sums.addCell(Eigen::Vector3d(i, j, k));
      }
}

}  // namespace

ZeroSetMeasure measureZeroSet(const SplineField& phi, const Progress& progress, int refine) {
  const Geometry& g = phi.geometry();
  const auto blocks = [&g](int axis) {
    return (g.size[static_cast<std::size_t>(axis)] + blockCells - 2) / blockCells;
  };
  std::vector<Sums> parts(static_cast<std::size_t>(blocks(1) * blocks(2)));
  parallelForEach(parts.size(), 1, [&](std::size_t row) {
    CellSums sums(phi, refine);
    for (int block = 0; block < blocks(0); ++block) {
      progress.check();
      const Index3 start{blockCells * block, blockCells * (static_cast<int>(row) % blocks(1)),
                         blockCells * (static_cast<int>(row) / blocks(1))};
      Index3 end{};
      for (std::size_t a = 0; a < 3; ++a) end[a] = std::min(start[a] + blockCells, g.size[a] - 1);
      addBlock(sums, phi, start, end);
    }
    parts[row] = sums.sums();
  });
  ZeroSetMeasure result;
  const double voxelMm3 = std::fabs((g.direction * g.spacing.asDiagonal()).determinant());
  for (const Sums& part : parts) {
    result.volumeMm3 += voxelMm3 * part.voxels + part.correctionMm3;
    result.areaMm2 += part.areaMm2;
  }
  progress.report(1.0);
  return result;
}

}  // namespace angiomesh
