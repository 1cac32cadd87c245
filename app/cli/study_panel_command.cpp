// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/study_panel_command.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/cli/commands.h"
#include "app/session/options.h"
#include "app/study/study_panel.h"
#include "core/base/formatted.h"
#include "core/parameters/field.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"

namespace angiomesh::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kBarSize = 256;  // of the trees that the bars are for
constexpr const char* kAblationRows =
    "tree-n20,tree-n60,drift-n20,close,thick,tiny,low-contrast,tube-r0.75-n60-oblique,tube-r20-n20";

struct PanelOptions {
  ParameterOptions settings;
  std::string output, rows;
  int size = kBarSize, cases = 0;
  bool force = false;
};

struct RowResult {
  PanelRow row;
  std::vector<CaseResult> cases;
  Measures summary{};
};

/// What is switched off, one after the other.
struct Departure {
  const char* name;
  const char* preset;  ///< nullptr: the one that was asked for
  std::vector<std::pair<const char*, const char*>> settings;
};

const std::vector<Departure>& departures() {
  static const std::vector<Departure> list{
      {"all on", nullptr, {}},
      {"start = seeds", nullptr, {{"levelset.start", "seeds"}}},
      {"refine off", nullptr, {{"levelset.refine", "false"}}},
      {"wall.smooth off", nullptr, {{"wall.smooth", "false"}}},
      {"refineLevel = 0.5", nullptr, {{"levelset.refineLevel", "0.5"}}},
      {"refineAlong = 0", nullptr, {{"levelset.refineAlong", "0"}}},
      {"refineAcross = 0", nullptr, {{"levelset.refineAcross", "0"}}},
      {"refineMeanSteps = 0", nullptr, {{"levelset.refineMeanSteps", "0"}}},
      {"acrossCrests off", nullptr, {{"levelset.acrossCrests", "false"}}},
      {"seeds.least = 0", nullptr, {{"seeds.least", "0"}}},
      {"floodLeastVoxels = 1000000", nullptr, {{"levelset.floodLeastVoxels", "1000000"}}},
      {"b by eq. 3.20", nullptr, {{"levelset.bRule", "average"}}},
      {"c by the range", nullptr, {{"vesselness.contrast", "range"}}},
      {"scalesFromImage off", nullptr, {{"vesselness.scalesFromImage", "false"}}},
      {"scales by eq. 5.1", nullptr, {{"vesselness.scaleRule", "difference"}}},
      {"Frangi's measure", nullptr, {{"vesselness.measure", "frangi"}}},
      {"printed method", "thesis", {}},
  };
  return list;
}

std::string numberText(double value, int decimals) {
  return std::isnan(value) ? "" : formatted("%.*f", decimals, value);
}

std::string barText(const RowResult& result) { return joined(result.row.bars, "; ", textOf); }

/// "yes", or what is missed; empty without a bar.
std::string reachedText(const RowResult& result) {
  std::string missed;
  for (const Bar& bar : result.row.bars)
    if (!reached(bar, result.summary))
      missed += (missed.empty() ? "no: " : ", ") +
                std::string(panelMetrics()[static_cast<std::size_t>(bar.metric)].title);
  if (!missed.empty()) return missed;
  return result.row.bars.empty() ? "" : "yes";
}

/// Columns that hold a number in some row; empty ones are left out.
std::vector<std::size_t> usedColumns(const std::vector<RowResult>& results) {
  std::vector<std::size_t> used;
  for (std::size_t m = 0; m < kMetrics; ++m)
    for (const RowResult& r : results)
      if (!std::isnan(r.summary[m])) {
        used.push_back(m);
        break;
      }
  return used;
}

std::string tableLine(const std::string& name, const std::string& what, const Measures& measures,
                      const std::vector<std::size_t>& columns, const std::string& end) {
  std::string line = "| " + name + " | " + what + " |";
  for (const std::size_t m : columns)
    line += " " + numberText(measures[m], panelMetrics()[m].decimals) + " |";
  return line + end + "\n";
}

std::string head(const std::vector<std::size_t>& columns, const std::vector<std::string>& left,
                 const std::vector<std::string>& right) {
  std::string titles = "|";
  std::string rule = "|";
  const auto add = [&](const std::string& title, const char* line) {
    titles += " " + title + " |";
    rule += line;
  };
  for (const std::string& title : left) add(title, "---|");
  for (const std::size_t m : columns) add(panelMetrics()[m].title, "---:|");
  for (const std::string& title : right) add(title, "---|");
  return titles + "\n" + rule + "\n";
}

constexpr const char* kLegend =
    "Lengths in voxels of the smallest spacing. best threshold: the greatest overlap that any "
    "threshold reaches after any Gaussian up to 1 voxel, both chosen with the truth. wall: "
    "distance from the result's zero set to the "
    "exact wall. radius bias: sqrt(V / (pi length)) over the middle 80 % of a tube less its "
    "radius; to image: less that of the noise-free image, whose 2 x 2 x 2 subvoxels make a tube "
    "along an axis up to 0.1 voxel thicker or thinner; each the worst of the cases. bias r a-b: "
    "mean signed distance of the wall of vessels of that radius, positive where they come out "
    "too thick. recall: share of the centre lines inside the result, of radius 1 and more, and of "
    "all. false ones: components without a voxel of the truth; largest in voxels. merged: cases "
    "where two vessels became one component (26-connected); as truth: where those of the truth "
    "mask are connected too. With clutter: overlap and wall within 1.5 voxels of the true vessels; "
    "outside: percent of the result more than a voxel away from them, all of it and with keep = "
    "seeded. s: the pipeline up to the mask.\n";

std::string markdown(const std::vector<RowResult>& results, const PanelOptions& options) {
  const std::vector<std::size_t> columns = usedColumns(results);
  std::string text = "Preset `" + options.settings.presetName + "`";
  for (const std::string& s : options.settings.settings) text += ", `" + s + "`";
  text += "; trees of " + std::to_string(options.size) + "^3 voxels";
  if (options.size != kBarSize) text += " (the bars are for 256^3)";
  text += ".\n\n" + head(columns, {"row", "what"}, {"bar", "reached"});
  for (const RowResult& r : results) {
    text += tableLine(r.row.name, r.row.what, r.summary, columns,
                      " " + barText(r) + " | " + reachedText(r) + " |");
    if (r.row.group == "tubes" || r.row.group == "kissing" || r.cases.size() < 2) continue;
    for (const CaseResult& one : r.cases)
      text += tableLine("", one.name + (one.failure.empty() ? "" : ": " + one.failure),
                        one.measures, columns, " | |");
  }
  return text + "\n" + kLegend;
}

Json jsonOf(const Measures& measures) {
  Json json = Json::object();
  for (std::size_t m = 0; m < kMetrics; ++m)
    if (!std::isnan(measures[m])) json[panelMetrics()[m].key] = measures[m];
  return json;
}

Json jsonOf(const RowResult& r) {
  Json json{{"row", r.row.name}, {"group", r.row.group}, {"what", r.row.what}};
  json["measures"] = jsonOf(r.summary);
  for (const Bar& bar : r.row.bars)
    json["bars"].push_back({{"bar", textOf(bar)}, {"reached", reached(bar, r.summary)}});
  for (const CaseResult& one : r.cases) {
    Json item{{"case", one.name}, {"measures", jsonOf(one.measures)}};
    if (!one.failure.empty()) item["failure"] = one.failure;
    for (const auto& [kind, percent] : one.clutterPercent)
      item["clutter_percent"][kind] = {{"all", percent[0]}, {"seeded", percent[1]}};
    json["cases"].push_back(std::move(item));
  }
  return json;
}

Json jsonHead(const PanelOptions& options) {
  return {{"schema", 1},
          {"tree_size", options.size},
          {"parameters", Json::parse(parametersToJson(options.settings.parameters()))}};
}

/// Fields with commas are quoted (RFC 4180).
std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"") == std::string::npos) return field;
  std::string text = "\"";
  for (const char c : field) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

std::string csvLine(const std::vector<std::string>& fields, const Measures& measures) {
  std::string line;
  for (const std::string& field : fields) line += quoted(field) + ",";
  for (std::size_t m = 0; m < kMetrics; ++m)
    line += (m > 0 ? "," : "") + numberText(measures[m], 6);
  return line + "\n";
}

std::string csvHead(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) line += field + ",";
  for (std::size_t m = 0; m < kMetrics; ++m)
    line += (m > 0 ? "," : "") + std::string(panelMetrics()[m].key);
  return line + "\n";
}

std::string csv(const std::vector<RowResult>& results) {
  std::string text = csvHead({"row", "case"});
  for (const RowResult& r : results) {
    text += csvLine({r.row.name, "all"}, r.summary);
    for (const CaseResult& one : r.cases) text += csvLine({r.row.name, one.name}, one.measures);
  }
  return text;
}

/// Longer work takes more of the progress.
double voxelsOf(const PanelRow& row) {
  double voxels = 0.0;
  for (const PanelCase& one : row.cases)
    voxels += 1.0 * one.phantom.size[0] * one.phantom.size[1] * one.phantom.size[2] *
              (one.phantom.clutter ? 2.0 : 1.0);
  return voxels;
}

std::vector<RowResult> runRows(const std::vector<PanelRow>& rows, const Parameters& params,
                               const std::string& label, const Progress& progress) {
  double all = 0.0;
  for (const PanelRow& row : rows) all += voxelsOf(row);
  double done = 0.0;
  std::vector<RowResult> results;
  for (const PanelRow& row : rows) {
    RowResult result{row, {}, {}};
    std::vector<Measures> measures;
    const double each = voxelsOf(row) / static_cast<double>(row.cases.size());
    for (const PanelCase& one : row.cases) {
      result.cases.push_back(
          runCase(one, params, progress.sub(done / all, std::min(1.0, (done + each) / all))));
      measures.push_back(result.cases.back().measures);
      done += each;
    }
    result.summary = summarise(measures);
    std::printf("%s%s: overlap %s, recall %s, false %s, %s s %s\n", label.c_str(), row.name.c_str(),
                numberText(at(result.summary, Metric::Overlap), 2).c_str(),
                numberText(at(result.summary, Metric::Recall), 2).c_str(),
                numberText(at(result.summary, Metric::LargestFalse), 0).c_str(),
                numberText(at(result.summary, Metric::Seconds), 1).c_str(),
                reachedText(result).c_str());
    std::fflush(stdout);
    results.push_back(std::move(result));
  }
  return results;
}

int panel(const PanelOptions& options, const Progress& progress) {
  const Parameters params = options.settings.parameters();
  const std::vector<PanelRow> rows =
      chooseRows(panelRows(options.size), options.rows, options.cases);
  StagedFolder folder(options.output, {"panel.md", "panel.json", "panel.csv"}, options.force);
  const std::vector<RowResult> results = runRows(rows, params, "", progress);
  Json json = jsonHead(options);
  for (const RowResult& r : results) json["rows"].push_back(jsonOf(r));
  folder.add("panel.md", [&](const auto& place) { writeText(place, markdown(results, options)); });
  folder.add("panel.json", [&](const auto& place) { writeText(place, json.dump(2) + "\n"); });
  folder.add("panel.csv", [&](const auto& place) { writeText(place, csv(results)); });
  folder.commit();
  return Done;
}

/// The wall bias of the row: of the tube's radius, else of the size of vessel that is worst off.
double biasOf(const Measures& measures) {
  if (!std::isnan(at(measures, Metric::RadiusBias))) return at(measures, Metric::RadiusBias);
  double worst = std::nan("");
  for (const Metric metric :
       {Metric::BiasThin, Metric::BiasSmall, Metric::BiasMiddle, Metric::BiasThick}) {
    const double bias = at(measures, metric);
    if (!std::isnan(bias) && !(std::fabs(bias) <= std::fabs(worst))) worst = bias;
  }
  return worst;
}

std::string ablationMarkdown(const std::vector<std::vector<RowResult>>& table) {
  std::string titles = "| switched off |";
  std::string rule = "|---|";
  for (const RowResult& r : table.front()) {
    titles += " " + r.row.name + " |";
    rule += "---:|";
  }
  std::string text = titles + "\n" + rule + "\n";
  for (std::size_t d = 0; d < table.size(); ++d) {
    text += "| " + std::string(departures()[d].name) + " |";
    for (const RowResult& r : table[d]) {
      text += " " + numberText(at(r.summary, Metric::Overlap), 2);
      const std::string bias = numberText(biasOf(r.summary), 2);
      text += " / " + (bias.empty() ? "-" : bias);
      text += " / " + numberText(at(r.summary, Metric::Recall), 1);
      if (!std::isnan(at(r.summary, Metric::Merged)))
        text += " / " + numberText(at(r.summary, Metric::Merged), 0);
      text += " |";
    }
    text += "\n";
  }
  return text +
         "\nEach cell: overlap in % / bias in voxels (of the radius for tubes, else of the wall "
         "of the vessel size that is worst off) / centre-line recall in % / for kissing tubes, "
         "cases that merged.\n";
}

int ablation(const PanelOptions& options, const Progress& progress) {
  const Parameters asked = options.settings.parameters();
  std::vector<Parameters> settings;
  for (const Departure& departure : departures()) {
    Parameters params = departure.preset != nullptr ? preset(departure.preset) : asked;
    for (const auto& [key, value] : departure.settings) setFieldFromText(params, key, value);
    validate(params);
    settings.push_back(std::move(params));
  }
  const std::vector<PanelRow> rows =
      chooseRows(panelRows(options.size), options.rows, options.cases);
  StagedFolder folder(options.output, {"ablation.md", "ablation.json", "ablation.csv"},
                      options.force);
  Json json = jsonHead(options);
  std::string lines = csvHead({"switched_off", "row", "case"});
  std::vector<std::vector<RowResult>> table;
  for (std::size_t d = 0; d < settings.size(); ++d) {
    const std::string name = departures()[d].name;
    const auto count = static_cast<double>(settings.size());
    table.push_back(
        runRows(rows, settings[d], name + ": ",
                progress.sub(static_cast<double>(d) / count, static_cast<double>(d + 1) / count)));
    Json group{{"switched_off", name}};
    for (const auto& [key, value] : departures()[d].settings) group["settings"][key] = value;
    for (const RowResult& r : table.back()) {
      group["rows"].push_back(jsonOf(r));
      lines += csvLine({name, r.row.name, "all"}, r.summary);
      for (const CaseResult& one : r.cases)
        lines += csvLine({name, r.row.name, one.name}, one.measures);
    }
    json["groups"].push_back(std::move(group));
  }
  folder.add("ablation.md", [&](const auto& place) { writeText(place, ablationMarkdown(table)); });
  folder.add("ablation.json", [&](const auto& place) { writeText(place, json.dump(2) + "\n"); });
  folder.add("ablation.csv", [&](const auto& place) { writeText(place, lines); });
  folder.commit();
  return Done;
}

void addCommand(CLI::App& study, Session& session, const char* name, const char* help,
                const char* rows, int (*body)(const PanelOptions&, const Progress&)) {
  auto options = std::make_shared<PanelOptions>();
  options->rows = rows;
  CLI::App* command = study.add_subcommand(name, help);
  command->add_option("-o,--output", options->output, "Folder to write")->required();
  addSettings(*command, options->settings);
  command
      ->add_option("--rows", options->rows,
                   "Rows or groups NAME,NAME: trees, thicker, scanned, spacing, drift, rician, "
                   "clutter, complaints, tubes, kissing, shapes")
      ->capture_default_str();
  command->add_option("--size", options->size, "Voxels along each side of the trees")
      ->check(CLI::Range(64, 512))
      ->capture_default_str();
  command->add_option("--cases", options->cases, "At most so many phantoms of each row; 0: all")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  command->add_flag("--force", options->force, "Replace the tables of a former call");
  setAction(command, session, options, body);
}

}  // namespace

void addStudyPanel(CLI::App& study, Session& session) {
  addCommand(study, session, "panel", "The segmentation measured on phantoms, as a table", "",
             panel);
  addCommand(study, session, "ablation",
             "The panel with each departure from the printed method switched off in turn",
             kAblationRows, ablation);
}

}  // namespace angiomesh::cli
