// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/session/field_input.h"
#include "app/session/options.h"
#include "core/base/error.h"
#include "core/centreline/skeleton.h"
#include "io/vessel/skeleton_file.h"

namespace angiomesh::cli {
namespace {

using Json = nlohmann::ordered_json;

struct SkeletonOptions {
  std::string input;
  MaskChoice choice;
  std::vector<std::string> outputs;
  bool json = false;
};

Json listOf(const Eigen::Vector3d& point) { return {point[0], point[1], point[2]}; }

Json describe(const Skeleton& skeleton) {
  Json nodes = Json::array();
  for (const SkeletonNode& node : skeleton.nodes)
    nodes.push_back({{"kind", nodeKindName(node.kind)},
                     {"component", node.component},
                     {"point_lps_mm", listOf(node.pointLps)},
                     {"radius_mm", node.radiusMm}});
  Json branches = Json::array();
  for (const SkeletonBranch& branch : skeleton.branches)
    branches.push_back({{"component", branch.component},
                        {"from_node", branch.from},
                        {"to_node", branch.to},
                        {"length_mm", branch.lengthMm},
                        {"mean_radius_mm", branch.meanRadiusMm},
                        {"min_radius_mm", branch.minRadiusMm},
                        {"max_radius_mm", branch.maxRadiusMm}});
  return {{"schema", 1}, {"skeleton", {{"nodes", nodes}, {"branches", branches}}}};
}

std::string counted(std::ptrdiff_t count, const char* one, const char* more) {
  return std::to_string(count) + ' ' + (count == 1 ? one : more);
}

void print(const Skeleton& skeleton) {
  double length = 0.0;
  int components = 0;
  int last = 0;
  for (const SkeletonBranch& branch : skeleton.branches) {
    length += branch.lengthMm;
    if (branch.component != last) ++components;
    last = branch.component;
  }
  const auto of = [&](NodeKind kind) {
    return std::count_if(skeleton.nodes.begin(), skeleton.nodes.end(),
                         [&](const SkeletonNode& node) { return node.kind == kind; });
  };
  std::printf(
      "%s in %s, %.6g mm\n",
      counted(static_cast<std::ptrdiff_t>(skeleton.branches.size()), "branch", "branches").c_str(),
      counted(components, "part", "parts").c_str(), length);
  std::printf("%s, %s, %s where the volume ends, %s\n",
              counted(of(NodeKind::Tip), "tip", "tips").c_str(),
              counted(of(NodeKind::Junction), "junction", "junctions").c_str(),
              counted(of(NodeKind::Border), "end", "ends").c_str(),
              counted(of(NodeKind::Ring), "ring", "rings").c_str());
}

int skeleton(const SkeletonOptions& options, const Progress& progress) {
  if (options.outputs.empty() && !options.json)
    throw InputError("no file to write is named", "-o", "give -o FILE.csv, -o FILE.vtp or --json");
  for (const std::string& output : options.outputs) {
    checkSkeletonFile(output);
    checkOutputFile(output);
  }
  const MeshInput input =
      readMeshInput(options.input, options.choice, nullptr, progress.sub(0.0, 0.5));
  progress.phase("centre lines");
  const Skeleton found = skeletonOf(input.phi, progress.sub(0.5, 1.0));
  if (found.branches.empty())
    throw InputError("there is no vessel in it, nothing that is longer than thick", options.input,
                     "give a level set function that is negative inside vessels, or a mask");
  for (const std::string& output : options.outputs) writeSkeleton(found, output);
  if (options.json)
    std::printf("%s\n", describe(found).dump(2).c_str());
  else
    print(found);
  return Done;
}

}  // namespace

void addSkeleton(CLI::App& program, Session& session) {
  auto options = std::make_shared<SkeletonOptions>();
  CLI::App* command = program.add_subcommand(
      "skeleton",
      "Centre lines of the vessels of a level set function, mask or label image: branches with "
      "their lengths and radii, junctions, tips");
  command->add_option("INPUT", options->input, "Level set function, mask or label image")
      ->required();
  addMaskChoice(*command, options->choice);
  command
      ->add_option("-o,--output", options->outputs,
                   "File to write: .csv (a row for each branch) or .vtp (lines with radii for "
                   "ParaView, 3D Slicer, VMTK); may be given twice")
      ->take_all();
  command->add_flag("--json", options->json, "Print nodes and branches as JSON");
  setAction(command, session, options, skeleton);
}

}  // namespace angiomesh::cli
