// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/image/volume.h"
#include "io/volume/image_format.h"
#include "io/volume/voxel_data.h"

namespace angiomesh {

/// What the header of a MetaImage, NRRD or NIfTI file says, compared with the sizes of the files
/// that it speaks of: their voxels can be there.
struct ImageHeader {
  std::vector<std::uintmax_t> size;  ///< along the three axes of space
  VoxelData data;
  std::string modality;                       ///< "MR", "CT", "" when not stated
  std::vector<std::string> warnings;          ///< without the file's name
  Geometry geometry;                          ///< of the axes of space
  std::map<std::string, std::string> fields;  ///< of NRRD: the keys of other programs
};

/// Reads the header alone and asks for the sizes of files; nothing is as large as what it claims.
/// @throws IoError (truncated, missing, more voxels than the file can hold), InputError (a header
/// that makes no sense, or a kind of image that is not read)
ImageHeader readHeader(const std::filesystem::path& path, const ImageFormat& format);

ImageHeader readMetaImageHeader(const std::filesystem::path& path);
ImageHeader readNrrdHeader(const std::filesystem::path& path);
ImageHeader readNiftiHeader(const std::filesystem::path& path);

/// "2 x 3 x 4", and "2 x 3 x 4 x 5" where there are several volumes.
std::string sizeText(const ImageHeader& header);

}  // namespace angiomesh
