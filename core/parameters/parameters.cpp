// SPDX-License-Identifier: BSD-3-Clause
#include "core/parameters/parameters.h"

#include "core/base/error.h"
#include "core/parameters/field.h"

namespace angiomesh {

void validate(const Parameters& params) {
  checkPartners(params);
  checkPorts(params.ports);
  if (!params.seeds.automatic && params.seeds.points.empty() && !isSegmented(params))
    throw InputError("there are no seeds", "seeds.automatic, seeds.points",
                     "give seeds by hand or turn seeds.automatic on");
}

bool evolves(const Parameters& params) {
  return params.segmentation.method == SegmentationMethod::LevelSet ||
         params.segmentation.method == SegmentationMethod::GeodesicActiveContour;
}

bool isSegmented(const Parameters& params) {
  return params.segmentation.method == SegmentationMethod::Label;
}

}  // namespace angiomesh
