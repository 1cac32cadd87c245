// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "io/scan/image_io.h"

namespace angiomesh {

/// The labels of an image: its values other than 0, ascending, by layers; empty where it is no
/// label image, because a value is negative or no whole number or there are more than 4096. Values
/// that other programs left nearly whole, or between 0 and 1, are taken as makeLabels() does.
/// ITK-SNAP, 3D Slicer (.seg.nrrd, with names and layers), nnU-Net, TotalSegmentator and plain
/// masks.
/// @throws IoError, InputError
std::vector<Label> readLabels(const std::filesystem::path& path, const Progress& progress = {});

/// Which voxels of a mask or label image are meant.
struct MaskChoice {
  std::string label;                ///< see chosenLabels()
  std::optional<double> threshold;  ///< voxels of this value and more, without labels
};

/// The labels of an image that looks like a segmentation: as readLabels(), but at most 255, and
/// neighbours within them alike, which the noise of a scan does not allow. Empty: a scan. `path` is
/// where the image came from.
std::vector<Label> labelsOfSegmentation(const std::filesystem::path& path,
                                        const Volume<float>& image, const Progress& progress = {});

/// The number of layers of a 3D Slicer segmentation whose segments overlap; 1 for any other file.
int segmentationLayers(const std::filesystem::path& path);

/// One layer of such a segmentation as an image of its labels. @throws as readImage()
LoadedImage readLayer(const std::filesystem::path& path, int layer, const Progress& progress = {});

struct LabelMask {
  Volume<std::uint8_t> mask;  ///< 1 where one of the labels is
  std::vector<Label> labels;  ///< the chosen ones
  bool onlyOne = false;       ///< the image has no other label
  std::vector<std::string> warnings;
};

/// The voxels of the chosen labels.
/// @throws IoError, InputError (no label image; no such label, or several and none chosen: the
/// message lists them)
LabelMask readLabel(const std::filesystem::path& path, const MaskChoice& choice,
                    const Progress& progress = {});

}  // namespace angiomesh
