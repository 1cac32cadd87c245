// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "core/quality/quality_gates.h"
#include "core/surface/zero_set_mesh.h"
#include "gui/job/inspect_job.h"

namespace angiomesh {

/// The measures in the order of tables: what decides between meshes, then the rest; null stands for
/// the verified parts, which are of the surface and not of a mesh's quality.
const std::vector<const QualityMeasure*>& qualityRows();
/// "Min angle, mean, °".
QString qualityTitle(const QualityMeasure* measure);
/// What stands where there is no figure.
QString noFigure();
QString qualityValue(const QualityMeasure* measure, const MeshQuality* quality);

/// The gates that the window shows: solver and print.
std::vector<const QualityGate*> shownGates();
QString gateHelp(const QualityGate& gate);
/// "✕ solver: fails, 2 of 9", as HTML.
QString gateVerdict(const QualityGate& gate, const MeshQuality& quality);
/// Rows of an HTML table: passed or not, what, how much, how much it is to be. What fails comes
/// first, with why that matters and what helps.
QString gateRows(const QualityGate& gate, const MeshQuality& quality,
                 const std::function<GateFix(const GateCheck&)>& fixOf);
/// What helps a mesh of that kind, made by `method`: None for one from a file.
GateFix helpfulFix(const GateCheck& check, MeshKind kind, SurfaceMethod method);

/// The per cent of each band and mesh, as an HTML table.
QString bandTable(const MeasuredMeshes& measured);

}  // namespace angiomesh
