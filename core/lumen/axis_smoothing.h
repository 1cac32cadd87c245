// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/progress.h"
#include "core/distance/cell_band.h"
#include "core/image/volume.h"

namespace angiomesh {

/// Unit directions along the vessels at the cells of a band, in working-voxel axes: the eigenvector
/// of least eigenvalue of the structure tensor (Weickert 1998), from gradients at scale 1 voxel,
/// averaged over about 1.5 voxels. The sign means nothing.
std::vector<Eigen::Vector3f> vesselAxes(const Volume<float>& image, const CellBand& band,
                                        const Progress& progress = {});

/// Smooths the image along the vessels and hardly across: f minimises
///
///   sum (f - I)^2 + along |H u|^2 + across |P H P|^2,
///
/// H the Hessian of f in working voxels by central differences, u the axis, P = 1 - u u^T. Straight
/// tubes of even brightness have H u = 0 and are left as they are, whatever their thickness. The
/// image is kept outside the band. Weights per cell; by conjugate gradients.
/// @return f at the cells
std::vector<float> smoothAlongAxes(const Volume<float>& image, const CellBand& band,
                                   const std::vector<Eigen::Vector3f>& axes,
                                   const std::vector<float>& along,
                                   const std::vector<float>& across, const Progress& progress = {});

/// Standard deviation of white noise at a set of voxels: the median absolute difference of a voxel
/// from the mean of its six neighbours, as it is for Gaussian noise. Voxels on a plateau (a
/// background that was set to one value) do not count, unless nine in ten lie on one: 0.
double noiseLevel(const Volume<float>& image, const std::vector<std::uint32_t>& voxels);

}  // namespace angiomesh
