// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "core/measure/review.h"
#include "core/pipeline/pipeline.h"
#include "core/quality/overlap.h"

namespace angiomesh {

/// report.json of a run (schema 1): see docs/report.md. Blocks of steps that did not run are
/// absent.
std::string runReportJson(const RunResult& result, const std::optional<OverlapMeasures>& truth = {},
                          const CaseReview& review = {});

/// One block alone, as {"schema": 1, "surface": {...}} and so on.
std::string surfaceJson(const SurfaceOrigin& origin);
std::string overlapJson(const OverlapMeasures& measures);

/// The last mesh of a run; null where it made none.
const TriMesh* finalMesh(const RunResult& result);

/// Of vertices, triangles and patches, as numbers in memory: the same for the same mesh, whatever
/// file it goes into. 16 hexadecimal digits.
std::string meshHash(const TriMesh& mesh);

/// The version of the library, "0.1.0".
const char* versionText();

}  // namespace angiomesh
