// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include "core/parameters/field.h"
#include "core/quality/triangle_measures.h"
#include "gui/model/result_model.h"
#include "io/mesh/mesh_io.h"

namespace angiomesh {

/// What the window calls a step, a layer and a mesh.
QString stepTitle(Step step);
QString layerTitle(Layer layer);
QString meshTitle(MeshKind kind);
/// "°" for "deg", "mm²" for "mm2".
QString unitText(const char* unit);
/// "Smallest angle, °".
QString measureTitle(const TriangleMeasure& measure);
/// With as many digits as the measure has.
QString measureValue(const TriangleMeasure& measure, double value);

/// "512 × 512 × 120 voxels of 0.41 × 0.41 × 1.5 mm".
QString gridText(const Geometry& grid);

/// "40.00 × 30.00 × 20.00 mm", of a size in `unit`.
QString boxSizeText(const Eigen::Vector3d& size, LengthUnit unit);

/// "a few seconds", "about 40 s", "about 3 min": as exactly as an estimate is worth.
QString durationText(double seconds);

/// What a form calls a parameter.
QString labelOf(const Field& field);

}  // namespace angiomesh
