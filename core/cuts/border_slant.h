// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/field/spline_field.h"
#include "core/openings/port.h"

namespace angiomesh {

/// How an opening at the volume's border lies to its vessel: against the nearest section across it,
/// on the ways that lead inwards from the opening, that does not reach the border, is about round
/// and, where it is much different, would end what the opening opens. Nothing where there is none
/// within four radii of the opening. `field` interpolates `phi`.
std::optional<BorderSlant> borderSlant(const SplineField& field, const Volume<float>& phi,
                                       const Port& port);

/// Gives the ports at the volume's border their slant, see borderSlant().
void measureSlants(const SplineField& field, const Volume<float>& phi, std::vector<Port>& ports);

/// A sentence for each port whose slant no solver should be given, and for those at the border of
/// which it is not known, but for small ones.
std::vector<std::string> slantWarnings(const std::vector<Port>& ports);

}  // namespace angiomesh
