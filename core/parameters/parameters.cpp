// SPDX-License-Identifier: BSD-3-Clause
#include "core/parameters/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/base/error.h"
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

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string numberText(double value) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string rangeText(const Field& field) {
  return numberText(field.minimum) + " to " + numberText(field.maximum) +
         (field.unit.empty() ? "" : " " + field.unit);
}

/// What the field takes, for messages.
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
          return numberText(v);
        } else if constexpr (std::is_same_v<T, std::string>) {
          return v;
        } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
          std::string text;
          for (const std::string& x : v) text += (text.empty() ? "" : ";") + x;
          return text;
        } else {
          std::string text;
          for (const double x : v) text += (text.empty() ? "" : ",") + numberText(x);
          return text;
        }
      },
      value);
}

void validate(const Parameters& params) {
  const VesselnessParams& v = params.vesselness;
  if (v.sigmaMinMm && v.sigmaMaxMm && *v.sigmaMaxMm < *v.sigmaMinMm)
    throw InputError("the largest scale is below the smallest",
                     "vesselness.sigmaMinMm = " + numberText(*v.sigmaMinMm) +
                         ", vesselness.sigmaMaxMm = " + numberText(*v.sigmaMaxMm),
                     "make sigmaMaxMm at least sigmaMinMm");
  const SizingParams& sizing = params.surface.sizing;
  if (sizing.edgeMinMm && sizing.edgeMaxMm && *sizing.edgeMaxMm < *sizing.edgeMinMm)
    throw InputError("the longest edge is below the shortest",
                     "surface.edgeMinMm = " + numberText(*sizing.edgeMinMm) +
                         ", surface.edgeMaxMm = " + numberText(*sizing.edgeMaxMm),
                     "make edgeMaxMm at least edgeMinMm");
  checkPorts(params.ports);
  if (params.levelset.bMax < params.levelset.bMin)
    throw InputError("the upper bound of b is below the lower", "levelset.bMin, levelset.bMax",
                     "make bMax at least bMin");
  const PreprocessParams& pre = params.preprocess;
  if (pre.clampLower && pre.clampUpper && *pre.clampUpper <= *pre.clampLower)
    throw InputError("the upper bound of the intensity is not above the lower",
                     "preprocess.clamp.lower = " + numberText(*pre.clampLower) +
                         ", preprocess.clamp.upper = " + numberText(*pre.clampUpper),
                     "make upper more than lower");
  const ComparisonParams& c = params.comparison;
  if (c.thresholdLower && c.thresholdUpper && *c.thresholdUpper < *c.thresholdLower)
    throw InputError("the upper threshold is below the lower",
                     "comparison.threshold.lower = " + numberText(*c.thresholdLower) +
                         ", comparison.threshold.upper = " + numberText(*c.thresholdUpper),
                     "make upper at least lower");
  if (!params.seeds.automatic && params.seeds.points.empty() && !isSegmented(params))
    throw InputError("there are no seeds", "seeds.automatic, seeds.points",
                     "give seeds by hand or turn seeds.automatic on");
}

bool evolves(const Parameters& params) {
  return params.segmentation.method == SegmentationMethod::LevelSet ||
         params.segmentation.method == SegmentationMethod::GeodesicActiveContour;
}

bool isSegmented(const Parameters& params) {
  return params.segmentation.method == SegmentationMethod::Label;
}

const std::vector<std::string>& presetNames() {
  static const std::vector<std::string> names{"angiomesh", "ct", "thesis"};
  return names;
}

Parameters preset(std::string_view name) {
  Parameters params;
  if (name == "angiomesh") return params;
  if (name == "ct") {
    // HU: fat and air are as good as soft tissue, contrast medium in a vessel is below 500.
    params.preprocess.clampLower = 0.0;
    params.preprocess.clampUpper = 500.0;
    return params;
  }
  if (name != "thesis")
    throw InputError("there is no preset '" + std::string(name) + "'", "preset",
                     "use one of " + joined(presetNames()));
  params.vesselness.scaleRule = ScaleRule::Difference;
  params.vesselness.scalesFromImage = false;
  params.vesselness.contrast = ContrastRule::Range;
  params.seeds.least = 0.0;
  params.levelset.start = StartRule::Seeds;
  params.levelset.acrossCrests = false;
  params.levelset.stepVoxels = 0.1667;
  params.levelset.maxIterations = 5000;
  params.levelset.checkEvery = 100;
  params.levelset.bRule = ThresholdRule::Average;
  params.lumen.enabled = false;
  params.wall.enabled = false;
  params.surface.spline = SplineKind::Bspline;
  params.surface.sizing = SizingParams::printed();
  params.surface.border = SurfaceBorder::Open;
  params.smooth.method = SmoothMethod::Taubin;
  return params;
}

std::string parametersToJson(const Parameters& params) {
  Json json = Json::object();
  for (const Field& field : parameterFields()) {
    Json* at = &json;
    std::size_t start = 0;
    for (std::size_t dot = field.key.find('.'); dot != std::string::npos;
         dot = field.key.find('.', start)) {
      at = &(*at)[field.key.substr(start, dot - start)];
      start = dot + 1;
    }
    (*at)[field.key.substr(start)] = toJson(field.get(params), field);
  }
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
