// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "gui/model/window_presets.h"

namespace angiomesh {

// What is remembered from one volume to the next of the same modality ("MR", "CT"; empty where the
// file does not tell).

/// The preset that was chosen last; empty: none was. It may not exist any more.
QString rememberedPreset(const std::string& modality);
void rememberPreset(const std::string& modality, const QString& preset);

/// The window that was set last, for another image. Numbers are remembered of CT alone, whose
/// values mean the same in each scan; of others it is that of the file or the percentiles, if one
/// of these was chosen. Nothing, if there is none that suits the image.
std::optional<WindowLevel> windowFor(const DisplayFacts& facts);
void rememberWindow(const std::string& modality, const WindowLevel& window);
void rememberWindow(const std::string& modality, WindowPreset preset);
void forgetWindow(const std::string& modality);

}  // namespace angiomesh
