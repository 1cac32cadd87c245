// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/quality_gates.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

namespace angiomesh {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace

const std::vector<QualityGate>& qualityGates() {
  using Limits = std::vector<QualityGate::Limit>;
  using F = GateFix;
  const auto and_ = [](Limits limits, const Limits& more) {
    limits.insert(limits.end(), more.begin(), more.end());
    return limits;
  };
  static constexpr const char* flat =
      "Flat triangles make flat cells beside the wall, where the solution is inexact.";
  static const Limits manifold{
      {"triangles", 1.0, true, "There is no surface.", F::None},
      {"oriented", 1.0, true, "Inside and outside cannot be told apart.", F::MeshAnew},
      {"non_manifold_edges", 0.0, false, "Volume meshers refuse a surface that forks at an edge.",
       F::MeshAnew},
      {"non_manifold_vertices", 0.0, false,
       "Volume meshers refuse a surface that touches itself at a vertex.", F::MeshAnew},
      {"degenerate_triangles", 0.0, false, "A triangle without area has no normal.", F::MeshAnew},
      {"self_intersections", 0.0, false,
       "Where the surface cuts itself, inside and outside are not defined.", F::SmallerRho}};
  static const Limits closed =
      and_(manifold,
           {{"boundary_edges", 0.0, false, "The inside leaks through open rims.", F::CapEnds}});
  static const std::vector<QualityGate> gates{
      {"manifold", "oriented, no non-manifold spot, degenerate triangle or self-intersection",
       manifold},
      {"closed", "as manifold, and no boundary edge", closed},
      {"cfd", "as closed, and no angle below 15 degrees",
       and_(closed, {{"min_angle_deg.min", 15.0, true, flat, F::SmallerRho}})},
      {"solver", "as closed, all angles from 30 to 110 degrees, all radius ratios at least 0.6",
       and_(closed, {{"min_angle_deg.min", 30.0, true, flat, F::SmallerRho},
                     {"max_angle_deg.max", 110.0, false, flat, F::SmallerRho},
                     {"radius_ratio.min", 0.6, true, flat, F::SmallerRho}})},
      {"print",
       "as closed, in one part, and thinner than 0.5 mm at no more than 1 % of the triangles",
       and_(closed,
            {{"components", 1.0, false, "Parts that do not hang together fall apart.",
              F::RemoveParts},
             {"thickness_mm.p01", 0.5, true,
              "What is thinner than the strand of a usual nozzle (0.4 mm wide) breaks or is left "
              "out.",
              F::RemoveParts}})},
  };
  return gates;
}

const char* fixText(GateFix fix) {
  switch (fix) {
    case GateFix::None:
      break;
    case GateFix::MeshAnew:
      return "Mesh the segmentation with surface.method advancing-front.";
    case GateFix::SmallerRho:
      return "Make surface.rho smaller: edges get shorter where the wall bends.";
    case GateFix::RemoveParts:
      return "Leave parts out: untick them, or raise segmentation.minVolumeMm3.";
    case GateFix::CapEnds:
      return "Close the ends: surface.border cap.";
  }
  return "";
}

std::vector<GateCheck> checkGate(const QualityGate& gate, const MeshQuality& quality) {
  std::vector<GateCheck> checks;
  for (const QualityGate::Limit& limit : gate.limits) {
    const QualityMeasure& measure = qualityMeasure(limit.key);
    const auto value = (measure.gated != nullptr ? measure.gated : measure.value)(quality);
    const bool passed = !value || (limit.atLeast ? *value >= limit.bound : *value <= limit.bound);
    checks.push_back({&limit, &measure, value, passed});
  }
  return checks;
}

std::string limitText(const GateCheck& check) {
  if (check.measure->kind == MeasureKind::YesNo) return "yes";
  if (!check.limit->atLeast && check.limit->bound == 0.0) return "none";
  const std::string unit = check.measure->unit;
  return (check.limit->atLeast ? "at least " : "at most ") + number(check.limit->bound) +
         (unit.empty() ? "" : " " + unit);
}

std::string failureText(const GateCheck& check) {
  if (check.passed) return {};
  const QualityMeasure& measure = *check.measure;
  std::string label = measure.label;
  label[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(label[0])));
  const std::string value = valueText(measure, *check.value);
  if (measure.kind == MeasureKind::YesNo) return "not " + label;
  if (measure.kind == MeasureKind::Count) return (*check.value > 0.0 ? value : "no") + " " + label;
  return label + " " + value + (*measure.unit != '\0' ? std::string(" ") + measure.unit : "") +
         (check.limit->atLeast ? ", below " : ", above ") + number(check.limit->bound);
}

std::vector<std::string> gateFailures(const QualityGate& gate, const MeshQuality& quality) {
  std::vector<std::string> failures;
  for (const GateCheck& check : checkGate(gate, quality))
    if (!check.passed) failures.push_back(failureText(check));
  return failures;
}

}  // namespace angiomesh
