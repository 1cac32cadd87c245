// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/study_table.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/session/options.h"
#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/segmentation_mask.h"
#include "core/quality/overlap.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"

namespace angiomesh::cli {
namespace {

constexpr std::array kGammas{0.6, 0.7, 0.8};
constexpr std::array kDs{0.0, 0.2, 0.4};
constexpr std::array kXis{10.0, 20.0, 40.0};
constexpr std::array kNoises{20.0, 60.0};
constexpr std::size_t kRows = kGammas.size() * kDs.size() * kXis.size();

struct TableOptions {
  ParameterOptions settings;
  std::string output;
  int size = 256;
  std::uint64_t randomSeed = 1;
  bool force = false;
};

struct Row {
  double gamma = 0.0, d = 0.0, xi = 0.0;
  VoxelRatios ratios;
};

/// The rows in the thesis's order. Everything before the evolution is computed once: the pipeline
/// remembers it.
std::vector<Row> rowsOf(const Phantom& tree, Parameters params, const Progress& progress) {
  Pipeline pipeline(makeSource(tree.image, "tree"));
  RunOptions until;
  until.until = Step::Seeds;
  pipeline.run(params, until, progress.sub(0.0, 0.1));
  until.until = Step::Evolve;
  std::vector<Row> rows;
  for (const double gamma : kGammas)
    for (const double d : kDs)
      for (const double xi : kXis) {
        const double done = static_cast<double>(rows.size()) / kRows;
        const Progress part = progress.sub(0.1 + 0.9 * done, 0.1 + 0.9 * (done + 1.0 / kRows));
        params.levelset.gamma = gamma;
        params.levelset.d = d;
        params.thresholds.xi = xi;
        Volume<std::uint8_t> found(tree.truth.geometry);
        try {
          const RunResult run = pipeline.run(params, until, part);
          found = segmentationMask(run, tree.truth.geometry);
        } catch (const NumericError&) {
          // The front shrank to nothing: a row like any other.
        }
        rows.push_back({gamma, d, xi, voxelRatios(found, tree.truth)});
      }
  return rows;
}

std::string lines(const std::vector<Row>& rows, const char* format) {
  std::string out;
  for (const Row& row : rows) {
    const VoxelRatios& r = row.ratios;
    out += formatted(format, row.gamma, row.d, row.xi, r.truePositive, r.falsePositive,
                     r.trueNegative, r.falseNegative, r.overlap);
  }
  return out;
}

int tableA(const TableOptions& options, const Progress& progress) {
  const Parameters params = options.settings.parameters();
  StagedFolder folder(options.output, {"table-a1.csv", "table-a2.csv", "table-a.md"},
                      options.force);
  std::string tables;
  for (std::size_t n = 0; n < kNoises.size(); ++n) {
    const Progress part = progress.sub(0.5 * static_cast<double>(n), 0.5 * (1.0 + n));
    const Phantom tree =
        thesisTree(options.size, options.randomSeed, kNoises[n], part.sub(0.0, 0.05));
    const std::vector<Row> rows = rowsOf(tree, params, part.sub(0.05, 1.0));
    folder.add(formatted("table-a%zu.csv", n + 1), [&](const auto& place) {
      writeText(place, "gamma,d,xi,TPR,FPR,TNR,FNR,overlap\n" +
                           lines(rows, "%.2f,%.2f,%.0f,%.3f,%.3f,%.3f,%.3f,%.3f\n"));
    });
    tables += formatted(
        "Table A.%zu: %d x %d x %d voxels, noise %.0f, clipped to 0..255, random seed %llu, preset "
        "%s. TPR to FNR are "
        "percentages of all voxels.\n\n",
        n + 1, options.size, options.size, options.size, kNoises[n],
        static_cast<unsigned long long>(options.randomSeed), options.settings.presetName.c_str());
    tables +=
        "| gamma | d | xi | TPR | FPR | TNR | FNR | overlap |\n|---|---|---|---|---|---|---|---|\n";
    tables += lines(rows, "| %.2f | %.2f | %.0f | %.3f | %.3f | %.3f | %.3f | %.3f |\n") + "\n";
  }
  folder.add("table-a.md", [&](const auto& place) { writeText(place, tables); });
  folder.commit();
  std::printf("%s", tables.c_str());
  return Done;
}

}  // namespace

Phantom thesisTree(int size, std::uint64_t randomSeed, double noiseSigma,
                   const Progress& progress) {
  PhantomParams params;
  params.psf.kind = PointSpread::Kind::Subvoxels;
  params.size = {size, size, size};
  params.randomSeed = randomSeed;
  params.noiseSigma = noiseSigma;
  Phantom tree = makePhantom(params, progress);
  for (float& value : tree.image.voxels) value = std::clamp(value, 0.0F, 255.0F);
  return tree;
}

void addTableA(CLI::App& study, Session& session) {
  auto options = std::make_shared<TableOptions>();
  options->settings.presetName = "thesis";
  CLI::App* command = study.add_subcommand(
      "table-a",
      "Tables A.1 and A.2: gamma, d and xi varied on a tree with noise 20 and 60 (256^3 takes "
      "tens of minutes)");
  command->add_option("-o,--output", options->output, "Folder to write")->required();
  command->add_option("--size", options->size, "Voxels along each side of the tree")
      ->check(CLI::Range(32, 512))
      ->capture_default_str();
  command->add_option("--random-seed", options->randomSeed, "Another tree")->capture_default_str();
  command->add_flag("--force", options->force, "Replace the tables of a former call");
  addSettings(*command, options->settings);
  setAction(command, session, options, tableA);
}

}  // namespace angiomesh::cli
