// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The C library picks its exp, log and cos by processor, and they differ in the last bit. These use
// additions, multiplications, divisions and square roots only, so they give the same bits
// everywhere (compiled without contraction to fused multiply-add). An ulp is the distance to the
// next number.

namespace angiomesh {

/// e^x to 1.5 ulp; 0 below -708, infinity above 709.
double portableExp(double x);

/// Natural logarithm of x > 0 (normal numbers) to 3 ulp.
double portableLog(double x);

/// Cube root of x > 0 (normal numbers) to 1 ulp.
double portableCubeRoot(double x);

/// cos(2 pi x) and sin(2 pi x), |x| < 2^50; absolute error below 2.5e-16. The sine's grows with
/// |x|, by 2 pi times the rounding of x - 1/4.
double portableCosTurns(double x);
double portableSinTurns(double x);

}  // namespace angiomesh
