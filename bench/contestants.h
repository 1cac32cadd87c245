// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/image/volume.h"
#include "core/mesh/tri_mesh.h"
#include "core/sizing/sizing.h"

namespace angiomesh::bench {

/// One way from phi to a surface.
struct Contestant {
  std::string name;
  std::function<TriMesh()> make;
};

/// All of them for one phi, which must outlive them. `edgeMm` is for those that know one edge
/// length only.
std::vector<Contestant> contestants(const Volume<float>& phi, const SizingParams& sizing,
                                    double edgeMm);

}  // namespace angiomesh::bench
