// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>

#include "core/image/volume.h"

namespace angiomesh {

/// A small picture of a volume, in a PNG file that only the user can read.
struct CaseThumbnailJob {
  std::shared_ptr<const Volume<float>> image;
  std::filesystem::path path;
  int longestSide = 96;  ///< pixels

  /// Without a word where it fails: a row of a list without a picture is still a row.
  void execute() noexcept;
};

}  // namespace angiomesh
