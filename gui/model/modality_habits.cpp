// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/modality_habits.h"

#include <QSettings>
#include <QStringList>
#include <cmath>

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

const QString kFileWindow = QStringLiteral("file");
const QString kPercentileWindow = QStringLiteral("percentiles");

}  // namespace

QString rememberedPreset(const std::string& modality) {
  return QSettings().value(keyOf("preset", modality)).toString();
}

void rememberPreset(const std::string& modality, const QString& preset) {
  QSettings().setValue(keyOf("preset", modality), preset);
}

std::optional<WindowLevel> windowFor(const DisplayFacts& facts) {
  const QStringList words =
      QSettings().value(keyOf("window", facts.modality)).toString().split(QLatin1Char(' '));
  if (words.front() == kFileWindow) return facts.fileWindow;
  if (words.front() == kPercentileWindow) return facts.percentileWindow;
  bool window = false, level = false;
  const WindowLevel numbers(words.front().toDouble(&window), words.back().toDouble(&level));
  if (words.size() != 2 || !window || !level || !std::isfinite(numbers.first) ||
      !std::isfinite(numbers.second) || !(numbers.first > 0.0))
    return std::nullopt;
  return imageLimits(facts).bounded(numbers);
}

void rememberWindow(const std::string& modality, const WindowLevel& window) {
  if (modality != "CT") return;
  QSettings().setValue(keyOf("window", modality),
                       QStringLiteral("%1 %2").arg(window.first).arg(window.second));
}

void rememberWindow(const std::string& modality, WindowPreset preset) {
  if (preset != WindowPreset::File && preset != WindowPreset::Percentiles) return;
  QSettings().setValue(keyOf("window", modality),
                       preset == WindowPreset::File ? kFileWindow : kPercentileWindow);
}

void forgetWindow(const std::string& modality) { QSettings().remove(keyOf("window", modality)); }

}  // namespace angiomesh
