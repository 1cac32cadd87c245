// SPDX-License-Identifier: BSD-3-Clause
#include "io/file/length_unit.h"

#include "io/file/text_scanner.h"

namespace angiomesh {

std::optional<double> millimetresOf(const std::string& unit) {
  std::string name = inSmall(unit);
  if (name.size() > 2 && name.ends_with('s')) name.pop_back();
  const auto isOneOf = [&](const std::string& names) {
    return !name.empty() && names.find(" " + name + " ") != std::string::npos;
  };
  if (isOneOf(" mm millimeter millimetre ")) return 1.0;
  // Both of Unicode's letters mu, and the one of Latin 1.
  if (isOneOf(" um micron micrometer micrometre \xc2\xb5m \xce\xbcm \xb5m ")) return 1e-3;
  if (isOneOf(" nm nanometer nanometre ")) return 1e-6;
  if (isOneOf(" cm centimeter centimetre ")) return 10.0;
  if (isOneOf(" dm decimeter decimetre ")) return 100.0;
  if (isOneOf(" m meter metre ")) return 1000.0;
  if (isOneOf(" in inch inche ")) return 25.4;
  return {};
}

std::string unknownUnit(const std::string& unit) {
  // Headers may hold anything: only what is printed safely, and not all of it.
  std::string shown;
  for (const char c : unit.substr(0, 20)) shown += c >= ' ' && c < 127 ? c : '?';
  return "the file's unit of length, '" + shown + "', is not known: mm is assumed";
}

}  // namespace angiomesh
