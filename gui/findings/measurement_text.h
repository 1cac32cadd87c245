// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <cstddef>

#include "core/measure/measurement.h"

namespace angiomesh {

QString measurementTitle(MeasurementKind kind);
/// What to do to measure, with so many places picked already; a sentence.
QString measurementHint(MeasurementKind kind, std::size_t picked);
/// What a measurement comes to, in a line with units.
QString measurementValue(const Measurement& measurement);
/// How that is computed, in lines with its numbers.
QString measurementDetails(const Measurement& measurement);

}  // namespace angiomesh
