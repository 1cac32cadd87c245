// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/pipeline.h"
#include "core/quality/overlap.h"

namespace angiomesh::cli {

struct NamedQuality {
  std::string name;
  const MeshQuality* quality;
};

/// Mesh qualities side by side, one column each, on stdout.
void printQualities(const std::vector<NamedQuality>& columns);

/// A line for each port, on stdout.
void printPorts(const std::vector<Port>& ports);

/// One line on how a surface came to be, on stdout.
void printSurface(std::size_t triangles, const SurfaceOrigin& origin);

/// One line of overlap measures on stdout.
void printOverlap(const OverlapMeasures& measures);

/// What a run did, on stdout: sizes, segmentation, warnings, seconds per stage, mesh beside
/// marching cubes.
void printSummary(const RunResult& result, const std::optional<OverlapMeasures>& truth);

}  // namespace angiomesh::cli
