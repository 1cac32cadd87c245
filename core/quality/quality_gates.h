// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/quality/quality_table.h"

namespace angiomesh {

/// What the program can do about a mesh that misses a limit.
enum class GateFix {
  None,
  MeshAnew,    ///< by the advancing front, from the segmentation
  SmallerRho,  ///< surface.rho: shorter edges where the wall bends
  RemoveParts,
  CapEnds  ///< surface.border
};

/// A named list of conditions on a mesh.
struct QualityGate {
  struct Limit {
    const char* key;
    double bound;
    bool atLeast;     ///< else at most
    const char* why;  ///< what goes wrong beyond it, a sentence
    GateFix fix;
  };
  const char* name;
  const char* help;
  std::vector<Limit> limits;
};
const std::vector<QualityGate>& qualityGates();

/// What to do, a sentence; empty for None.
const char* fixText(GateFix fix);

/// A limit beside a mesh's figure. A figure that a mesh has not passes.
struct GateCheck {
  const QualityGate::Limit* limit;
  const QualityMeasure* measure;
  std::optional<double> value;
  bool passed;
};
/// In the order of the gate's limits.
std::vector<GateCheck> checkGate(const QualityGate& gate, const MeshQuality& quality);

/// "at least 30 deg", "none", "at most 1"; what the limit asks for.
std::string limitText(const GateCheck& check);
/// In words where it does not pass: "least angle 12.00 deg, below 15".
std::string failureText(const GateCheck& check);

/// The conditions that the mesh does not meet, in words.
std::vector<std::string> gateFailures(const QualityGate& gate, const MeshQuality& quality);

}  // namespace angiomesh
