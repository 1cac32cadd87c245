// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/image/projection.h"

namespace angiomesh::cli {

/// The coronal slice (of the grid axis nearest to posterior) where two segmentations on the image's
/// grid differ in most voxels; the middle one where they are equal.
int mostDifferentSlice(const Volume<float>& phi, const Volume<float>& other);

/// A coronal slice from the 1st to the 99.8th percentile, head up, the patient's right on the left,
/// pixels square; the voxels with phi < 0 tinted. `phi` on the image's grid, or null.
Picture coronalSlice(const Volume<float>& image, const Volume<float>* phi, int slice);

/// The MIP of the image from three sides, and below it a row for each phi, seen alike: see
/// previewPicture().
Picture projectionRows(const Volume<float>& image, const std::vector<const Volume<float>*>& phis);

/// Pictures of one width below one another.
Picture stacked(const std::vector<Picture>& pictures);

}  // namespace angiomesh::cli
