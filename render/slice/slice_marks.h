// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "render/marks/port_drag.h"
#include "render/marks/port_mark.h"
#include "render/slice/slice_raster.h"

class vtkRenderer;

namespace angiomesh {

/// The marks of ports in a slice pane: where a disc cuts the slice a line with an arrow along the
/// normal, and a disc that lies in the slice as its outline.
class SliceMarks {
 public:
  explicit SliceMarks(vtkRenderer* renderer);  ///< which outlives the marks
  ~SliceMarks();
  SliceMarks(const SliceMarks&) = delete;
  SliceMarks& operator=(const SliceMarks&) = delete;

  void set(std::vector<PortMark> marks);
  /// @param depth of the flat scene, towards the viewer
  void show(const SlicePlane& plane, bool visible, double depth, double pixelRatio);
  [[nodiscard]] const std::vector<PortMark>& marks() const;
  /// The movable mark nearest to a place of the slice last shown, mm, within `reachMm`: its line or
  /// the outer half of its arrow, which turns it.
  [[nodiscard]] std::optional<PortHit> at(const Eigen::Vector2d& place, double reachMm) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace angiomesh
