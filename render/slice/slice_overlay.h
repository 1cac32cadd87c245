// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <string>

#include "render/slice/pane_axes.h"
#include "render/slice/slice_raster.h"

class vtkRenderer;

namespace angiomesh {

/// A round length (1, 2 or 5 times a power of ten, mm) of at most `longestMm`.
double scaleBarLengthMm(double longestMm);

/// What a slice is called in the language of the window, UTF-8.
struct SliceWords {
  std::array<std::string, 3> planes{"Sagittal", "Coronal", "Axial"};
  std::array<std::string, 4> slabs{"", "MIP", "MinIP", "Mean"};  ///< by SlabMode
  std::string turned = "turned by %1°";                          ///< %1: degrees
  std::string patientAxes = "Patient axes";
};

/// What lies flat on a pane: direction letters in the middle of the four edges, lines of text in
/// the upper and lower left and upper right corners, a scale bar in the lower right one.
class SliceOverlay {
 public:
  explicit SliceOverlay(vtkRenderer* renderer);
  ~SliceOverlay();
  SliceOverlay(const SliceOverlay&) = delete;
  SliceOverlay& operator=(const SliceOverlay&) = delete;

  void setVisible(bool visible);
  /// From the next setTexts() on.
  void setWords(SliceWords words);
  void setLetters(const PaneAxes& axes);
  /// What the lines of text say of a slice.
  struct Texts {
    int plane = 2;  ///< 0 sagittal, 1 coronal, 2 axial
    int slice = 0, count = 0;
    bool patientAxes = false;
    double turnedDeg = 0.0;  ///< from where the plane began; 0: not at all
    double alongMm = 0.0;    ///< position of the slice's middle along the plane's axis, LPS
    Slab slab;
    double window = 0.0, level = 0.0;
    std::string caption;  ///< lines, upper right
    std::string pointer;  ///< lines, lower left above window and level; may be empty
  };
  void setTexts(const Texts& texts);
  /// To be called when the zoom or the pane's size has changed.
  void setScale(double mmPerPixel, int widthPixels, int heightPixels, double pixelRatio);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace angiomesh
