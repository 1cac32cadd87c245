// SPDX-License-Identifier: BSD-3-Clause
#include "io/recipe/command_line.h"

#include <algorithm>
#include <cctype>

#include "core/base/formatted.h"

namespace angiomesh {
namespace {

/// A word for a POSIX shell.
std::string quoted(const std::string& text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return c < 128 &&
           (std::isalnum(c) != 0 ||
            std::string_view("_-+.,:=/@%").find(static_cast<char>(c)) != std::string_view::npos);
  });
  if (plain) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// What names a field's single values on the command line; null: --set names all of them.
const char* optionOf(const Field& field) {
  if (field.key == "seeds.points") return " --seed ";
  if (field.key == "preprocess.roi") return " --roi ";
  if (field.key == "ports.cuts") return " --cut ";
  if (field.key == "ports.names") return " --name-port ";
  return nullptr;
}

/// The values that one option each is written for.
std::vector<std::string> singleValues(const FieldValue& value, const Field& field) {
  if (const auto* texts = std::get_if<std::vector<std::string>>(&value)) return *texts;
  const auto& numbers = std::get<std::vector<double>>(value);
  std::vector<std::string> all;
  for (std::size_t n = 0; n < numbers.size(); n += field.groupOf) {
    const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(n);
    all.push_back(
        joined(std::vector<double>(first, first + static_cast<std::ptrdiff_t>(field.groupOf)), ",",
               shortestText));
  }
  return all;
}

std::string optionText(const Parameters& params, const Field& field) {
  const FieldValue value = field.get(params);
  const char* option = optionOf(field);
  if (option == nullptr) return " --set " + quoted(field.key + "=" + fieldText(value, field));
  std::string text;
  for (const std::string& single : singleValues(value, field)) text += option + quoted(single);
  return text;
}

}  // namespace

NearestPreset nearestPreset(const Parameters& params) {
  NearestPreset nearest;
  for (const std::string& name : presetNames()) {
    const Parameters base = preset(name);
    std::vector<const Field*> others;
    for (const Field& field : parameterFields())
      if (!field.place && field.get(params) != field.get(base)) others.push_back(&field);
    if (nearest.name.empty() || others.size() < nearest.others.size())
      nearest = {name, std::move(others)};
  }
  return nearest;
}

std::string commandLine(const Parameters& params) {
  const NearestPreset nearest = nearestPreset(params);
  std::string line = "angiomesh-cli run SCAN -o OUT";
  if (nearest.name != presetNames().front()) line += " --preset " + nearest.name;
  for (const Field* field : nearest.others) line += optionText(params, *field);
  for (const Field& field : parameterFields())
    if (field.place && !std::holds_alternative<std::monostate>(field.get(params)))
      line += optionText(params, field);
  return line;
}

}  // namespace angiomesh
