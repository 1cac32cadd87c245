// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "render/marks/measure_mark.h"

class vtkRenderer;

namespace angiomesh {

/// Measurements in a scene, before all else that it shows: lines, points and labels.
class MeasureMarks {
 public:
  explicit MeasureMarks(vtkRenderer* renderer);  ///< which outlives the marks
  ~MeasureMarks();
  MeasureMarks(const MeasureMarks&) = delete;
  MeasureMarks& operator=(const MeasureMarks&) = delete;

  /// In the renderer's world coordinates.
  void show(const std::vector<DrawnMeasure>& marks);
  /// Pixels of the screen per pixel that lines are designed for.
  void setPixelRatio(double ratio);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Of marks in a scene of patient space.
std::vector<DrawnMeasure> drawnInSpace(const std::vector<MeasureMark>& marks);

}  // namespace angiomesh
