// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace angiomesh {

/// How many mm a unit of length is: "um", "micron", "cm", "metres" ...; nothing for others.
std::optional<double> millimetresOf(const std::string& unit);

/// A warning.
std::string unknownUnit(const std::string& unit);

}  // namespace angiomesh
