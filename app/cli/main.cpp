// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "app/cli/commands.h"
#include "app/session/program.h"
#include "core/base/error.h"

namespace angiomesh::cli {
namespace {

#ifdef ANGIOMESH_WITH_PICTURES
/// The commands that draw need libraries that take longer to load than most others take to run,
/// and a hundred megabytes of addresses: they are a program of their own, beside this one or where
/// it was installed.
void addElsewhere(CLI::App& program, Session& session, const char* name, const char* text,
                  char** argv) {
  CLI::App* command = program.add_subcommand(name, text);
  command->prefix_command();
  command->set_help_flag();
  command->fallthrough(false);
  command->callback([&session, argv] {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const fs::path& place : {folder, folder / ANGIOMESH_LIBEXEC})
      execv((place / "angiomesh-pictures").c_str(), argv);
    session.action = []() -> int {
      throw IoError("the program that draws pictures is not there", "angiomesh-pictures",
                    "install Angiomesh anew, with all of its parts");
    };
  });
}
#endif

void addCommands(CLI::App& program, Session& session, [[maybe_unused]] char** argv) {
  addRun(program, session);
  addInfo(program, session);
  addPhantom(program, session);
  addVesselness(program, session);
  addSegment(program, session);
  addMesh(program, session);
  addSmooth(program, session);
  addQuality(program, session);
  addEvaluate(program, session);
  addSkeleton(program, session);
  addConvert(program, session);
#ifdef ANGIOMESH_WITH_PICTURES
  for (const auto& [name, text] :
       {std::pair{"snapshot", kSnapshotText}, std::pair{"study", kStudyText}})
    addElsewhere(program, session, name, text, argv);
#endif
  addParameters(program, session);
}

}  // namespace
}  // namespace angiomesh::cli

int main(int argc, char** argv) {
  using namespace angiomesh::cli;
  return parseAndRun(argc, argv, [argv](CLI::App& program, Session& session) {
    addCommands(program, session, argv);
  });
}
