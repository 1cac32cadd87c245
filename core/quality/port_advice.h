// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/quality/skeleton.h"
#include "core/surface/cut_away.h"

namespace angiomesh {

/// Diameters of a port that flow solvers want between it and the next branching, so that the
/// profile given there has room to develop.
constexpr double kPortDiametersToBranching = 5.0;

/// What speaks against the places of cuts, in sentences: a section that passes other than one
/// vessel of the skeleton (of the same phi), or lies fewer than kPortDiametersToBranching of its
/// equivalent diameters from the next branching of what is left.
std::vector<std::string> portAdvice(const Skeleton& skeleton, const CutAway& away);

}  // namespace angiomesh
