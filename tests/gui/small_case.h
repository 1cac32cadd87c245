// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>

#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "gui/model/case_models.h"

namespace angiomesh::test {

/// Two parallel tubes well apart: quick to segment, and two components.
inline Source twoTubes(int size = 40) {
  PhantomParams params;
  params.psf.kind = PointSpread::Kind::Subvoxels;
  params.kind = PhantomKind::Kissing;
  params.size = {size, size, size};
  params.spacingMm = {0.5, 0.5, 0.5};
  params.radius = 3.0;
  params.gap = 8.0;
  params.noiseSigma = 5.0;
  return makeSource(makePhantom(params).image, "two-tubes");
}

/// A tree whose evolution takes long enough to be watched.
inline Source slowTree() {
  PhantomParams params;
  params.psf.kind = PointSpread::Kind::Subvoxels;
  params.size = {48, 48, 48};
  params.radiusMax = 4.0;
  params.noiseSigma = 10.0;
  return makeSource(makePhantom(params).image, "tree");
}

/// Iterations that take long enough to act in the midst of them, and end by themselves.
constexpr int kLongEvolution = 5000;

/// An evolution that only ends after `iterations`: by default not in the time of a test.
inline void evolveFor(CaseModels& models, int iterations = 1000000) {
  models.document.setField("levelset.tolerance", 0.0);
  models.document.setField("levelset.toleranceDelta", 0.0);
  models.document.setField("levelset.checkEvery", std::int64_t(20));
  models.document.setField("levelset.maxIterations", std::int64_t(iterations));
}

}  // namespace angiomesh::test
