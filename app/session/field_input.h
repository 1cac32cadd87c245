// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "core/parameters/parameters.h"
#include "io/scan/label_image.h"

namespace angiomesh::cli {

/// Reads a level set function, or a mask as the function that is -0.5 inside and 0.5 outside. A
/// file is a mask when none of its values is negative. Prints what the file is warned of.
Volume<float> readPhiOrMask(const std::string& path, std::optional<double> threshold = {});

/// readMask(); prints what the file is warned of.
Volume<std::uint8_t> readTruth(const std::string& path, std::optional<double> threshold = {});

/// The options --label and --threshold.
void addMaskChoice(CLI::App& command, MaskChoice& choice);

/// Where a surface comes from.
struct MeshInput {
  Volume<float> phi;
  // Of a mask or label image:
  std::vector<Label> labels;
  bool otherLabels = false;  ///< the image has more of them
  bool atBorder = false;     ///< the mask reaches the border of the volume
  std::size_t voxels = 0;
  double largestShiftVoxels = 0.0, maskVolumeMm3 = 0.0;  ///< see MaskDistance
};

/// A level set function (float, with negative values) as it is; of anything else the labels that
/// are chosen (see readLabel()) as the distance to a smooth wall. `params`, where there are any,
/// say how smooth the wall of a mask becomes, whether voxels that touch by an edge or a corner
/// alone are joined or parted (settleContacts()), and which parts are kept (selectSegments()).
/// Prints what there is to be warned of.
/// @throws IoError, InputError, Cancelled; NumericError: no part is kept
MeshInput readMeshInput(const std::string& path, const MaskChoice& choice, const Parameters* params,
                        const Progress& progress);

}  // namespace angiomesh::cli
