// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include "gui/model/run_model.h"

namespace angiomesh {

/// What a pane or table says of what it shows.
struct ShownText {
  QString text;
  bool stale = false;  ///< not of the present parameters; the text says so

  bool operator==(const ShownText&) const = default;
};

/// @param shown the layer itself; null: the pane shows the source in its place
ShownText layerText(const ResultModel& results, Layer layer, bool shown);
/// A layer in colour over another one.
ShownText overlayText(ResultModel& results, Layer overlay);
/// The segmentation outlined on slices; empty where there is none.
ShownText contourText(const ResultModel& results, const RunModel& runs);
/// The surface of a 3D pane: the evolving one, a mesh, or that of a segmentation without a mesh.
/// Empty where there is none.
ShownText surfaceText(const ResultModel& results, const RunModel& runs, MeshKind kind);
/// A mesh of the case, or the one from a file; empty where there is none.
ShownText meshText(const ResultModel& results, MeshKind kind);
/// Whose the tables of meshes and parts are: "result 2b".
ShownText meshText(const ResultModel& results);

}  // namespace angiomesh
