// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/cli/commands.h"
#include "app/session/options.h"
#include "core/base/error.h"
#include "io/file/files.h"
#include "io/mesh/mesh_io.h"
#include "io/scan/image_io.h"
#include "render/picture/mesh_panels.h"
#include "render/picture/offscreen.h"

namespace angiomesh::cli {
namespace {

constexpr int kWidth = 1400;
constexpr int kHeight = 800;
constexpr int kPanelWidth = 700, kPanelHeight = 600;

struct SnapshotOptions {
  std::vector<std::string> folders;
  std::string output, at;
  double width = 0.0;
  bool edges = false;
};

TriMesh meshIn(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder / "vessels.ply"))
    throw InputError("the folder holds no vessels.ply", folder.string(),
                     "give a folder that 'angiomesh-cli run' wrote");
  return readMesh(folder / "vessels.ply");
}

Picture wholePicture(const std::filesystem::path& folder) {
  const TriMesh mesh = meshIn(folder);
  Volume<float> phi;
  const bool hasPhi = std::filesystem::exists(folder / "phi.nrrd");
  if (hasPhi) phi = readImage(folder / "phi.nrrd").image;
  return renderSurfacePicture(mesh, hasPhi ? &phi : nullptr, kWidth, kHeight);
}

/// The results side by side, and below each what lies in a cube around a place.
Picture closeUp(const SnapshotOptions& options) {
  const std::vector<double> at = parseNumbers(options.at, 3, "--at");
  std::array<double, 6> box{};
  for (std::size_t a = 0; a < 3; ++a) {
    box[2 * a] = at[a] - 0.5 * options.width;
    box[2 * a + 1] = at[a] + 0.5 * options.width;
  }
  std::vector<TriMesh> meshes;
  for (const std::string& folder : options.folders) meshes.push_back(meshIn(folder));
  std::vector<MeshPanel> panels;
  for (std::size_t n = 0; n < meshes.size(); ++n)
    panels.push_back({&meshes[n], std::filesystem::path(options.folders[n]).filename().string()});
  return renderMeshPanels(panels, box, kPanelWidth, kPanelHeight, options.edges);
}

int snapshot(const SnapshotOptions& options) {
  if (options.at.empty() != (options.width == 0.0))
    throw InputError("a close-up needs a place and a width", "--at, --width", "give both");
  if (options.at.empty() && options.folders.size() > 1)
    throw InputError("several results can be shown only as close-ups", "DIR",
                     "give one folder, or --at and --width");
  writePng(options.at.empty() ? wholePicture(options.folders.front()) : closeUp(options),
           options.output);
  return Done;
}

}  // namespace

void addSnapshot(CLI::App& program, Session& session) {
  auto options = std::make_shared<SnapshotOptions>();
  CLI::App* command = program.add_subcommand("snapshot", kSnapshotText);
  command->add_option("DIR", options->folders, "Folders that 'run' wrote; one without --at")
      ->required();
  command->add_option("-o,--output", options->output, "PNG to write")->required();
  command->add_option("--at", options->at,
                      "Close-up: x,y,z, mm LPS; below each result what lies around this place");
  command->add_option("--width", options->width, "Side of the cube that the close-up shows, mm")
      ->check(CLI::PositiveNumber);
  command->add_flag("--edges", options->edges, "Draw the close-up's edges");
  command->callback(
      [options, &session] { session.action = [options] { return snapshot(*options); }; });
}

}  // namespace angiomesh::cli
