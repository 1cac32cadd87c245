// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/measure/measurement.h"

namespace angiomesh {

/// A table of comma-separated values (RFC 4180), one line for each thing that was measured, its
/// columns named with units; what a line does not have is empty. In the column "part": "whole" for
/// the measurement, "from" and "to" for the ends of a distance, "narrowest", "proximal" and
/// "distal" for the sections of a stenosis, "along" for the points of a profile. The column
/// "parameters" says whether the wall was that of the present ones ("present") or an earlier one
/// ("earlier").
/// @param key of the step evolve by the present parameters
std::string measurementsTable(const std::vector<Measurement>& measurements, const std::string& key);

/// @throws IoError: what was at `path` stays
void writeMeasurements(const std::filesystem::path& path,
                       const std::vector<Measurement>& measurements, const std::string& key);

}  // namespace angiomesh
