// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/centreline/skeleton.h"
#include "core/openings/cut_away.h"

namespace angiomesh {

/// Diameters of a port that flow solvers want between it and the next branching, so that the
/// profile given there has room to develop.
constexpr double kPortDiametersToBranching = 5.0;

struct PortAdvice {
  std::size_t cut = 0;
  std::string words;  ///< a sentence without its subject, the cut
};

/// What speaks against the places of cuts: a section that passes other than one
/// vessel of the skeleton (of the same phi), or lies fewer than kPortDiametersToBranching of its
/// equivalent diameters from the next branching of what is left.
std::vector<PortAdvice> portAdvice(const Skeleton& skeleton, const CutAway& away);

}  // namespace angiomesh
