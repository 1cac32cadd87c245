// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "core/phantom/phantom.h"
#include "tests/core/refusal.h"

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

/// Whether no phantom is made of parameters after a change, for a reason told in one line.
inline bool isRefused(PhantomParams params, const std::function<void(PhantomParams&)>& change) {
  change(params);
  const std::string message = messageOf([&] { makePhantom(params); });
  return !message.empty() && message.find('\n') == std::string::npos;
}

}  // namespace angiomesh::analytic
