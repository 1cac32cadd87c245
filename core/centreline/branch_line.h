// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "core/centreline/lumen_probe.h"
#include "core/centreline/skeleton.h"

namespace angiomesh {

using Polyline = std::vector<Eigen::Vector3d>;

/// A moving mean over `half` points on either side, fewer towards the ends, which stay.
Polyline smoothed(const Polyline& line, std::size_t half);

double lengthOf(const Polyline& line);

/// Unit direction at point n of a curve through the points up to `reach` on either side; 0 where
/// they coincide.
Eigen::Vector3d tangentAt(const Polyline& line, std::size_t n, std::size_t reach);

/// A branch on its way from a chain of voxels to a centre line. Lengths in mm, points LPS.
class BranchLine {
 public:
  struct End {
    NodeKind kind = NodeKind::Tip;
    std::size_t inJunction = 0;  ///< points within the reach of the other vessels of a junction
  };

  /// @param line two or more points, about a voxel apart
  BranchLine(const LumenProbe& probe, const Polyline& line, const std::array<End, 2>& ends);

  /// Where the line comes out of the junction at its end 0 or 1.
  struct Entry {
    Eigen::Vector3d point{0.0, 0.0, 0.0};
    Eigen::Vector3d direction{0.0, 0.0, 1.0};  ///< unit, into the junction; 0 of a lone point
    double radiusMm = 0.0;
  };
  [[nodiscard]] Entry entry(std::size_t end) const;

  /// The whole line, which begins and ends in the given places where its ends are junctions.
  /// Once.
  [[nodiscard]] SkeletonBranch finished(const std::array<Eigen::Vector3d, 2>& junctions);

 private:
  void cutAt(std::size_t end, const Eigen::Vector3d& place);
  void leaveJunction(std::size_t end);
  void extend(std::size_t end);
  void extendToBorder();
  void extendToTip();
  void wrapRing();
  void unwrapRing();
  void centre();
  void measure(SkeletonBranch& branch, double from, double to) const;
  [[nodiscard]] Polyline throughJunction(std::size_t end, const Eigen::Vector3d& place) const;

  const LumenProbe& probe_;
  std::array<End, 2> ends_;
  Polyline line_;               ///< outside the junctions
  bool isOutside_ = true;       ///< false: all of it is in junctions, `line_` is a point half-way
  std::size_t wrapped_ = 0;     ///< points of a ring that stand at either end once more
  std::vector<double> radius_;  ///< at the points of line_
};

}  // namespace angiomesh
