// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "gui/report/report_job.h"

namespace angiomesh {

struct CaseModels;
class CaseMeasures;
class CaseReviewModel;

// The parts of a report, as HTML that is XML as well. None names a patient, a date or a file.

/// All before the first section: which program, which result, and of what grid.
QString reportHead(CaseModels& models);
QString reportEnd();
QString sectionTitle(const QString& title);

/// The measures of all meshes, with the better one marked.
QString qualitySection(const CaseModels& models);
/// Each gate and mesh: limits, what the mesh has, why it matters and what helps.
QString gateSection(const CaseModels& models);
/// Empty where there are none.
QString measurementSection(const CaseMeasures& measures);
/// Empty where nobody has reviewed.
QString reviewSection(const CaseReviewModel& review);
/// How the meshes were made, as a paragraph for a paper, in English.
QString methodsSection(const CaseModels& models);
/// The run that the meshes come from: warnings, steps and parameters.
QString runSection(const CaseModels& models);

}  // namespace angiomesh
