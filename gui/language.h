// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <vector>

namespace angiomesh {

struct Language {
  QString code;  ///< "de"; empty: the system's
  QString name;  ///< in the language itself
};

/// Those that the window speaks, English first.
const std::vector<Language>& languages();

/// The code chosen last, at first empty.
QString rememberedLanguage();
void rememberLanguage(const QString& code);

/// Texts of the program and of Qt's own dialogs, and how numbers are written, from the next window
/// on. In a language that is not among languages(): English. Call it once, before the first window.
void applyLanguage(const QString& code);

}  // namespace angiomesh
