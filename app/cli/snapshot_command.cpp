// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <memory>

#include "app/cli/commands.h"
#include "core/base/error.h"
#include "io/files.h"
#include "io/image_io.h"
#include "io/mesh_io.h"
#include "render/offscreen.h"

namespace angiomesh::cli {
namespace {

constexpr int kWidth = 1400;
constexpr int kHeight = 800;

struct SnapshotOptions {
  std::string folder, output;
};

int snapshot(const SnapshotOptions& options) {
  namespace fs = std::filesystem;
  const fs::path folder = options.folder;
  if (!fs::exists(folder / "vessels.ply"))
    throw InputError("the folder holds no vessels.ply", options.folder,
                     "give a folder that 'angiomesh-cli run' wrote");
  const TriMesh mesh = readMesh(folder / "vessels.ply");
  Volume<float> phi;
  const bool hasPhi = fs::exists(folder / "phi.nrrd");
  if (hasPhi) phi = readImage(folder / "phi.nrrd").image;
  writePng(renderSurfacePicture(mesh, hasPhi ? &phi : nullptr, kWidth, kHeight), options.output);
  return Done;
}

}  // namespace

void addSnapshot(CLI::App& program, Session& session) {
  auto options = std::make_shared<SnapshotOptions>();
  CLI::App* command = program.add_subcommand(
      "snapshot", "A rendered picture of a result (needs an X display, a virtual one will do)");
  command->add_option("DIR", options->folder, "Folder that 'run' wrote")->required();
  command->add_option("-o,--output", options->output, "PNG to write")->required();
  command->callback(
      [options, &session] { session.action = [options] { return snapshot(*options); }; });
}

}  // namespace angiomesh::cli
