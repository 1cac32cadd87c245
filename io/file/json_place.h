// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace angiomesh {

/// Where a value stands in a JSON file, and what a reader says about it: ports[1].normal.
class JsonPlace {
 public:
  explicit JsonPlace(std::string file, std::string name = {})
      : file_(std::move(file)), name_(std::move(name)) {}

  /// @throws InputError: this value `what`, such as "is no number"
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(name_ + " " + what, file_,
                     "correct the file, or write it again with angiomesh");
  }
  [[nodiscard]] JsonPlace in(const std::string& key) const {
    return JsonPlace(file_, name_.empty() ? key : name_ + "." + key);
  }
  [[nodiscard]] JsonPlace at(std::size_t n) const {
    return JsonPlace(file_, name_ + "[" + std::to_string(n) + "]");
  }

 private:
  std::string file_, name_;
};

// Of nlohmann's value; each throws as JsonPlace::refuse().

/// The object's values in the order of `keys`: these and no others.
template <class Json>
std::vector<Json> valuesOf(const Json& object, const std::vector<std::string>& keys,
                           const JsonPlace& place) {
  if (!object.is_object()) place.refuse("is no object");
  std::vector<Json> values;
  for (const std::string& key : keys) {
    if (!object.contains(key)) place.in(key).refuse("is missing");
    values.push_back(object.at(key));
  }
  for (const auto& entry : object.items())
    if (std::find(keys.begin(), keys.end(), entry.key()) == keys.end())
      place.in(entry.key()).refuse("is not known");
  return values;
}

template <class Json>
double numberIn(const Json& value, const JsonPlace& place) {
  // JSON has no infinity, but 1e999 reads as one.
  if (!value.is_number() || !std::isfinite(value.template get<double>()))
    place.refuse("is no number");
  return value.template get<double>();
}

template <class Json>
std::string textIn(const Json& value, const JsonPlace& place) {
  if (!value.is_string()) place.refuse("is no text");
  return value.template get<std::string>();
}

/// The values of a list of three.
template <class Json>
std::vector<Json> threeIn(const Json& value, const JsonPlace& place) {
  if (!value.is_array() || value.size() != 3) place.refuse("is no list of three numbers");
  return {value[0], value[1], value[2]};
}

/// @throws InputError unless the file's `schema` is the one that this program writes; `what` is in
/// it: "the ports were"
template <class Json>
void checkSchema(const Json& schema, int known, const std::string& what, const std::string& file) {
  if (schema.is_number_integer() && schema.template get<std::int64_t>() > known)
    throw InputError(what + " written by a newer Angiomesh (schema " + schema.dump() + ")", file,
                     "update the program");
  if (schema != Json(known)) JsonPlace(file, "schema").refuse("is not " + std::to_string(known));
}

}  // namespace angiomesh
