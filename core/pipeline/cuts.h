// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "core/surface/cut_away.h"
#include "core/surface/spline_field.h"

namespace angiomesh {

/// A cut as somebody asks for it.
struct GivenCut {
  Eigen::Vector3d pointLps{0.0, 0.0, 0.0};   ///< mm; in a vessel, or at most 2 voxels off its wall
  std::optional<Eigen::Vector3d> normalLps;  ///< outward; none: the vessel's axis, towards the side
                                             ///< that has less of it
  std::string name;
};

/// "x,y,z,NAME" or "x,y,z,nx,ny,nz,NAME". A name has letters, digits, '_', '-' and '.' only, and is
/// neither that of the wall nor one of those that openings at the volume's border get.
/// @throws InputError
GivenCut parseCut(const std::string& text);
std::string cutText(const GivenCut& cut);

/// The parameters of ports.
struct PortParams {
  std::vector<std::string> cuts;  ///< as parseCut() takes them
  double cutEndsRadii = 0.0;      ///< ends are cut so far from their tips; 0: not
};

/// @throws InputError: two cuts of one name, or as parseCut()
void checkPorts(const PortParams& params);

/// What the cuts take of phi, and remarks: ends that were not cut, cuts that end no single vessel
/// or lie too near to a branching. Ends are named end_1 and on, and left alone where a given cut
/// lies in the way. `field` interpolates `phi`.
/// @throws InputError as cutAway()   @throws Cancelled
CutAway makeCuts(const SplineField& field, const Volume<float>& phi, const PortParams& params,
                 std::vector<std::string>& remarks, const Progress& progress = {});

}  // namespace angiomesh
