// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "core/openings/port.h"

namespace angiomesh {

/// How the case meshes the vessel; lengths in metres.
struct OpenFoamMesh {
  std::vector<std::string>
      patches;                    ///< names, the wall's first: words of letters, digits, '_', '-'
  std::vector<double> diameters;  ///< of the ports' circles
  Eigen::Vector3d low{0.0, 0.0, 0.0}, high{0.0, 0.0, 0.0};  ///< of the background mesh
  std::array<int, 3> cells{0, 0, 0};
  double cell = 0.0;  ///< edge in the background mesh; each level halves it
  /// Of each patch; the wall's is that of the widest port, and `finest` where it is curved.
  std::vector<int> levels;
  int finest = 0;
  Eigen::Vector3d inside{0.0, 0.0, 0.0};  ///< in the middle of a cell of the finest level
};

struct OpenFoamCase {
  OpenFoamMesh mesh;
  std::vector<std::string> warnings;
};

/// A case for OpenFOAM (openfoam.com; v1912 as in Debian 12, and later): the surface in metres, one
/// solid for each patch, and what blockMesh, surfaceFeatureExtract and snappyHexMesh need to fill
/// it, about 11 cells across each port, with a script that runs them. Port n names patch 1 + n of
/// the mesh.
///
/// All is written beside `folder` and renamed, so that the case is there as a whole or not at all.
/// `folder` may be there if it is empty; with `replace` the case's files in it are replaced, and
/// others stay.
/// @returns with a warning where the mesh has more than one component: snappyHexMesh fills one
/// @throws InputError: the mesh is not closed, has a patch without triangles or not one for each
/// port; the folder is not empty   @throws IoError   @throws NumericError: see pointInside()
OpenFoamCase writeOpenFoamCase(const TriMesh& mesh, const std::vector<Port>& ports,
                               const std::filesystem::path& folder, bool replace = false);

}  // namespace angiomesh
