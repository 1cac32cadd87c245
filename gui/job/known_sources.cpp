// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/known_sources.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSettings>
#include <QStringList>
#include <system_error>

namespace angiomesh {

namespace {

const char* const kKey = "sources";
constexpr int kMost = 500;

}  // namespace

void keepSettingsPrivate() {
  namespace fs = std::filesystem;
  const QFileInfo folder(QFileInfo(QSettings().fileName()).path());
  // Where the settings share a folder with those of other programs, it is left as it is.
  if (folder.fileName() != QCoreApplication::organizationName()) return;
  const fs::path path = folder.filePath().toStdString();
  std::error_code error;
  fs::create_directories(path, error);
  fs::permissions(path, fs::perms::owner_all, error);
}

KnownSources knownSources() {
  KnownSources known;
  for (const QString& entry : QSettings().value(kKey).toStringList()) {
    const qsizetype space = entry.indexOf(' ');
    known.emplace_back(entry.left(space).toStdString(), entry.mid(space + 1).toStdString());
  }
  return known;
}

void rememberSource(const std::string& hash, const std::filesystem::path& path) {
  QSettings settings;
  const QString entry = QString::fromStdString(hash + ' ' + path.string());
  QStringList entries = settings.value(kKey).toStringList();
  entries.removeAll(entry);
  entries.prepend(entry);
  settings.setValue(kKey, QStringList(entries.mid(0, kMost)));
}

std::vector<std::filesystem::path> placesOf(const std::string& hash, const KnownSources& known) {
  std::vector<std::filesystem::path> places;
  for (const auto& [each, path] : known)
    if (each == hash) places.push_back(path);
  return places;
}

}  // namespace angiomesh
