// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/centreline/voxel_set.h"
#include "core/image/volume.h"

namespace angiomesh {

/// The centre lines of the parts of a set of voxels: cheapest paths from tip to tip, a step's cost
/// its length over the squared distance to the wall (after Sato et al., TEASAR, 2000). What sticks
/// out less than 2 working voxels and a third of the vessel's radius has none. Keeps a reference to
/// the set, whose numbers stand for voxels here.
class CentreLines {
 public:
  /// One end of a path.
  struct PathEnd {
    bool joins = false;        ///< ends on another path
    std::size_t attached = 0;  ///< points before the outermost one at which another path joins it
    bool isAttached = false;
  };

  /// Neighbours all, from a tip (front) to where it joins another path, or to the root's tip
  /// (back). Where the front joins another path as well, closing a ring, its first step is longer.
  struct Path {
    std::vector<std::uint32_t> points;
    PathEnd front, back;
  };

  /// Where a centre line ends short of the tip of its path.
  struct LineEnd {
    enum class Kind { Joint, Border, Tip };
    Kind kind = Kind::Joint;
    std::size_t at = 0;  ///< points of the path before the line's last one
    /// From there on: to the face of the volume, or to the centre of a ball's end.
    double extraMm = 0.0;
  };

  /// @param phi signed distance in mm, negative inside, clamped at 5 working voxels or more
  CentreLines(const Volume<float>& phi, const VoxelSet& set);

  /// The paths of the part that holds voxel `start`, each joining earlier ones. `visited` gets the
  /// part's voxels, in no particular order.
  const std::vector<Path>& find(std::uint32_t start, std::vector<std::uint32_t>& visited,
                                const Progress& progress);

  /// At points.front(); `end` is that end of its path.
  [[nodiscard]] LineEnd endOf(const std::vector<std::uint32_t>& points, const PathEnd& end) const;

  /// Distance to the wall, mm; where phi is clamped by steps from voxel to voxel.
  [[nodiscard]] double wallMm(std::uint32_t n) const { return wall_[n]; }

 private:
  void findWallDistances(const Volume<float>& phi);
  std::uint32_t spread(std::uint32_t root, std::vector<std::uint32_t>& visited,
                       const Progress& progress);
  void addPath(std::uint32_t tip);
  void closeRing(Path& path);
  void cover(std::uint32_t path);
  void attach(std::uint32_t point);
  /// To the nearest face of the box of the voxels' centres, mm.
  [[nodiscard]] double toFace(std::uint32_t n) const;
  /// Whether the volume ends before the vessel does, beside a voxel.
  [[nodiscard]] bool isSliced(std::uint32_t n) const;
  [[nodiscard]] bool inOpening(std::uint32_t tip) const;
  [[nodiscard]] bool straightInside(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] std::optional<double> toBorder(const std::vector<std::uint32_t>& points,
                                               std::size_t from) const;
  [[nodiscard]] double reach(std::uint32_t n) const { return 1.3 * wall_[n] + 2.0 * voxelMm_; }

  const VoxelSet& set_;
  double voxelMm_;
  std::vector<double> wall_;          ///< distance to the wall, mm
  std::vector<double> cost_, along_;  ///< from the root: of the cheapest path, and its length
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> coveredBy_;  ///< the nearest earlier point of a path that reaches it
  std::vector<std::uint32_t> pathOf_;     ///< number of the path that a voxel is a point of
  std::vector<Path> paths_;
};

}  // namespace angiomesh
