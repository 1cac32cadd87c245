// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "render/marks/port_drag.h"
#include "render/marks/port_mark.h"

class vtkRenderer;

namespace angiomesh {

/// The marks of ports in a 3D scene: translucent discs with rims, arrows and names.
class PortMarks {
 public:
  explicit PortMarks(vtkRenderer* renderer);  ///< which outlives the marks
  ~PortMarks();
  PortMarks(const PortMarks&) = delete;
  PortMarks& operator=(const PortMarks&) = delete;

  void set(std::vector<PortMark> marks);
  [[nodiscard]] const std::vector<PortMark>& marks() const;
  /// To be called before each frame: arrows and names keep a size on the screen.
  void follow(double pixelRatio);

  /// The movable mark at a display position; arrows lie before discs.
  [[nodiscard]] std::optional<PortHit> at(double displayX, double displayY) const;
  [[nodiscard]] double arrowMm(std::size_t mark) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace angiomesh
