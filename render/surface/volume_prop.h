// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "render/surface/volume_look.h"

class vtkProp3D;

namespace angiomesh {

/// A volume seen through, as a prop in patient space.
class VolumeProp {
 public:
  VolumeProp();
  ~VolumeProp();
  VolumeProp(const VolumeProp&) = delete;
  VolumeProp& operator=(const VolumeProp&) = delete;

  [[nodiscard]] vtkProp3D* prop() const;
  void setVolume(std::shared_ptr<const DrawnVolume> volume);  ///< null shows nothing
  void setLook(const VolumeLook& look);
  /// Rays of our own on the processor, which are the faster ones where OpenGL runs in software. To
  /// be called before the first frame.
  void setSoftware(bool software);
  /// Sampling `coarseness` times coarser along the rays and across the picture; 1 is full quality.
  void setCoarseness(double coarseness);
  [[nodiscard]] double coarseness() const;
  /// Rays end at what the renderer has drawn before. A graphics card always does so.
  void setEndsAtSurfaces(bool ends);
  [[nodiscard]] double secondsOfLastFrame() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace angiomesh
