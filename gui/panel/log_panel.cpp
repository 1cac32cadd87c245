// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/log_panel.h"

#include <QTextCharFormat>
#include <QTextCursor>
#include <QTime>

namespace angiomesh {

namespace {
constexpr int kMostLines = 2000;
}

LogPanel::LogPanel(CaseModels& models, QWidget* parent) : QPlainTextEdit(parent) {
  setObjectName("log");
  setReadOnly(true);
  setMaximumBlockCount(kMostLines);
  setLineWrapMode(QPlainTextEdit::WidgetWidth);
  connect(&models.log, &MessageLog::message, this, &LogPanel::add);
}

void LogPanel::add(Severity severity, const QString& text) {
  QString line = QTime::currentTime().toString("HH:mm:ss  ");
  if (severity == Severity::Warning)
    line += tr("Warning: ");
  else if (severity == Severity::Error)
    line += tr("Error: ");
  QTextCursor cursor(document());
  cursor.movePosition(QTextCursor::End);
  if (!document()->isEmpty()) cursor.insertBlock();
  QTextCharFormat format;
  if (severity == Severity::Error) format.setFontWeight(QFont::Bold);
  cursor.insertText(line + text, format);
  setTextCursor(cursor);
  ensureCursorVisible();
}

}  // namespace angiomesh
