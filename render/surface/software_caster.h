// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkRayCastImageDisplayHelper.h>
#include <vtkSmartPointer.h>
#include <vtkVolumeMapper.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/surface/volume_look.h"

namespace angiomesh {

/// Draws a volume by castRays(). The last picture is drawn again where a new one would be the same:
/// a surface that evolves in front of a projection then costs nothing of it.
class SoftwareCaster : public vtkVolumeMapper {
 public:
  static SoftwareCaster* New();

  void setVolume(std::shared_ptr<const DrawnVolume> volume);
  void setLook(const VolumeLook& look);
  /// Between samples, mm, and pixels of the window for each of the picture, across and upwards.
  void setSampling(double stepMm, double pixels);
  void setEndsAtSurfaces(bool ends);

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  SoftwareCaster();
  ~SoftwareCaster() override;

 private:
  /// All that the picture follows from, but for the clipping range, which never cuts the volume.
  struct Seen {
    std::array<double, 10> camera{};
    std::array<int, 2> size{0, 0};
    vtkMTimeType changed = 0;
    std::vector<float> depths;

    bool operator==(const Seen&) const = default;
  };

  [[nodiscard]] Seen seenBy(vtkRenderer* renderer);
  [[nodiscard]] std::vector<float> depthsOf(vtkRenderer* renderer) const;
  void cast(vtkRenderer* renderer);

  std::shared_ptr<const DrawnVolume> drawn_;
  VolumeLook look_;
  double stepMm_ = 1.0, pixels_ = 1.0;
  bool endsAtSurfaces_ = false;
  std::array<int, 2> pictureSize_{0, 0};
  std::vector<std::uint8_t> picture_;
  Seen seen_;
  vtkSmartPointer<vtkRayCastImageDisplayHelper> display_;
};

}  // namespace angiomesh
