// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <set>
#include <string>
#include <vector>

#include "core/cuts/cuts.h"

namespace angiomesh {

/// As a cut is written by hand: micrometres, and directions to as little.
GivenCut writtenCut(const CutPlane& plane, const std::string& name);

/// The names that cuts and openings have got.
std::set<std::string> namesIn(const PortParams& ports);

/// "inlet", "outlet", "outlet-2", ...: the first that is free.
std::string freePortName(const PortParams& ports);

/// An opening that is no cut, called `name` now, gets the name `wanted` by its place; empty: the
/// one that it has of itself.
PortParams withOpeningNamed(PortParams ports, const std::string& name,
                            const Eigen::Vector3d& placeLps, const std::string& wanted);

/// Cuts and names that were read, in place of those of the same name.
PortParams withPortsRead(PortParams ports, const PortParams& read);

}  // namespace angiomesh
