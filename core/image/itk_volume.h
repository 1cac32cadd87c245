// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/image/volume.h"

// Only for sources that include ITK themselves: this header names its types, no more.
namespace itk {
template <class Pixel, unsigned int dimension>
class Image;
class ProcessObject;
template <class Object>
class SmartPointer;
}  // namespace itk

namespace angiomesh {

using ItkImage = itk::Image<float, 3>;

/// A copy, along the axes of the grid, with spacing in working voxels, so that ITK's widths and
/// speeds are, too.
itk::SmartPointer<ItkImage> toItk(const Volume<float>& image);

/// A copy of an image of that grid.
Volume<float> fromItk(const ItkImage& image, const Geometry& geometry);

/// Runs a filter to its end, passing on a wish to cancel: an exception may not cross ITK's events,
/// so the filter is asked to stop, and Cancelled follows once it has.
void runFilter(itk::ProcessObject& filter, const Progress& progress);

}  // namespace angiomesh
