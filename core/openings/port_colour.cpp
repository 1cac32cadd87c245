// SPDX-License-Identifier: BSD-3-Clause
#include "core/openings/port_colour.h"

namespace angiomesh {

std::array<double, 3> portColour(std::size_t number) {
  static const std::array<std::array<double, 3>, 8> colours{{{0.34, 0.71, 0.91},
                                                             {0.95, 0.90, 0.26},
                                                             {0.15, 0.72, 0.52},
                                                             {0.85, 0.55, 0.78},
                                                             {0.94, 0.62, 0.05},
                                                             {0.30, 0.45, 0.90},
                                                             {0.65, 0.85, 0.33},
                                                             {0.60, 0.42, 0.85}}};
  return colours[number % colours.size()];
}

}  // namespace angiomesh
