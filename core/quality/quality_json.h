// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/json_text.h"
#include "core/quality/quality_table.h"

namespace angiomesh {

/// The measures that a mesh has, nested by the dots of their keys. `Json` is nlohmann's, in order.
template <class Json>
Json qualityJson(const MeshQuality& quality) {
  Json json = Json::object();
  for (const QualityMeasure& measure : qualityMeasures()) {
    const std::optional<double> value = measure.value(quality);
    if (!value) continue;
    Json& place = placeAt(json, measure.key);
    if (measure.kind == MeasureKind::YesNo)
      place = *value != 0.0;
    else if (measure.kind == MeasureKind::Count)
      place = static_cast<long long>(*value);
    else
      place = *value;
  }
  return json;
}

}  // namespace angiomesh
