// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace angiomesh {

/// to = w[0] centre + sum over m = 1 .. radius of w[m] (low[m - 1] + high[m - 1]), for `width`
/// samples; the rows may be the same ones.
void sumRows(const float* centre, const float* const* low, const float* const* high,
             const float* weights, int radius, int width, float* to);

/// Samples at a distance before and after a row, linearly between two rows each.
struct ShiftedRows {
  const float *before0, *before1, *after0, *after1;
  float beforeT, afterT;
};

/// Half the difference of the samples after and before.
void firstDifference(const ShiftedRows& rows, int width, float* to);

/// The samples before and after less twice the centre.
void secondDifference(const ShiftedRows& rows, const float* centre, int width, float* to);

/// What eq. 3.15 and 3.22 need besides the Hessian.
struct MeasureRow {
  float scale = 1.0F;               ///< 1 / c, negative for dark vessels
  bool negative = true;             ///< the branch beside vessels
  float plate = 2.0F, blob = 2.0F;  ///< 1 / (2 alpha^2), 1 / (2 beta^2)
};

/// Writes v of eq. 3.22 over `v` where its magnitude is larger, for `width` Hessians {xx, yy, zz,
/// xy, xz, yz}. Eigenvalues in closed form, single precision: those of a tube's section are 3e-4 of
/// their size off where they are equal.
void mergeMeasure(const std::array<const float*, 6>& hessian, const MeasureRow& measure, int width,
                  float* v);

}  // namespace angiomesh
