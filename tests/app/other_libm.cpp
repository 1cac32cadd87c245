// SPDX-License-Identifier: BSD-3-Clause
// Loaded before the C library: its functions that are not exact give the next number here, as those
// for another processor do now and then.
#include <cmath>

#define OTHER(name)                                                \
  extern "C" double name(double x) noexcept {                      \
    return std::nextafter(static_cast<double>(name##l(x)), 1e300); \
  }                                                                \
  extern "C" float name##f(float x) noexcept {                     \
    return std::nextafter(static_cast<float>(name(x)), 1e30F);     \
  }
#define OTHER_OF_TWO(name)                                            \
  extern "C" double name(double x, double y) noexcept {               \
    return std::nextafter(static_cast<double>(name##l(x, y)), 1e300); \
  }                                                                   \
  extern "C" float name##f(float x, float y) noexcept {               \
    return std::nextafter(static_cast<float>(name(x, y)), 1e30F);     \
  }

OTHER(sin)
OTHER(cos)
OTHER(tan)
OTHER(asin)
OTHER(acos)
OTHER(atan)
OTHER(sinh)
OTHER(cosh)
OTHER(tanh)
OTHER(exp)
OTHER(exp2)
OTHER(expm1)
OTHER(log)
OTHER(log2)
OTHER(log10)
OTHER(log1p)
OTHER(cbrt)
OTHER(erf)
OTHER(erfc)
OTHER_OF_TWO(atan2)
OTHER_OF_TWO(pow)
OTHER_OF_TWO(hypot)

extern "C" void sincos(double x, double* s, double* c) noexcept {
  *s = sin(x);
  *c = cos(x);
}
extern "C" void sincosf(float x, float* s, float* c) noexcept {
  *s = sinf(x);
  *c = cosf(x);
}
