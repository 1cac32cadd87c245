// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/image/volume.h"

namespace angiomesh {

/// The phi of an evolution in little memory: two bytes for a voxel near the front, and next to
/// nothing for the others. Values are kept to 1/50 working voxel, their signs exactly; beyond 2.5
/// working voxels, where the evolution knows the side only, all are that far off.
class PackedFront {
 public:
  /// @param phi in working voxels
  explicit PackedFront(const Volume<float>& phi);

  [[nodiscard]] Volume<float> unpacked() const;
  [[nodiscard]] std::size_t bytes() const { return runs_.size(); }

 private:
  Geometry geometry_;
  std::vector<std::uint8_t> runs_;  ///< a value, then how often it follows itself, base 128
};

}  // namespace angiomesh
