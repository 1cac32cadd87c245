// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace angiomesh {

/// RGB, 0..1, of ports by numbers, repeating: told apart from the wall and, by most, from each
/// other (the palette of Okabe & Ito 2008).
std::array<double, 3> portColour(std::size_t number);

}  // namespace angiomesh
