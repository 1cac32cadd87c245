// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/modality_habits.h"

#include <QSettings>
#include <algorithm>

#include "core/parameters/parameters.h"

namespace angiomesh {

namespace {

/// A file may write anything as its modality; a slash would open a group of settings.
QString keyOf(const char* habit, const std::string& modality) {
  QString letters;
  for (const char c : modality)
    if ((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')) letters += QLatin1Char(c);
  return QStringLiteral("modality/%1/%2")
      .arg(letters.isEmpty() ? QStringLiteral("unknown") : letters, QLatin1String(habit));
}

}  // namespace

QString presetFor(const std::string& modality) {
  const std::string made = modality == "CT" ? "ct" : "angiomesh";
  const QString known = QSettings().value(keyOf("preset", modality)).toString();
  const auto& names = presetNames();
  const bool exists = std::find(names.begin(), names.end(), known.toStdString()) != names.end();
  return exists ? known : QString::fromStdString(made);
}

void rememberPreset(const std::string& modality, const QString& preset) {
  QSettings().setValue(keyOf("preset", modality), preset);
}

}  // namespace angiomesh
