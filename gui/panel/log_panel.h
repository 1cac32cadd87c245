// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPlainTextEdit>

#include "gui/model/case_models.h"

namespace angiomesh {

/// What happened, with the cause and what to do next: one line each.
class LogPanel : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit LogPanel(CaseModels& models, QWidget* parent = nullptr);

 private:
  void add(Severity severity, const QString& text);
};

}  // namespace angiomesh
