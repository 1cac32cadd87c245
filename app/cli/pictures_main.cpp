// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/commands.h"
#include "app/session/program.h"

// The commands of angiomesh-cli that draw: see main.cpp.
int main(int argc, char** argv) {
  using namespace angiomesh::cli;
  return parseAndRun(argc, argv, [](CLI::App& program, Session& session) {
    addSnapshot(program, session);
    addStudy(program, session);
  });
}
