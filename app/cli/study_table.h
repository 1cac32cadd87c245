// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/App.hpp>

#include "app/cli/session.h"

namespace angiomesh::cli {

/// `study table-a`: Tables A.1 and A.2 of the thesis on a generated tree.
void addTableA(CLI::App& study, Session& session);

}  // namespace angiomesh::cli
