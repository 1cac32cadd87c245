// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>

namespace angiomesh {

/// As printf() writes it.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

/// The shortest text that reads back as the same number.
std::string shortestText(double value);

/// A place for a message: "L 12.3 P -4.5 S 67.8 mm".
std::string placeText(const Eigen::Vector3d& pointLps);

}  // namespace angiomesh
