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

/// A figure of MeshQuality. Reports, summaries, the inspector, gates and docs/quality.md come from
/// the table of these.
struct QualityMeasure {
  const char* key;    ///< in reports, nested by the dots
  const char* label;  ///< English, to be translated
  const char* unit;   ///< "mm"; may be empty
  MeasureKind kind;
  int digits;
  bool main;            ///< among the few that decide between meshes
  const char* meaning;  ///< one line
  /// Nothing where the mesh has no such figure.
  std::optional<double> (*value)(const MeshQuality&);
  /// The figure that gates go by, where that is another one; else null.
  std::optional<double> (*gated)(const MeshQuality&) = nullptr;
};

/// In the order of reports.
const std::vector<QualityMeasure>& qualityMeasures();

/// "12.35", "yes"; "-" where there is none. Numbers as in C.
std::string measureText(const QualityMeasure& measure, const MeshQuality& quality);

/// A named list of conditions on a mesh.
struct QualityGate {
  struct Limit {
    const char* key;
    double bound;
    bool atLeast;  ///< else at most
  };
  const char* name;
  const char* help;
  std::vector<Limit> limits;
};
const std::vector<QualityGate>& qualityGates();

/// The conditions that the mesh does not meet, in words: "least angle 12.00 deg, below 15".
std::vector<std::string> gateFailures(const QualityGate& gate, const MeshQuality& quality);

}  // namespace angiomesh
