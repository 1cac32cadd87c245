// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>

namespace angiomesh {

enum class Severity { Info, Warning, Error };

/// What the models have to say to the user, a line each.
class MessageLog : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void say(Severity severity, const QString& text) { Q_EMIT message(severity, text.simplified()); }
  void say(Severity severity, const std::string& text) {
    say(severity, QString::fromStdString(text));
  }

 Q_SIGNALS:
  void message(angiomesh::Severity severity, const QString& text);
};

}  // namespace angiomesh
