// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <string>

namespace angiomesh {

// What is remembered from one volume to the next of the same modality ("MR", "CT"; empty where the
// file does not tell).

/// The preset that was chosen last, else the one made for the modality.
QString presetFor(const std::string& modality);
void rememberPreset(const std::string& modality, const QString& preset);

}  // namespace angiomesh
