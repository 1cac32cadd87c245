// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "gui/model/case_models.h"

class QMainWindow;

namespace angiomesh {

/// The menu that starts, cancels, pauses, steps and ends runs; `cancel` does so with all work.
void addRunMenu(QMainWindow* window, CaseModels& models, const std::function<void()>& cancel);

}  // namespace angiomesh
