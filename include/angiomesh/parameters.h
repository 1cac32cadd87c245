// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Parameters of a run, their description, presets, and their JSON.
#include "core/parameters/field.h"
#include "core/parameters/parameters.h"
