// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/parameters/parameters.h"
#include "core/parameters/step.h"

namespace angiomesh {

/// A field's value: monostate stands for the field's empty word ("auto", "none").
using FieldValue = std::variant<std::monostate, bool, std::int64_t, double, std::string,
                                std::vector<double>, std::vector<std::string>>;
enum class FieldKind { Boolean, Integer, Real, Choice, Numbers, Texts };

/// Why a field has no effect with these parameters, as a clause: "it is used only with ..."; ""
/// when it has one.
using IdleReason = std::function<std::string(const Parameters&)>;

/// What a form knows of an image, and of results made of it.
struct FieldContext {
  double voxelMm = 1.0;
  double window = 1.0, level = 0.5;  ///< of the viewer, intensities
  double volumeMm3 = 1e6;
  double largestValue = 1.0;
  std::vector<double> scalesMm;  ///< of the vesselness; may be empty
  std::optional<double> c, b;    ///< of the vesselness, of the thresholds
};

/// The one description of a parameter: JSON, --set, GUI form, validation, documentation and what
/// has to be computed again come from it.
struct Field {
  std::string key;  ///< "vesselness.sigmaMinMm"
  FieldKind kind = FieldKind::Real;
  double minimum = 0.0, maximum = 0.0;  ///< inclusive, for Integer, Real and each of Numbers
  std::string unit;
  std::string label;                 ///< in a form; English, to be translated
  std::string help;                  ///< one line
  std::string rise;                  ///< what happens when its value rises, one line; may be empty
  std::vector<std::string> choices;  ///< Choice
  std::string emptyWord;             ///< "auto" or "none" where the field may be empty, else ""
  bool zeroIsEmpty = false;          ///< 0 may be written for the empty word
  std::size_t groupOf = 0;           ///< Numbers come in whole groups of this many
  std::string form;                  ///< Texts: how each is written
  /// Texts: throws InputError for one that cannot be used.
  std::function<void(const std::string&)> check;

  Step step = Step::Preprocess;        ///< in whose form it stands
  std::optional<Step> ofScan, ofMask;  ///< the step that reads it, of a scan and of a segmentation
  bool remakes = true;                 ///< the step's result depends on it
  bool place = false;                  ///< means something in one image only
  bool ofSpeed = false;                ///< sets the thresholds that the speed p is made with

  bool main = false;           ///< shown among the few main sliders of its step
  bool logarithmic = false;    ///< a slider moves in equal ratios
  double shownTimes = 1.0;     ///< a form shows the value times this
  std::string notBelow;        ///< the key of a field whose value it is never less than; or ""
  bool strictlyAbove = false;  ///< nor equal to
  /// The part of the range that is worth a slider; empty: all of it.
  std::function<std::array<double, 2>(const FieldContext&)> slider;
  /// Where a field that was empty begins when it gets a value; empty: in the middle.
  std::function<double(const Parameters&, const FieldContext&)> suggestion;
  IdleReason idle;  ///< empty: it always has an effect
  std::function<FieldValue(const Parameters&)> get;
  std::function<void(Parameters&, const FieldValue&)>
      put;  ///< stores without checking: use setField()
};

/// All fields in the order of the pipeline.
const std::vector<Field>& parameterFields();

/// @throws InputError naming the nearest known key
const Field& findField(std::string_view key);

/// Checks kind, range, choice and group, then stores.
/// @throws InputError that names the key, the value and what is allowed
void setField(Parameters& params, std::string_view key, const FieldValue& value);

/// As --set: `text` is parsed by the field's kind ("auto", "true", "3", "0.5", "modified",
/// "1,2,3", texts separated by ';').
void setFieldFromText(Parameters& params, std::string_view key, std::string_view text);

std::string fieldText(const FieldValue& value, const Field& field);

std::array<double, 2> sliderRange(const Field& field, const FieldContext& context);
FieldValue suggestedValue(const Field& field, const Parameters& params,
                          const FieldContext& context);

/// After a field was set: the one that bounds it, or that it bounds, follows where they would
/// contradict each other.
void pushPartners(Parameters& params, const Field& set);

/// @throws InputError naming both where a field is below the one that bounds it
void checkPartners(const Parameters& params);

/// What means something in one image only, and whether that is a segmentation.
void copyPlaces(const Parameters& from, Parameters& to);

/// Nested JSON by the dots of the keys. Reading takes nested or dotted keys, changes only those
/// named, and throws InputError for unknown keys and for values of the wrong kind or out of range.
std::string parametersToJson(const Parameters& params);
Parameters parametersFromJson(std::string_view json, const Parameters& base,
                              const std::string& where);

}  // namespace angiomesh
