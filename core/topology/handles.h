// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// Hole: the loop is shorter than 8 voxels, so what it goes around is about a voxel wide. Thin: it
/// closes through a section less than half a voxel deep, as where vessels touch. Both are below
/// what voxels tell; a loop is most likely real.
enum class HandleKind { Loop, Hole, Thin };

/// A loop of the vessels: a real one (the circle of Willis, a fistula), vessels that touch twice,
/// or a hole through one.
struct Handle {
  HandleKind kind = HandleKind::Loop;
  int component = 0;                        ///< from 1, see connectedComponents()
  Eigen::Vector3d placeLps{0.0, 0.0, 0.0};  ///< a voxel in the middle of its thinnest section, mm
  double depthMm = 0.0;                     ///< -phi there: about the radius of that section
  double lengthMm = 0.0;                    ///< of the shortest loop of voxels through that section
  bool lengthIsLeast = false;  ///< no loop was found up to lengthMm, where the search ended
  Eigen::Vector3d centreLps{0.0, 0.0, 0.0};  ///< of that loop: in the hole, where it is short
};

/// The handles of the 26-connected components of phi < 0 (background 6-connected), the shortest
/// loop first: as many as the genus of the wall, its cavities apart. Each component is grown from
/// its deepest voxel, deepest voxels first, by voxels that change no topology; where none is left
/// and two fronts meet, a loop closes in its thinnest section. The same for any number of threads.
/// @param phi signed distance, mm, negative inside   @throws Cancelled
std::vector<Handle> handlesOf(const Volume<float>& phi, const Progress& progress = {});

}  // namespace angiomesh
