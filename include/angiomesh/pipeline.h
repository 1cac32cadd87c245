// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// From a volume to a vessel surface: the steps, their results, progress and cancelling.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/report.h"
