// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/App.hpp>

#include "app/session/session.h"

namespace angiomesh::cli {

/// `study surface`: the exported wall against the true one.
void addStudySurface(CLI::App& study, Session& session);

}  // namespace angiomesh::cli
