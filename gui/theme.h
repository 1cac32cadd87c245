// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace angiomesh {

enum class Theme { System, Light, Dark };

/// Colours the whole program. System: as the platform has its windows.
void applyTheme(Theme theme);
/// The theme chosen last, at first the system's.
Theme rememberedTheme();
void rememberTheme(Theme theme);

}  // namespace angiomesh
