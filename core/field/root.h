// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace angiomesh {

/// The zero in 0..1 of a function of different signs f0 at 0 and f1 at 1, by false position
/// (Illinois): to 1e-12, and not nearer than 1e-5 to either end.
template <class F>
double falsePosition(F value, double f0, double f1) {
  double t0 = 0.0, t1 = 1.0, t = 0.5;
  const bool negative = f0 < 0.0;
  int kept = 0;  // which end stayed last: -1 the lower, 1 the upper
  for (int n = 0; n < 60 && t1 - t0 > 1e-12; ++n) {
    t = (t0 * f1 - t1 * f0) / (f1 - f0);
    const double f = value(t);
    if (std::fabs(f) < 1e-13) break;
    if ((f < 0.0) == negative) {
      t0 = t;
      f0 = f;
      if (kept == 1) f1 *= 0.5;
      kept = 1;
    } else {
      t1 = t;
      f1 = f;
      if (kept == -1) f0 *= 0.5;
      kept = -1;
    }
  }
  return std::clamp(t, 1e-5, 1.0 - 1e-5);
}

}  // namespace angiomesh
