// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "render/marks/measure_mark.h"
#include "render/slice/slice_raster.h"

namespace angiomesh {

class SliceScene;

/// What of a mark is seen in a slice, flat in mm: its lines as far as they lie within `halfSlices`
/// of the slice; a section that lies in the slice by its outline and diameters, and one that
/// crosses it by the lines in which the two meet.
DrawnMeasure drawnInSlice(const MeasureMark& mark, const SlicePlane& plane, double halfSlices);

/// The measurements in a slice pane. They follow the scene from frame to frame.
class SliceMeasures {
 public:
  explicit SliceMeasures(const SliceScene& scene);  ///< which outlives them
  ~SliceMeasures();
  SliceMeasures(const SliceMeasures&) = delete;
  SliceMeasures& operator=(const SliceMeasures&) = delete;

  void set(std::vector<MeasureMark> marks);
  void setPixelRatio(double ratio);
  /// The point of a named mark that the slice shows nearest to a display position, if it is within
  /// reach.
  [[nodiscard]] std::optional<MarkPoint> pointAt(const Eigen::Vector2d& at) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace angiomesh
