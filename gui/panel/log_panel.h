// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPlainTextEdit>

#include "gui/model/case_controller.h"

namespace angiomesh {

/// What happened, with the cause and what to do next: one line each.
class LogPanel : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit LogPanel(CaseController& controller, QWidget* parent = nullptr);

 private:
  void add(Severity severity, const QString& text);
};

}  // namespace angiomesh
