// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/image/volume.h"

namespace angiomesh {

/// Which of `points` (x,y,z,... LPS mm) lie in voxels of the component (26-connected, phi < 0) that
/// holds `inner`: indices of points, ascending.
std::vector<std::size_t> pointsInComponent(const Volume<float>& phi, const Eigen::Vector3d& inner,
                                           const std::vector<double>& points);

}  // namespace angiomesh
