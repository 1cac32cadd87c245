// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/parameters/parameters.h"
#include "core/phantom/phantom.h"

namespace angiomesh::cli {

/// What is measured of a segmented phantom, in the order of panelMetrics().
enum class Metric {
  Overlap,
  BestThreshold,
  Sensitivity,
  Precision,
  MeanDistance,
  Distance95,
  RadiusBias,
  RadiusBiasImage,
  BiasThin,
  BiasSmall,
  BiasMiddle,
  BiasThick,
  Recall,
  RecallAll,
  Components,
  FalseOnes,
  LargestFalse,
  Merged,
  MergedAsTruth,
  OverlapLoss,
  Outside,
  OutsideSeeded,
  Seconds
};
constexpr std::size_t kMetrics = 23;

/// How the measures of a row's cases make that of the row.
enum class Summary { Mean, Worst, Sum };

struct MetricInfo {
  const char* key;    ///< in panel.json and panel.csv
  const char* title;  ///< in panel.md
  int decimals;
  Summary summary;
};
const std::array<MetricInfo, kMetrics>& panelMetrics();

/// By Metric; NaN where a metric says nothing about the phantom.
using Measures = std::array<double, kMetrics>;
double& at(Measures& measures, Metric metric);
double at(const Measures& measures, Metric metric);
Measures summarise(const std::vector<Measures>& cases);

struct Bar {
  Metric metric;
  double limit;
  enum class Kind { AtLeast, AtMost, Within } kind;  ///< Within: of +-limit
};
bool reached(const Bar& bar, const Measures& measures);
std::string textOf(const Bar& bar);

struct PanelCase {
  std::string name;
  PhantomParams phantom;
};

/// A line of the evidence table.
struct PanelRow {
  std::string name, group, what;
  std::vector<PanelCase> cases;
  std::vector<Bar> bars;
};

/// All rows. @param treeSize voxels along the sides of the vascular trees
std::vector<PanelRow> panelRows(int treeSize);

/// Those whose name or group is in `names` (with commas); all when empty, at most `cases` of each.
/// @throws InputError for a name of neither
std::vector<PanelRow> chooseRows(std::vector<PanelRow> rows, const std::string& names, int cases);

struct CaseResult {
  std::string name;
  Measures measures{};
  std::string failure;  ///< of the pipeline; then nothing was found
  /// With clutter: what of the result is voxels of each kind of piece, percent; all, and with keep
  /// = seeded.
  std::map<std::string, std::array<double, 2>> clutterPercent;
};

/// Makes the phantom, segments it up to the step `evolve` and measures the result.
/// @throws Cancelled, InputError for a phantom that cannot be made
CaseResult runCase(const PanelCase& what, const Parameters& params, const Progress& progress);

}  // namespace angiomesh::cli
