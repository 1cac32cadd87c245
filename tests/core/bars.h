// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QtGlobal>
#include <cmath>

// Whether a measured value keeps a bar; one that does not is told before the test that asks fails.
namespace angiomesh {

inline bool isBelow(double value, double bar) {
  if (value < bar) return true;
  qWarning("%g is not below %g", value, bar);
  return false;
}

inline bool isAbove(double value, double bar) {
  if (value > bar) return true;
  qWarning("%g is not above %g", value, bar);
  return false;
}

inline bool isNear(double value, double expected, double tolerance) {
  if (std::fabs(value - expected) < tolerance) return true;
  qWarning("%g is %g or more from %g", value, tolerance, expected);
  return false;
}

}  // namespace angiomesh
