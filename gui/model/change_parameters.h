// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <QUndoCommand>

#include "core/parameters/parameters.h"

namespace angiomesh {

class CaseController;

/// The one undoable edit: parameters before and after.
class ChangeParameters final : public QUndoCommand {
 public:
  /// @param continued joins the last command when that one has the same key
  ChangeParameters(CaseController& controller, Parameters before, Parameters after,
                   const QString& text, QString mergeKey, bool continued);

  void undo() override;
  void redo() override;
  [[nodiscard]] int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* other) override;

 private:
  CaseController& controller_;
  Parameters before_, after_;
  QString mergeKey_;
  bool continued_;
};

}  // namespace angiomesh
