// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/change_parameters.h"

#include <utility>

#include "gui/model/case_controller.h"

namespace angiomesh {

ChangeParameters::ChangeParameters(CaseController& controller, Parameters before, Parameters after,
                                   const QString& text, QString mergeKey, bool continued)
    : QUndoCommand(text),
      controller_(controller),
      before_(std::move(before)),
      after_(std::move(after)),
      mergeKey_(std::move(mergeKey)),
      continued_(continued) {}

void ChangeParameters::undo() { controller_.replaceParameters(before_); }

void ChangeParameters::redo() { controller_.replaceParameters(after_); }

bool ChangeParameters::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const ChangeParameters*>(other);
  if (!next->continued_ || next->mergeKey_ != mergeKey_) {
    return false;
  }
  after_ = next->after_;
  return true;
}

}  // namespace angiomesh
