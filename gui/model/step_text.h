// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include "core/parameters/field.h"
#include "core/pipeline/pipeline.h"
#include "gui/model/case_controller.h"

namespace angiomesh {

/// What the window calls a step, a layer and a mesh.
QString stepTitle(Step step);
QString layerTitle(Layer layer);
QString meshTitle(MeshKind kind);

/// The step whose result a parameter goes into.
Step stepOfField(const Field& field);

/// "512 × 512 × 120 voxels of 0.41 × 0.41 × 1.5 mm".
QString gridText(const Geometry& grid);

/// "40.00 × 30.00 × 20.00 mm", of a size in `unit`.
QString boxSizeText(const Eigen::Vector3d& size, LengthUnit unit);

/// How the window names and scales a parameter. The value shown is factor times the value stored.
struct FieldPresentation {
  QString label;
  QString unit;
  double factor = 1.0;
};
FieldPresentation presentationOf(const Field& field);

}  // namespace angiomesh
