// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "core/quality/skeleton.h"
#include "core/surface/cut_away.h"
#include "core/surface/port.h"
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

/// @throws InputError unless parseCut() takes the name
void checkPortName(const std::string& name);

/// The parameters of ports.
struct PortParams {
  std::vector<std::string> cuts;  ///< as parseCut() takes them
  double cutEndsRadii = 0.0;      ///< ends are cut so far from their tips; 0: not
  bool cutBorders = false;        ///< see addBorderCuts()
  std::vector<std::string> names =
      {};  ///< "border_1=inlet": ports and what they are called instead
};

/// "border_1=inlet" as both names. @throws InputError, as checkPortName() for the second
std::array<std::string, 2> parsePortName(const std::string& text);

/// Gives ports the names that `params` has for them. @returns a warning for each name that cannot
/// be given: no such port, or another one has the name
std::vector<std::string> namePorts(const PortParams& params, std::vector<Port>& ports);

/// @throws InputError: two cuts or new names of one name, or as parseCut() and parsePortName()
void checkPorts(const PortParams& params);

/// Where a cut lies: at its point, or, of one that is not inside phi < 0, where the axis of the
/// vessel beside it meets its plane; without a normal across the vessel at its centre.
/// @throws InputError: no vessel there; without a normal as cutAway()   @throws Cancelled
CutPlane placeCut(const SplineField& field, const Volume<float>& phi, const GivenCut& cut,
                  const Progress& progress = {});

/// Cuts near the tips of vessels, with names.
struct EndPlan {
  std::vector<CutPlane> planes;
  std::vector<std::string> names;    ///< end_1 and on, without those of the given cuts
  std::vector<std::string> remarks;  ///< ends that are not cut, and why
  CutAway away;                      ///< of the given cuts and these, where there are any
};

/// proposeEndCuts() where no given cut lies in the way, as far as they can be cut.
/// @throws InputError as proposeEndCuts(), Cancelled
EndPlan planEndCuts(const SplineField& field, const Volume<float>& phi, const Skeleton& skeleton,
                    const CutAway& given, double radiiFromTip, const Progress& progress = {});

/// What the cuts take of phi, and remarks: ends that were not cut, cuts that end no single vessel
/// or lie too near to a branching. Ends are named end_1 and on, and left alone where a given cut
/// lies in the way. `field` interpolates `phi`.
/// @throws InputError as cutAway()   @throws Cancelled
CutAway makeCuts(const SplineField& field, const Volume<float>& phi, const PortParams& params,
                 std::vector<std::string>& remarks, const Progress& progress = {});

}  // namespace angiomesh
