// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/openings/port.h"

namespace angiomesh {

/// A port's kind in JSON: a cut, or where a vessel leaves the volume.
constexpr const char* kCutKind = "cut";
constexpr const char* kBorderKind = "border";

/// A port as ports.json and the report have it: mm, LPS; "vessel" where its slant is known. `Json`
/// is nlohmann's, in order.
template <class Json>
Json portJson(const Port& port) {
  const auto numbers = [](const Eigen::Vector3d& v) { return Json{v.x(), v.y(), v.z()}; };
  Json json = {{"name", port.name},
               {"kind", port.atBorder ? kBorderKind : kCutKind},
               {"centre_mm", numbers(port.centreLps)},
               {"normal", numbers(port.normalLps)},
               {"area_mm2", port.areaMm2},
               {"equivalent_diameter_mm", port.equivalentDiameterMm()}};
  if (port.slant)
    json["vessel"] = {{"angle_deg", port.slant->angleDeg},
                      {"area_ratio", port.slant->areaRatio},
                      {"section_area_mm2", port.slant->sectionAreaMm2},
                      {"section_centre_mm", numbers(port.slant->centreLps)},
                      {"axis", numbers(port.slant->axisLps)}};
  return json;
}

}  // namespace angiomesh
