// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/field/spline_field.h"
#include "core/image/volume.h"
#include "core/mesh/tri_mesh.h"
#include "core/quality/mesh_quality.h"
#include "core/sizing/sizing.h"

namespace angiomesh::cli {

/// How the surface of one panel is made; the start values are the thesis's.
struct PanelRecipe {
  bool marchingCubes = false;
  SplineKind spline = SplineKind::Bspline;
  SizingParams sizing;
  bool gradation = true;  ///< else the length of the curvature at the place alone
  bool taubin = false;

  PanelRecipe();
};

struct PanelResult {
  TriMesh mesh;
  MeshQuality quality;
  double seconds = 0.0;  ///< of meshing and smoothing
};

struct FigurePlan {
  std::string number, caption;
  std::vector<std::pair<std::string, PanelRecipe>> panels;  ///< title and recipe
};

/// Figures 4.1, 5.4, 5.5, 5.6, B.1 and B.2 of the thesis, in its settings.
std::vector<FigurePlan> thesisFigures();

/// Makes the surfaces of one level set function. Those that several figures show are made once.
class PanelMaker {
 public:
  explicit PanelMaker(const Volume<float>& phi) : phi_(phi) {}
  /// @throws InputError, Cancelled
  const PanelResult& make(const PanelRecipe& recipe, const Progress& progress);

 private:
  [[nodiscard]] TriMesh surface(const PanelRecipe& recipe, const Progress& progress) const;

  const Volume<float>& phi_;
  std::map<std::string, PanelResult> made_;
};

/// The cube of `side` mm that holds most vertices: where a picture of the triangles shows most.
std::array<double, 6> busiestBox(const TriMesh& mesh, double side);

}  // namespace angiomesh::cli
