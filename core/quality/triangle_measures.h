// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// A figure of each triangle: to colour a mesh by, to count, and to find the worst places by.
struct TriangleMeasure {
  const char* key;    ///< in case files
  const char* label;  ///< English, to be translated
  const char* unit;   ///< "deg"; may be empty
  int digits;         ///< behind the point
  /// The ends of the scale, the same for all meshes; worst > best where less is better.
  double worst, best;
  bool fitted;                ///< the end that is not 0 follows the values instead
  const char* gateKey;        ///< what gates bound it by in the table of measures; empty: nothing
  std::vector<double> bands;  ///< usual limits besides
  const char* meaning;        ///< one line
  /// Of each triangle; not a number where it has none. @throws Cancelled
  std::vector<float> (*values)(const TriMesh&, const Progress&);

  [[nodiscard]] bool lessIsBetter() const { return worst > best; }
};
const std::vector<TriangleMeasure>& triangleMeasures();

/// A scale that all meshes share.
struct MeasureScale {
  double worst = 0.0, best = 1.0;
};
/// Of a fitted measure up to the 98th percentile of the mesh where that is largest.
/// @param meshes the values of each mesh; null and empty ones do not count
MeasureScale scaleOf(const TriangleMeasure& measure,
                     const std::vector<const std::vector<float>*>& meshes);

/// Where one band ends and the next begins.
struct BandLimit {
  double at;
  std::string gate;  ///< that it is a limit of; empty: of none
};
/// Ascending.
std::vector<BandLimit> bandLimits(const TriangleMeasure& measure);

/// Percent of the values that are numbers below the first limit, between that and the next, and so
/// on; a value on a limit belongs to the better side. All 0 without values.
std::vector<double> bandShares(const TriangleMeasure& measure, const std::vector<float>& values);

/// The triangles with the worst values, the worst first, of which no two have a vertex in common.
std::vector<std::uint32_t> worstTriangles(const TriangleMeasure& measure, const TriMesh& mesh,
                                          const std::vector<float>& values, std::size_t most);

}  // namespace angiomesh
