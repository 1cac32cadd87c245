// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/commands.h"
#include "app/cli/field_input.h"
#include "app/cli/summary.h"
#include "core/base/error.h"
#include "core/pipeline/report.h"
#include "core/surface/spline_field.h"
#include "io/image_io.h"
#include "io/mesh_io.h"

namespace angiomesh::cli {
namespace {

using Json = nlohmann::ordered_json;

/// A named list of conditions on a mesh.
struct Gate {
  const char* name;
  const char* help;
  double leastAngleDeg;  ///< every smallest angle is at least this
  bool closed;
};

constexpr Gate kGates[] = {
    {"manifold", "oriented, no non-manifold spot, degenerate triangle or self-intersection", 0.0,
     false},
    {"closed", "as manifold, and no boundary edge", 0.0, true},
    {"cfd", "as closed, and no angle below 15 degrees", 15.0, true},
};

const Gate& findGate(const std::string& name) {
  std::string known;
  for (const Gate& gate : kGates) {
    if (name == gate.name) return gate;
    known += (known.empty() ? "" : ", ") + std::string(gate.name);
  }
  throw InputError("no gate is called '" + name + "'", "--gate", "use one of " + known);
}

/// The conditions that the mesh does not meet.
std::vector<std::string> failures(const Gate& gate, const MeshQuality& q) {
  std::vector<std::string> list;
  const auto none = [&](std::size_t number, const char* what) {
    if (number > 0) list.push_back(std::to_string(number) + " " + what);
  };
  none(q.nonManifoldEdges, "non-manifold edges");
  none(q.nonManifoldVertices, "non-manifold vertices");
  none(q.degenerateTriangles, "degenerate triangles");
  none(q.selfIntersections, "self-intersections");
  if (!q.oriented) list.emplace_back("not oriented");
  if (gate.closed) none(q.boundaryEdges, "boundary edges");
  if (q.triangles == 0) list.emplace_back("no triangle");
  if (q.minAngleMin < gate.leastAngleDeg) {
    char text[80];
    std::snprintf(text, sizeof text, "least angle %.2f degrees, below %g", q.minAngleMin,
                  gate.leastAngleDeg);
    list.emplace_back(text);
  }
  return list;
}

struct QualityOptions {
  std::string mesh, phi, against, gate;
  bool json = false;
};

int quality(const QualityOptions& options, const Progress& progress) {
  const Gate* gate = options.gate.empty() ? nullptr : &findGate(options.gate);
  std::optional<SplineField> phi;
  if (!options.phi.empty())
    phi.emplace(readPhiOrMask(options.phi), SplineKind::InterpolatingBspline);
  const SplineField* wall = phi ? &*phi : nullptr;
  const MeshQuality mine = measureQuality(readMesh(options.mesh), wall, progress.sub(0.0, 0.5));
  std::optional<MeshQuality> other;
  if (!options.against.empty())
    other = measureQuality(readMesh(options.against), wall, progress.sub(0.5, 1.0));
  const std::vector<std::string> failed =
      gate != nullptr ? failures(*gate, mine) : std::vector<std::string>{};

  if (options.json) {
    Json report = Json::parse(meshQualityJson(mine));
    if (other) report["against"] = Json::parse(meshQualityJson(*other))["mesh"];
    if (gate != nullptr)
      report["gate"] = {{"name", gate->name}, {"passed", failed.empty()}, {"failures", failed}};
    std::printf("%s\n", report.dump(2).c_str());
  } else {
    std::vector<NamedQuality> columns{{"mesh", &mine}};
    if (other) columns.push_back({"against", &*other});
    printQualities(columns);
  }
  if (failed.empty()) return Done;
  std::string list;
  for (const std::string& failure : failed) list += (list.empty() ? "" : ", ") + failure;
  printError("the mesh fails the gate '" + options.gate + "' (" + list + "), " + options.mesh +
             ": repair or remesh it");
  return GateFailed;
}

struct EvaluateOptions {
  std::string result, truth;
  bool json = false;
};

int evaluate(const EvaluateOptions& options, const Progress& progress) {
  const Volume<std::uint8_t> truth = readMask(options.truth);
  const Volume<float> field = readPhiOrMask(options.result);
  const OverlapMeasures measures = compareMasks(maskOnGrid(field, truth.geometry), truth, progress);
  if (options.json)
    std::fputs(overlapJson(measures).c_str(), stdout);
  else
    printOverlap(measures);
  return Done;
}

}  // namespace

void addQuality(CLI::App& program, Session& session) {
  auto options = std::make_shared<QualityOptions>();
  CLI::App* command = program.add_subcommand("quality", "What a mesh is worth to a solver");
  command->add_option("MESH", options->mesh, "Mesh to measure")->required();
  command->add_option("--phi", options->phi, "Level set function to measure the deviation from");
  command->add_option("--against", options->against, "Another mesh, to be measured beside it");
  std::string gates = "End with exit code 3 unless the mesh passes:";
  for (const Gate& gate : kGates) gates += std::string(" ") + gate.name + " (" + gate.help + ")";
  command->add_option("--gate", options->gate, gates);
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options, &session] {
    session.action = [options, &session] { return quality(*options, session.progress); };
  });
}

void addEvaluate(CLI::App& program, Session& session) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command =
      program.add_subcommand("evaluate", "Compare a result with the truth, on the truth's grid");
  command->add_option("PHI_OR_MASK", options->result, "Level set function or mask")->required();
  command->add_option("TRUTH", options->truth, "Mask")->required();
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options, &session] {
    session.action = [options, &session] { return evaluate(*options, session.progress); };
  });
}

}  // namespace angiomesh::cli
