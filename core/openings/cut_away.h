// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/field/spline_field.h"
#include "core/image/volume.h"
#include "core/openings/section.h"

namespace angiomesh {

/// What cuts take of the vessels: of each the part beyond its section, on the side of the normal,
/// and all that is connected to it other than through a section.
struct CutAway {
  std::vector<Section> sections;
  std::vector<std::string> names;  ///< of the cuts; may be fewer
  static constexpr std::uint8_t kOutside = 0, kLeft = 1, kTaken = 2;
  Volume<std::uint8_t> voxels;     ///< one of these each (outside phi < 0); empty without cuts
  std::vector<std::size_t> taken;  ///< per cut: voxels beyond it (those beyond two count twice)

  [[nodiscard]] bool empty() const { return sections.empty(); }
  [[nodiscard]] std::vector<CutPlane> planes() const;
  /// "the cut 'NAME'", or its number, for messages.
  [[nodiscard]] std::string nameOf(std::size_t cut) const;
  /// Whether the voxel inside phi < 0 that is nearest to a point is taken: among the corners of its
  /// cell, or, where none of these is inside, among those up to three cells around.
  [[nodiscard]] bool takenAt(const Eigen::Vector3d& pointLps) const;
  /// Whether a point of phi = 0 does not count for the surface that is left: its voxels are taken,
  /// or it lies within two voxels beyond a section.
  [[nodiscard]] bool beyond(const Eigen::Vector3d& pointLps) const;
};

/// Voxels are joined along the grid's axes.
/// @throws InputError naming the cut: its point is not inside phi < 0, it reaches the outermost
/// voxel centres, another cut or what another cut takes, or both of its sides are connected, so
/// that it ends no vessel   @throws Cancelled
CutAway cutAway(const SplineField& field, const Volume<float>& phi,
                const std::vector<CutPlane>& cuts, const std::vector<std::string>& names = {},
                const Progress& progress = {});

/// phi of what cuts leave: signed distance, negative inside, ended by the planes; redistanced, mm,
/// clamped at +-5 working voxels. The sign at voxel centres is exact.
Volume<float> phiWithout(const Volume<float>& phi, const CutAway& away,
                         const Progress& progress = {});

}  // namespace angiomesh
