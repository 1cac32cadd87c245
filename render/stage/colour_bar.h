// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>

#include <string>

class vtkLookupTable;
class vtkRenderer;
class vtkScalarBarActor;
class vtkTextActor;

namespace angiomesh {

/// The colours of values of triangles, red (bad) over pale yellow to blue (good), told apart with
/// any kind of colour vision; and the bar at the bottom of a 3D pane that explains them. Not
/// visible at first.
class ColourBar {
 public:
  /// Adds itself to the renderer, which has to live longer.
  explicit ColourBar(vtkRenderer* renderer);
  ~ColourBar();
  ColourBar(const ColourBar&) = delete;
  ColourBar& operator=(const ColourBar&) = delete;

  [[nodiscard]] vtkLookupTable* table() const;
  /// Red at `lo`, blue at `hi`, which may be less; grey without a value.
  void setRange(const std::string& title, double lo, double hi);
  void setVisible(bool visible);

 private:
  vtkNew<vtkLookupTable> table_;
  vtkNew<vtkScalarBarActor> bar_;
  vtkNew<vtkTextActor> title_;  // the bar's own title runs into its labels
};

}  // namespace angiomesh
