// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "app/session/options.h"
#include "app/session/session.h"
#include "core/pipeline/report.h"

namespace angiomesh::cli {
namespace {

/// What is wrong with the command line, in one line.
std::string explain(const CLI::ParseError& error, const CLI::App& program, int argc, char** argv) {
  const auto commands = program.get_subcommands();
  if (commands.empty()) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const auto word = std::find_if(words.begin(), words.end(),
                                   [](const std::string& w) { return w.rfind('-', 0) != 0; });
    if (error.get_name() == "RequiredError")
      return word == words.end()
                 ? "a command is missing, command line: see angiomesh-cli --help"
                 : "no command is called '" + *word + "', command line: see angiomesh-cli --help";
  }
  std::string what = error.what();
  std::replace(what.begin(), what.end(), '\n', ' ');
  const std::string command = commands.empty() ? "" : " " + commands.front()->get_name();
  return what + ", command line: see angiomesh-cli" + command + " --help";
}

}  // namespace

int parseAndRun(int argc, char** argv,
                const std::function<void(CLI::App&, Session&)>& addCommands) {
  static Session session;
  handleSignals(session.progress);

  CLI::App program("Angiomesh: from an angiogram to a vessel surface", "angiomesh-cli");
  program.set_version_flag("--version", std::string("angiomesh-cli ") + versionText());
  program.add_option("--threads", session.threads, "Threads to use; all cores unless given")
      ->check(CLI::Range(1, 1024));
  program.add_option("--progress", session.progressMode, "auto (on a terminal), json or none")
      ->check(CLI::IsMember({"auto", "json", "none"}));
  program.require_subcommand(1);
  program.fallthrough();

  addCommands(program, session);

  std::vector<std::string> arguments = joinNumbers(argc, argv);
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  try {
    program.parse(arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      program.exit(error);
      return flushOutput() ? Done : UserCanChange;
    }
    printError(explain(error, program, argc, argv));
    return UserCanChange;
  }
  return runSession(session);
}

}  // namespace angiomesh::cli
