// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "core/base/formatted.h"
#include "core/parameters/field.h"
#include "core/parameters/presets.h"

namespace angiomesh::cli {
namespace {

std::string number(double value) { return formatted("%.10g", value); }

std::string allowed(const Field& field) {
  std::string text;
  switch (field.kind) {
    case FieldKind::Boolean:
      return "true, false";
    case FieldKind::Choice:
      text = joined(field.choices);
      break;
    case FieldKind::Integer:
    case FieldKind::Real:
      text = number(field.minimum) + " to " + number(field.maximum);
      break;
    case FieldKind::Texts:
      text = field.form;
      break;
    case FieldKind::Numbers:
      text = "groups of " + std::to_string(field.groupOf) + " numbers";
      break;
  }
  if (!field.emptyWord.empty()) text += ", or " + field.emptyWord;
  return text;
}

std::string valueIn(const Field& field, const std::string& presetName) {
  const std::string text = fieldText(field.get(preset(presetName)), field);
  return text.empty() ? "none" : text;
}

/// The values that presets beside the default have, in groups: "0 (ct, head-cta)".
std::string otherValues(const Field& field) {
  std::vector<std::pair<std::string, std::string>> groups;  // value, names
  const std::string own = valueIn(field, presetNames().front());
  for (const std::string& name : presetNames()) {
    const std::string value = valueIn(field, name);
    if (value == own) continue;
    const auto known = std::find_if(groups.begin(), groups.end(),
                                    [&](const auto& group) { return group.first == value; });
    if (known == groups.end())
      groups.emplace_back(value, name);
    else
      known->second += ", " + name;
  }
  std::string text;
  for (const auto& [value, names] : groups)
    text += (text.empty() ? "" : "; ") + value + " (" + names + ")";
  return text;
}

void printMarkdown() {
  std::printf(
      "# Parameters\n\n"
      "Keys as in `--set key=value`, in `params.json` (nested by the dots) and in the forms of "
      "the\n"
      "desktop program. A working voxel is a voxel of the grid that the pipeline works on after\n"
      "cropping and resampling.\n\n"
      "This page is the output of `angiomesh-cli parameters --markdown`.\n\n"
      "## Presets\n\n`--preset` chooses what to begin with.\n\n"
      "| preset | for |\n|---|---|\n");
  for (const Preset& preset : shippedPresets())
    std::printf("| `%s` | %s |\n", preset.name.c_str(), preset.about.c_str());
  std::printf(
      "\n## Fields\n\n"
      "| key | default | in other presets | allowed | unit | meaning | a larger value |\n"
      "|---|---|---|---|---|---|---|\n");
  for (const Field& field : parameterFields()) {
    std::printf("| `%s` | %s | %s | %s | %s | %s | %s |\n", field.key.c_str(),
                valueIn(field, presetNames().front()).c_str(), otherValues(field).c_str(),
                allowed(field).c_str(), field.unit.c_str(), field.help.c_str(), field.rise.c_str());
  }
}

void printText() {
  for (const Field& field : parameterFields()) {
    std::printf("%-36s %-24s %s%s%s\n", field.key.c_str(), valueIn(field, "angiomesh").c_str(),
                field.help.c_str(), field.unit.empty() ? "" : ", ", field.unit.c_str());
    if (!field.rise.empty()) std::printf("%-61s larger: %s\n", "", field.rise.c_str());
  }
}

}  // namespace

void addParameters(CLI::App& program, Session& session) {
  auto markdown = std::make_shared<bool>(false);
  CLI::App* command =
      program.add_subcommand("parameters", "All parameters with their defaults and ranges");
  command->add_flag("--markdown", *markdown, "As the table of docs/parameters.md");
  command->callback([markdown, &session] {
    session.action = [markdown] {
      if (*markdown)
        printMarkdown();
      else
        printText();
      return static_cast<int>(Done);
    };
  });
}

}  // namespace angiomesh::cli
