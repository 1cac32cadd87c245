// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/centreline/skeleton.h"
#include "core/field/spline_field.h"
#include "core/image/volume.h"
#include "core/openings/cut_away.h"
#include "core/openings/port.h"

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

/// The names of cuts that are written so. @throws InputError
std::set<std::string> cutNames(const std::vector<std::string>& cuts);

/// @throws InputError unless parseCut() takes the name
void checkPortName(const std::string& name);

/// The parameters of ports.
struct PortParams {
  std::vector<std::string> cuts;  ///< as parseCut() takes them
  double cutEndsRadii = 0.0;      ///< ends are cut so far from their tips; 0: not
  bool cutBorders = false;        ///< see addBorderCuts()
  /// As parsePortNaming() takes them: ports and what they are called instead.
  std::vector<std::string> names = {};

  bool operator==(const PortParams&) const = default;
};

/// What a port is to be called that has not got its name from a cut.
struct PortNaming {
  std::string port;                         ///< the name that it has without it
  std::optional<Eigen::Vector3d> placeLps;  ///< or where it lies, mm
  std::string name;
};

/// "border_1=inlet", or "x,y,z=inlet" with the centre of the port. @throws InputError, as
/// checkPortName() for the new name
PortNaming parsePortNaming(const std::string& text);
std::string portNamingText(const PortNaming& naming);

/// Gives ports the names that `params` has for them. A place stands for the port whose centre is
/// nearest to it, at most one and a half of its radii off; a port with a name of a given cut has
/// its name already. @returns a warning for each name that cannot be given: no such port, or
/// another one has the name
std::vector<std::string> namePorts(const PortParams& params, std::vector<Port>& ports);

/// Adds to `params` what makes the same ports on another surface: cuts in place of those that come
/// from cuts, and names by their places for those at the volume's border that have been named.
void addPorts(const std::vector<Port>& ports, PortParams& params);

/// @throws InputError: two cuts or new names of one name, or as parseCut() and parsePortNaming()
void checkPorts(const PortParams& params);

/// Where a cut lies: at its point, or, of one that is not inside phi < 0, where the axis of the
/// vessel beside it meets its plane; without a normal across the vessel at its centre, or at the
/// nearest place where it can be cut across: along the vessel or just inside the volume's border.
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
