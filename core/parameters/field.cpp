// SPDX-License-Identifier: BSD-3-Clause
#include "core/parameters/field.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/base/json_text.h"

namespace angiomesh {
namespace {

using Json = nlohmann::ordered_json;

/// Levenshtein distance, for the nearest known key.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

std::string rangeText(const Field& field) {
  return shortestText(field.minimum) + " to " + shortestText(field.maximum) +
         (field.unit.empty() ? "" : " " + field.unit);
}

/// What the field takes: "a number from 0 to 1".
std::string allowedText(const Field& field) {
  std::string text;
  switch (field.kind) {
    case FieldKind::Boolean:
      text = "true or false";
      break;
    case FieldKind::Integer:
      text = "a whole number from " + rangeText(field);
      break;
    case FieldKind::Real:
      text = "a number from " + rangeText(field);
      break;
    case FieldKind::Choice:
      text = "one of " + joined(field.choices);
      break;
    case FieldKind::Numbers:
      text = "numbers from " + rangeText(field) + " in groups of " + std::to_string(field.groupOf) +
             ", separated by commas";
      break;
    case FieldKind::Texts:
      text = field.form + ", separated by ';'";
      break;
  }
  if (!field.emptyWord.empty()) text += ", or " + field.emptyWord;
  return text;
}

[[noreturn]] void refuse(const Field& field, const std::string& value) {
  throw InputError("'" + value + "' cannot be used", field.key, "give " + allowedText(field));
}

bool allowed(const Field& field, const FieldValue& value) {
  const auto inRange = [&field](double x) {
    return std::isfinite(x) && x >= field.minimum && x <= field.maximum;
  };
  if (std::holds_alternative<std::monostate>(value)) return !field.emptyWord.empty();
  switch (field.kind) {
    case FieldKind::Boolean:
      return std::holds_alternative<bool>(value);
    case FieldKind::Integer: {
      const auto* n = std::get_if<std::int64_t>(&value);
      return n != nullptr && inRange(static_cast<double>(*n));
    }
    case FieldKind::Real: {
      const auto* x = std::get_if<double>(&value);
      return x != nullptr && inRange(*x);
    }
    case FieldKind::Choice: {
      const auto* word = std::get_if<std::string>(&value);
      return word != nullptr &&
             std::find(field.choices.begin(), field.choices.end(), *word) != field.choices.end();
    }
    case FieldKind::Numbers: {
      const auto* numbers = std::get_if<std::vector<double>>(&value);
      return numbers != nullptr && numbers->size() % field.groupOf == 0 &&
             (field.groupOf != 6 || numbers->size() == 6) &&
             std::all_of(numbers->begin(), numbers->end(), inRange);
    }
    case FieldKind::Texts: {
      const auto* texts = std::get_if<std::vector<std::string>>(&value);
      if (texts == nullptr) return false;
      // It says itself what is wrong.
      for (const std::string& text : *texts) field.check(text);
      return true;
    }
  }
  return false;
}

/// The whole of `text` as a number; from_chars does not depend on the locale.
template <class T>
std::optional<T> parsed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '+')) text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Json toJson(const FieldValue& value, const Field& field) {
  return std::visit(
      [&field](const auto& v) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::monostate>)
          return field.emptyWord;
        else
          return v;
      },
      value);
}

FieldValue fromJson(const Json& json, const Field& field) {
  if (!field.emptyWord.empty() && json.is_string() && json == field.emptyWord) return {};
  switch (field.kind) {
    case FieldKind::Boolean:
      if (json.is_boolean()) return json.get<bool>();
      break;
    case FieldKind::Integer:
      if (json.is_number_integer()) return json.get<std::int64_t>();
      break;
    case FieldKind::Real:
      if (json.is_number()) return json.get<double>();
      break;
    case FieldKind::Choice:
      if (json.is_string()) return json.get<std::string>();
      break;
    case FieldKind::Numbers:
      if (json.is_array() &&
          std::all_of(json.begin(), json.end(), [](const Json& x) { return x.is_number(); }))
        return json.get<std::vector<double>>();
      break;
    case FieldKind::Texts:
      if (json.is_array() &&
          std::all_of(json.begin(), json.end(), [](const Json& x) { return x.is_string(); }))
        return json.get<std::vector<std::string>>();
      break;
  }
  refuse(field, json.dump());
}

bool isGroup(const std::string& prefix) {
  const auto& fields = parameterFields();
  return std::any_of(fields.begin(), fields.end(),
                     [&](const Field& f) { return f.key.starts_with(prefix + "."); });
}

void readObject(Parameters& params, const Json& object, const std::string& prefix) {
  for (const auto& [name, value] : object.items()) {
    const std::string key = prefix.empty() ? name : prefix + "." + name;
    if (value.is_object() && isGroup(key)) {
      readObject(params, value, key);
    } else {
      setField(params, key, fromJson(value, findField(key)));
    }
  }
}

/// Whether both have a value, and that of the upper one is too small.
bool contradict(const Parameters& params, const Field& lower, const Field& upper) {
  const FieldValue low = lower.get(params), high = upper.get(params);
  const double* a = std::get_if<double>(&low);
  const double* b = std::get_if<double>(&high);
  return a != nullptr && b != nullptr && (upper.strictlyAbove ? *b <= *a : *b < *a);
}

}  // namespace

const Field& findField(std::string_view key) {
  const auto& fields = parameterFields();
  const auto found =
      std::find_if(fields.begin(), fields.end(), [key](const Field& f) { return f.key == key; });
  if (found != fields.end()) return *found;
  const auto nearest =
      std::min_element(fields.begin(), fields.end(), [key](const Field& a, const Field& b) {
        return editDistance(key, a.key) < editDistance(key, b.key);
      });
  throw InputError("there is no parameter '" + std::string(key) + "'", "parameters",
                   "did you mean " + nearest->key + "?");
}

void setField(Parameters& params, std::string_view key, const FieldValue& value) {
  const Field& field = findField(key);
  const auto* whole = std::get_if<std::int64_t>(&value);
  if (field.zeroIsEmpty && whole != nullptr && *whole == 0) return field.put(params, {});
  if (!allowed(field, value)) refuse(field, fieldText(value, field));
  field.put(params, value);
}

void setFieldFromText(Parameters& params, std::string_view key, std::string_view text) {
  const Field& field = findField(key);
  const std::string given(text);
  if (!field.emptyWord.empty() && given == field.emptyWord) {
    setField(params, key, {});
    return;
  }
  switch (field.kind) {
    case FieldKind::Boolean:
      if (given == "true" || given == "on" || given == "1") return setField(params, key, true);
      if (given == "false" || given == "off" || given == "0") return setField(params, key, false);
      break;
    case FieldKind::Integer:
      if (const auto n = parsed<std::int64_t>(text)) return setField(params, key, *n);
      break;
    case FieldKind::Real:
      if (const auto x = parsed<double>(text)) return setField(params, key, *x);
      break;
    case FieldKind::Choice:
      return setField(params, key, given);
    case FieldKind::Numbers: {
      std::vector<double> numbers;
      bool good = true;
      for (std::size_t start = 0; start <= text.size() && good;) {
        const std::size_t end = std::min(text.find(',', start), text.size());
        const auto x = parsed<double>(text.substr(start, end - start));
        good = x.has_value();
        if (x) numbers.push_back(*x);
        start = end + 1;
      }
      if (good) return setField(params, key, numbers);
      break;
    }
    case FieldKind::Texts: {
      std::vector<std::string> texts;
      for (std::size_t start = 0; start < given.size();) {
        const std::size_t end = std::min(given.find(';', start), given.size());
        texts.push_back(given.substr(start, end - start));
        start = end + 1;
      }
      return setField(params, key, texts);
    }
  }
  refuse(field, given);
}

std::string fieldText(const FieldValue& value, const Field& field) {
  return std::visit(
      [&field](const auto& v) -> std::string {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, std::monostate>) {
          return field.emptyWord.empty() ? "nothing" : field.emptyWord;
        } else if constexpr (std::is_same_v<T, bool>) {
          return v ? "true" : "false";
        } else if constexpr (std::is_same_v<T, std::int64_t>) {
          return std::to_string(v);
        } else if constexpr (std::is_same_v<T, double>) {
          return shortestText(v);
        } else if constexpr (std::is_same_v<T, std::string>) {
          return v;
        } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
          return joined(v, ";");
        } else {
          return joined(v, ",", shortestText);
        }
      },
      value);
}

std::array<double, 2> sliderRange(const Field& field, const FieldContext& context) {
  if (!field.slider) return {field.minimum, field.maximum};
  const std::array<double, 2> ends = field.slider(context);
  return {std::max(ends[0], field.minimum), std::min(ends[1], field.maximum)};
}

FieldValue suggestedValue(const Field& field, const Parameters& params,
                          const FieldContext& context) {
  switch (field.kind) {
    case FieldKind::Boolean:
      return true;
    case FieldKind::Choice:
      return field.choices.empty() ? std::string() : field.choices.front();
    case FieldKind::Texts:
      return std::vector<std::string>();
    case FieldKind::Numbers:
      return std::vector<double>();
    case FieldKind::Integer:
    case FieldKind::Real:
      break;
  }
  double value = field.logarithmic && field.minimum > 0.0 ? std::sqrt(field.minimum * field.maximum)
                                                          : 0.5 * (field.minimum + field.maximum);
  if (field.suggestion) value = field.suggestion(params, context);
  value = std::clamp(value, field.minimum, field.maximum);
  if (field.kind == FieldKind::Real) return value;
  return static_cast<std::int64_t>(std::lround(value));
}

void pushPartners(Parameters& params, const Field& set) {
  for (const Field& upper : parameterFields()) {
    if (upper.notBelow.empty() || upper.strictlyAbove) continue;
    const Field& lower = findField(upper.notBelow);
    if (upper.key != set.key && lower.key != set.key) continue;
    if (!contradict(params, lower, upper)) continue;
    const Field& follows = upper.key == set.key ? lower : upper;
    follows.put(params, set.get(params));
  }
}

void checkPartners(const Parameters& params) {
  for (const Field& upper : parameterFields()) {
    if (upper.notBelow.empty()) continue;
    const Field& lower = findField(upper.notBelow);
    if (contradict(params, lower, upper))
      throw InputError(
          upper.key + (upper.strictlyAbove ? " is not above " : " is below ") + lower.key,
          lower.key + " = " + fieldText(lower.get(params), lower) + ", " + upper.key + " = " +
              fieldText(upper.get(params), upper),
          "raise the one or lower the other");
  }
}

void copyPlaces(const Parameters& from, Parameters& to) {
  for (const Field& field : parameterFields())
    if (field.place) field.put(to, field.get(from));
  if (isSegmented(from)) {
    to.segmentation.method = from.segmentation.method;
    to.segmentation.label = from.segmentation.label;
  } else if (isSegmented(to)) {
    to.segmentation.method = SegmentationParams().method;
    to.segmentation.label = SegmentationParams().label;
  }
}

std::string parametersToJson(const Parameters& params) {
  Json json = Json::object();
  for (const Field& field : parameterFields())
    placeAt(json, field.key) = toJson(field.get(params), field);
  return json.dump(2) + "\n";
}

Parameters parametersFromJson(std::string_view text, const Parameters& base,
                              const std::string& where) {
  if (!isModestJson(text))
    throw InputError("the parameters are nested too deep, or there are too many", where,
                     "write them as {\"vesselness\": {\"sigmaMinMm\": 0.5}, ...}");
  const Json json = parseJson<Json>(text);
  if (json.is_discarded() || !json.is_object())
    throw InputError("the parameters are not a JSON object", where,
                     "write them as {\"vesselness\": {\"sigmaMinMm\": 0.5}, ...}");
  Parameters params = base;
  readObject(params, json, "");
  return params;
}

}  // namespace angiomesh
