// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "gui/findings/case_sensitivity.h"
#include "gui/model/case_models.h"

class QMainWindow;

namespace angiomesh {

/// The menu that starts, cancels, pauses, steps and ends runs, and that tries the parameters.
/// `cancel` ends all work.
void addRunMenu(QMainWindow* window, CaseModels& models, CaseSensitivity& sensitivity,
                const std::function<void()>& cancel);

}  // namespace angiomesh
