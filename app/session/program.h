// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/App.hpp>
#include <functional>

#include "app/session/session.h"

namespace angiomesh::cli {

/// Reads the command line of angiomesh-cli with the commands that `addCommands` adds, and runs one.
/// @returns the exit code
int parseAndRun(int argc, char** argv, const std::function<void(CLI::App&, Session&)>& addCommands);

}  // namespace angiomesh::cli
