// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "core/base/progress.h"

namespace angiomesh::cli {

/// Exit codes, part of the contract of the command line.
enum ExitCode { Done = 0, OurFault = 1, UserCanChange = 2, GateFailed = 3, WasCancelled = 4 };

/// What all commands share. A command's parser sets `action`; main() runs it after parsing.
struct Session {
  int threads = 0;
  std::string progressMode = "auto";
  Progress progress;
  std::function<int()> action;
};

/// Makes SIGINT, SIGTERM and SIGHUP cancel `progress`, and writing beyond a file size limit or to a
/// closed pipe fail instead of ending the program. Where no memory can be had even for an
/// exception, the program says so and ends with UserCanChange. `progress` must live until the
/// program ends.
void handleSignals(const Progress& progress);

/// Runs session.action with the progress shown on stderr, maps exceptions to exit codes and prints
/// one line for each.
int runSession(Session& session);

/// Whether all that was printed has arrived; else it says so.
bool flushOutput();

/// One line on stderr: "angiomesh-cli: error: TEXT".
void printError(const std::string& text);
void printWarning(const std::string& text);

}  // namespace angiomesh::cli
