// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace angiomesh {

/// What a plain left click or drag does in a slice pane.
enum class Tool { Navigate, PickSeed, DrawRoi, CutVessel };

/// What the left button does with Tool::Navigate: window/level, or the crosshair.
enum class MouseScheme { Radiology, Engineering };

}  // namespace angiomesh
