// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The C library picks its exp, log and cos by processor, and they differ in the last bit. These use
// additions, multiplications, divisions and square roots alone, so they give the same bits
// everywhere (compiled without contraction to fused multiply-add). Relative error below 1e-14
// unless stated.

namespace angiomesh {

/// e^x; 0 below -708, infinity above 709.
double portableExp(double x);

/// Natural logarithm of x > 0 (normal numbers).
double portableLog(double x);

/// cos(2 pi x) and sin(2 pi x), |x| < 2^50; absolute error below 1e-14.
double portableCosTurns(double x);
double portableSinTurns(double x);

}  // namespace angiomesh
