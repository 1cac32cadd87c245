// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/image/volume.h"
#include "render/slice/pane_grid.h"
#include "render/slice/slice_raster.h"

class vtkImageData;
class vtkRenderer;

namespace angiomesh {

/// Values in colour over a slice. Of a range that begins below zero, what is below it is blue, what
/// is above orange; else all is from dark red to yellow. The closer a value is to zero, or to the
/// range's beginning, the less of it is seen.
struct ColourLayer {
  std::shared_ptr<const Volume<float>> values;  ///< on any grid; null: none
  double from = 0.0, to = 1.0;
  double opacity = 0.5;  ///< of what is seen most, 0..1

  bool operator==(const ColourLayer&) const = default;
};

/// RGB, 0..255, and opacity, 0..255, of a value of a layer.
std::array<unsigned char, 4> overlayColour(const ColourLayer& layer, float value);

/// The image of a slice pane, as it is cast, and what lies over it in colour.
class SlicePixels {
 public:
  explicit SlicePixels(vtkRenderer* renderer);  ///< which outlives the pixels
  ~SlicePixels();
  SlicePixels(const SlicePixels&) = delete;
  SlicePixels& operator=(const SlicePixels&) = delete;

  void setImage(std::shared_ptr<const Volume<float>> image);  ///< null shows nothing
  [[nodiscard]] const std::shared_ptr<const Volume<float>>& image() const;
  void setOverlay(const ColourLayer& layer);
  /// Casts slices first..last of the grid around `plane`; to be called after each change of the
  /// image or the overlay, too.
  void show(const PaneGrid& pane, const SlicePlane& plane, SlabMode mode, int slice, int first,
            int last);

  void setWindowLevel(double window, double level);
  [[nodiscard]] double window() const;
  [[nodiscard]] double level() const;
  void setInterpolated(bool on);

  /// What is shown at the pixel nearest to `lps`: see SliceScene::Probe.
  struct Probe {
    float value = 0.0F;
    Index3 voxel{0, 0, 0};
    Eigen::Vector3d placeLps{0.0, 0.0, 0.0};
    std::optional<float> overlay;
  };
  [[nodiscard]] std::optional<Probe> probe(const Eigen::Vector3d& lps) const;

  /// The pixels in grey (values) and in colour (RGBA; without dimensions where there are none).
  [[nodiscard]] vtkImageData* grey() const;
  [[nodiscard]] vtkImageData* colour() const;
  [[nodiscard]] bool overlaid() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace angiomesh
