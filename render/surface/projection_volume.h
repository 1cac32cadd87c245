// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "core/image/volume.h"

class vtkProp3D;

namespace angiomesh {

/// The maximum intensity projection of an image as a prop in patient space.
class ProjectionVolume {
 public:
  ProjectionVolume();
  ~ProjectionVolume();
  ProjectionVolume(const ProjectionVolume&) = delete;
  ProjectionVolume& operator=(const ProjectionVolume&) = delete;

  [[nodiscard]] vtkProp3D* prop() const;
  void setImage(const std::shared_ptr<const Volume<float>>& image);
  /// Values from which and up to which the grey goes from transparent to opaque white.
  void setWindow(double from, double to);
  /// Ray casting by the processor, which is the faster one where OpenGL runs in software. To be
  /// called before the first frame.
  void setSoftware(bool software);
  /// Sampling `coarseness` times coarser along the rays and across the picture; 1 is full quality.
  void setCoarseness(double coarseness);
  [[nodiscard]] double coarseness() const;
  [[nodiscard]] double secondsOfLastFrame() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace angiomesh
