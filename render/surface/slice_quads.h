// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "render/slice/slice_scene.h"

class vtkRenderer;

namespace angiomesh {

/// The slices of other panes where they lie in patient space, as those panes cast them, with what
/// lies over them in colour.
class SliceQuads {
 public:
  explicit SliceQuads(vtkRenderer* renderer);  ///< which outlives the quads
  ~SliceQuads();
  SliceQuads(const SliceQuads&) = delete;
  SliceQuads& operator=(const SliceQuads&) = delete;

  /// Scenes that live as long as they are shown here. @returns whether anything has changed
  bool show(const std::vector<const SliceScene*>& scenes);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace angiomesh
