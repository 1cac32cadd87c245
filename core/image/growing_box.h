// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>

#include "core/image/voxel_box.h"

namespace angiomesh {

/// The least box of the voxels that were added.
class GrowingBox {
 public:
  void add(const Index3& p) {
    if (!box_) box_ = VoxelBox{p, p};
    for (std::size_t a = 0; a < 3; ++a) {
      box_->low[a] = std::min(box_->low[a], p[a]);
      box_->high[a] = std::max(box_->high[a], p[a]);
    }
  }
  /// Nothing as long as none was added.
  [[nodiscard]] const std::optional<VoxelBox>& box() const { return box_; }

 private:
  std::optional<VoxelBox> box_;
};

}  // namespace angiomesh
