// SPDX-License-Identifier: BSD-3-Clause
#include "gui/recent_cases.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <utility>

namespace angiomesh {

namespace {

constexpr int kMostRecent = 10;
const QString kKey = QStringLiteral("recent");

/// Beside the settings, where only the user can read.
QDir pictureFolder() {
  return QDir(QFileInfo(QSettings().fileName()).path() + QStringLiteral("/thumbnails"));
}

}  // namespace

RecentCases::RecentCases(CaseModels& models, const JobRunnerFactory& makeRunner, QObject* parent)
    : QObject(parent),
      models_(models),
      slot_(models.timer, makeRunner, [this](const std::shared_ptr<CaseThumbnailJob>&) {
        Q_EMIT changed();
        makeNext();
      }) {}

QStringList RecentCases::paths() const { return QSettings().value(kKey).toStringList(); }

QString RecentCases::pictureOf(const QString& path) {
  const QByteArray name = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1).toHex();
  return pictureFolder().filePath(QString::fromLatin1(name) + ".png");
}

QString fullTitle(const QString& name, const QString& path) {
  const QFileInfo file(path);
  const QString folder = file.absoluteDir().dirName();
  return file.isFile() && file.fileName().startsWith(name) && !folder.isEmpty()
             ? QStringLiteral("%1 (%2)").arg(name, folder)
             : name;
}

QString RecentCases::titleOf(const QString& caseName) const { return fullTitle(caseName, open_); }

void RecentCases::remember(const QString& path) {
  open_ = path;
  QStringList now = paths();
  now.removeAll(path);
  now.prepend(path);
  setPaths(now.mid(0, kMostRecent));
  if (const auto image = models_.document.image()) {
    next_ = std::make_shared<CaseThumbnailJob>();
    next_->image = image;
    next_->path = pictureOf(path).toStdString();
    if (!slot_) makeNext();
  }
}

void RecentCases::makeNext() {
  if (!next_) return;
  const QString folder = pictureFolder().path();
  QDir().mkpath(folder);
  QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  slot_.start(std::exchange(next_, nullptr));
}

void RecentCases::forgetAll() { setPaths({}); }

void RecentCases::setPaths(const QStringList& paths) {
  QSettings().setValue(kKey, paths);
  QStringList kept;
  for (const QString& path : paths) kept << QFileInfo(pictureOf(path)).fileName();
  QDir folder = pictureFolder();
  for (const QString& name : folder.entryList({QStringLiteral("*.png")}, QDir::Files))
    if (!kept.contains(name)) folder.remove(name);
  Q_EMIT changed();
}

}  // namespace angiomesh
