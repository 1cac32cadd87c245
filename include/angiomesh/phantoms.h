// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Synthetic scans of vessels with known truth.
#include "core/phantom/phantom.h"
