// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "core/parameters/field.h"
#include "fuzz/fuzz_readers.h"
#include "io/recipe/command_line.h"
#include "io/recipe/recipe_file.h"
#include "io/vessel/ports_file.h"

namespace angiomesh::fuzz {

/// Parameters come back from JSON, and each of them from the text that --set takes.
inline void checkParameters(const Parameters& params) {
  const Parameters back = parametersFromJson(parametersToJson(params), preset("thesis"), "fuzz");
  Parameters byText = preset("thesis");
  for (const Field& field : parameterFields()) {
    expect(field.get(back) == field.get(params), field.key + " is another one in JSON");
    setFieldFromText(byText, field.key, fieldText(field.get(params), field));
    expect(field.get(byText) == field.get(params), field.key + " is another one as text");
  }
}

inline void readCut(const std::string& text) {
  attempt([&] {
    const GivenCut cut = parseCut(text);
    must([&] {
      const GivenCut back = parseCut(cutText(cut));
      expect(
          back.pointLps == cut.pointLps && back.normalLps == cut.normalLps && back.name == cut.name,
          "another cut as text");
      expect(!cut.normalLps || std::fabs(cut.normalLps->normalized().norm() - 1.0) < 1e-9,
             "a cut without a direction");
    });
  });
}

/// A recipe, or parameters alone, comes back from what is written of it.
inline void checkRecipe(const Recipe& recipe) {
  const std::string text = recipeText(recipe);
  const Recipe back = recipeFromText(text, preset("thesis"), "fuzz");
  expect(recipeText(back) == text, "another recipe in JSON");
  expect(recipeHash(back) == recipeHash(recipe), "another hash of the same recipe");
  expect(commandLine(back.params) == commandLine(recipe.params), "another command line");
}

/// As the options of a command: JSON, then the lines of --set, --cut and --name-port.
inline void readOptions(std::string_view json, std::string_view settings, std::string_view cuts,
                        std::string_view names) {
  Parameters params = preset("angiomesh");
  attempt([&] {
    const Recipe recipe = recipeFromText(json, params, "fuzz");
    must([&] { checkRecipe(recipe); });
    params = recipe.params;
  });
  must([&] { checkParameters(params); });
  for (const std::string_view setting : partsOf(settings, '\n'))
    attempt([&] {
      const std::size_t equals = std::min(setting.find('='), setting.size());
      setFieldFromText(params, setting.substr(0, equals),
                       setting.substr(std::min(equals + 1, setting.size())));
    });
  must([&] { checkParameters(params); });
  if (!cuts.empty())
    for (const std::string_view cut : partsOf(cuts, '\n')) {
      readCut(std::string(cut));
      params.ports.cuts.emplace_back(cut);
    }
  if (!names.empty())
    for (const std::string_view name : partsOf(names, '\n')) params.ports.names.emplace_back(name);
  attempt([&] {
    validate(params);
    must([&] { checkParameters(params); });
  });
}

inline bool same(const Port& a, const Port& b) {
  const auto sameSlant = [&] {
    return a.slant->angleDeg == b.slant->angleDeg && a.slant->areaRatio == b.slant->areaRatio &&
           a.slant->sectionAreaMm2 == b.slant->sectionAreaMm2 &&
           a.slant->centreLps == b.slant->centreLps && a.slant->axisLps == b.slant->axisLps;
  };
  return a.name == b.name && a.centreLps == b.centreLps && a.normalLps == b.normalLps &&
         a.areaMm2 == b.areaMm2 && a.slant.has_value() == b.slant.has_value() &&
         (!a.slant || sameSlant());
}

/// A ports.json comes back from what is written of it.
inline void readPortsText(std::string_view text) {
  const InputFolder folder;
  folder.add("ports.json", text);
  attempt([&] {
    const std::vector<Port> ports = readPorts(folder / "ports.json");
    must([&] {
      writePorts(ports, folder / "again.json");
      const std::vector<Port> back = readPorts(folder / "again.json");
      expect(std::equal(ports.begin(), ports.end(), back.begin(), back.end(), same),
             "other ports in JSON");
    });
  });
}

/// Between form feeds: the text of --recipe; lines of --set; lines of --cut; lines of --name-port;
/// a ports.json.
inline void readParametersInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string_view> parts = partsOf(textOf(data, size), '\f');
  readOptions(part(parts, 0), part(parts, 1), part(parts, 2), part(parts, 3));
  if (!part(parts, 4).empty()) readPortsText(part(parts, 4));
}

}  // namespace angiomesh::fuzz
