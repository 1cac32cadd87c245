// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/projection.h"
#include "core/parameters/parameters.h"

namespace angiomesh::cli {

/// One segmentation of a figure.
struct SegmentationPanel {
  std::string title;
  std::size_t insideVoxels = 0, components = 0;
  int iterations = 0;
  std::optional<double> overlap;  ///< with the truth, %
};

struct SegmentationFigure {
  std::string number, caption;
  std::vector<SegmentationPanel> panels;  ///< from the top
  Picture picture;
};

/// The numbers of the figures that segmentationFigures() makes.
const std::vector<std::string>& segmentationFigureNumbers();

/// Figures 3.3 (the original measure, the modified one and the slice itself), 5.2 and 5.3 (MIP of
/// the image, then geodesic active contour, confidence connected and the level set) and A.1 to A.3
/// (MIP, then gamma, d and xi varied) of the thesis on one image. `truth` on the image's grid, or
/// null. A front that shrinks to nothing is an empty panel.
/// @throws InputError, NumericError, Cancelled
std::vector<SegmentationFigure> segmentationFigures(const Volume<float>& image,
                                                    const Volume<std::uint8_t>* truth,
                                                    const Parameters& params,
                                                    const Progress& progress);

}  // namespace angiomesh::cli
