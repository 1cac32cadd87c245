// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/quality/mesh_quality.h"

namespace angiomesh {

/// How a measure's number is written.
enum class MeasureKind {
  Count,
  YesNo,
  Fixed,       ///< with `digits` behind the point
  Significant  ///< with `digits` in all
};

/// Which of two figures is the better one, all else equal.
enum class Better { Neither, More, Less };

/// A figure of MeshQuality. Reports, summaries, the inspector, gates and docs/quality.md come from
/// the table of these.
struct QualityMeasure {
  const char* key;    ///< in reports, nested by the dots
  const char* label;  ///< English, to be translated
  const char* unit;   ///< "mm"; may be empty
  MeasureKind kind;
  int digits;
  bool main;  ///< among the few that decide between meshes
  Better better;
  const char* meaning;  ///< one line
  /// Nothing where the mesh has no such figure.
  std::optional<double> (*value)(const MeshQuality&);
  /// The figure that gates go by, where that is another one; else null.
  std::optional<double> (*gated)(const MeshQuality&) = nullptr;
};

/// In the order of reports.
const std::vector<QualityMeasure>& qualityMeasures();

/// "12.35", "yes". Numbers as in C.
std::string valueText(const QualityMeasure& measure, double value);
/// The same; "-" where there is none.
std::string measureText(const QualityMeasure& measure, const MeshQuality& quality);

/// Of the figures of several meshes those that are better than all others' and are written
/// otherwise, by index; none where all are alike, or neither is better.
std::vector<std::size_t> betterOnes(const QualityMeasure& measure,
                                    const std::vector<const MeshQuality*>& meshes);

/// The measure with that key, which must be there.
const QualityMeasure& qualityMeasure(const std::string& key);

}  // namespace angiomesh
