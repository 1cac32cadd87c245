// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/App.hpp>

#include "app/session/session.h"

namespace angiomesh::cli {

/// Adds `study sensitivity`.
void addStudySensitivity(CLI::App& study, Session& session);

}  // namespace angiomesh::cli
