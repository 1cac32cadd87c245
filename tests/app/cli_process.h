// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

/// What one call of angiomesh-cli did.
struct CliResult {
  int code = -1;
  bool crashed = false;
  QByteArray output, errors;

  [[nodiscard]] QJsonObject json() const { return QJsonDocument::fromJson(output).object(); }
  /// The lines on stderr that are not warnings.
  [[nodiscard]] QList<QByteArray> errorLines() const {
    QList<QByteArray> lines;
    for (const QByteArray& line : errors.split('\n'))
      if (!line.isEmpty() && !line.startsWith("angiomesh-cli: warning: ")) lines.append(line);
    return lines;
  }
};

inline CliResult finish(QProcess& process) {
  CliResult result;
  if (!process.waitForFinished(60000)) process.kill();
  result.crashed = process.exitStatus() != QProcess::NormalExit;
  result.code = process.exitCode();
  result.output = process.readAllStandardOutput();
  result.errors = process.readAllStandardError();
  return result;
}

/// Runs angiomesh-cli in `folder`.
inline CliResult runCli(const QString& folder, const QStringList& arguments) {
  QProcess process;
  process.setWorkingDirectory(folder);
  process.start(ANGIOMESH_CLI, arguments);
  return finish(process);
}

/// As runCli(), with no file allowed to grow beyond `kilobytes`.
inline CliResult runCliWithFileLimit(const QString& folder, const QStringList& arguments,
                                     int kilobytes) {
  QProcess process;
  process.setWorkingDirectory(folder);
  const QString script = QStringLiteral("ulimit -f %1; exec \"$0\" \"$@\"").arg(kilobytes);
  process.start("bash", QStringList{"-c", script, ANGIOMESH_CLI} + arguments);
  return finish(process);
}

inline QStringList filesIn(const QString& folder) {
  return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
}

/// Nothing where the file is not there.
inline QByteArray readBytes(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline QJsonObject readJson(const QString& path) {
  return QJsonDocument::fromJson(readBytes(path)).object();
}

/// A folder that is gone after the test.
struct CliFolder {
  QTemporaryDir dir;

  [[nodiscard]] QString at(const QString& name) const { return dir.filePath(name); }
  [[nodiscard]] CliResult cli(const QStringList& arguments) const {
    return runCli(dir.path(), arguments);
  }
};
