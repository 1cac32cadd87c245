// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/large_pages.h"

namespace angiomesh {

using Index3 = std::array<int, 3>;

/// A grid of voxels in patient space, LPS, mm: x = origin + direction * diag(spacing) * index.
/// `origin` is the centre of voxel (0, 0, 0); the columns of `direction` are unit vectors.
struct Geometry {
  Index3 size{0, 0, 0};
  Eigen::Vector3d spacing{1.0, 1.0, 1.0};
  Eigen::Vector3d origin{0.0, 0.0, 0.0};
  Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();

  [[nodiscard]] std::size_t voxelCount() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
           static_cast<std::size_t>(size[2]);
  }
  /// Position in memory of voxel (i, j, k): x runs fastest.
  [[nodiscard]] std::size_t offset(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(size[0]) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(k));
  }
  [[nodiscard]] Index3 indexOf(std::size_t offset) const {
    const auto nx = static_cast<std::size_t>(size[0]);
    const auto ny = static_cast<std::size_t>(size[1]);
    return {static_cast<int>(offset % nx), static_cast<int>(offset / nx % ny),
            static_cast<int>(offset / nx / ny)};
  }
  [[nodiscard]] bool contains(int i, int j, int k) const {
    return i >= 0 && j >= 0 && k >= 0 && i < size[0] && j < size[1] && k < size[2];
  }
  /// Continuous index -> LPS mm.
  [[nodiscard]] Eigen::Vector3d toPhysical(const Eigen::Vector3d& index) const {
    return origin + direction * spacing.cwiseProduct(index);
  }
  /// LPS mm -> continuous index. Uses the inverse of `direction`, which may be slightly skew.
  [[nodiscard]] Eigen::Vector3d toIndex(const Eigen::Vector3d& pointLps) const;
  /// Whether a point lies between the outermost voxel centres, to a tolerance in voxels.
  [[nodiscard]] bool holds(const Eigen::Vector3d& pointLps, double toleranceVoxels = 0.0) const;
  /// d index / d physical: the matrix that toIndex() applies.
  [[nodiscard]] Eigen::Matrix3d physicalToIndexMatrix() const;
  [[nodiscard]] double voxelVolumeMm3() const { return spacing.prod(); }
  /// Length of one working voxel, the unit of phi's tolerances: the smallest spacing, mm.
  [[nodiscard]] double voxelMm() const { return spacing.minCoeff(); }

  bool operator==(const Geometry& other) const;
};

/// Values on a grid; `voxels` holds geometry.voxelCount() values, x fastest.
template <class T>
struct Volume {
  Geometry geometry;
  BigVector<T> voxels;

  Volume() = default;
  explicit Volume(const Geometry& g, T value = T()) : geometry(g), voxels(g.voxelCount(), value) {}

  [[nodiscard]] T& at(int i, int j, int k) { return voxels[geometry.offset(i, j, k)]; }
  [[nodiscard]] const T& at(int i, int j, int k) const { return voxels[geometry.offset(i, j, k)]; }
};

/// Smallest and largest value of a non-empty volume.
std::array<float, 2> valueRange(const Volume<float>& image);

/// Of the voxels of a non-empty volume the percentile() at each of the given fractions (0..1):
/// linear between ranks.
std::vector<double> percentiles(const Volume<float>& image, const std::vector<double>& fractions);

/// Trilinear interpolation at a continuous index, clamped to the border.
double interpolateLinear(const Volume<float>& image, const Eigen::Vector3d& index);

/// What checkUsable() asks of the voxels, for those who looked at them on the way.
struct ValueFacts {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  float least = std::numeric_limits<float>::infinity();
  float greatest = -std::numeric_limits<float>::infinity();
  std::size_t firstNotFinite = none;  ///< in memory

  void add(const ValueFacts& other);
};

/// The facts of `count` values that begin at voxel `first`.
ValueFacts valueFacts(const float* values, std::size_t count, std::size_t first);
ValueFacts valueFacts(const Volume<float>& image);

/// @throws InputError unless the volume is 3D (each size >= 2), finite, not constant, with positive
/// spacing and an invertible direction. `where` names the source in the message.
void checkUsable(const Volume<float>& image, const std::string& where);
void checkUsable(const Geometry& geometry, const ValueFacts& values, const std::string& where);

/// Voxels labelled 1..count by component of `mask` != 0 (0 elsewhere), largest component first,
/// ties by position in memory; 26-connected, or 6-connected. `sizes[l - 1]` is the number of voxels
/// of label l.
struct Components {
  Volume<std::int32_t> labels;
  std::vector<std::size_t> sizes;
};
Components connectedComponents(const Volume<std::uint8_t>& mask, bool fullyConnected = true);

/// 1 where phi < 0, 0 elsewhere.
Volume<std::uint8_t> insideMask(const Volume<float>& phi);

/// Of the voxels in the outermost planes of a mask, the share that is not 0. Of vessels next to
/// nothing is; more than half is of a mask that is inside out.
double shareOfBorder(const Volume<std::uint8_t>& mask);

}  // namespace angiomesh
