// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Inlets and outlets: cuts, openings, and their names.
#include "core/cuts/cuts.h"
#include "core/openings/port.h"
#include "io/vessel/ports_file.h"
