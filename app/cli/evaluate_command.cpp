// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>

#include "app/cli/commands.h"
#include "app/session/field_input.h"
#include "app/session/summary.h"
#include "core/pipeline/report.h"
#include "io/scan/image_io.h"

namespace angiomesh::cli {
namespace {

struct EvaluateOptions {
  std::string result, truth;
  std::optional<double> threshold;
  bool json = false;
};

int evaluate(const EvaluateOptions& options, const Progress& progress) {
  const Volume<std::uint8_t> truth = readTruth(options.truth, options.threshold);
  const Volume<float> field = readPhiOrMask(options.result);
  const OverlapMeasures measures = compareMasks(maskOnGrid(field, truth.geometry), truth, progress);
  if (options.json)
    std::fputs(overlapJson(measures).c_str(), stdout);
  else
    printOverlap(measures);
  return Done;
}

}  // namespace

void addEvaluate(CLI::App& program, Session& session) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command =
      program.add_subcommand("evaluate", "Compare a result with the truth, on the truth's grid");
  command->add_option("PHI_OR_MASK", options->result, "Level set function or mask")->required();
  command->add_option("TRUTH", options->truth, "Mask")->required();
  command->add_option("--threshold", options->threshold,
                      "Voxels of the truth of this value and more are inside");
  command->add_flag("--json", options->json, "Print JSON");
  setAction(command, session, options, evaluate);
}

}  // namespace angiomesh::cli
