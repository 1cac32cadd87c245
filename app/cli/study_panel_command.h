// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/App.hpp>

#include "app/session/session.h"

namespace angiomesh::cli {

/// Adds `panel` and `ablation` to the command `study`.
void addStudyPanel(CLI::App& study, Session& session);

/// Adds `ports` to the command `study`.
void addStudyPorts(CLI::App& study, Session& session);

}  // namespace angiomesh::cli
