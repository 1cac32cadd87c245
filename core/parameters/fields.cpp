// SPDX-License-Identifier: BSD-3-Clause
#include "core/parameters/field_table.h"

namespace angiomesh {

const std::vector<Field>& parameterFields() {
  static const std::vector<Field> fields = [] {
    FieldTable table;
    addScanFields(table);
    addSegmentationFields(table);
    addSurfaceFields(table);
    std::vector<Field> all = table.take();
    for (Field& field : all) {
      if (field.ofMask) continue;
      field.idle = [among = field.idle](const Parameters& p) {
        if (isSegmented(p)) return std::string("it is used only for scans: this is a segmentation");
        return among ? among(p) : std::string();
      };
    }
    return all;
  }();
  return fields;
}

}  // namespace angiomesh
