// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/phantom/phantom.h"

namespace angiomesh::analytic {

/// A phantom in a cube of `side` voxels, as the literature's: bars were set on them; `radius` in
/// voxels.
inline PhantomParams paramsOf(PhantomKind kind, int side, double radius = 4.0) {
  PhantomParams params;
  params.kind = kind;
  params.size = {side, side, side};
  params.radius = radius;
  params.psf.kind = PointSpread::Kind::Subvoxels;
  return params;
}

}  // namespace angiomesh::analytic
